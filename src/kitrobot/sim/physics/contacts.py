"""Who touches whom: loops over rows of numbers, in the Python that Numba compiles too.

On a road, robots are ordered by where they are, and only neighbours can touch: bumper to bumper. Everywhere else a
robot is a disc. What overlaps is pushed apart; who touched is written down as pairs (robot, other), where a wall w is
the other -1 - w. The loops write pairs behind the `count` that are there already, as far as there is room, and give how
many there are now.
"""

from __future__ import annotations

import math

from kitrobot.sim.physics.motion import is_last, is_moving, nudge
from kitrobot.sim.physics.wall_contacts import TOUCH_MM, add_pair, hold_at_walls
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
from kitrobot.sim.tables.state import Contacts, Roads, Robots, State


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


def separate_discs(piece: int, state: State, count: int) -> int:
    """Robots that are not on one road keep their discs apart; guided ones stay. The grid was filled a moment ago.

    Two that meet in several cells are looked at in the first of them.
    """
    robots = state.robots
    grid = state.grid
    pairs = state.contacts.pairs
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
                push_apart(i, j, dx, dy, distance, state)
    return count


def push_apart(i: int, j: int, dx: float, dy: float, distance: float, state: State) -> None:
    """Moves two discs apart that overlap, one of them free; (dx, dy) is from the first to the other.

    Each gives way by half, a guided one not at all. Of what a wall does not let one go, the other one goes.
    """
    robots = state.robots
    floats = robots.floats
    road = robots.ints[ROAD]
    way = floats[WAY]
    ux = floats[UX]
    uy = floats[UY]
    near = floats[RADIUS][i] + floats[RADIUS][j]
    push = near
    if distance > 0.0:
        push = (near - distance) / distance
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
    is_held = push_disc(i, -first * push * dx, -first * push * dy, state)
    is_other_held = push_disc(j, (1.0 - first) * push * dx, (1.0 - first) * push * dy, state)
    if is_held:
        give_way(j, i, near, state)
    if is_other_held:
        give_way(i, j, near, state)


def push_disc(i: int, dx: float, dy: float, state: State) -> bool:
    """Moves a disc; gives whether a wall held it."""
    x = state.robots.floats[X]
    y = state.robots.floats[Y]
    was_x = x[i]
    was_y = y[i]
    x[i] += dx
    y[i] += dy
    return state.robots.ints[ROAD][i] < 0 and hold_at_walls(i, was_x, was_y, state)


def give_way(i: int, j: int, near: float, state: State) -> None:
    """Moves disc i, unless it is guided, out of disc j, which cannot move: their middles come `near` to each other."""
    x = state.robots.floats[X]
    y = state.robots.floats[Y]
    dx = x[i] - x[j]
    dy = y[i] - y[j]
    distance = math.sqrt(dx * dx + dy * dy)
    if distance >= near or distance == 0.0 or state.robots.ints[ROAD][i] >= 0:
        return
    push = (near - distance) / distance
    push_disc(i, push * dx, push * dy, state)


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
