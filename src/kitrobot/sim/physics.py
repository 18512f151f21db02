"""One step of all robots: wheels roll, robots move along their roads or freely, what touches is parted and counted.

Holds the lists that the loops of motion and contacts work in, and the pairs that touch now, so that one contact is one
collision however long it lasts. A step in which nothing rolls or turns costs next to nothing.
"""

from __future__ import annotations

from kitrobot.sim.bodies import Bodies, Ways
from kitrobot.sim.contacts import (
    measure_gaps,
    part_discs,
    part_from_walls,
    part_on_roads,
    sort_along,
    sort_by_x,
)
from kitrobot.sim.devices import Stage
from kitrobot.sim.motion import follow, place, roll, wander


class Physics:
    """The moving part of a stage. `rolling` is how many robots moved in the last step."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.bodies: Bodies = stage.bodies
        self.ways: Ways = stage.ways
        bodies = stage.bodies
        count = len(bodies)
        self.rolling = 0
        self.collisions = 0
        self._way = [0.0] * count
        self._leader = [-1] * count
        self._guided = [robot for robot in range(count) if bodies.solid[robot] and bodies.road[robot] >= 0]
        self._solid = [robot for robot in range(count) if bodies.solid[robot]]
        self._free = len(self._solid) > len(self._guided)
        self._widest = max((bodies.radius[robot] for robot in self._solid), default=0.0)
        self._discs = self._free or len({bodies.road[robot] for robot in self._guided}) > 1
        self._pairs = [0] * (2 * (8 * count + 64))
        self._touching: set[tuple[int, int]] = set()
        self._measure()
        self._place()

    def step(self, dt: float) -> list[tuple[int, int]]:
        """Moves everything by one step; gives the pairs (robot, other; a wall w is -1 - w) that have begun to touch."""
        bodies = self.bodies
        self.rolling = roll(dt, bodies.speed, bodies.target, bodies.acceleration, bodies.braking, self._way)
        if self.rolling == 0 and not (self._free and any(bodies.turn)):
            return []
        touching: list[tuple[int, int]] = []
        if self._guided:
            ways = self.ways
            follow(self._way, bodies.speed, bodies.road, bodies.at, ways.length, ways.closed)
            self._measure()
            room = len(self._pairs) // 2
            count = part_on_roads(
                self._guided,
                bodies.road,
                bodies.at,
                bodies.speed,
                ways.length,
                ways.closed,
                bodies.gap_ahead,
                self._leader,
                self._pairs,
                room,
            )
            if count:
                self._take(count, touching)
                self._measure()
            self._place()
        if self._free:
            wander(self._way, bodies.turn, bodies.road, bodies.x, bodies.y, bodies.heading)
            self._part_from_walls(touching)
        if self._discs:
            self._part_discs(touching)
        return self._news(touching)

    def _measure(self) -> None:
        bodies, ways = self.bodies, self.ways
        sort_along(self._guided, bodies.road, bodies.at)
        measure_gaps(
            self._guided,
            bodies.road,
            bodies.at,
            bodies.length,
            ways.length,
            ways.closed,
            bodies.gap_ahead,
            bodies.gap_behind,
            self._leader,
        )

    def _place(self) -> None:
        bodies, ways = self.bodies, self.ways
        place(
            bodies.road,
            bodies.at,
            bodies.stretch,
            bodies.x,
            bodies.y,
            bodies.heading,
            ways.x,
            ways.y,
            ways.along,
            ways.heading_from,
            ways.heading_to,
            ways.first,
            ways.last,
        )

    def _part_from_walls(self, touching: list[tuple[int, int]]) -> None:
        bodies, stage = self.bodies, self.stage
        count = part_from_walls(
            bodies.road,
            bodies.solid,
            bodies.x,
            bodies.y,
            bodies.radius,
            stage.wall_x1,
            stage.wall_y1,
            stage.wall_x2,
            stage.wall_y2,
            self._pairs,
            len(self._pairs) // 2,
        )
        self._take(count, touching)

    def _part_discs(self, touching: list[tuple[int, int]]) -> None:
        bodies = self.bodies
        sort_by_x(self._solid, bodies.x)
        count = part_discs(
            self._solid,
            self._widest,
            bodies.road,
            bodies.x,
            bodies.y,
            bodies.radius,
            self._pairs,
            len(self._pairs) // 2,
        )
        self._take(count, touching)

    def _take(self, count: int, touching: list[tuple[int, int]]) -> None:
        pairs = self._pairs
        touching += [(pairs[2 * k], pairs[2 * k + 1]) for k in range(min(count, len(pairs) // 2))]

    def _news(self, touching: list[tuple[int, int]]) -> list[tuple[int, int]]:
        if not touching and not self._touching:
            return []
        now = set(touching)
        news = sorted(now - self._touching)
        flags = self.bodies.touching
        for robot, other in self._touching:
            flags[robot] = 0
            if other >= 0:
                flags[other] = 0
        for robot, other in now:
            flags[robot] = 1
            if other >= 0:
                flags[other] = 1
        self._touching = now
        self.collisions += len(news)
        return news
