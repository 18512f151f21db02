"""The tables of what stands still: roads, docks, walls, lines and floors of a world."""

from __future__ import annotations

from kitrobot.sim.physics.grids import fixed
from kitrobot.sim.tables.state import Docks, Floors, Lines, Roads, Walls
from kitrobot.world.model import COLOURS, World


def dock_tables(world: World, goals: list[list[int]]) -> Docks:
    """Docks and storehouses, with these goals: storehouses, and how many boxes each is to hold."""
    names = [road.name for road in world.roads]
    return Docks(
        floats=[[dock.at_mm for dock in world.docks], [dock.reach_mm for dock in world.docks]],
        road=[names.index(dock.road) for dock in world.docks],
        stock=[house.stock for house in world.storehouses],
        capacity=[house.capacity for house in world.storehouses],
        goals=goals,
    )


def wall_tables(world: World, margin: float) -> Walls:
    """Walls; the cells of their grid hold all that come nearer to them than `margin` (mm)."""
    walls = wall_rows(world)
    return Walls(walls, fixed(walls, margin))


def road_tables(world: World) -> Roads:
    """Roads. The last point of one is inclusive, the last of its sections exclusive."""
    made = Roads([[], [], [], [], []], [], [[], [], [], [], []], [], [])
    for road in world.roads:
        line = road.line
        points, cuts = len(made.points[0]), len(made.cut_from)
        headings = (*line.heading_from, line.heading_to[-1]), (*line.heading_to, line.heading_to[-1])
        for row, numbers in zip(made.points, (line.xs, line.ys, line.along, *headings), strict=True):
            row += numbers
        made.cut_from.extend(section.from_mm for section in road.sections)
        made.cut_sign.extend(section.sign for section in road.sections)
        numbers_of = (1 if road.closed else 0, points, len(made.points[0]) - 1, cuts, len(made.cut_from))
        for ints, number in zip(made.ints, numbers_of, strict=True):
            ints.append(number)
        made.length.append(line.length_mm)
    return made


def line_tables(world: World) -> Lines:
    """Coloured lines, in straight stretches."""
    stretches: list[list[float]] = [[], [], [], [], []]
    colours: list[int] = []
    for coloured in world.lines:
        xs, ys = coloured.line.xs, coloured.line.ys
        for row, numbers in zip(stretches, (xs[:-1], ys[:-1], xs[1:], ys[1:]), strict=False):
            row += numbers
        stretches[4] += [coloured.width_mm / 2] * (len(xs) - 1)
        colours += [COLOURS[coloured.colour]] * (len(xs) - 1)
    return Lines(stretches, colours, fixed(stretches, max(stretches[4], default=0.0)))


def floor_tables(world: World) -> Floors:
    """Coloured floors."""
    made = Floors([[], [], []], [[], [], [], []], [[], []])
    for floor in world.floors:
        xs, ys = floor.line.xs, floor.line.ys
        first = len(made.points[0])
        for ints, number in zip(made.ints, (COLOURS[floor.colour], first, first + len(xs) - 1), strict=True):
            ints.append(number)
        for row, side in zip(made.box, (min(xs), min(ys), max(xs), max(ys)), strict=True):
            row.append(side)
        made.points[0].extend(xs)
        made.points[1].extend(ys)
    return made


def wall_rows(world: World) -> list[list[float]]:
    """The walls as rows x1, y1, x2, y2."""
    return [
        [wall.x1_mm for wall in world.walls],
        [wall.y1_mm for wall in world.walls],
        [wall.x2_mm for wall in world.walls],
        [wall.y2_mm for wall in world.walls],
    ]
