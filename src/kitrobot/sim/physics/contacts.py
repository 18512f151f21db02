"""Who touches whom: loops over rows of numbers, in the Python that Numba compiles too.

On a road, robots are ordered by where they are, and only neighbours can touch: bumper to bumper. Everywhere else a
robot is a disc. What overlaps is pushed apart; who touched is written down as pairs (robot, other), where a wall w is
the other -1 - w. The loops write pairs behind the `count` that are there already, as far as there is room, and give how
many there are now.
"""

from __future__ import annotations

import math

from kitrobot.sim.physics.grids import cell_at
from kitrobot.sim.physics.motion import is_last, is_moving, nudge
from kitrobot.sim.tables.columns import (
    AT,
    CLOSED,
    GAP_AHEAD,
    GAP_BEHIND,
    LEADER,
    LENGTH,
    LOW_X,
    LOW_Y,
    RADIUS,
    ROAD,
    SPEED,
    UX,
    UY,
    WAY,
    X,
    Y,
)
from kitrobot.sim.tables.state import Contacts, Grid, Roads, Robots, Walls

TOUCH_MM = 0.5
"""Nearer than this is touching."""


def sort_along(robots: Robots) -> None:
    """Sorts the guided robots by road and place; they hardly overtake, so insertion is quick."""
    order = robots.guided
    road = robots.ints[ROAD]
    at = robots.floats[AT]
    for n in range(1, len(order)):
        i = order[n]
        k = n - 1
        while k >= 0 and (road[order[k]] > road[i] or (road[order[k]] == road[i] and at[order[k]] > at[i])):
            order[k + 1] = order[k]
            k -= 1
        order[k + 1] = i


def measure_gaps(robots: Robots, roads: Roads) -> None:
    """For each guided robot (they are sorted): the free way ahead and behind, and who is ahead (-1: nobody)."""
    order = robots.guided
    ints = robots.ints
    road = ints[ROAD]
    leader = ints[LEADER]
    floats = robots.floats
    at = floats[AT]
    length = floats[LENGTH]
    ahead = floats[GAP_AHEAD]
    behind = floats[GAP_BEHIND]
    road_length = roads.length
    closed = roads.ints[CLOSED]
    n = len(order)
    start = 0
    while start < n:
        r = road[order[start]]
        end = start
        while end < n and road[order[end]] == r:
            end += 1
        for k in range(start, end):
            i = order[k]
            ahead[i] = math.inf
            leader[i] = -1
            behind[i] = math.inf
        if end - start > 1 and r >= 0:
            for k in range(start, end):
                i = order[k]
                if k + 1 < end:
                    j = order[k + 1]
                    distance = at[j] - at[i]
                elif closed[r]:
                    j = order[start]
                    distance = at[j] - at[i] + road_length[r]
                else:
                    continue
                gap = distance - (length[i] + length[j]) / 2.0
                ahead[i] = gap
                behind[j] = gap
                leader[i] = j
        start = end


def separate_on_roads(piece: int, robots: Robots, roads: Roads, pairs: list[int], count: int) -> int:
    """Robots that ran into one another on a road stand bumper to bumper; the one that came too near gives way."""
    order = robots.guided
    ints = robots.ints
    road = ints[ROAD]
    leader = ints[LEADER]
    floats = robots.floats
    at = floats[AT]
    speed = floats[SPEED]
    ahead = floats[GAP_AHEAD]
    road_length = roads.length
    closed = roads.ints[CLOSED]
    for k in range(len(order)):
        i = order[k]
        j = leader[i]
        if j < 0 or ahead[i] > TOUCH_MM:
            continue
        if piece > 0 and not (is_moving(i, piece, robots) or is_moving(j, piece, robots)):
            continue
        if is_last(i, j, piece, robots):
            count = add_pair(i, j, pairs, count)
        if ahead[i] >= 0.0:
            continue
        r = road[i]
        moved = i
        shift = ahead[i]
        if speed[i] <= 0.0 and speed[j] < 0.0:
            moved = j
            shift = -shift
        s = at[moved] + shift
        if closed[r]:
            if s < 0.0:
                s += road_length[r]
            elif s >= road_length[r]:
                s -= road_length[r]
        elif s < 0.0:
            s = 0.0
        elif s > road_length[r]:
            s = road_length[r]
        at[moved] = s
        speed[moved] = 0.0
        nudge(i, j, robots)
        ahead[i] = 0.0
    return count


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


