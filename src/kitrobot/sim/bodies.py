"""All robots at once: one flat list a quantity, one entry a robot, in the order of the team.

Lengths in mm, speeds in mm/s, angles in rad. `road` is the number of the road that guides the robot, or -1 for one
that moves freely; then `at` (mm along) and `stretch` (which piece of the sampled road) mean nothing. `target` is the
speed the wheels are told, `speed` the speed they have; `turn` is how far the robot turns in this step. `gap_ahead`
and `gap_behind` are the free lengths to the next robot on the same road (infinite without one), bumper to bumper. The
functions that work on these lists know nothing but numbers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from kitrobot.world import Pose, Road

FREE = -1


class Bodies:
    """The lists; `add` appends one robot to each."""

    def __init__(self) -> None:
        self.x: list[float] = []
        self.y: list[float] = []
        self.heading: list[float] = []
        self.speed: list[float] = []
        self.target: list[float] = []
        self.acceleration: list[float] = []
        self.braking: list[float] = []
        self.turn: list[float] = []
        self.length: list[float] = []
        self.radius: list[float] = []
        self.solid: list[int] = []
        self.road: list[int] = []
        self.at: list[float] = []
        self.stretch: list[int] = []
        self.gap_ahead: list[float] = []
        self.gap_behind: list[float] = []
        self.touching: list[int] = []
        self.bed: list[int] = []
        self.load: list[int] = []
        self.lamp: list[int] = []
        self.arm: list[int] = []
        self.alarm: list[int] = []

    def __len__(self) -> int:
        return len(self.x)

    def add(self, pose: Pose) -> int:
        """A robot without wheels, without size, at a place; its devices give it more."""
        for numbers in (self.x, self.y, self.heading, self.speed, self.target, self.turn, self.length, self.radius):
            numbers.append(0.0)
        for counts in (self.solid, self.stretch, self.touching, self.bed, self.load, self.lamp, self.arm, self.alarm):
            counts.append(0)
        self.x[-1], self.y[-1], self.heading[-1] = pose.x_mm, pose.y_mm, pose.heading_rad
        self.acceleration.append(1.0)
        self.braking.append(1.0)
        self.road.append(FREE)
        self.at.append(0.0)
        self.gap_ahead.append(math.inf)
        self.gap_behind.append(math.inf)
        return len(self.x) - 1


class Ways:
    """All roads in flat lists: road r has the points `first[r]`…`last[r]` and the sections
    `cut_first[r]`…`cut_last[r]`.

    The last index is exclusive for sections and, for points, the last point itself. A road without sections has none.
    """

    def __init__(self, roads: Sequence[Road]) -> None:
        self.x: list[float] = []
        self.y: list[float] = []
        self.along: list[float] = []
        self.heading_from: list[float] = []
        self.heading_to: list[float] = []
        self.first: list[int] = []
        self.last: list[int] = []
        self.length: list[float] = []
        self.closed: list[int] = []
        self.cut_from: list[float] = []
        self.cut_sign: list[int] = []
        self.cut_first: list[int] = []
        self.cut_last: list[int] = []
        for road in roads:
            line = road.line
            self.first.append(len(self.x))
            self.x += line.xs
            self.y += line.ys
            self.along += line.along
            self.heading_from += (*line.heading_from, line.heading_to[-1])
            self.heading_to += (*line.heading_to, line.heading_to[-1])
            self.last.append(len(self.x) - 1)
            self.length.append(line.length_mm)
            self.closed.append(1 if road.closed else 0)
            self.cut_first.append(len(self.cut_from))
            self.cut_from += [section.from_mm for section in road.sections]
            self.cut_sign += [section.sign for section in road.sections]
            self.cut_last.append(len(self.cut_from))
