"""The rows of a study as columns, block by block of their files: for numbers over very many of them.

Only what numbers are made of is read of a line, and of lines that were read before not even that (`column_file`). So
this is many times as quick as row by row. A row that stands twice comes once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby
from operator import attrgetter
from pathlib import Path
from typing import Annotated, Any

from kitrobot.experiments.column_file import ColumnFile, Columns, ColumnWriter
from kitrobot.experiments.plan import Plan
from kitrobot.experiments.study_folder import no_row, read_row, row_blocks, row_files

try:
    import msgspec
except ImportError:  # a page has none, and few rows
    HAS_MSGSPEC = False
else:
    HAS_MSGSPEC = True

WORTH_KEEPING = 8 << 20
"""Bytes of lines for which a column file is made: those of some ten thousand rows."""


def row_columns(folder: Path, plan: Plan) -> Iterator[Columns]:
    """The rows of a study, each once; those of a file in the order in which they were written.

    Raises:
        ExperimentError: a line is no row of this study.
    """
    seen = bytearray(plan.rows)
    read = _reader(folder, plan)
    for path in row_files(folder):
        for columns in _columns_of(path, plan, read):
            yield _once(columns, seen)


def keep_columns(folder: Path, plan: Plan, file: str) -> None:
    """Makes the column file of a file of rows if it is worth it, so that the next one to ask has it.

    Raises:
        ExperimentError: a line is no row of this study.
    """
    if _is_growing(folder / file, 0):
        for _ in _columns_of(folder / file, plan, _reader(folder, plan)):
            pass


def _columns_of(path: Path, plan: Plan, read: Callable[[bytes], Columns]) -> Iterator[Columns]:
    """The rows of one file, those that its column file has first; makes that anew where it is worth it."""
    with ColumnFile(path, plan) as kept:
        yield from kept
        if not _is_growing(path, kept.covered):
            yield from map(read, row_blocks(path, kept.covered))
            return
        with ColumnWriter(kept) as writer:
            for block in row_blocks(path, kept.covered):
                columns = read(block)
                writer.add(block, columns)
                yield columns
            writer.finish()


def _is_growing(path: Path, covered: int) -> bool:
    """Whether a file is so much longer than its columns, of so many bytes, that they are worth writing: so all that is
    ever written is a few times the last.
    """
    try:
        return path.stat().st_size - covered > max(WORTH_KEEPING, covered // 2)
    except OSError:
        return False  # Told when it is read.


def point_stretches(numbers: Sequence[int], seeds: int) -> Iterator[tuple[int, slice]]:
    """The points of rows, by the numbers of these, and where those of each stand, one after another.

    Args:
        numbers: of rows in the plan.
        seeds: rows of a point.
    """
    if isinstance(numbers, range):
        for at in range(numbers.start // seeds, -(-numbers.stop // seeds)):
            first, end = max(at * seeds, numbers.start), min((at + 1) * seeds, numbers.stop)
            yield at, slice(first - numbers.start, end - numbers.start)
        return
    begin = 0
    for at, group in groupby(numbers, lambda number: number // seeds):
        end = begin + sum(1 for _ in group)
        yield at, slice(begin, end)
        begin = end


def _reader(folder: Path, plan: Plan) -> Callable[[bytes], Columns]:
    """What makes columns of lines; it raises an ExperimentError for a line that is no row of this study."""
    if not HAS_MSGSPEC:
        return lambda block: _read_plainly(block, plan, folder)
    names = [f"m{at}" for at in range(len(plan.measured))]
    measured: Any = msgspec.defstruct(
        "Measured",
        [(name, int | float | None, None) for name in names],
        rename=dict(zip(names, plan.measured, strict=True)),
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

    def read(block: bytes) -> Columns:
        try:
            rows = decoder.decode_lines(block)
        except (msgspec.DecodeError, RecursionError):
            raise no_row(_first_refused(block, decoder), folder) from None
        found = [row.measures for row in rows]
        columns = [list(map(attrgetter(name), found)) for name in names]
        return Columns([row.row for row in rows], [row.outcome for row in rows], columns)

    return read


def _read_plainly(block: bytes, plan: Plan, folder: Path) -> Columns:
    rows = [read_row(line, plan, folder) for line in block.splitlines(keepends=True)]
    measures = [[row.get("measures", {}).get(name) for row in rows] for name in plan.measured]
    return Columns([row["row"] for row in rows], [row["outcome"] for row in rows], measures)


def _first_refused(block: bytes, decoder: Any) -> bytes:
    for line in block.splitlines(keepends=True):
        try:
            decoder.decode(line)
        except (msgspec.DecodeError, RecursionError):
            return line
    return block


def _once(columns: Columns, seen: bytearray) -> Columns:
    """Those rows that were not there before, nor before in these."""
    first = columns.numbers[0] if columns.numbers else 0
    numbers = range(first, first + len(columns.numbers))
    if 1 not in seen[first : numbers.stop] and columns.numbers == list(numbers):
        # One follows another, as nearly always.
        seen[first : numbers.stop] = b"\1" * len(numbers)
        return Columns(numbers, columns.outcomes, columns.measures)
    fresh = []
    for at, number in enumerate(columns.numbers):
        if not seen[number]:
            seen[number] = 1
            fresh.append(at)
    if len(fresh) == len(columns.numbers):
        return columns
    return Columns(
        [columns.numbers[at] for at in fresh],
        [columns.outcomes[at] for at in fresh],
        [[column[at] for at in fresh] for column in columns.measures],
    )
