"""Messages between members: frozen values, each with the seat of its sender."""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.team.commands import Batch, Seat
from kitrobot.team.records import Number, TaggedRecord
from kitrobot.team.tables import Tables

EVERYONE = -1
"""Addressee of a message for all others."""


class Ballot(NamedTuple):
    """An attempt to decide a slot: its round, and the rank among the voters of who makes it."""

    round: Number
    rank: Number


class Stamp(NamedTuple):
    """When a variable was written, and by whom: the larger one is the later."""

    clock: Number
    member: Number
    life: Number


class Entry(NamedTuple):
    """A shared variable as one write left it."""

    variable: Number
    stamp: Stamp
    value: Number


class Echo(NamedTuple):
    """The latest time stamp that was heard of a seat."""

    member: Number
    life: Number
    stamp: Number


class Prepare(TaggedRecord, frozen=True):
    """Asks the voters of a slot to promise this ballot (synod, phase 1a)."""

    sender: Seat
    slot: Number
    ballot: Ballot


class Promise(TaggedRecord, frozen=True):
    """Promises to vote in no lower ballot; `accepted` and `value` are the last vote (phase 1b)."""

    sender: Seat
    slot: Number
    ballot: Ballot
    accepted: Ballot
    value: Batch


class Propose(TaggedRecord, frozen=True):
    """Asks for votes for a value (phase 2a)."""

    sender: Seat
    slot: Number
    ballot: Ballot
    value: Batch


class Accepted(TaggedRecord, frozen=True):
    """A vote (phase 2b)."""

    sender: Seat
    slot: Number
    ballot: Ballot


class Denied(TaggedRecord, frozen=True):
    """A higher ballot was promised."""

    sender: Seat
    slot: Number
    ballot: Ballot


class Chosen(TaggedRecord, frozen=True):
    """What a slot decided."""

    sender: Seat
    slot: Number
    value: Batch


class Request(TaggedRecord, frozen=True):
    """Commands of the sender that are not decided yet."""

    sender: Seat
    commands: Batch


class Behind(TaggedRecord, frozen=True):
    """The sender knows this many slots and asks for those after them."""

    sender: Seat
    slot: Number


class History(TaggedRecord, frozen=True):
    """What `slot` and the slots after it decided."""

    sender: Seat
    slot: Number
    values: tuple[Batch, ...]


class Heartbeat(TaggedRecord, frozen=True):
    """The sender lives.

    Attributes:
        stamp: its time, ms.
        view, slot: the number of the view that it knows, how many slots of the log it knows.
        firm: whether it has not voted for a change of that view.
        digest: of its copies of the shared variables.
        echoes: what it heard of the others within a lease.
    """

    sender: Seat
    stamp: Number
    view: Number
    slot: Number
    firm: bool
    digest: Number
    echoes: tuple[Echo, ...]


class Writes(TaggedRecord, frozen=True):
    """Shared variables as the sender knows them."""

    sender: Seat
    entries: tuple[Entry, ...]


class Compare(TaggedRecord, frozen=True):
    """The stamps of the sender's copies; who knows later writes answers with them."""

    sender: Seat
    stamps: tuple[Stamp, ...]


class Snapshot(TaggedRecord, frozen=True):
    """The tables after so many slots, for a member that is too far behind to be sent each."""

    sender: Seat
    slot: Number
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
