"""Pushable objects, boxes and balls: loops over rows of numbers, in the Python that Numba compiles too.

In each step a moving object slows down by its friction and moves on. Then overlaps are resolved in a few rounds,
between robots and objects, objects and objects, objects and walls: each body moves in proportion to its inverse mass.
The distance that an object has moved gives its new speed. Only what moves, or is touched by what moves, is computed.
Boxes keep their orientation, walls and standing robots do not move, and nothing bounces. So no object moves further in
a step than half its own size, and none passes through a wall.
"""

from __future__ import annotations

import math

from kitrobot.sim.physics.grids import cell_at
from kitrobot.sim.physics.motion import is_moving
from kitrobot.sim.physics.pushable_grid import (
    PUSH_AWAKE,
    PUSH_DECELERATION,
    PUSH_HALF_HEIGHT,
    PUSH_HALF_WIDTH,
    PUSH_INVERSE_MASS,
    PUSH_IS_BALL,
    PUSH_OLD_X,
    PUSH_OLD_Y,
    PUSH_VX,
    PUSH_VY,
    PUSH_X,
    PUSH_Y,
    column_of,
    row_of,
    sort_into_cells,
)
from kitrobot.sim.physics.wall_contacts import hold_at_walls, is_crossed
from kitrobot.sim.tables.columns import DT, MOVED, PUSHABLES, RADIUS, ROAD, WAY, X, Y
from kitrobot.sim.tables.state import Pushables, State, Walls

ROBOT_INVERSE_MASS = 0.001
"""1 / mass of a robot: 1 kg."""

ROUNDS = 4
"""How many rounds of a step resolve overlaps."""

REST_MM = 1e-3
"""Smaller overlaps are ignored, in mm."""


def slide_pushables(state: State) -> None:
    """Slows moving objects down by friction and moves them on."""
    pushables = state.pushables
    floats = pushables.floats
    xs = floats[PUSH_X]
    ys = floats[PUSH_Y]
    vx = floats[PUSH_VX]
    vy = floats[PUSH_VY]
    slows = floats[PUSH_DECELERATION]
    awake = pushables.ints[PUSH_AWAKE]
    dt = state.fixed_floats[DT]
    for i in range(len(xs)):
        awake[i] = 0
        if vx[i] == 0.0 and vy[i] == 0.0:
            continue
        speed = math.sqrt(vx[i] * vx[i] + vy[i] * vy[i])
        if speed <= slows[i]:
            vx[i] = 0.0
            vy[i] = 0.0
            continue
        left = (speed - slows[i]) / speed
        wake(i, 0, pushables)
        xs[i] += vx[i] * left * dt
        ys[i] += vy[i] * left * dt


def separate_pushables(piece: int, state: State) -> int:
    """Resolves overlaps after the robots moved by a piece of their ways; returns how many."""
    pushables = state.pushables
    awake = pushables.ints[PUSH_AWAKE]
    count = len(awake)
    sort_into_cells(pushables)
    pushed = 0
    for _ in range(ROUNDS):
        found = separate_from_robots(piece, state)
        for i in range(count):
            if awake[i] == piece + 1:
                found += separate_from_pushables(i, piece, pushables)
        for i in range(count):
            if awake[i] == piece + 1:
                found += separate_from_pushable_walls(i, pushables, state.pushable_walls)
        pushed += found
        if found == 0:
            break
    return pushed


def update_pushable_speeds(pushed: int, state: State) -> None:
    """Sets the speed of each object from the distance it moved. `pushed`: how many overlaps were resolved."""
    floats = state.pushables.floats
    xs = floats[PUSH_X]
    ys = floats[PUSH_Y]
    vx = floats[PUSH_VX]
    vy = floats[PUSH_VY]
    awake = state.pushables.ints[PUSH_AWAKE]
    dt = state.fixed_floats[DT]
    moving = 0
    for i in range(len(xs)):
        if awake[i] == 0:
            continue
        vx[i] = (xs[i] - floats[PUSH_OLD_X][i]) / dt
        vy[i] = (ys[i] - floats[PUSH_OLD_Y][i]) / dt
        most = min(floats[PUSH_HALF_WIDTH][i], floats[PUSH_HALF_HEIGHT][i]) / dt
        speed = math.sqrt(vx[i] * vx[i] + vy[i] * vy[i])
        if speed > most:
            vx[i] *= most / speed
            vy[i] *= most / speed
        if speed < REST_MM:
            vx[i] = 0.0
            vy[i] = 0.0
        else:
            moving += 1
    state.clock[PUSHABLES] = moving
    if moving > 0 or pushed > 0:
        state.clock[MOVED] = 1


def wake(i: int, piece: int, pushables: Pushables) -> None:
    """Marks an object as moving in this piece of the step."""
    if pushables.ints[PUSH_AWAKE][i] == 0:
        pushables.floats[PUSH_OLD_X][i] = pushables.floats[PUSH_X][i]
        pushables.floats[PUSH_OLD_Y][i] = pushables.floats[PUSH_Y][i]
    pushables.ints[PUSH_AWAKE][i] = piece + 1


