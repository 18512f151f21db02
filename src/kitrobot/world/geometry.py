"""Where things are along a line: corners rounded into arcs, a point and a heading at so many mm, the way back to mm.

A `Polyline` is flat tuples, one entry a sampled point: `xs`, `ys` (mm), `along` (mm from the first point, measured on
the true arcs, so the length of a rounded corner is r·θ), and for each stretch between two points the heading (rad) at
its start and at its end. Arcs are sampled so finely that a chord leaves its arc by at most `SAGITTA_MM`. A closed line
ends with its first point again. Headings are unwrapped within a stretch: they may be blended.

Left to others: what a line means (model), and moving along it tick by tick (sim).
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, field

from kitrobot.text.sentences import Sentence
from kitrobot.world.limits import Coordinate, Length

SAGITTA_MM = 0.05
"""How far a sampled chord may leave its arc."""

MAX_ARC_POINTS = 256
"""Samples of one corner at most, however large its radius is."""


@dataclass(frozen=True)
class Pose:
    """A place and a direction: mm, and radians counter-clockwise from +x in (-π, π]."""

    x_mm: float
    y_mm: float
    heading_rad: float


@dataclass(frozen=True)
class Corner:
    """A point of a line as people give it; a radius rounds it off."""

    x_mm: Coordinate = field(metadata={"alias": "x"})
    y_mm: Coordinate = field(metadata={"alias": "y"})
    radius_mm: Length = field(default=0.0, metadata={"alias": "radius"})


def normalised(angle_rad: float) -> float:
    """The same direction in (-π, π]."""
    wrapped = math.remainder(angle_rad, math.tau)
    return math.pi if wrapped == -math.pi else wrapped


def distance_to_stretch(x_mm: float, y_mm: float, x1: float, y1: float, x2: float, y2: float) -> tuple[float, float]:
    """From a point to the stretch between two others: (distance in mm, nearest part of the stretch, 0…1)."""
    dx, dy = x2 - x1, y2 - y1
    squared = dx * dx + dy * dy
    part = 0.0 if squared == 0 else min(1.0, max(0.0, ((x_mm - x1) * dx + (y_mm - y1) * dy) / squared))
    return math.hypot(x_mm - x1 - part * dx, y_mm - y1 - part * dy), part


def cut_mm(before: Corner, corner: Corner, after: Corner) -> float:
    """How much of both neighbouring stretches the rounding of a corner takes; infinite for a turn on the spot."""
    if corner.radius_mm <= 0:
        return 0.0
    turn = abs(_turn(before, corner, after))
    if turn < 1e-9:
        return 0.0
    if turn > math.pi - 1e-6:
        return math.inf
    return corner.radius_mm * math.tan(turn / 2)


def _turn(before: Corner, corner: Corner, after: Corner) -> float:
    arriving = math.atan2(corner.y_mm - before.y_mm, corner.x_mm - before.x_mm)
    leaving = math.atan2(after.y_mm - corner.y_mm, after.x_mm - corner.x_mm)
    return normalised(leaving - arriving)


@dataclass(frozen=True)
class Polyline:
    """A sampled line; see the head of the module."""

    xs: tuple[float, ...]
    ys: tuple[float, ...]
    along: tuple[float, ...]
    heading_from: tuple[float, ...]
    heading_to: tuple[float, ...]
    closed: bool

    @property
    def length_mm(self) -> float:
        """The whole length; for a closed line, once round."""
        return self.along[-1]

    def wrapped(self, at_mm: float) -> float:
        """`at_mm` brought into 0…length: round and round on a closed line, held at the ends of an open one."""
        if self.closed:
            at_mm = math.fmod(at_mm, self.length_mm)
            return at_mm + self.length_mm if at_mm < 0 else at_mm
        return min(max(at_mm, 0.0), self.length_mm)

    def pose_at(self, at_mm: float) -> Pose:
        """Point and heading so many mm along."""
        at_mm = self.wrapped(at_mm)
        stretch = min(bisect_right(self.along, at_mm), len(self.along) - 1) - 1
        start, end = self.along[stretch], self.along[stretch + 1]
        part = (at_mm - start) / (end - start)
        heading = self.heading_from[stretch] + part * (self.heading_to[stretch] - self.heading_from[stretch])
        return Pose(
            self.xs[stretch] + part * (self.xs[stretch + 1] - self.xs[stretch]),
            self.ys[stretch] + part * (self.ys[stretch + 1] - self.ys[stretch]),
            normalised(heading),
        )

    def nearest(self, x_mm: float, y_mm: float) -> tuple[float, float]:
        """(mm along of the nearest point, distance to it in mm); the first of several that are as near."""
        best_at, best = 0.0, math.inf
        for stretch in range(len(self.xs) - 1):
            distance, part = distance_to_stretch(
                x_mm, y_mm, self.xs[stretch], self.ys[stretch], self.xs[stretch + 1], self.ys[stretch + 1]
            )
            if distance < best:
                best = distance
                best_at = self.along[stretch] + part * (self.along[stretch + 1] - self.along[stretch])
        return self.wrapped(best_at), best


def polyline(corners: Sequence[Corner], closed: bool) -> Polyline:
    """The sampled line through `corners`.

    Raises:
        ValueError: fewer than two different neighbouring points, or a radius for which there is no room.
    """
    if len(corners) < (3 if closed else 2):
        raise ValueError(Sentence("a line needs two points, a closed one three"))
    count = len(corners)
    cuts: list[float] = []
    for index, corner in enumerate(corners):
        inner = closed or 0 < index < count - 1
        cuts.append(cut_mm(corners[index - 1], corner, corners[(index + 1) % count]) if inner else 0.0)
    path = _Path()
    for index in range(count if closed else count - 1):
        here, there = corners[index], corners[(index + 1) % count]
        length = math.hypot(there.x_mm - here.x_mm, there.y_mm - here.y_mm)
        if length < 1e-6:
            raise ValueError(Sentence("two neighbouring points are the same"))
        first, last = cuts[index], length - cuts[(index + 1) % count]
        if last - first < -1e-6:
            raise ValueError(Sentence("there is no room for this radius"))
        ux, uy = (there.x_mm - here.x_mm) / length, (there.y_mm - here.y_mm) / length
        heading = math.atan2(uy, ux)
        if not path.xs:
            path.start(here.x_mm + first * ux, here.y_mm + first * uy)
        path.straight(here.x_mm + last * ux, here.y_mm + last * uy, heading)
        if cuts[(index + 1) % count] > 0:
            following = corners[(index + 2) % count]
            path.arc(heading, _turn(here, there, following), there.radius_mm)
    return Polyline(
        tuple(path.xs), tuple(path.ys), tuple(path.along), tuple(path.heading_from), tuple(path.heading_to), closed
    )


class _Path:
    """The lists a polyline is made of, while they grow."""

    def __init__(self) -> None:
        self.xs: list[float] = []
        self.ys: list[float] = []
        self.along: list[float] = []
        self.heading_from: list[float] = []
        self.heading_to: list[float] = []

    def start(self, x_mm: float, y_mm: float) -> None:
        self.xs.append(x_mm)
        self.ys.append(y_mm)
        self.along.append(0.0)

    def _go(self, x_mm: float, y_mm: float, length_mm: float, heading_from: float, heading_to: float) -> None:
        self.xs.append(x_mm)
        self.ys.append(y_mm)
        self.along.append(self.along[-1] + length_mm)
        self.heading_from.append(heading_from)
        self.heading_to.append(heading_to)

    def straight(self, x_mm: float, y_mm: float, heading: float) -> None:
        length = math.hypot(x_mm - self.xs[-1], y_mm - self.ys[-1])
        if length > 1e-6:
            self._go(x_mm, y_mm, length, heading, heading)

    def arc(self, heading: float, turn: float, radius_mm: float) -> None:
        step = 2 * math.acos(max(0.0, 1 - SAGITTA_MM / radius_mm))
        count = max(2, min(MAX_ARC_POINTS, math.ceil(abs(turn) / step)))
        side = math.copysign(radius_mm, turn)
        centre_x = self.xs[-1] - side * math.sin(heading)
        centre_y = self.ys[-1] + side * math.cos(heading)
        for number in range(1, count + 1):
            before, after = heading + turn * (number - 1) / count, heading + turn * number / count
            x_mm, y_mm = centre_x + side * math.sin(after), centre_y - side * math.cos(after)
            self._go(x_mm, y_mm, radius_mm * abs(turn) / count, before, after)
