"""What a ray meets, and what colour is below: loops over rows of numbers, in the Python that Numba compiles too.

(ux, uy) is the ray's direction, of length 1.
"""

from __future__ import annotations

import math

from kitrobot.sim.physics.grids import cell_at, cells_on_ray
from kitrobot.sim.tables.columns import RADIUS, X, Y
from kitrobot.sim.tables.state import Floors, Grid, Lines, Rays, Robots, Walls


def ray_to_walls(x: float, y: float, ux: float, uy: float, reach: float, walls: Walls, rays: Rays) -> float:
    """How far a ray goes until it meets a wall, `reach` at most."""
    best = reach
    items = walls.grid.items
    if len(items) == 0:
        return best
    starts = walls.grid.starts
    ends = walls.floats
    x1 = ends[0]
    y1 = ends[1]
    x2 = ends[2]
    y2 = ends[3]
    cells = rays.cells
    exits = rays.exits
    count = cells_on_ray(x, y, ux, uy, reach, walls.grid, rays)
    for c in range(count):
        for k in range(starts[cells[c]], starts[cells[c] + 1]):
            w = items[k]
            dx = x2[w] - x1[w]
            dy = y2[w] - y1[w]
            across = ux * dy - uy * dx
            if abs(across) < 1e-12:
                continue
            ax = x1[w] - x
            ay = y1[w] - y
            far = (ax * dy - ay * dx) / across
            if 0.0 <= far < best and 0.0 <= (ax * uy - ay * ux) / across <= 1.0:
                best = far
        if best <= exits[c]:
            break
    return best


def ray_to_discs(me: int, ux: float, uy: float, reach: float, robots: Robots, grid: Grid, rays: Rays) -> float:
    """How far a ray from the middle of robot `me` goes until it meets the disc of another one, `reach` at most; 0 when
    it begins inside one.
    """
    best = reach
    floats = robots.floats
    disc_x = floats[X]
    disc_y = floats[Y]
    radius = floats[RADIUS]
    starts = grid.starts
    items = grid.items
    cells = rays.cells
    exits = rays.exits
    x = disc_x[me]
    y = disc_y[me]
    count = cells_on_ray(x, y, ux, uy, reach, grid, rays)
    for c in range(count):
        for k in range(starts[cells[c]], starts[cells[c] + 1]):
            i = items[k]
            if i == me:
                continue
            ax = disc_x[i] - x
            ay = disc_y[i] - y
            across = ax * uy - ay * ux
            r = radius[i]
            inside = r * r - across * across
            if inside < 0.0:
                continue
            half = math.sqrt(inside)
            along = ax * ux + ay * uy
            if along + half < 0.0:
                continue
            far = along - half
            if far < 0.0:
                far = 0.0
            if far < best:
                best = far
        if best <= exits[c]:
            break
    return best


def colour_at(x: float, y: float, lines: Lines) -> int:
    """The colour of the uppermost coloured stretch (the last one) at a point, or 0."""
    c = cell_at(x, y, lines.grid)
    if c < 0:
        return 0
    stretches = lines.floats
    starts = lines.grid.starts
    items = lines.grid.items
    for back in range(starts[c + 1] - starts[c]):
        k = items[starts[c + 1] - 1 - back]
        dx = stretches[2][k] - stretches[0][k]
        dy = stretches[3][k] - stretches[1][k]
        squared = dx * dx + dy * dy
        part = 0.0
        if squared > 0.0:
            part = ((x - stretches[0][k]) * dx + (y - stretches[1][k]) * dy) / squared
            if part < 0.0:
                part = 0.0
            elif part > 1.0:
                part = 1.0
        ax = x - stretches[0][k] - part * dx
        ay = y - stretches[1][k] - part * dy
        if math.sqrt(ax * ax + ay * ay) <= stretches[4][k]:
            return lines.colours[k]
    return 0


def floor_at(x: float, y: float, floors: Floors) -> int:
    """The colour of the uppermost coloured floor (the last one) at a point, or 0.

    Floor k has the colour `ints[0][k]`, its border goes through the points `ints[1][k]` … `ints[2][k]` and ends
    where it began. A point whose way to the right crosses the border an odd number of times is inside.
    """
    ints = floors.ints
    box = floors.box
    xs = floors.points[0]
    ys = floors.points[1]
    count = len(ints[0])
    for back in range(count):
        k = count - 1 - back
        if x < box[0][k] or y < box[1][k] or x > box[2][k] or y > box[3][k]:
            continue
        inside = False
        for n in range(ints[1][k], ints[2][k]):
            if (ys[n] > y) != (ys[n + 1] > y):
                across = xs[n] + (y - ys[n]) * (xs[n + 1] - xs[n]) / (ys[n + 1] - ys[n])
                if x < across:
                    inside = not inside
        if inside:
            return ints[0][k]
    return 0