def separate_from_robots(piece: int, state: State) -> int:
    """Pushes objects out of the discs of robots; a robot whose wheels turn moves a little itself. Returns how many."""
    pushables = state.pushables
    grid = pushables.grid
    robots = state.robots
    xs = pushables.floats[PUSH_X]
    ys = pushables.floats[PUSH_Y]
    wide = pushables.floats[PUSH_HALF_WIDTH]
    high = pushables.floats[PUSH_HALF_HEIGHT]
    ball = pushables.ints[PUSH_IS_BALL]
    gives = pushables.floats[PUSH_INVERSE_MASS]
    x = robots.floats[X]
    y = robots.floats[Y]
    radius = robots.floats[RADIUS]
    way = robots.floats[WAY]
    road = robots.ints[ROAD]
    found = 0
    for n in range(len(robots.solid)):
        r = robots.solid[n]
        if road[r] < -1 or (piece > 0 and not is_moving(r, piece, robots)):
            continue
        reach = radius[r] + pushables.numbers[0] + grid.frame[2] * 0.01
        for row in range(row_of(y[r] - reach, grid), row_of(y[r] + reach, grid) + 1):
            for column in range(column_of(x[r] - reach, grid), column_of(x[r] + reach, grid) + 1):
                c = row * grid.shape[0] + column
                for k in range(grid.starts[c], grid.starts[c + 1]):
                    i = grid.items[k]
                    dx = xs[i] - x[r]
                    dy = ys[i] - y[r]
                    near = radius[r]
                    if ball[i]:
                        near += wide[i]
                    else:
                        dx = beyond(dx, wide[i])
                        dy = beyond(dy, high[i])
                    away = dx * dx + dy * dy
                    if away >= (near - REST_MM) * (near - REST_MM):
                        continue
                    away = math.sqrt(away)
                    if away == 0.0:
                        dx = 1.0
                        away = 1.0
                        over = near
                    else:
                        over = near - away
                    mine = 0.0
                    if road[r] < 0 and way[r] != 0.0:
                        mine = ROBOT_INVERSE_MASS / (ROBOT_INVERSE_MASS + gives[i])
                    wake(i, piece, pushables)
                    found += 1
                    xs[i] += dx / away * over * (1.0 - mine)
                    ys[i] += dy / away * over * (1.0 - mine)
                    if mine > 0.0:
                        push_back(r, i, -dx / away * over * mine, -dy / away * over * mine, state)
    return found


def push_back(r: int, i: int, dx: float, dy: float, state: State) -> None:
    """Moves robot r away from object i; where a wall holds it, the object goes as far the other way."""
    x = state.robots.floats[X]
    y = state.robots.floats[Y]
    was_x = x[r]
    was_y = y[r]
    x[r] += dx
    y[r] += dy
    wanted_x = x[r]
    wanted_y = y[r]
    if hold_at_walls(r, was_x, was_y, state):
        state.pushables.floats[PUSH_X][i] += x[r] - wanted_x
        state.pushables.floats[PUSH_Y][i] += y[r] - wanted_y


def beyond(away: float, half: float) -> float:
    """The distance from a point to the nearer side of a box; 0 inside."""
    if away > half:
        return away - half
    if away < -half:
        return away + half
    return 0.0


def separate_from_pushables(i: int, piece: int, pushables: Pushables) -> int:
    """Separates an object from the others."""
    grid = pushables.grid
    xs = pushables.floats[PUSH_X]
    ys = pushables.floats[PUSH_Y]
    wide = pushables.floats[PUSH_HALF_WIDTH]
    high = pushables.floats[PUSH_HALF_HEIGHT]
    gives = pushables.floats[PUSH_INVERSE_MASS]
    awake = pushables.ints[PUSH_AWAKE]
    slack = grid.frame[2] * 0.01
    reach_x = wide[i] + pushables.numbers[0] + slack
    reach_y = high[i] + pushables.numbers[0] + slack
    found = 0
    for row in range(row_of(ys[i] - reach_y, grid), row_of(ys[i] + reach_y, grid) + 1):
        for column in range(column_of(xs[i] - reach_x, grid), column_of(xs[i] + reach_x, grid) + 1):
            c = row * grid.shape[0] + column
            for k in range(grid.starts[c], grid.starts[c + 1]):
                j = grid.items[k]
                if j == i or (awake[j] == piece + 1 and j < i):
                    continue
                over_x = wide[i] + wide[j] - abs(xs[j] - xs[i])
                over_y = high[i] + high[j] - abs(ys[j] - ys[i])
                if over_x <= REST_MM or over_y <= REST_MM:
                    continue
                nx, ny, over = pushable_overlap(i, j, pushables)
                if over <= REST_MM:
                    continue
                wake(j, piece, pushables)
                found += 1
                mine = gives[i] / (gives[i] + gives[j])
                xs[i] -= nx * over * mine
                ys[i] -= ny * over * mine
                xs[j] += nx * over * (1.0 - mine)
                ys[j] += ny * over * (1.0 - mine)
    return found