def separate_discs(piece: int, robots: Robots, grid: Grid, pairs: list[int], count: int) -> int:
    """Robots that are not on one road keep their discs apart; guided ones stay. The grid was filled a moment ago.

    Two that meet in several cells are looked at in the first of them.
    """
    ints = robots.ints
    road = ints[ROAD]
    low_x = ints[LOW_X]
    low_y = ints[LOW_Y]
    floats = robots.floats
    x = floats[X]
    y = floats[Y]
    radius = floats[RADIUS]
    starts = grid.starts
    items = grid.items
    columns = grid.shape[0]
    for c in range(columns * grid.shape[1]):
        end = starts[c + 1]
        for k in range(starts[c], end):
            i = items[k]
            for m in range(k + 1, end):
                j = items[m]
                near = radius[i] + radius[j]
                dx = x[j] - x[i]
                if dx > near + TOUCH_MM or dx < -near - TOUCH_MM:
                    continue
                dy = y[j] - y[i]
                if dy > near + TOUCH_MM or dy < -near - TOUCH_MM:
                    continue
                if (road[i] >= 0 and road[i] == road[j]) or (
                    c != max(low_y[i], low_y[j]) * columns + max(low_x[i], low_x[j])
                ):
                    continue
                distance = math.sqrt(dx * dx + dy * dy)
                if distance > near + TOUCH_MM:
                    continue
                if piece > 0 and not (is_moving(i, piece, robots) or is_moving(j, piece, robots)):
                    continue
                if is_last(i, j, piece, robots):
                    count = add_pair(min(i, j), max(i, j), pairs, count)
                if distance >= near or (road[i] >= 0 and road[j] >= 0):
                    continue
                push_apart(i, j, dx, dy, distance, robots)
    return count


def push_apart(i: int, j: int, dx: float, dy: float, distance: float, robots: Robots) -> None:
    """Moves two discs apart that overlap, one of them free; (dx, dy) is from the first to the other."""
    floats = robots.floats
    road = robots.ints[ROAD]
    x = floats[X]
    y = floats[Y]
    way = floats[WAY]
    ux = floats[UX]
    uy = floats[UY]
    push = floats[RADIUS][i] + floats[RADIUS][j]
    if distance > 0.0:
        push = (push - distance) / distance
    elif way[i] != 0.0 and road[i] < 0:
        # They met middle on middle: each is put back to where it came from.
        dx = math.copysign(ux[i], ux[i] * way[i])
        dy = math.copysign(uy[i], uy[i] * way[i])
    elif way[j] != 0.0 and road[j] < 0:
        dx = -math.copysign(ux[j], ux[j] * way[j])
        dy = -math.copysign(uy[j], uy[j] * way[j])
    else:
        return
    first = 0.5
    if road[i] >= 0:
        first = 0.0
    elif road[j] >= 0:
        first = 1.0
    nudge(i, j, robots)
    x[i] -= first * push * dx
    y[i] -= first * push * dy
    x[j] += (1.0 - first) * push * dx
    y[j] += (1.0 - first) * push * dy


def add_pair(one: int, other: int, pairs: list[int], count: int) -> int:
    """Writes a pair behind those that are there, as far as there is room; gives how many there are now."""
    if 2 * count >= len(pairs):
        return count
    pairs[2 * count] = one
    pairs[2 * count + 1] = other
    return count + 1


def news_first(contacts: Contacts, count: int, count_before: int) -> int:
    """Brings the pairs that were not there before to the front, in their order; gives how many they are.

    `buckets` (a power of two, all -1, and so again afterwards) and `chain` are room for looking up.
    """
    pairs = contacts.pairs
    before = contacts.before
    buckets = contacts.buckets
    chain = contacts.chain
    mask = len(buckets) - 1
    for k in range(count_before):
        b = (31 * before[2 * k] + before[2 * k + 1]) & mask
        chain[k] = buckets[b]
        buckets[b] = k
    news = 0
    for k in range(count):
        i = pairs[2 * k]
        j = pairs[2 * k + 1]
        found = buckets[(31 * i + j) & mask]
        while found >= 0 and (before[2 * found] != i or before[2 * found + 1] != j):
            found = chain[found]
        if found < 0:
            pairs[2 * k] = pairs[2 * news]
            pairs[2 * k + 1] = pairs[2 * news + 1]
            pairs[2 * news] = i
            pairs[2 * news + 1] = j
            news += 1
    for k in range(count_before):
        buckets[(31 * before[2 * k] + before[2 * k + 1]) & mask] = -1
    return news
