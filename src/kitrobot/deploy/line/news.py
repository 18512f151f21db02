"""Messages that a board sends unrequested (docs/reference/link.md): changes of its program, faults, text."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.text.sentences import Sentence, Word

NO_INSTRUCTION = 65535
FAULTS = {
    0: Word("none"),
    1: Sentence("a driver failed"),
    2: Sentence("a device did not say that it is done in its time"),
    3: Sentence("the board ran out of memory"),
    4: Sentence("the program file is damaged or cannot be read"),
    5: Sentence("a driver is missing or does not start"),
    6: Sentence("the link was lost during a run that hangs on it"),
}


@dataclass(frozen=True)
class News:
    """Changes: cells' values, the place of each slot (None: not running), and which instructions ran.

    `state` and `late` as in `Hello`; None: the board does not report them by itself.
    """

    tick: int
    cells: Mapping[int, int]
    threads: Mapping[int, int | None]
    ran: frozenset[int] = frozenset()
    state: int | None = None
    late: int | None = None

    @property
    def is_empty(self) -> bool:
        """Whether nothing changed but the tick."""
        return not (self.cells or self.threads or self.ran)


@dataclass(frozen=True)
class Fault:
    """Why a board stopped; `instruction` None: none is to blame."""

    number: int
    instruction: int | None
    tick: int
    text: str

    @property
    def meaning(self) -> str:
        """The meaning of the number."""
        return FAULTS.get(self.number, Sentence("fault {number}, which this KitRobot does not know", self.number))


@dataclass(frozen=True)
class Text:
    """Text that a board printed."""

    text: str


def read_fault(payload: bytes) -> Fault:
    """Reads F; one that cannot be read is none."""
    try:
        number, instruction, tick = struct.unpack("<BHI", payload[:7])
    except struct.error:
        return Fault(0, None, 0, "")
    at = None if instruction == NO_INSTRUCTION else instruction
    return Fault(number, at, tick, payload[7:].decode(errors="replace"))


_RECORDS = {ord("c"): 6, ord("t"): 4, ord("r"): 3, ord("s"): 4}
"""Bytes of each kind of record in T."""


def read_news(payload: bytes) -> News:
    """Reads T; what a later version may add at its end is left out."""
    state = late = None
    cells: dict[int, int] = {}
    threads: dict[int, int | None] = {}
    ran = set()
    tick = struct.unpack("<I", payload[:4])[0] if len(payload) >= 4 else 0
    at = 4
    while at < len(payload):
        kind, size = chr(payload[at]), _RECORDS.get(payload[at], 0)
        if not size or at + size > len(payload):
            break
        record = payload[at + 1 : at + size]
        if kind == "c":
            cell, value = struct.unpack("<Bi", record)
            cells[cell] = value
        elif kind == "t":
            slot, instruction = struct.unpack("<BH", record)
            threads[slot] = None if instruction == NO_INSTRUCTION else instruction
        elif kind == "s":
            state, late = struct.unpack("<BH", record)
        else:
            ran.add(struct.unpack("<H", record)[0])
        at += size
    return News(tick, cells, threads, frozenset(ran), state, late)


def printable(data: bytes) -> str:
    """The text of bytes; empty when it is noise or only white space."""
    try:
        text = data.decode().replace("\r\n", "\n")
    except UnicodeDecodeError:
        return ""
    if not text.strip() or not all(sign.isprintable() or sign in "\n\t" for sign in text):
        return ""
    return text
