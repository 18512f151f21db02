"""Scripted inputs: a CSV table that says what a robot senses, tick by tick.

    tick,Captor,done:Motor
    0,40,
    12,8,0

The header names the columns: `tick`, then sensors (`Captor`) and devices' done flags (`done:Motor`). A row holds from
its tick on; an empty cell changes nothing. Representation: the changes of each tick, in the order of the rows;
nothing in them is unknown or out of order. Numbers are kept as written: the machine clamps them to the sensor's
range. A tolerant reader of the format itself: byte order mark, any line ends, quoted cells, spaces around cells and
blank lines are fine.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from kitrobot.diagnostics.model import Diagnostic, Severity, Source, rule
from kitrobot.primitives.robot import Robot
from kitrobot.text.forms import name_form, number_form
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import Suggestions

HEADER = rule(
    "inputs-header",
    Severity.ERROR,
    "The table of inputs has no header",
    "The first line of a table of inputs names its columns: `tick` and then sensors or `done:ACTUATOR`.",
)
UNKNOWN = rule(
    "inputs-unknown-name",
    Severity.ERROR,
    "A column is no input of the robot",
    "Every column after `tick` is the name of a sensor, or `done:` and the name of an actuator.",
)
TWICE = rule(
    "inputs-column-twice",
    Severity.ERROR,
    "Two columns have one name",
    "Each input has one column, so that a row can say one thing about it.",
)
CELLS = rule(
    "inputs-cells",
    Severity.ERROR,
    "A row has too few or too many cells",
    "Every row has as many cells as the header; a cell may be empty.",
)
NUMBER = rule(
    "inputs-number",
    Severity.ERROR,
    "A cell is not a whole number",
    "Ticks are whole numbers from 0, sensors take whole numbers, `done:` takes 0 or 1.",
)
ORDER = rule(
    "inputs-tick-order",
    Severity.ERROR,
    "The ticks are out of order",
    "The rows of a table of inputs go forward in time.",
)
REPEATED = rule(
    "inputs-tick-twice",
    Severity.WARNING,
    "Two rows have one tick",
    "Both rows hold from that tick on; where both fill a cell, the later row wins.",
)

DONE = "done:"
_CELL = re.compile(r'[ \t]*(?:"((?:[^"]|"")*)"[ \t]*|([^,]*))(?=,|$)')
_NUMBER = re.compile(r"[+-]?[0-9]{1,18}")


@dataclass(frozen=True)
class Change:
    """One cell: from its tick on, this input (a sensor's, or an actuator's done flag) is `value`."""

    name: str
    done: bool
    value: int


@dataclass(frozen=True)
class Inputs:
    """What changes in which tick; empty when nothing is scripted."""

    changes: Mapping[int, tuple[Change, ...]] = field(default_factory=dict)

    def at(self, tick: int) -> tuple[Change, ...]:
        """What changes in this tick."""
        return self.changes.get(tick, ())


@dataclass(frozen=True)
class _Cell:
    text: str
    start: int
    end: int


def read_inputs(text: str, name: str, robot: Robot) -> tuple[Inputs, list[Diagnostic]]:
    """The table in `text`, checked against the robot; what is wrong is told, and the rest is still read."""
    source = Source(name, text)
    problems: list[Diagnostic] = []
    rows = _rows(text)
    header = next(rows, None)
    if header is None or header[0].text != "tick":
        problems.append(_header_problem(source, header))
        return Inputs(), problems
    names = _Names(robot)
    columns = [_column(source, cell, names, problems) for cell in header[1:]]
    seen: set[str] = set()
    for cell in header[1:]:
        if cell.text and cell.text in seen:
            place = source.place(cell.start, cell.end)
            problems.append(TWICE(Sentence("The column `{cell}` stands here a second time", cell.text), place))
        seen.add(cell.text)
    changes: dict[int, list[Change]] = {}
    last = -1
    for row in rows:
        if len(row) != len(header):
            place = source.place(row[0].start, row[-1].end)
            count = Sentence("{count} cell{what}", len(row), "s" if len(row) != 1 else "")
            problems.append(
                CELLS(Sentence("this row has {count}, the header has {count_2}", count, len(header)), place)
            )
            continue
        tick = _number(source, row[0], Sentence("a tick"), 0, None, problems)
        if tick is None:
            continue
        if tick < last:
            message = Sentence("tick {tick} comes after tick {last}", tick, last)
            problems.append(
                ORDER(message, source.place(row[0].start, row[0].end), help=Sentence("sort the rows by their tick"))
            )
            continue
        if tick == last:
            message = Sentence("tick {tick} stands in two rows; where both fill a cell, this one wins", tick)
            problems.append(REPEATED(message, source.place(row[0].start, row[0].end)))
        last = tick
        made = changes.setdefault(tick, [])
        for cell, column in zip(row[1:], columns, strict=True):
            if not cell.text or column is None:
                continue
            input_name, done = column
            value = _number(
                source, cell, Sentence("0 or 1") if done else Sentence("a whole number"), *_bounds(done), problems
            )
            if value is not None:
                made.append(Change(input_name, done, value))
    return Inputs({tick: tuple(made) for tick, made in changes.items()}), problems


def _rows(text: str) -> Iterator[list[_Cell]]:
    """The lines that hold something, as cells with their offsets."""
    for line in re.finditer(r"[^\r\n]+", text):
        if not line.group().strip():
            continue
        cells: list[_Cell] = []
        at = line.start()
        while True:
            match = _CELL.match(text, at, line.end())
            assert match is not None  # the plain cell takes whatever stands before a comma or the end
            quoted, plain = match.groups()
            raw, end = plain if quoted is None else quoted.replace('""', '"'), match.end()
            # The place of a cell is what it shows, without the spaces around it.
            shown = text[at:end]
            start = at + len(shown) - len(shown.lstrip())
            cells.append(_Cell(name_form(raw.strip()), start, max(start, at + len(shown.rstrip()))))
            if end >= line.end():
                break
            at = end + 1
        yield cells


def _header_problem(source: Source, header: list[_Cell] | None) -> Diagnostic:
    help = Sentence("begin the file with a line such as `tick,Captor,done:Motor`")
    if header is None:
        return HEADER(Sentence("the table of inputs is empty"), source.place(0, 0), help=help)
    first = header[0]
    if ";" in first.text:
        help = Sentence("separate the cells with commas, not with semicolons")
    elif "\t" in first.text:
        help = Sentence("separate the cells with commas, not with tabs")
    message = Sentence("the first column should be `tick`, found `{first}`", first.text[:40])
    return HEADER(message, source.place(first.start, first.end), help=help)


class _Names:
    """What the columns of a robot's table of inputs may be called."""

    def __init__(self, robot: Robot) -> None:
        self.robot = robot.name
        self.sensors = {part.name for part in robot.sensors}
        self.actuators = {part.name for part in robot.actuators}
        self.columns = [part.name for part in robot.sensors] + [DONE + part.name for part in robot.actuators]
        self.suggestions = Suggestions()


