"""The tables of pushable objects, and the grid in which those close to one another are found."""

from __future__ import annotations

import math

from kitrobot.sim.physics.grids import fixed
from kitrobot.sim.tables.state import Grid, Pushables, Walls
from kitrobot.world.model import World

(
    PUSH_X,
    PUSH_Y,
    PUSH_VX,
    PUSH_VY,
    PUSH_OLD_X,
    PUSH_OLD_Y,
    PUSH_HALF_WIDTH,
    PUSH_HALF_HEIGHT,
    PUSH_INVERSE_MASS,
    PUSH_DECELERATION,
) = range(10)
"""Rows of an object's numbers: its middle, speed, position before the step, half its width and height, 1 / mass, and by
how much friction slows it in a step, in mm/s."""
PUSH_IS_BALL, PUSH_AWAKE, PUSH_CELL = range(3)

GRAVITY = 9810.0
"""mm/s²."""


def pushable_tables(world: World, dt: float) -> Pushables:
    """The boxes and then the balls of a world."""
    boxes = [
        (one.x_mm, one.y_mm, one.width_mm / 2, one.height_mm / 2, one.mass_g, one.friction, 0) for one in world.boxes
    ]
    balls = [(one.x_mm, one.y_mm, one.radius_mm, one.radius_mm, one.mass_g, one.friction, 1) for one in world.balls]
    floats: list[list[float]] = [[] for _ in range(10)]
    ints: list[list[int]] = [[] for _ in range(3)]
    for x, y, wide, high, mass, friction, is_ball in (*boxes, *balls):
        row = (x, y, 0.0, 0.0, x, y, wide, high, 1 / mass, friction * GRAVITY * dt)
        for column, number in zip(floats, row, strict=True):
            column.append(number)
        for counts, whole in zip(ints, (is_ball, 0, 0), strict=True):
            counts.append(whole)
    count = len(ints[0])
    widest = max((*floats[PUSH_HALF_WIDTH], *floats[PUSH_HALF_HEIGHT]), default=0.0)
    size = max(2 * widest, math.sqrt(world.width_mm * world.height_mm / max(count, 1)), 1.0)
    shape = [int(world.width_mm / size) + 1, int(world.height_mm / size) + 1] if count else [1, 1]
    grid = Grid([0.0, 0.0, size], shape, [0] * (shape[0] * shape[1] + 1), [0] * count)
    return Pushables(floats, ints, grid, [widest])


def pushable_walls(walls: Walls, world: World) -> Walls:
    """The walls with a grid whose cells hold everything that an object with its middle in them can touch."""
    sizes = [math.hypot(one.width_mm, one.height_mm) / 2 for one in world.boxes]
    sizes += [one.radius_mm for one in world.balls]
    return Walls(walls.floats, fixed(walls.floats, max(sizes))) if sizes else walls


def column_of(x: float, grid: Grid) -> int:
    """The column of a place; beyond the edge is the last one."""
    return min(max(int(x / grid.frame[2]), 0), grid.shape[0] - 1)


def row_of(y: float, grid: Grid) -> int:
    """The row of a place."""
    return min(max(int(y / grid.frame[2]), 0), grid.shape[1] - 1)


def sort_into_cells(pushables: Pushables) -> None:
    """Sorts the objects into the cells of the grid, by their middles."""
    grid = pushables.grid
    starts = grid.starts
    cells = pushables.ints[PUSH_CELL]
    xs = pushables.floats[PUSH_X]
    ys = pushables.floats[PUSH_Y]
    count = len(xs)
    for c in range(len(starts)):
        starts[c] = 0
    for i in range(count):
        cells[i] = row_of(ys[i], grid) * grid.shape[0] + column_of(xs[i], grid)
        starts[cells[i]] += 1
    total = 0
    for c in range(len(starts)):
        total += starts[c]
        starts[c] = total
    for back in range(count):
        i = count - 1 - back
        starts[cells[i]] -= 1
        grid.items[starts[cells[i]]] = i
