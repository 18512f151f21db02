"""Whether robots start apart from one another and from the walls."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.mission.model import Team
from kitrobot.sim.physics.grids import cell_at, fixed
from kitrobot.sim.setup import rules
from kitrobot.sim.setup.initial_state import Tables
from kitrobot.sim.setup.world_tables import wall_rows
from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables.columns import AT, FREE, LENGTH, RADIUS, ROAD, SOLID, X, Y
from kitrobot.text.sentences import COMMA, Help, Sentence, Series
from kitrobot.world.geometry import distance_to_stretch
from kitrobot.world.model import World

MAX_OVERLAPS = 100
"""So many robots in one another's way are told at most; there may be millions of pairs."""


@dataclass(frozen=True)
class StartPlaces:
    """The places at which the robots of a run start; the tables have all of them."""

    world: World
    team: Team
    agents: Sequence[Agent]
    tables: Tables
    free_starts: Sequence[str]

    def problems(self) -> list[Diagnostic]:
        """Robots start apart from one another and from the walls."""
        ints = self.tables.ints
        solid = [robot for robot in range(len(self.agents)) if ints[SOLID][robot]]
        return [*self._in_walls(solid), *islice(self._in_one_place(solid), MAX_OVERLAPS)]

    def _in_walls(self, solid: Sequence[int]) -> Iterator[Diagnostic]:
        floats, ints, walls = self.tables.floats, self.tables.ints, wall_rows(self.world)
        grid = fixed(walls, max((floats[RADIUS][robot] for robot in solid), default=0.0))
        for robot in solid if self.world.walls else ():
            x, y = floats[X][robot], floats[Y][robot]
            cell = cell_at(x, y, grid)
            if ints[ROAD][robot] != FREE or cell < 0:
                continue
            near = grid.items[grid.starts[cell] : grid.starts[cell + 1]]
            ways = (distance_to_stretch(x, y, *(row[wall] for row in walls))[0] for wall in near)
            if any(way < floats[RADIUS][robot] for way in ways):
                message = Sentence("{agent} starts in a wall", self.agents[robot].name)
                help = Sentence("move its start away from the wall")
                yield self._at_start(robot, rules.START(message, help=help))

    def _in_one_place(self, solid: Sequence[int]) -> Iterator[Diagnostic]:
        floats = self.tables.floats
        size = max((floats[LENGTH][robot] for robot in solid), default=0.0)
        cells: defaultdict[tuple[int, int], list[int]] = defaultdict(list)
        for robot in solid:
            column, row = math.floor(floats[X][robot] / size), math.floor(floats[Y][robot] / size)
            for near in ((column + dx, row + dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)):
                for other in cells.get(near, ()):
                    if self._overlap(robot, other):
                        names = self.agents[other].name, self.agents[robot].name
                        message = Sentence("{agent} and {other} start in the same place", *names)
                        yield self._at_start(robot, rules.START(message, help=self._apart(other, robot)))
            cells[column, row].append(robot)

    def _start_of(self, robot: int) -> str:
        """The name of the start at which a robot stands."""
        name = self.agents[robot].name
        return next((one.start_name for one in self.team.agents if one.name == name), name)

    def _at_start(self, robot: int, item: Diagnostic) -> Diagnostic:
        """The same, about the start of that robot."""
        name = self._start_of(robot)
        at = next((at for at, start in enumerate(self.world.starts) if start.name == name), None)
        return item if at is None else replace(item, thing=f"start:{at}")

    def _apart(self, one: int, other: int) -> Help:
        first, second = self._start_of(one), self._start_of(other)
        if first != second:
            return Sentence("move one of the two: their starts are {first} and {second}", first, second)
        free = self.free_starts
        if not free:
            return Sentence("every start of this world is taken: add one to it, or take an agent out of the team")
        return Sentence("give one of them a start that is free: {free}", Series(COMMA, free[:20]))

    def _overlap(self, robot: int, other: int) -> bool:
        floats, road = self.tables.floats, self.tables.ints[ROAD]
        if road[robot] != FREE and road[robot] == road[other]:
            line = self.world.roads[road[robot]].line
            way = abs(floats[AT][robot] - floats[AT][other])
            if line.closed:
                way = min(way, line.length_mm - way)
            return way < (floats[LENGTH][robot] + floats[LENGTH][other]) / 2
        away = math.hypot(floats[X][robot] - floats[X][other], floats[Y][robot] - floats[Y][other])
        return away < floats[RADIUS][robot] + floats[RADIUS][other]
