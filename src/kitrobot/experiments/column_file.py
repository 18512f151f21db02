"""The columns of a file of rows, kept beside it, so that very many lines are read once and not again.

The lines are the truth. A column file (`rows.columns` of `rows.jsonl`) says of how many bytes of them it was made and
what their checksum is; whoever reads it looks whether these bytes are still the same, and its own numbers are whole.
Where they are not, or the study is another, it counts as if it were not there, and is made anew. Its bytes: how long
its head is (8, little-endian), the head in JSON, then of all rows the number in the plan (int64), the number of the
outcome among those in the head (a byte), and each measure (float64, NaN for nothing), as the machine has them; in the
end their checksum (4).
"""

from __future__ import annotations

import hashlib
import math
import sys
from array import array
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from zlib import crc32

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.meters import Number
from kitrobot.experiments.plan import Plan
from kitrobot.files.disk import write_atomic
from kitrobot.text.json_text import from_json, to_json

FORMAT = 1
_PIECE = 1 << 20
_ROWS = 1 << 15
"""Rows that are given at once."""
_MOST_OUTCOMES = 256


@dataclass(frozen=True, slots=True)
class Columns:
    """Some rows: of each its number in the plan and its outcome, and a column for each measure of the plan. A column
    that is an array has a number for each row.
    """

    numbers: Sequence[int]
    outcomes: Sequence[str]
    measures: Sequence[Sequence[Number]]


class ColumnFile:
    """The columns of the first bytes of a file of rows: those that are kept, and more as they are added.

    Args:
        rows: the file of rows.
        plan: their study.

    Attributes:
        covered: of how many bytes of the file it has the rows.
    """

    def __init__(self, rows: Path, plan: Plan) -> None:
        self._rows, self._plan = rows, plan
        self._path = rows.with_suffix(".columns")
        self.covered = self._sum = 0
        self._outcomes: dict[str, int] = {}
        self._numbers, self._ends = array("q"), array("B")
        self._measures = [array("d") for _ in plan.measured]
        self._has_gaps = [False for _ in plan.measured]
        # Whatever is wrong with it: the lines are there.
        with suppress(OSError, ValueError, KeyError, TypeError):
            self._read()

    def __iter__(self) -> Iterator[Columns]:
        """The rows that it has, some at a time."""
        outcomes = list(self._outcomes)
        for begin in range(0, len(self._numbers), _ROWS):
            part = slice(begin, begin + _ROWS)
            yield Columns(
                self._numbers[part].tolist(),
                [outcomes[end] for end in self._ends[part]],
                [
                    [None if number != number else number for number in column[part]] if gaps else column[part]
                    for column, gaps in zip(self._measures, self._has_gaps, strict=True)
                ],
            )

    def add(self, block: bytes, columns: Columns) -> None:
        """Takes in the rows of the bytes that follow those that it covers."""
        for outcome in dict.fromkeys(columns.outcomes):
            self._outcomes.setdefault(outcome, len(self._outcomes))
        if len(self._outcomes) <= _MOST_OUTCOMES:
            self._ends.extend([self._outcomes[outcome] for outcome in columns.outcomes])
        self._numbers.extend(columns.numbers)
        for at, measured in enumerate(columns.measures):
            self._has_gaps[at] = self._has_gaps[at] or None in measured
            self._measures[at].extend([math.nan if number is None else number for number in measured])
        self.covered += len(block)
        self._sum = crc32(block, self._sum)

    def write(self) -> None:
        """Keeps it on the disk, if that can be."""
        if len(self._outcomes) > _MOST_OUTCOMES:
            return
        head = {**self._identity, "covered": self.covered, "sum": self._sum, "rows": len(self._numbers)}
        said = to_json(head | {"outcomes": list(self._outcomes), "gaps": self._has_gaps})
        parts: list[bytes | array[Any]] = [len(said).to_bytes(8, "little"), said, *self._columns]
        found = 0
        for part in parts:
            found = crc32(part, found)
        with suppress(OSError, KitRobotError):
            write_atomic(self._path, b"".join([*parts, found.to_bytes(4, "little")]))

    @property
    def _columns(self) -> list[array[Any]]:
        return [self._numbers, self._ends, *self._measures]

    @property
    def _identity(self) -> dict[str, Any]:
        study = hashlib.sha256(self._plan.to_toml().encode()).hexdigest()
        return {"format": FORMAT, "order": sys.byteorder, "study": study}

    def _read(self) -> None:
        whole = memoryview(self._path.read_bytes())
        data = whole[:-4]
        if crc32(data) != int.from_bytes(whole[-4:], "little"):
            return
        begin = 8 + int.from_bytes(data[:8], "little")
        head, body = from_json(bytes(data[8:begin])), data[begin:]
        identity, count = self._identity, head["rows"]
        if {name: head[name] for name in identity} != identity or self._sum_of(head["covered"]) != head["sum"]:
            return
        self.covered, self._sum = head["covered"], head["sum"]
        self._outcomes = {outcome: number for number, outcome in enumerate(head["outcomes"])}
        self._has_gaps = head["gaps"]
        at = 0
        for column in self._columns:
            end = at + count * column.itemsize
            column.frombytes(body[at:end])
            at = end

    def _sum_of(self, length: int) -> int | None:
        """The checksum of the first bytes of the file; None where there are not so many."""
        found = 0
        with self._rows.open("rb") as file:
            while length and (piece := file.read(min(_PIECE, length))):
                found = crc32(piece, found)
                length -= len(piece)
        return None if length else found
