"""The protocol of a team, as pure state machines: time and events in, messages and changes out."""

from kitrobot.team.changes import (
    Change,
    Counted,
    Decided,
    Granted,
    Late,
    NotCounted,
    Noted,
    Passed,
    Quorum,
    Refused,
    Skipped,
    Viewed,
    Written,
)
from kitrobot.team.charter import Charter, Group, MeetingRule, Move, Role, Work
from kitrobot.team.coding import MessageError, decode, encode
from kitrobot.team.commands import Announce, Done, Free, Note, Seat, Take
from kitrobot.team.events import Event, Leave, Received, Time, Write
from kitrobot.team.member import step
from kitrobot.team.messages import EVERYONE, Message, Sending
from kitrobot.team.state import Member, Stepped, first_state, may_act
from kitrobot.team.tables import Tables, View

__all__ = [
    "EVERYONE",
    "Announce",
    "Change",
    "Charter",
    "Counted",
    "Decided",
    "Done",
    "Event",
    "Free",
    "Granted",
    "Group",
    "Late",
    "Leave",
    "MeetingRule",
    "Member",
    "Message",
    "MessageError",
    "Move",
    "NotCounted",
    "Note",
    "Noted",
    "Passed",
    "Quorum",
    "Received",
    "Refused",
    "Role",
    "Seat",
    "Sending",
    "Skipped",
    "Stepped",
    "Tables",
    "Take",
    "Time",
    "View",
    "Viewed",
    "Work",
    "Write",
    "Written",
    "decode",
    "encode",
    "first_state",
    "may_act",
    "step",
]
