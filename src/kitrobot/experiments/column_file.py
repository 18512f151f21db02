"""The columns of a file of rows, kept beside it, so that very many lines are read once and not again.

The lines are the truth. A column file (`rows.columns` of `rows.jsonl`) says of how many bytes of them it was made and
what their checksum is; whoever reads it looks whether these bytes are still the same, and its own numbers are whole.
Where they are not, or the study is another, it counts as if it were not there, and is made anew. It holds pieces, then
what is said of them in JSON, how long that is (8 bytes, little-endian) and the checksum of all of it (4). A piece is
the number of its rows (8), then of these rows the number in the plan (int64), that of the outcome among those that the
JSON names (a byte), and each measure (float64, NaN for nothing), as the machine has them.
"""

from __future__ import annotations

import hashlib
import math
import os
import sys
from array import array
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO
from zlib import crc32

from kitrobot.experiments.meters import Number
from kitrobot.experiments.plan import Plan
from kitrobot.text.json_text import from_json, to_json

FORMAT = 1
_PIECE = 1 << 20
_MOST_OUTCOMES = 256
_SUM, _WORD = 4, 8


@dataclass(frozen=True, slots=True)
class Columns:
    """Some rows: of each its number in the plan and its outcome, and a column for each measure of the plan. A column
    that is an array has a number for each row.
    """

    numbers: Sequence[int]
    outcomes: Sequence[str]
    measures: Sequence[Sequence[Number]]


class ColumnFile:
    """The columns that are kept of the first bytes of a file of rows; `with` it.

    Args:
        rows: the file of rows.
        plan: their study.

    Attributes:
        covered: of how many bytes of the file it has the rows.
    """

    def __init__(self, rows: Path, plan: Plan) -> None:
        self._rows, self._measures = rows, len(plan.measured)
        self.path = rows.with_suffix(".columns")
        study = hashlib.sha256(plan.to_toml().encode()).hexdigest()
        self._identity = {"format": FORMAT, "order": sys.byteorder, "study": study}
        self.covered = self.sum = self._length = 0
        self._file: BinaryIO | None = None
        self.outcomes: dict[str, int] = {}
        self.has_gaps = [False for _ in plan.measured]
        # Whatever is wrong with it: the lines are there.
        with suppress(OSError, ValueError, KeyError, TypeError):
            self._read_head()

    def __iter__(self) -> Iterator[Columns]:
        """The rows that it has, some at a time."""
        outcomes, file = list(self.outcomes), self._file
        if file is None:
            return
        file.seek(0)
        while file.tell() < self._length:
            count = int.from_bytes(file.read(_WORD), "little")
            numbers, ends = _array("q", count, file), _array("B", count, file)
            columns = [_array("d", count, file) for _ in range(self._measures)]
            yield Columns(
                numbers.tolist(),
                [outcomes[end] for end in ends],
                [
                    [None if number != number else number for number in column] if gaps else column
                    for column, gaps in zip(columns, self.has_gaps, strict=True)
                ],
            )

    def pieces(self) -> Iterator[bytes]:
        """The bytes of what it has."""
        if self._file is not None:
            self._file.seek(0)
            left = self._length
            while left and (piece := self._file.read(min(_PIECE, left))):
                left -= len(piece)
                yield piece

    def __enter__(self) -> ColumnFile:
        return self

    def __exit__(self, *raised: object) -> None:
        if self._file is not None:
            self._file.close()

    def head(self, covered: int, sum_of_rows: int) -> bytes:
        """What is said of the pieces for so many bytes of rows with that checksum."""
        said = {**self._identity, "covered": covered, "sum": sum_of_rows}
        return to_json(said | {"outcomes": list(self.outcomes), "gaps": self.has_gaps})

    def _read_head(self) -> None:
        with ExitStack() as stack:
            file = stack.enter_context(self.path.open("rb"))
            size = file.seek(0, os.SEEK_END)
            found = _sum_of(file, size - _SUM)
            file.seek(size - _SUM - _WORD)
            length = int.from_bytes(file.read(_WORD), "little")
            if int.from_bytes(file.read(_SUM), "little") != found:
                return
            file.seek(size - _SUM - _WORD - length)
            head = from_json(file.read(length))
            if {name: head[name] for name in self._identity} != self._identity:
                return
            with self._rows.open("rb") as rows:
                if _sum_of(rows, head["covered"]) != head["sum"]:
                    return
            self.covered, self.sum, self._length = head["covered"], head["sum"], size - _SUM - _WORD - length
            self.outcomes = {outcome: number for number, outcome in enumerate(head["outcomes"])}
            self.has_gaps = head["gaps"]
            # Another one may take the place of its name meanwhile.
            self._file = file
            stack.pop_all()


class ColumnWriter:
    """Writes a column file anew: what it has, and the rows that are added. Where the disk refuses, there is none.

    `with` it; the file is put in its place by `finish`.
    """

    def __init__(self, kept: ColumnFile) -> None:
        self._kept = kept
        self._covered, self._sum_of_rows, self._sum = kept.covered, kept.sum, 0
        # Two that write at once spoil each other's file, its checksum says so, and it is made anew.
        self._name = kept.path.with_name(f"{kept.path.name}.new")
        self._out: BinaryIO | None = None
        with suppress(OSError):
            self._out = self._name.open("wb")
        for piece in kept.pieces():
            self._write(piece)

    def add(self, block: bytes, columns: Columns) -> None:
        """Takes in the rows of the bytes that follow."""
        outcomes = self._kept.outcomes
        for outcome in dict.fromkeys(columns.outcomes):
            outcomes.setdefault(outcome, len(outcomes))
        if len(outcomes) > _MOST_OUTCOMES:
            self._give_up()
            return
        self._write(len(columns.numbers).to_bytes(_WORD, "little"))
        self._write(array("q", columns.numbers))
        self._write(array("B", [outcomes[outcome] for outcome in columns.outcomes]))
        for at, measured in enumerate(columns.measures):
            self._kept.has_gaps[at] = self._kept.has_gaps[at] or None in measured
            self._write(array("d", [math.nan if number is None else number for number in measured]))
        self._covered += len(block)
        self._sum_of_rows = crc32(block, self._sum_of_rows)

    def finish(self) -> None:
        """Puts the file in its place."""
        said = self._kept.head(self._covered, self._sum_of_rows)
        self._write(said)
        self._write(len(said).to_bytes(_WORD, "little"))
        self._write(self._sum.to_bytes(_SUM, "little"))
        if self._out is not None:
            try:
                self._out.close()
                os.replace(self._name, self._kept.path)
                self._out = None
            except OSError:
                self._give_up()

    def __enter__(self) -> ColumnWriter:
        return self

    def __exit__(self, *raised: object) -> None:
        self._give_up()

    def _write(self, data: bytes | array[Any]) -> None:
        if self._out is None:
            return
        self._sum = crc32(data, self._sum)
        try:
            self._out.write(data)
        except OSError:
            self._give_up()

    def _give_up(self) -> None:
        if self._out is not None:
            with suppress(OSError):
                self._out.close()
            with suppress(OSError):
                self._name.unlink()
            self._out = None


def _array(kind: str, count: int, file: BinaryIO) -> array[Any]:
    """The next numbers of a file."""
    made = array(kind)
    made.frombytes(file.read(count * made.itemsize))
    return made


def _sum_of(file: BinaryIO, length: int) -> int | None:
    """The checksum of the first bytes of a file; None where there are not so many."""
    found = 0
    file.seek(0)
    while length > 0 and (piece := file.read(min(_PIECE, length))):
        found = crc32(piece, found)
        length -= len(piece)
    return None if length else found
