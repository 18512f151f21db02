"""Robots and walls: loops over rows of numbers, in the Python that Numba compiles too.

A robot is a disc, and a wall a stretch without a width. Who comes too near to it is moved away from it. So nobody may
come over a wall before that: a robot goes less than its own radius at once, and who is pushed is held back at once, on
the side on which it was.
"""

from __future__ import annotations

import math

from kitrobot.sim.physics.grids import cell_at
from kitrobot.sim.physics.motion import is_last, is_moving
from kitrobot.sim.tables.columns import RADIUS, X, Y
from kitrobot.sim.tables.state import Robots, State, Walls

TOUCH_MM = 0.5
"""Nearer than this is touching."""

HELD_MM = 1e-6
"""A wall holds nobody who only slides along it, and has no gap to the next one, however numbers are rounded."""


def separate_from_walls(piece: int, robots: Robots, walls: Walls, pairs: list[int], count: int) -> int:
    """Free robots slide along walls and never through them; the wheels of one that goes straight at a wall slip.

    The grid's cells hold every wall that a robot with its middle in them can touch.
    """
    starts = walls.grid.starts
    items = walls.grid.items
    if len(items) == 0:
        return count
    who = robots.free_solid
    floats = robots.floats
    x = floats[X]
    y = floats[Y]
    radius = floats[RADIUS]
    ends = walls.floats
    x1 = ends[0]
    y1 = ends[1]
    x2 = ends[2]
    y2 = ends[3]
    for n in range(len(who)):
        i = who[n]
        if piece > 0 and not is_moving(i, piece, robots):
            continue
        c = cell_at(x[i], y[i], walls.grid)
        if c < 0:
            continue
        for k in range(starts[c], starts[c + 1]):
            w = items[k]
            dx = x2[w] - x1[w]
            dy = y2[w] - y1[w]
            nx = x[i] - x1[w]
            ny = y[i] - y1[w]
            squared = dx * dx + dy * dy
            if squared > 0.0:
                part = (nx * dx + ny * dy) / squared
                if part >= 1.0:
                    nx -= dx
                    ny -= dy
                elif part > 0.0:
                    nx -= part * dx
                    ny -= part * dy
            near = radius[i] + TOUCH_MM
            if nx > near or nx < -near or ny > near or ny < -near:
                continue
            distance = math.sqrt(nx * nx + ny * ny)
            if distance > near or distance == 0.0:
                continue
            if is_last(i, i, piece, robots):
                count = add_pair(i, -1 - w, pairs, count)
            if distance < radius[i]:
                x[i] += (radius[i] - distance) * (nx / distance)
                y[i] += (radius[i] - distance) * (ny / distance)
    return count


def hold_at_walls(i: int, was_x: float, was_y: float, state: State) -> bool:
    """Moves disc i, which was pushed from a place, out of walls and back over those it was pushed over; gives whether
    a wall held it.
    """
    walls = state.walls
    if len(walls.grid.items) == 0:
        return False
    x = state.robots.floats[X]
    y = state.robots.floats[Y]
    radius = state.robots.floats[RADIUS][i]
    c = cell_at(x[i], y[i], walls.grid)
    if c < 0:
        return False
    is_held = False
    for k in range(walls.grid.starts[c], walls.grid.starts[c + 1]):
        nx, ny, over = disc_overlap(x[i], y[i], was_x, was_y, radius, walls.grid.items[k], walls)
        if over > HELD_MM:
            is_held = True
            x[i] += nx * over
            y[i] += ny * over
    return is_held


def disc_overlap(
    x: float, y: float, was_x: float, was_y: float, radius: float, w: int, walls: Walls
) -> tuple[float, float, float]:
    """The direction in which wall w pushes a disc that comes from a place, and how far; 0 where it does not."""
    ends = walls.floats
    dx = ends[2][w] - ends[0][w]
    dy = ends[3][w] - ends[1][w]
    length = math.sqrt(dx * dx + dy * dy)
    ux = 1.0
    uy = 0.0
    if length > 0.0:
        ux = dx / length
        uy = dy / length
    ax = x - ends[0][w]
    ay = y - ends[1][w]
    along = ax * ux + ay * uy
    across = ay * ux - ax * uy
    before = (was_y - ends[1][w]) * ux - (was_x - ends[0][w]) * uy
    came = (was_x - ends[0][w]) * ux + (was_y - ends[1][w]) * uy
    if is_crossed(before, across, came, along, length):
        side = 1.0 if before > 0.0 else -1.0
        return -uy * side, ux * side, abs(across) + radius
    past = 0.0
    if along < 0.0:
        past = along
    elif along > length:
        past = along - length
    away = math.sqrt(past * past + across * across)
    if away >= radius or away == 0.0:
        return 0.0, 0.0, 0.0
    return (past * ux - across * uy) / away, (past * uy + across * ux) / away, radius - away


def is_crossed(before: float, across: float, came: float, along: float, length: float) -> bool:
    """Whether a straight way leads over a wall: from `came` along it and `before` beside it to `along` and `across`."""
    if before == 0.0 or before * across > 0.0:
        return False
    at = came + (along - came) * before / (before - across)
    return -HELD_MM <= at <= length + HELD_MM


def add_pair(one: int, other: int, pairs: list[int], count: int) -> int:
    """Writes a pair behind those that are there, as far as there is room; gives how many there are now."""
    if 2 * count >= len(pairs):
        return count
    pairs[2 * count] = one
    pairs[2 * count + 1] = other
    return count + 1
