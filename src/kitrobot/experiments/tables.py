"""The rows of a study as a table: CSV here, Arrow and Parquet through arro3 (`kitrobot[data]`).

Columns: `row`, `id`, `seed`, what varies by its address, `outcome`, `sentence`, `seconds`, and what is measured by its
name; one of these with the name of a column before it has `measure ` in front. Rows are in the order of the plan.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.study_rows import StudyRow, StudyRows
from kitrobot.text.sentences import Sentence

if TYPE_CHECKING:
    from kitrobot.experiments.plan import Plan

_BEFORE = ("row", "id", "seed")
_BEHIND = ("outcome", "sentence", "seconds")


def column_names(plan: Plan) -> list[str]:
    """The columns, in their order."""
    names = [*_BEFORE, *plan.addresses, *_BEHIND]
    return [*names, *(f"measure {name}" if name in names else name for name in plan.measured if name != "seconds")]


def row_values(plan: Plan, row: StudyRow) -> list[Any]:
    """A row, column by column."""
    values: list[Any] = [row.number, row.id, row.seed, *(row.point.get(name) for name in plan.addresses)]
    values += [row.outcome, row.sentence, row.seconds]
    return values + [row.measures.get(name) for name in plan.measured if name != "seconds"]


def write_csv(study: StudyRows, out: TextIO) -> None:
    """The table as CSV (RFC 4180 with plain line breaks): a line of names, then a line for each row."""
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(column_names(study.plan))
    for row in study.rows:
        writer.writerow(["" if value is None else value for value in row_values(study.plan, row)])


def arrow_table(study: StudyRows) -> Any:
    """The table as an `arro3.core.Table`.

    Raises:
        KitRobotError: arro3 is not installed.
    """
    core = _arro3("core")
    names, plan = column_names(study.plan), study.plan
    columns: list[list[Any]] = [[] for _ in names]
    for row in study.rows:
        for column, value in zip(columns, row_values(plan, row), strict=True):
            column.append(value)
    return core.Table.from_arrays([core.Array(column, type=_kind(core, column)) for column in columns], names=names)


def write_parquet(study: StudyRows, file: Path) -> None:
    """The table as a Parquet file.

    Raises:
        KitRobotError: arro3 is not installed.
    """
    _arro3("io").write_parquet(arrow_table(study), str(file))


def _kind(core: Any, column: Sequence[Any]) -> Any:
    """Of a column the narrowest type that holds all of it; of numbers and words together, words."""
    kinds = {type(value) for value in column if value is not None}
    if str in kinds:
        column[:] = [None if value is None else str(value) for value in column]  # type: ignore[index]
        return core.DataType.utf8()
    if float in kinds:
        return core.DataType.float64()
    return core.DataType.int64() if int in kinds or bool in kinds else core.DataType.float64()


def _arro3(module: str) -> Any:
    from importlib import import_module

    try:
        return import_module(f"arro3.{module}")
    except ImportError as error:
        raise KitRobotError(
            Sentence("Parquet and Arrow need arro3, which is not installed"),
            Sentence("install it: {command}", '`pip install "kitrobot[data]"`'),
        ) from error


def text_lines(rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """Cells as columns for people: words to the left, numbers to the right."""
    table = [list(row) for row in rows]
    widths = [max(len(row[at]) for row in table) for at in range(len(table[0]))] if table else []
    for row in table:
        cells = [
            cell.rjust(width) if at and _is_number(cell) else cell.ljust(width)
            for at, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        yield "  ".join(cells).rstrip()


def _is_number(cell: str) -> bool:
    return cell.replace(".", "", 1).removeprefix("-").isdecimal()
