"""A table of boxes that robots push, in pymunk (Chipmunk, a physics engine in C): nothing turns, as in ours.

Kind to pymunk: bodies that rest sleep, it has no programs, no sensors and no trace, its robots are kinematic (nothing
holds them up, they do not touch one another) and everything but turning them back is done in C.
"""

from __future__ import annotations

import math

import pymunk

from benchmarks.table import BACK_STEPS, BOX_MM, RADIUS_MM, SIZE_MM, SPEED_MM_S, boxes, robots

NAME = f"pymunk {pymunk.version}"
STEP_S = 0.02
_LEFT = 1e-4
"""Of a speed, after a second: nearly nothing, as boxes slide hardly."""


class Table:
    """So many boxes and robots, and walls around."""

    def __init__(self, box_count: int, robot_count: int) -> None:
        self.space = pymunk.Space()
        self.space.sleep_time_threshold = 0.1
        self.space.damping = _LEFT
        ends = [(0.0, 0.0), (SIZE_MM, 0.0), (SIZE_MM, SIZE_MM), (0.0, SIZE_MM)]
        for one, other in zip(ends, ends[1:] + ends[:1], strict=True):
            self.space.add(pymunk.Segment(self.space.static_body, one, other, 1.0))
        for place in boxes(box_count):
            body = pymunk.Body(0.2, math.inf)
            body.position = place
            self.space.add(body, pymunk.Poly.create_box(body, (BOX_MM, BOX_MM)))
        self.robots = []
        for x, y, heading in robots(robot_count):
            body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
            body.position = x, y
            body.velocity = SPEED_MM_S * math.cos(heading), SPEED_MM_S * math.sin(heading)
            self.space.add(body, pymunk.Circle(body, RADIUS_MM))
            self.robots.append(body)
        self.done = 0

    def go(self, steps: int) -> None:
        """So many steps."""
        for _ in range(steps):
            self.space.step(STEP_S)
            self.done += 1
            if self.done % BACK_STEPS == 0:
                for body in self.robots:
                    body.velocity = -body.velocity
