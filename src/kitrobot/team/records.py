"""Records that travel: values whose bytes are JSON arrays of their fields, and that are read by the types of these."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, Struct

LARGEST = 1 << 53

Number = Annotated[int, Meta(ge=-LARGEST, le=LARGEST)]
Numbers = tuple[Number, ...]


class Record(Struct, frozen=True, array_like=True, forbid_unknown_fields=True):
    """A frozen value; exactly its fields are read, and nothing of another type."""


class TaggedRecord(Record, frozen=True, tag=True):
    """One of several records: the name of its class is before its fields."""
