"""`SharedStore`: shared variables, copied to all members; the write with the latest stamp wins (Lamport clocks).

What a message brings is merged, so neither order nor repetition matters. Heartbeats carry a digest; where two differ,
the stamps are compared and the later writes are sent, so copies are equal once every member has heard the others.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass, replace
from hashlib import blake2b

from kitrobot.team.commands import Seat
from kitrobot.team.messages import Entry, Stamp

AHEAD = 1 << 32
"""Writes by which a clock may be ahead of the latest known; no team writes that often while one member is away."""

LAST_CLOCK = 1 << 52

FIRST_STAMP = Stamp(0, -1, 0)


@dataclass(frozen=True, slots=True)
class SharedStore:
    """The copies of one member: an entry for each variable."""

    entries: tuple[Entry, ...]

    @property
    def clock(self) -> int:
        """The latest clock of any write that is known."""
        return max((entry.stamp.clock for entry in self.entries), default=0)

    @property
    def stamps(self) -> tuple[Stamp, ...]:
        """The stamp of each variable."""
        return tuple(entry.stamp for entry in self.entries)


def initial_store(variables: int) -> SharedStore:
    """All variables are 0."""
    return SharedStore(tuple(Entry(variable, FIRST_STAMP, 0) for variable in range(variables)))


def write(store: SharedStore, seat: Seat, variable: int, value: int) -> tuple[SharedStore, Entry]:
    """The store after a write of this seat, which is later than all it knows."""
    entry = Entry(variable, Stamp(store.clock + 1, *seat), value)
    return _with(store, entry), entry


def merge(store: SharedStore, entries: Iterable[Entry]) -> tuple[SharedStore, list[Entry], int]:
    """The store with those writes that are later than its own, what has another value now, how many were refused.

    Two writes with one stamp are a fault of their writer; the larger value is taken, so that copies are equal still.
    """
    news: dict[int, Entry] = {}
    refused = 0
    for entry in entries:
        if not 0 <= entry.variable < len(store.entries) or entry.stamp.clock < 0:
            refused += 1
            continue
        if entry.stamp.clock > min(store.clock + AHEAD, LAST_CLOCK):
            refused += 1
            continue
        mine = store.entries[entry.variable]
        refused += entry.stamp == mine.stamp and entry.value != mine.value
        if entry[1:] > mine[1:]:
            store = _with(store, entry)
            if entry.value != mine.value:
                news[entry.variable] = entry
    return store, list(news.values()), refused


def later_entries(store: SharedStore, stamps: tuple[Stamp, ...]) -> tuple[Entry, ...]:
    """The entries that are later than these stamps, one for each variable."""
    return tuple(entry for entry, stamp in zip(store.entries, stamps, strict=False) if entry.stamp >= stamp)


def digest(store: SharedStore) -> int:
    """48 bits that differ when copies differ."""
    return int.from_bytes(blake2b(json.dumps(store.entries).encode(), digest_size=6).digest())


def _with(store: SharedStore, entry: Entry) -> SharedStore:
    at = entry.variable
    return replace(store, entries=(*store.entries[:at], entry, *store.entries[at + 1 :]))