def pushable_overlap(i: int, j: int, pushables: Pushables) -> tuple[float, float, float]:
    """The direction from object i to object j in which they overlap least, and by how much."""
    wide = pushables.floats[PUSH_HALF_WIDTH]
    high = pushables.floats[PUSH_HALF_HEIGHT]
    ball = pushables.ints[PUSH_IS_BALL]
    dx = pushables.floats[PUSH_X][j] - pushables.floats[PUSH_X][i]
    dy = pushables.floats[PUSH_Y][j] - pushables.floats[PUSH_Y][i]
    if ball[i] or ball[j]:
        near = wide[i] if ball[i] else 0.0
        if ball[j]:
            near += wide[j]
            if ball[i] == 0:
                dx = beyond(dx, wide[i])
                dy = beyond(dy, high[i])
        else:
            dx = beyond(dx, wide[j])
            dy = beyond(dy, high[j])
        away = math.sqrt(dx * dx + dy * dy)
        if away > 0.0:
            return dx / away, dy / away, near - away
        return 1.0, 0.0, near - away
    over_x = wide[i] + wide[j] - abs(dx)
    over_y = high[i] + high[j] - abs(dy)
    if over_x < over_y:
        return 1.0 if dx >= 0.0 else -1.0, 0.0, over_x
    return 0.0, 1.0 if dy >= 0.0 else -1.0, over_y


def separate_from_pushable_walls(i: int, pushables: Pushables, walls: Walls) -> int:
    """Pushes an object out of walls."""
    xs = pushables.floats[PUSH_X]
    ys = pushables.floats[PUSH_Y]
    c = cell_at(xs[i], ys[i], walls.grid)
    if c < 0 or len(walls.grid.items) == 0:
        return 0
    found = 0
    for k in range(walls.grid.starts[c], walls.grid.starts[c + 1]):
        nx, ny, over = wall_overlap(i, walls.grid.items[k], pushables, walls)
        if over > 0.0:
            found += 1
            xs[i] += nx * over
            ys[i] += ny * over
    return found


def wall_overlap(i: int, w: int, pushables: Pushables, walls: Walls) -> tuple[float, float, float]:
    """The direction in which wall w pushes object i, and how far; 0 where it does not."""
    x = pushables.floats[PUSH_X][i]
    y = pushables.floats[PUSH_Y][i]
    wide = pushables.floats[PUSH_HALF_WIDTH][i]
    high = pushables.floats[PUSH_HALF_HEIGHT][i]
    ball = pushables.ints[PUSH_IS_BALL][i]
    was_x = pushables.floats[PUSH_OLD_X][i]
    was_y = pushables.floats[PUSH_OLD_Y][i]
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
        # It was pushed onto the wall with more than its half: back to where it came from.
        side = 1.0 if before > 0.0 else -1.0
        return -uy * side, ux * side, abs(across) + (wide if ball else abs(uy) * wide + abs(ux) * high)
    if ball:
        past = beyond(along - length / 2.0, length / 2.0)
        away = math.sqrt(past * past + across * across)
        if wide - away <= REST_MM or away == 0.0:
            return 0.0, 0.0, 0.0
        return (past * ux - across * uy) / away, (past * uy + across * ux) / away, wide - away
    over = abs(uy) * wide + abs(ux) * high - abs(across)
    end = abs(ux) * wide + abs(uy) * high + length / 2.0 - abs(along - length / 2.0)
    if over <= REST_MM or end <= REST_MM:
        return 0.0, 0.0, 0.0
    if end < over:
        side = 1.0 if along >= length / 2.0 else -1.0
        return ux * side, uy * side, end
    side = 1.0 if across >= 0.0 else -1.0
    return -uy * side, ux * side, over


def ray_to_pushables(x: float, y: float, ux: float, uy: float, reach: float, pushables: Pushables) -> float:
    """The distance along a ray to the nearest object, `reach` at most; 0 if it begins inside one."""
    best = reach
    xs = pushables.floats[PUSH_X]
    ys = pushables.floats[PUSH_Y]
    wide = pushables.floats[PUSH_HALF_WIDTH]
    high = pushables.floats[PUSH_HALF_HEIGHT]
    ball = pushables.ints[PUSH_IS_BALL]
    for i in range(len(xs)):
        ax = xs[i] - x
        ay = ys[i] - y
        along = ax * ux + ay * uy
        if ball[i]:
            across = ax * uy - ay * ux
            inside = wide[i] * wide[i] - across * across
            if inside < 0.0:
                continue
            near = along - math.sqrt(inside)
            far = along + math.sqrt(inside)
        else:
            near = -math.inf
            far = math.inf
            if ux != 0.0:
                near = min((ax - wide[i]) / ux, (ax + wide[i]) / ux)
                far = max((ax - wide[i]) / ux, (ax + wide[i]) / ux)
            elif abs(ax) > wide[i]:
                continue
            if uy != 0.0:
                near = max(near, min((ay - high[i]) / uy, (ay + high[i]) / uy))
                far = min(far, max((ay - high[i]) / uy, (ay + high[i]) / uy))
            elif abs(ay) > high[i]:
                continue
        if near <= far and far >= 0.0 and near < best:
            best = max(near, 0.0)
    return best
