"""Messages between members: frozen values, each with the seat of its sender."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from kitrobot.team.commands import Batch, Seat
from kitrobot.team.tables import Tables

EVERYONE = -1
"""Addressee of a message for all others."""


class Ballot(NamedTuple):
    """An attempt to decide a slot: its round, and the rank among the voters of who makes it."""

    round: int
    rank: int


class Stamp(NamedTuple):
    """When a variable was written, and by whom: the larger one is the later."""

    clock: int
    member: int
    life: int


class Entry(NamedTuple):
    """A shared variable as one write left it."""

    variable: int
    stamp: Stamp
    value: int


class Echo(NamedTuple):
    """The latest time stamp that was heard of a seat."""

    member: int
    life: int
    stamp: int


@dataclass(frozen=True, slots=True)
class Prepare:
    """Asks the voters of a slot to promise this ballot (synod, phase 1a)."""

    sender: Seat
    slot: int
    ballot: Ballot


@dataclass(frozen=True, slots=True)
class Promise:
    """Promises to vote in no lower ballot; `accepted` and `value` are the last vote (phase 1b)."""

    sender: Seat
    slot: int
    ballot: Ballot
    accepted: Ballot
    value: Batch


@dataclass(frozen=True, slots=True)
class Propose:
    """Asks for votes for a value (phase 2a)."""

    sender: Seat
    slot: int
    ballot: Ballot
    value: Batch


@dataclass(frozen=True, slots=True)
class Accepted:
    """A vote (phase 2b)."""

    sender: Seat
    slot: int
    ballot: Ballot


@dataclass(frozen=True, slots=True)
class Denied:
    """A higher ballot was promised."""

    sender: Seat
    slot: int
    ballot: Ballot


@dataclass(frozen=True, slots=True)
class Chosen:
    """What a slot decided."""

    sender: Seat
    slot: int
    value: Batch


@dataclass(frozen=True, slots=True)
class Request:
    """Commands of the sender that are not decided yet."""

    sender: Seat
    commands: Batch


@dataclass(frozen=True, slots=True)
class Behind:
    """The sender knows this many slots and asks for those after them."""

    sender: Seat
    slot: int


@dataclass(frozen=True, slots=True)
class History:
    """What `slot` and the slots after it decided."""

    sender: Seat
    slot: int
    values: tuple[Batch, ...]


@dataclass(frozen=True, slots=True)
class Heartbeat:
    """The sender lives.

    Attributes:
        stamp: its time, ms.
        view, slot: the number of the view that it knows, how many slots of the log it knows.
        firm: whether it has not voted for a change of that view.
        digest: of its copies of the shared variables.
        echoes: what it heard of the others within a lease.
    """

    sender: Seat
    stamp: int
    view: int
    slot: int
    firm: bool
    digest: int
    echoes: tuple[Echo, ...]


@dataclass(frozen=True, slots=True)
class Writes:
    """Shared variables as the sender knows them."""

    sender: Seat
    entries: tuple[Entry, ...]


@dataclass(frozen=True, slots=True)
class Compare:
    """The stamps of the sender's copies; who knows later writes answers with them."""

    sender: Seat
    stamps: tuple[Stamp, ...]


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The tables after so many slots, for a member that is too far behind to be sent each."""

    sender: Seat
    slot: int
    tables: Tables


Message = (
    Prepare
    | Promise
    | Propose
    | Accepted
    | Denied
    | Chosen
    | Request
    | Behind
    | History
    | Heartbeat
    | Writes
    | Compare
    | Snapshot
)


class OutgoingMessage(NamedTuple):
    """A message and its addressee, a member or `EVERYONE`."""

    to: int
    message: Message
