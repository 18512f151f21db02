"""Boxes and balls that are pushed: loops over rows of numbers, in the Python that Numba compiles too.

In each step what moves slows down by its friction and goes on; then what overlaps is parted a few times, robots and
things, things and things, things and walls, each giving way in proportion to how light it is; and how far a thing came
is its speed. Only what moves, or is touched by what moves, is looked at. Boxes keep their direction, walls and robots
that stand give way to nothing, and nothing bounces. So no thing goes faster in a step than half its own size, and none
gets through a wall.
"""

from __future__ import annotations

import math

from kitrobot.sim.columns import DT, MOVED, RADIUS, ROAD, THINGS, WAY, X, Y
from kitrobot.sim.grids import cell_at, fixed
from kitrobot.sim.motion import is_moving
from kitrobot.sim.state import Grid, State, Things, Walls
from kitrobot.world import World

(T_X, T_Y, T_VX, T_VY, T_WAS_X, T_WAS_Y, T_WIDE, T_HIGH, T_GIVES, T_SLOWS) = range(10)
"""Rows of a thing's numbers: its middle, speed, place before the step, half its width and height, 1 / mass, and how
much slower it gets in a step, in mm/s."""
T_BALL, T_AWAKE, T_CELL = range(3)

GRAVITY = 9810.0
"""mm/s²."""

ROBOT_GIVES = 0.001
"""1 / mass of a robot: 1 kg."""

ROUNDS = 4
"""So often in a step what overlaps is parted."""

REST_MM = 1e-3
"""Less than this is no overlap."""


def thing_tables(world: World, dt: float) -> Things:
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
    widest = max((*floats[T_WIDE], *floats[T_HIGH]), default=0.0)
    size = max(2 * widest, math.sqrt(world.width_mm * world.height_mm / max(count, 1)), 1.0)
    shape = [int(world.width_mm / size) + 1, int(world.height_mm / size) + 1] if count else [1, 1]
    grid = Grid([0.0, 0.0, size], shape, [0] * (shape[0] * shape[1] + 1), [0] * count)
    return Things(floats, ints, grid, [widest])


def thing_walls(walls: Walls, world: World) -> Walls:
    """The walls with a grid whose cells hold all that a thing with its middle in them can touch."""
    sizes = [math.hypot(one.width_mm, one.height_mm) / 2 for one in world.boxes]
    sizes += [one.radius_mm for one in world.balls]
    return Walls(walls.floats, fixed(walls.floats, max(sizes))) if sizes else walls


def column_of(x: float, grid: Grid) -> int:
    """The column of a place; beyond the edge is the last one."""
    return min(max(int(x / grid.frame[2]), 0), grid.shape[0] - 1)


def row_of(y: float, grid: Grid) -> int:
    """The row of a place."""
    return min(max(int(y / grid.frame[2]), 0), grid.shape[1] - 1)


def sort_into_cells(things: Things) -> None:
    """Puts the middle of each thing into its cell."""
    grid = things.grid
    starts = grid.starts
    cells = things.ints[T_CELL]
    xs = things.floats[T_X]
    ys = things.floats[T_Y]
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


def begin_things(state: State) -> None:
    """What moves slows down and goes on."""
    things = state.things
    floats = things.floats
    xs = floats[T_X]
    ys = floats[T_Y]
    vx = floats[T_VX]
    vy = floats[T_VY]
    slows = floats[T_SLOWS]
    awake = things.ints[T_AWAKE]
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
        wake(i, 0, things)
        xs[i] += vx[i] * left * dt
        ys[i] += vy[i] * left * dt


def part_things(piece: int, state: State) -> int:
    """Parts what overlaps after the robots went a piece of their ways, a few times; gives how often."""
    things = state.things
    awake = things.ints[T_AWAKE]
    count = len(awake)
    sort_into_cells(things)
    pushed = 0
    for _ in range(ROUNDS):
        found = part_from_robots(piece, state)
        for i in range(count):
            if awake[i] == piece + 1:
                found += part_from_things(i, piece, things)
        for i in range(count):
            if awake[i] == piece + 1:
                found += part_from_thing_walls(i, things, state.thing_walls)
        pushed += found
        if found == 0:
            break
    return pushed


