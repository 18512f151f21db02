"""Changes that a member reports to its host; all members report those of the log, in the same order."""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.team.commands import Seat
from kitrobot.team.messages import OutgoingMessage
from kitrobot.team.records import Numbers, TaggedRecord
from kitrobot.team.tables import View
from kitrobot.text.sentences import Sentence


class AppliedNote(TaggedRecord, frozen=True):
    """A `Note` of this seat took effect."""

    seat: Seat
    numbers: Numbers


@dataclass(frozen=True, slots=True)
class SlotDecision:
    """All changes of the log reported since the last `SlotDecision` or `LogGap` is of this slot."""

    slot: int


@dataclass(frozen=True, slots=True)
class LogGap:
    """The log goes on from this slot: earlier decisions were not reported, but are in the tables."""

    slot: int


class NewView(TaggedRecord, frozen=True):
    """There is a new view."""

    view: View


@dataclass(frozen=True, slots=True)
class QuorumChange:
    """Whether the member hears enough of the view to decide; without, stop at the next meeting and wait."""

    heard: bool


@dataclass(frozen=True, slots=True)
class VariableChange:
    """A shared variable has another value here."""

    variable: int
    value: int


@dataclass(frozen=True, slots=True)
class Refusal:
    """A message of this member was refused."""

    member: int
    why: Sentence


Change = AppliedNote | SlotDecision | LogGap | NewView | QuorumChange | VariableChange | Refusal

OutgoingMessages = tuple[OutgoingMessage, ...]
Changes = tuple[Change, ...]
