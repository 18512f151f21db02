"""Who touches whom: module-level loops over flat lists of numbers, in the Python that Numba compiles too.

On a road, robots are ordered by where they are, and only neighbours can touch: bumper to bumper. Everywhere else a
robot is a disc. What overlaps is pushed apart; who touched is written down as pairs (robot, other), where a wall w is
the other -1 - w. The loops write at most `room` pairs and give how many there were.
"""

from __future__ import annotations

import math

TOUCH_MM = 0.5
"""Nearer than this is touching."""


def sort_along(order: list[int], road: list[int], at: list[float]) -> None:
    """Sorts robots by road and place; they hardly overtake, so insertion is quick."""
    for n in range(1, len(order)):
        i = order[n]
        k = n - 1
        while k >= 0 and (road[order[k]] > road[i] or (road[order[k]] == road[i] and at[order[k]] > at[i])):
            order[k + 1] = order[k]
            k -= 1
        order[k + 1] = i


def measure_gaps(
    order: list[int],
    road: list[int],
    at: list[float],
    length: list[float],
    road_length: list[float],
    closed: list[int],
    ahead: list[float],
    behind: list[float],
    leader: list[int],
) -> None:
    """For each robot in `order` (sorted): the free way ahead and behind, and who is ahead (-1: nobody)."""
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
        if r >= 0 and end - start > 1:
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


def part_on_roads(
    order: list[int],
    road: list[int],
    at: list[float],
    speed: list[float],
    road_length: list[float],
    closed: list[int],
    ahead: list[float],
    leader: list[int],
    pairs: list[int],
    room: int,
) -> int:
    """Robots that ran into one another on a road stand bumper to bumper; the one that came too near gives way."""
    count = 0
    for k in range(len(order)):
        i = order[k]
        j = leader[i]
        if j < 0 or ahead[i] > TOUCH_MM:
            continue
        if count < room:
            pairs[2 * count] = i
            pairs[2 * count + 1] = j
        count += 1
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
        ahead[i] = 0.0
    return count


def part_from_walls(
    road: list[int],
    solid: list[int],
    x: list[float],
    y: list[float],
    radius: list[float],
    x1: list[float],
    y1: list[float],
    x2: list[float],
    y2: list[float],
    pairs: list[int],
    room: int,
) -> int:
    """Free robots slide along walls and never through them; the wheels of one that goes straight at a wall slip."""
    count = 0
    for i in range(len(x)):
        if road[i] >= 0 or solid[i] == 0:
            continue
        for w in range(len(x1)):
            dx = x2[w] - x1[w]
            dy = y2[w] - y1[w]
            squared = dx * dx + dy * dy
            part = 0.0
            if squared > 0.0:
                part = ((x[i] - x1[w]) * dx + (y[i] - y1[w]) * dy) / squared
                if part < 0.0:
                    part = 0.0
                elif part > 1.0:
                    part = 1.0
            nx = x[i] - x1[w] - part * dx
            ny = y[i] - y1[w] - part * dy
            distance = math.sqrt(nx * nx + ny * ny)
            if distance > radius[i] + TOUCH_MM or distance == 0.0:
                continue
            if count < room:
                pairs[2 * count] = i
                pairs[2 * count + 1] = -1 - w
            count += 1
            if distance < radius[i]:
                nx /= distance
                ny /= distance
                x[i] += (radius[i] - distance) * nx
                y[i] += (radius[i] - distance) * ny
    return count


def sort_by_x(order: list[int], x: list[float]) -> None:
    """Sorts robots from left to right."""
    for n in range(1, len(order)):
        i = order[n]
        k = n - 1
        while k >= 0 and x[order[k]] > x[i]:
            order[k + 1] = order[k]
            k -= 1
        order[k + 1] = i


def part_discs(
    order: list[int],
    widest: float,
    road: list[int],
    x: list[float],
    y: list[float],
    radius: list[float],
    pairs: list[int],
    room: int,
) -> int:
    """Solid robots (`order`: from left to right) that are not on one road keep their discs apart; guided ones stay."""
    count = 0
    for k in range(len(order)):
        i = order[k]
        for m in range(k + 1, len(order)):
            j = order[m]
            dx = x[j] - x[i]
            if dx > radius[i] + widest + TOUCH_MM:
                break
            if road[i] >= 0 and road[i] == road[j]:
                continue
            dy = y[j] - y[i]
            near = radius[i] + radius[j]
            distance = math.sqrt(dx * dx + dy * dy)
            if distance > near + TOUCH_MM:
                continue
            if count < room:
                pairs[2 * count] = min(i, j)
                pairs[2 * count + 1] = max(i, j)
            count += 1
            if distance >= near or distance == 0.0 or (road[i] >= 0 and road[j] >= 0):
                continue
            first = 0.5
            if road[i] >= 0:
                first = 0.0
            elif road[j] >= 0:
                first = 1.0
            push = (near - distance) / distance
            x[i] -= first * push * dx
            y[i] -= first * push * dy
            x[j] += (1.0 - first) * push * dx
            y[j] += (1.0 - first) * push * dy
    return count