def end_things(pushed: int, state: State) -> None:
    """How far each thing came is its speed. `pushed`: how often things were parted."""
    floats = state.things.floats
    xs = floats[T_X]
    ys = floats[T_Y]
    vx = floats[T_VX]
    vy = floats[T_VY]
    awake = state.things.ints[T_AWAKE]
    dt = state.fixed_floats[DT]
    moving = 0
    for i in range(len(xs)):
        if awake[i] == 0:
            continue
        vx[i] = (xs[i] - floats[T_WAS_X][i]) / dt
        vy[i] = (ys[i] - floats[T_WAS_Y][i]) / dt
        most = min(floats[T_WIDE][i], floats[T_HIGH][i]) / dt
        speed = math.sqrt(vx[i] * vx[i] + vy[i] * vy[i])
        if speed > most:
            vx[i] *= most / speed
            vy[i] *= most / speed
        if speed < REST_MM:
            vx[i] = 0.0
            vy[i] = 0.0
        else:
            moving += 1
    state.clock[THINGS] = moving
    if moving > 0 or pushed > 0:
        state.clock[MOVED] = 1


def wake(i: int, piece: int, things: Things) -> None:
    """From now on in this piece of the step the thing is looked at."""
    if things.ints[T_AWAKE][i] == 0:
        things.floats[T_WAS_X][i] = things.floats[T_X][i]
        things.floats[T_WAS_Y][i] = things.floats[T_Y][i]
    things.ints[T_AWAKE][i] = piece + 1


def part_from_robots(piece: int, state: State) -> int:
    """Robots push things out of their discs; one whose wheels turn gives way a little itself. Gives how often."""
    things = state.things
    grid = things.grid
    robots = state.robots
    xs = things.floats[T_X]
    ys = things.floats[T_Y]
    wide = things.floats[T_WIDE]
    high = things.floats[T_HIGH]
    ball = things.ints[T_BALL]
    gives = things.floats[T_GIVES]
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
        reach = radius[r] + things.numbers[0] + grid.frame[2] * 0.01
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
                        mine = ROBOT_GIVES / (ROBOT_GIVES + gives[i])
                    wake(i, piece, things)
                    found += 1
                    xs[i] += dx / away * over * (1.0 - mine)
                    ys[i] += dy / away * over * (1.0 - mine)
                    x[r] -= dx / away * over * mine
                    y[r] -= dy / away * over * mine
    return found


def beyond(away: float, half: float) -> float:
    """How far it is to the nearer side of a box from a place beside it; 0 within."""
    if away > half:
        return away - half
    if away < -half:
        return away + half
    return 0.0


def part_from_things(i: int, piece: int, things: Things) -> int:
    """Parts a thing from the others."""
    grid = things.grid
    xs = things.floats[T_X]
    ys = things.floats[T_Y]
    wide = things.floats[T_WIDE]
    high = things.floats[T_HIGH]
    gives = things.floats[T_GIVES]
    ball = things.ints[T_BALL]
    awake = things.ints[T_AWAKE]
    slack = grid.frame[2] * 0.01
    reach_x = wide[i] + things.numbers[0] + slack
    reach_y = high[i] + things.numbers[0] + slack
    found = 0
    for row in range(row_of(ys[i] - reach_y, grid), row_of(ys[i] + reach_y, grid) + 1):
        for column in range(column_of(xs[i] - reach_x, grid), column_of(xs[i] + reach_x, grid) + 1):
            c = row * grid.shape[0] + column
            for k in range(grid.starts[c], grid.starts[c + 1]):
                j = grid.items[k]
                if j == i or (awake[j] == piece + 1 and j < i):
                    continue
                dx = xs[j] - xs[i]
                dy = ys[j] - ys[i]
                over_x = wide[i] + wide[j] - abs(dx)
                over_y = high[i] + high[j] - abs(dy)
                if over_x <= REST_MM or over_y <= REST_MM:
                    continue
                nx = 0.0
                ny = 0.0
                over = 0.0
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
                    over = near - away
                    if over <= REST_MM:
                        continue
                    if away > 0.0:
                        nx = dx / away
                        ny = dy / away
                    else:
                        nx = 1.0
                elif over_x < over_y:
                    over = over_x
                    nx = 1.0 if dx >= 0.0 else -1.0
                else:
                    over = over_y
                    ny = 1.0 if dy >= 0.0 else -1.0
                wake(j, piece, things)
                found += 1
                mine = gives[i] / (gives[i] + gives[j])
                xs[i] -= nx * over * mine
                ys[i] -= ny * over * mine
                xs[j] += nx * over * (1.0 - mine)
                ys[j] += ny * over * (1.0 - mine)
    return found


