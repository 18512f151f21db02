"""What pens drew in a run: the corners of their lines, in the order in which they were drawn.

Where a pen is and how it is stands in every record of a trace; `DrawingReader` finds from that what was drawn, and the
simulator finds the same in its step (see strokes). What was drawn up to a tick is a beginning of the whole list, so
going back is cutting it, and who has been told some of it is told how much stays and what comes next.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from operator import attrgetter
from typing import NamedTuple

from kitrobot.trace import strokes
from kitrobot.trace.model import POSE_WORDS, TickRecord, TraceHeader

MOST_MARKS = 100_000
"""Corners that are kept of a run; what is drawn after that is not."""

PEN = "pen "
"""Columns of a trace that begin so, with the name of the pen, are its numbers: whether it is down, colour and width."""
PEN_NUMBERS = 3

MOST_COLOUR = 7
MOST_WIDTH_MM = 100
_FAR = 1 << 30
_SPAN = 1 << 31


class Pen(NamedTuple):
    """A pen: the place of its agent in the team, and the name of the actuator."""

    agent: int
    name: str


class Mark(NamedTuple):
    """A point of a line, in tenths of a mm: `what` is GOES_ON, BEGINS or ENDS (see strokes).

    `tick` is the first record that knows of it, `pen` its number, `colour` 0…7 and `width` in mm those of the stroke.
    """

    tick: int
    pen: int
    what: int
    x: int
    y: int
    colour: int
    width: int


@dataclass(frozen=True)
class Stroke:
    """A line of one pen, points in mm."""

    pen: int
    colour: int
    width_mm: int
    points: tuple[tuple[float, float], ...]


class News(NamedTuple):
    """Of a list that somebody was told before, the first `keep` stay, and `marks` come after them."""

    keep: int
    marks: Sequence[Mark]


class Drawing:
    """What the pens of a run drew so far. `full` says that not all of it could be kept."""

    def __init__(self, pens: Sequence[Pen] = ()) -> None:
        self.pens = tuple(pens)
        self.marks: list[Mark] = []
        self.full = False
        self._told = 0
        self._is_other = False
        """Whether something that was told is drawn no more."""

    def add(self, marks: Iterable[Mark]) -> None:
        """Goes on; ticks never shrink."""
        for mark in marks:
            if len(self.marks) >= MOST_MARKS:
                self.full = True
                return
            self.marks.append(mark)

    def forget_after(self, tick: int) -> None:
        """What was drawn after a tick is drawn no more: another future begins there."""
        count = self.count(tick)
        if count < len(self.marks):
            del self.marks[count:]
            self.full = False
        self._is_other |= count < self._told
        self._told = min(self._told, count)

    def count(self, tick: int) -> int:
        """How many marks there are up to a tick."""
        return bisect_right(self.marks, tick, key=attrgetter("tick"))

    def until(self, tick: int) -> list[Mark]:
        """The marks up to a tick."""
        return self.marks[: self.count(tick)]

    def news(self, tick: int) -> News | None:
        """What is to be told to somebody who was told all news so far and stands at a tick now; None for nothing."""
        count, told = self.count(tick), self._told
        if count == told and not self._is_other:
            return None
        keep, self._told, self._is_other = min(told, count), count, False
        return News(keep, self.marks[keep:count])

    def strokes(self, tick: int, places: Mapping[int, tuple[float, float]]) -> list[Stroke]:
        """The lines up to a tick, in the order in which they began.

        Args:
            tick: the last one that counts.
            places: for each agent where it is at that tick, in mm: a pen that is down there has drawn as far.
        """
        found: list[tuple[Mark, list[tuple[float, float]]]] = []
        drawn: dict[int, list[tuple[float, float]]] = {}
        for mark in self.until(tick):
            place = mark.x / 10, mark.y / 10
            if mark.what == strokes.BEGINS:
                drawn[mark.pen] = [place]
                found.append((mark, drawn[mark.pen]))
            elif mark.pen in drawn:
                drawn[mark.pen].append(place)
                if mark.what == strokes.ENDS:
                    del drawn[mark.pen]
        if not self.full:
            for pen, points in drawn.items():
                place = places.get(self.pens[pen].agent, points[-1])
                points.append((round(place[0], 1), round(place[1], 1)))
        return [Stroke(mark.pen, mark.colour, mark.width, _without_repeats(points)) for mark, points in found]


def _without_repeats(points: list[tuple[float, float]]) -> tuple[tuple[float, float], ...]:
    """A dot has one point."""
    return tuple(point for at, point in enumerate(points) if at == 0 or point != points[at - 1])


def marks_of(tick: int, pen: int, made: int, style: int, before: int, x: int, y: int) -> list[Mark]:
    """What a step made of a point, as marks; `style` is that of the pen now, `before` that before the step."""
    found = []
    for what, worn in ((strokes.ENDS, before), (strokes.GOES_ON, style), (strokes.BEGINS, style)):
        if made & what and worn != strokes.UP:
            found.append(Mark(tick, pen, what, x, y, (worn - 1) % strokes.COLOURS, (worn - 1) // strokes.COLOURS))
    return found


def packed(x: float, y: float) -> int:
    """A point in tenths of a mm as one number; further than 100 km is as far as that."""
    column = min(max(int(x), -_FAR), _FAR - 1) + _FAR
    row = min(max(int(y), -_FAR), _FAR - 1) + _FAR
    return column * _SPAN + row


def unpacked(number: int) -> tuple[int, int]:
    """The point of such a number."""
    return number // _SPAN - _FAR, number % _SPAN - _FAR


class DrawingReader:
    """Finds what was drawn from the records of a run, one after another; `has_pens` says whether there is anything."""

    def __init__(self, header: TraceHeader) -> None:
        agents = {agent.name: number for number, agent in enumerate(header.agents)}
        names = [(column.owner, column.name) for column in header.columns]
        xs = {owner: at for at, (owner, name) in enumerate(names) if name == POSE_WORDS[0]}
        pens: list[Pen] = []
        self._places: list[tuple[int, int]] = []
        for at, (owner, name) in enumerate(names):
            pen = name.removeprefix(PEN).removesuffix(" 0")
            wanted = [(owner, f"{PEN}{pen} {number}") for number in range(PEN_NUMBERS)]
            if owner in xs and owner in agents and names[at : at + PEN_NUMBERS] == wanted:
                pens.append(Pen(agents[owner], pen))
                self._places.append((at, xs[owner]))
        self.drawing = Drawing(pens)
        self.tick = -1
        """The tick of the last record that it was given."""
        self._rows = [[0.0] * strokes.ROW for _ in pens]

    @property
    def has_pens(self) -> bool:
        """Whether anybody has a pen."""
        return bool(self._rows)

    def take(self, record: TickRecord) -> None:
        """The next record."""
        first = self.tick < 0
        self.tick = record.tick
        numbers = record.numbers
        for pen, (row, (start, at)) in enumerate(zip(self._rows, self._places, strict=True)):
            x, y = (float(min(max(number, -_FAR), _FAR - 1)) for number in numbers[at : at + 2])
            if first:
                row[strokes.AT_X], row[strokes.AT_Y] = x, y
                continue
            down, colour, width = numbers[start : start + PEN_NUMBERS]
            style = strokes.style_of(
                1 if down else 0, min(max(colour, 0), MOST_COLOUR), min(max(width, 1), MOST_WIDTH_MM)
            )
            px, py, before = int(row[strokes.AT_X]), int(row[strokes.AT_Y]), int(row[strokes.STYLE])
            made = strokes.extend_stroke(row, style, x, y)
            if made:
                self.drawing.add(marks_of(record.tick, pen, made, style, before, px, py))
