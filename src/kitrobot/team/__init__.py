"""The protocol of a team, as pure state machines: time and events in, messages and changes out."""

from kitrobot.team.changes import (
    AppliedNote,
    Change,
    LogGap,
    NewView,
    QuorumChange,
    Refusal,
    SlotDecision,
    VariableChange,
)
from kitrobot.team.charter import Charter
from kitrobot.team.codec import MessageError, decode, encode
from kitrobot.team.commands import Note, Seat
from kitrobot.team.events import Event, IncomingMessage, Leave, Time, Write
from kitrobot.team.member import step
from kitrobot.team.messages import EVERYONE, Message, Sending
from kitrobot.team.state import Member, StepResult, initial_state, may_act
from kitrobot.team.tables import Tables, View

__all__ = [
    "EVERYONE",
    "AppliedNote",
    "Change",
    "Charter",
    "Event",
    "IncomingMessage",
    "Leave",
    "LogGap",
    "Member",
    "Message",
    "MessageError",
    "NewView",
    "Note",
    "QuorumChange",
    "Refusal",
    "Seat",
    "Sending",
    "SlotDecision",
    "StepResult",
    "Tables",
    "Time",
    "VariableChange",
    "View",
    "Write",
    "decode",
    "encode",
    "initial_state",
    "may_act",
    "step",
]
