"""Discrete roads: zones, and classes of the gap between two robots, one behind the other.

A road is cut into zones where the value of a sensor may change: at the borders of its sections (as far ahead as the
sensor looks) and at the ends of docks. The position of a robot within its zone is left open. The gap from bumper to
bumper is in one of a few classes: pressed, touching, one for each reach of a collision sensor, beyond. Which gaps are
possible between two zones follows from geometry and is computed here once.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from kitrobot.sim.physics.wall_contacts import TOUCH_MM

PRESSED, TOUCHING = range(2)
"""The classes of a gap between two touching robots: no gap, so that the one behind cannot roll, and a small one."""

_NONE_MM = 1e-6


@dataclass(frozen=True)
class Zones:
    """The zones of one road.

    Attributes:
        begins: where each begins, mm along the road, ascending; the first is 0.
        length_mm: the length of the road.
        closed: whether the last zone is followed by the first one.
    """

    begins: tuple[float, ...]
    length_mm: float
    closed: bool

    def __len__(self) -> int:
        return len(self.begins)

    def zone_at(self, at_mm: float) -> int:
        """The zone of a place along the road, 0 to its length."""
        return max(0, bisect_right(self.begins, at_mm) - 1)

    def ends(self, zone: int) -> tuple[float, float]:
        """The start and end of a zone, mm."""
        return self.begins[zone], self.begins[zone + 1] if zone + 1 < len(self.begins) else self.length_mm

    def size(self, zone: int) -> float:
        """The length of a zone, mm."""
        begin, end = self.ends(zone)
        return end - begin

    def next(self, zone: int, way: int) -> int:
        """The zone ahead (`way` 1) or behind (-1); -1 where the road ends."""
        found = zone + way
        if self.closed:
            return found % len(self.begins)
        return found if 0 <= found < len(self.begins) else -1

    def between(self, zone: int, ahead: int) -> tuple[float, float]:
        """The shortest and longest way from a zone to the one `ahead` zones further, mm along the road."""
        if ahead == 0:
            return 0.0, self.size(zone)
        first, last = self.size(zone), self.size((zone + ahead) % len(self.begins))
        if self.closed and ahead == len(self.begins):
            return self.length_mm - first, self.length_mm
        least = sum(self.size((zone + n) % len(self.begins)) for n in range(1, ahead))
        return least, least + first + last


@dataclass(frozen=True)
class Gaps:
    """The classes of a gap: pressed, touching (up to `TOUCH_MM`), one up to each reach, and the last one beyond.

    Attributes:
        reaches: the ranges of the collision sensors of the two robots, mm, ascending, each once.
        lengths_mm: half of the length of both robots together.
    """

    reaches: tuple[float, ...]
    lengths_mm: float

    @property
    def beyond(self) -> int:
        """The class of a gap that no sensor reaches over."""
        return len(self.reaches) + 2

    def limits(self, gap: int) -> tuple[float, float]:
        """The lower and upper limit of a class, mm."""
        borders = (-math.inf, _NONE_MM, TOUCH_MM, *self.reaches, math.inf)
        return borders[gap], borders[gap + 1]

    def class_of(self, gap_mm: float) -> int:
        """The class of a gap."""
        return next(gap for gap in range(self.beyond + 1) if gap_mm <= self.limits(gap)[1])

    def reached(self, gap: int, reach_mm: float) -> bool:
        """Whether a sensor with this range notices a robot at a gap of this class."""
        return gap <= TOUCHING or self.limits(gap)[1] <= reach_mm


@dataclass(frozen=True)
class Track:
    """One robot's road.

    Attributes:
        zones: the zones of its road.
        gaps: the classes of the gap to the robot ahead.
        braking_mm: the most it rolls from a reading that lets it brake until it stands.
        tick_mm: the most it rolls from one tick of its own to the next.
    """

    zones: Zones
    gaps: Gaps
    braking_mm: float
    tick_mm: float


def possible(zones: Zones, gaps: Gaps, zone: int, ahead: int) -> tuple[bool, ...]:
    """For each class, whether the gap from a robot in `zone` to one `ahead` zones further can be in it."""
    return _fitting(gaps, *zones.between(zone, ahead))


def _fitting(gaps: Gaps, least_way: float, most_way: float) -> tuple[bool, ...]:
    least, most = least_way - gaps.lengths_mm, most_way - gaps.lengths_mm
    found = []
    for gap in range(gaps.beyond + 1):
        low, high = gaps.limits(gap)
        # A robot that came too near is put back to a gap of 0.
        found.append(max(least, 0.0) <= high and most >= max(low, 0.0))
    return tuple(found)


def possible_everywhere(zones: Zones, gaps: Gaps) -> list[bool]:
    """`possible` of each zone, each number of zones ahead up to a lap, and each class, one after another."""
    count = len(zones)
    sizes = [zones.size(zone) for zone in range(count)]
    found: list[bool] = []
    for zone in range(count):
        least = 0.0
        for ahead in range(count + 1):
            if ahead == 0 or (zones.closed and ahead == count):
                found += possible(zones, gaps, zone, ahead)
                continue
            if ahead > 1:
                least += sizes[(zone + ahead - 1) % count]
            found += _fitting(gaps, least, least + sizes[zone] + sizes[(zone + ahead) % count])
    return found


def zones_of(length_mm: float, closed: bool, cuts: Iterable[float]) -> Zones:
    """The zones of a road that is cut at these places; on a closed one a place may be before 0 or beyond the end."""
    begins = {0.0}
    for cut in cuts:
        at = cut % length_mm if closed else cut
        if 0.0 < at < length_mm:
            begins.add(at)
    return Zones(tuple(sorted(begins)), length_mm, closed)


def in_order(places: Sequence[float]) -> list[int]:
    """The numbers of places in the order along a road."""
    return sorted(range(len(places)), key=places.__getitem__)
