"""The rows of a study as columns, block by block of their files: for numbers over very many of them.

Only what is asked of a row is made of its line, so this is several times as quick as row by row, and takes no more
memory however many rows there are. A row that stands twice comes once.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby
from operator import attrgetter
from pathlib import Path
from typing import Annotated, Any

import msgspec

from kitrobot.experiments.meters import Number
from kitrobot.experiments.plan import Plan
from kitrobot.experiments.study_folder import no_row, row_blocks


@dataclass(frozen=True, slots=True)
class RowBlock:
    """Some rows: of each its number in the plan and its outcome, and a column for each measure that was asked for."""

    numbers: Sequence[int]
    outcomes: Sequence[str]
    measures: Sequence[Sequence[Number]]

    def stretches(self, size: int) -> Iterator[tuple[int, slice]]:
        """Where rows one after another have the same number divided by `size`; that number, and their places."""
        numbers = self.numbers
        if isinstance(numbers, range):
            for at in range(numbers.start // size, -(-numbers.stop // size)):
                first, end = max(at * size, numbers.start), min((at + 1) * size, numbers.stop)
                yield at, slice(first - numbers.start, end - numbers.start)
            return
        begin = 0
        for at, group in groupby(numbers, lambda number: number // size):
            end = begin + sum(1 for _ in group)
            yield at, slice(begin, end)
            begin = end


def row_columns(folder: Path, plan: Plan, measures: Sequence[str] = ()) -> Iterator[RowBlock]:
    """The rows of a study, each once, in the order in which they were written.

    Args:
        folder: where it is.
        plan: the study.
        measures: the names of what is asked of them.

    Raises:
        ExperimentError: a line is no row of this study.
    """
    names = [f"m{at}" for at in range(len(measures))]
    measured: Any = msgspec.defstruct(
        "Measured",
        [(name, int | float | None, None) for name in names],
        rename=dict(zip(names, measures, strict=True)),
        gc=False,
    )
    line: Any = msgspec.defstruct(
        "Line",
        [
            ("row", Annotated[int, msgspec.Meta(ge=0, lt=plan.rows)]),
            ("outcome", str),
            ("measures", measured, msgspec.field(default_factory=measured)),
        ],
        gc=False,
    )
    decoder = msgspec.json.Decoder(line)
    seen = bytearray(plan.rows)
    for block in row_blocks(folder):
        try:
            rows = decoder.decode_lines(block)
        except (msgspec.DecodeError, RecursionError):
            raise no_row(_first_refused(block, decoder), folder) from None
        numbers = _fresh(rows, seen)
        if numbers is None:
            rows = _once(rows, seen)
            numbers = [row.row for row in rows]
        found = [row.measures for row in rows]
        yield RowBlock(numbers, [row.outcome for row in rows], [list(map(attrgetter(name), found)) for name in names])


def _fresh(rows: Sequence[Any], seen: bytearray) -> range | None:
    """The numbers of rows of which one follows another, as they nearly always do; None where one does not, or was
    there before.
    """
    first = rows[0].row if rows else 0
    numbers = range(first, first + len(rows))
    if 1 in seen[first : numbers.stop] or [row.row for row in rows] != list(numbers):
        return None
    seen[first : numbers.stop] = b"\1" * len(rows)
    return numbers


def _once(rows: Sequence[Any], seen: bytearray) -> list[Any]:
    """Those that were not there before, nor before in these."""
    fresh = []
    for row in rows:
        if not seen[row.row]:
            seen[row.row] = 1
            fresh.append(row)
    return fresh


def _first_refused(block: bytes, decoder: Any) -> bytes:
    for line in block.splitlines(keepends=True):
        try:
            decoder.decode(line)
        except (msgspec.DecodeError, RecursionError):
            return line
    return block
