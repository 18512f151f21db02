"""How robots move in one step: module-level loops over flat lists of numbers, in the Python that Numba compiles too.

Speed goes to its target at the acceleration (or braking) of the robot, and the way is the exact integral of that, so
the stopping distance is v²/2a whatever the step. A robot that moves freely follows the exact arc of constant speed
and turn. Nothing in here allocates, calls, or knows a Python object.
"""

from __future__ import annotations

import math


def roll(
    dt: float,
    speed: list[float],
    target: list[float],
    acceleration: list[float],
    braking: list[float],
    way: list[float],
) -> int:
    """Brings each speed nearer to its target; `way[i]` is how far robot i rolls. Gives how many roll at all."""
    rolling = 0
    for i in range(len(speed)):
        v = speed[i]
        u = target[i]
        if v == u:
            way[i] = v * dt
            if v != 0.0:
                rolling += 1
            continue
        rolling += 1
        rate = acceleration[i]
        if v * u < 0.0 or abs(u) < abs(v):
            rate = braking[i]
        needed = abs(u - v) / rate
        if needed <= dt:
            way[i] = (v + u) / 2.0 * needed + u * (dt - needed)
            speed[i] = u
        else:
            after = v + rate * dt if u > v else v - rate * dt
            way[i] = (v + after) / 2.0 * dt
            speed[i] = after
    return rolling


def follow(
    way: list[float], speed: list[float], road: list[int], at: list[float], length: list[float], closed: list[int]
) -> None:
    """Moves the guided robots along their roads; at the end of an open road they stand."""
    for i in range(len(way)):
        r = road[i]
        if r < 0 or way[i] == 0.0:
            continue
        s = at[i] + way[i]
        if closed[r]:
            if s >= length[r]:
                s -= length[r]
            elif s < 0.0:
                s += length[r]
        elif s > length[r]:
            s = length[r]
            speed[i] = 0.0
        elif s < 0.0:
            s = 0.0
            speed[i] = 0.0
        at[i] = s


def place(
    road: list[int],
    at: list[float],
    stretch: list[int],
    x: list[float],
    y: list[float],
    heading: list[float],
    way_x: list[float],
    way_y: list[float],
    along: list[float],
    heading_from: list[float],
    heading_to: list[float],
    first: list[int],
    last: list[int],
) -> None:
    """The pose of each guided robot from its place along its road; `stretch` remembers where to look first."""
    for i in range(len(road)):
        r = road[i]
        if r < 0:
            continue
        s = at[i]
        k = stretch[i]
        if k < first[r] or k >= last[r]:
            k = first[r]
        while s < along[k] and k > first[r]:
            k -= 1
        while s >= along[k + 1] and k < last[r] - 1:
            k += 1
        stretch[i] = k
        part = (s - along[k]) / (along[k + 1] - along[k])
        x[i] = way_x[k] + part * (way_x[k + 1] - way_x[k])
        y[i] = way_y[k] + part * (way_y[k + 1] - way_y[k])
        heading[i] = heading_from[k] + part * (heading_to[k] - heading_from[k])


def wander(
    way: list[float], turn: list[float], road: list[int], x: list[float], y: list[float], heading: list[float]
) -> None:
    """Moves the free robots along the arc of their way and turn."""
    for i in range(len(way)):
        if road[i] >= 0:
            continue
        d = way[i]
        t = turn[i]
        h = heading[i]
        if abs(t) < 1e-9:
            if d != 0.0:
                x[i] += d * math.cos(h)
                y[i] += d * math.sin(h)
            continue
        if d != 0.0:
            r = d / t
            x[i] += r * (math.sin(h + t) - math.sin(h))
            y[i] += r * (math.cos(h) - math.cos(h + t))
        h += t
        if h > math.pi:
            h -= 2.0 * math.pi
        elif h <= -math.pi:
            h += 2.0 * math.pi
        heading[i] = h