def _column(source: Source, cell: _Cell, names: _Names, problems: list[Diagnostic]) -> tuple[str, bool] | None:
    """(input, whether it is a done flag) of a column, or None when the robot has no such input."""
    done = cell.text.startswith(DONE)
    wanted = cell.text.removeprefix(DONE).strip() if done else cell.text
    if wanted in (names.actuators if done else names.sensors):
        return wanted, done
    near = names.suggestions.nearest(cell.text, names.columns)
    if near:
        help = Sentence("did you mean `{near}`?", near)
    elif names.columns:
        help = Sentence("known: {columns}", listed(f"`{name}`" for name in names.columns))
    else:
        help = Sentence("this robot has no inputs")
    what = "actuator" if done else "sensor"
    message = Sentence("the robot `{robot}` has no {what} `{wanted}`", names.robot, what, wanted)
    problems.append(UNKNOWN(message, source.place(cell.start, cell.end), help=help))
    return None


def _bounds(done: bool) -> tuple[int | None, int | None]:
    return (0, 1) if done else (None, None)


def _number(
    source: Source, cell: _Cell, what: str, least: int | None, most: int | None, problems: list[Diagnostic]
) -> int | None:
    if _NUMBER.fullmatch(cell.text):
        value = int(cell.text)
        if (least is None or value >= least) and (most is None or value <= most):
            return value
    found = f"`{cell.text[:40]}`" if cell.text else Sentence("an empty cell")
    figures = number_form(cell.text)
    help: Help = ""
    if figures != cell.text and _NUMBER.fullmatch(figures):
        help = Sentence("files have their numbers in the digits 0 to 9: write {number}", figures)
    place = source.place(cell.start, cell.end)
    problems.append(NUMBER(Sentence("expected {what}, found {found}", what, found), place, help=help))
    return None
