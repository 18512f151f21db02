"""What a member tells its host; those made of the log are told by all members, in the same order."""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.team.commands import Seat
from kitrobot.team.messages import Sending
from kitrobot.team.tables import View
from kitrobot.text import Sentence


@dataclass(frozen=True, slots=True)
class Noted:
    """A `Note` of this seat took effect."""

    seat: Seat
    numbers: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Decided:
    """All that was told of the log since the last `Decided` or `Skipped` is of this slot."""

    slot: int


@dataclass(frozen=True, slots=True)
class Skipped:
    """The log goes on from this slot: what was decided before it was not told, but is in the tables."""

    slot: int


@dataclass(frozen=True, slots=True)
class Viewed:
    """There is a new view."""

    view: View


@dataclass(frozen=True, slots=True)
class Quorum:
    """Whether the member hears enough of the view to decide; without, stop at the next meeting and wait."""

    heard: bool


@dataclass(frozen=True, slots=True)
class Written:
    """A shared variable has another value here."""

    variable: int
    value: int


@dataclass(frozen=True, slots=True)
class Refused:
    """A message of this member was refused."""

    member: int
    why: Sentence


Change = Noted | Decided | Skipped | Viewed | Quorum | Written | Refused

Outgoing = tuple[Sending, ...]
Told = tuple[Change, ...]
