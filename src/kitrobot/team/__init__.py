"""The protocol of a team, as pure state machines: time and events in, messages and changes out."""

from kitrobot.team.changes import (
    Change,
    Decided,
    Noted,
    Quorum,
    Refused,
    Skipped,
    Viewed,
    Written,
)
from kitrobot.team.charter import Charter
from kitrobot.team.coding import MessageError, decode, encode
from kitrobot.team.commands import Note, Seat
from kitrobot.team.events import Event, Leave, Received, Time, Write
from kitrobot.team.member import step
from kitrobot.team.messages import EVERYONE, Message, Sending
from kitrobot.team.state import Member, Stepped, first_state, may_act
from kitrobot.team.tables import Tables, View

__all__ = [
    "EVERYONE",
    "Change",
    "Charter",
    "Decided",
    "Event",
    "Leave",
    "Member",
    "Message",
    "MessageError",
    "Note",
    "Noted",
    "Quorum",
    "Received",
    "Refused",
    "Seat",
    "Sending",
    "Skipped",
    "Stepped",
    "Tables",
    "Time",
    "View",
    "Viewed",
    "Write",
    "Written",
    "decode",
    "encode",
    "first_state",
    "may_act",
    "step",
]