def part_from_thing_walls(i: int, things: Things, walls: Walls) -> int:
    """Keeps a thing out of walls."""
    xs = things.floats[T_X]
    ys = things.floats[T_Y]
    wide = things.floats[T_WIDE][i]
    high = things.floats[T_HIGH][i]
    ball = things.ints[T_BALL][i]
    was_x = things.floats[T_WAS_X][i]
    was_y = things.floats[T_WAS_Y][i]
    c = cell_at(xs[i], ys[i], walls.grid)
    if c < 0 or len(walls.grid.items) == 0:
        return 0
    found = 0
    ends = walls.floats
    for k in range(walls.grid.starts[c], walls.grid.starts[c + 1]):
        w = walls.grid.items[k]
        dx = ends[2][w] - ends[0][w]
        dy = ends[3][w] - ends[1][w]
        length = math.sqrt(dx * dx + dy * dy)
        ux = 1.0
        uy = 0.0
        if length > 0.0:
            ux = dx / length
            uy = dy / length
        ax = xs[i] - ends[0][w]
        ay = ys[i] - ends[1][w]
        along = ax * ux + ay * uy
        across = ay * ux - ax * uy
        before = (was_y - ends[1][w]) * ux - (was_x - ends[0][w]) * uy
        came = (was_x - ends[0][w]) * ux + (was_y - ends[1][w]) * uy
        if before * across < 0.0 and 0.0 <= along <= length and 0.0 <= came <= length:
            # It was pushed onto the wall with more than its half: back to where it came from.
            side = 1.0 if before > 0.0 else -1.0
            over = abs(across) + (wide if ball else abs(uy) * wide + abs(ux) * high)
            nx = -uy * side
            ny = ux * side
        elif ball:
            past = beyond(along - length / 2.0, length / 2.0)
            away = math.sqrt(past * past + across * across)
            over = wide - away
            if over <= REST_MM or away == 0.0:
                continue
            nx = (past * ux - across * uy) / away
            ny = (past * uy + across * ux) / away
        else:
            over = abs(uy) * wide + abs(ux) * high - abs(across)
            end = abs(ux) * wide + abs(uy) * high + length / 2.0 - abs(along - length / 2.0)
            if over <= REST_MM or end <= REST_MM:
                continue
            side = 1.0 if across >= 0.0 else -1.0
            nx = -uy * side
            ny = ux * side
            if end < over:
                over = end
                side = 1.0 if along >= length / 2.0 else -1.0
                nx = ux * side
                ny = uy * side
        found += 1
        xs[i] += nx * over
        ys[i] += ny * over
    return found


def ray_to_things(x: float, y: float, ux: float, uy: float, reach: float, things: Things) -> float:
    """How far a ray goes until it meets a thing, `reach` at most; 0 when it begins inside one."""
    best = reach
    xs = things.floats[T_X]
    ys = things.floats[T_Y]
    wide = things.floats[T_WIDE]
    high = things.floats[T_HIGH]
    ball = things.ints[T_BALL]
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
