"""How robots move in one step: loops over rows of numbers, in the Python that Numba compiles too.

Speed goes to its target at the acceleration (or braking) of the robot, and the way is the exact integral of that, so
the stopping distance is v²/2a whatever the step. A robot that moves freely follows the exact arc of constant speed
and turn. Each loop goes over the robots in `who`.
"""

from __future__ import annotations

import math

from kitrobot.sim.angles import direction


def roll(
    dt: float,
    who: list[int],
    speed: list[float],
    target: list[float],
    acceleration: list[float],
    braking: list[float],
    way: list[float],
) -> int:
    """Brings each speed nearer to its target; `way[i]` is how far robot i rolls. Gives how many roll at all."""
    rolling = 0
    for k in range(len(who)):
        i = who[k]
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
    who: list[int],
    way: list[float],
    speed: list[float],
    road: list[int],
    at: list[float],
    length: list[float],
    closed: list[int],
) -> None:
    """Moves the guided robots along their roads; at the end of an open road they stand."""
    for k in range(len(who)):
        i = who[k]
        if way[i] == 0.0:
            continue
        r = road[i]
        s = at[i] + way[i]
        if closed[r]:
            while s >= length[r]:
                s -= length[r]
            while s < 0.0:
                s += length[r]
        elif s > length[r]:
            s = length[r]
            speed[i] = 0.0
        elif s < 0.0:
            s = 0.0
            speed[i] = 0.0
        at[i] = s


def place(
    who: list[int],
    road: list[int],
    at: list[float],
    stretch: list[int],
    directed: list[int],
    x: list[float],
    y: list[float],
    heading: list[float],
    ux: list[float],
    uy: list[float],
    points: list[list[float]],
    first: list[int],
    last: list[int],
) -> None:
    """The pose of each guided robot from its place along its road; `stretch` remembers where to look first."""
    along = points[2]
    for n in range(len(who)):
        i = who[n]
        r = road[i]
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
        x[i] = points[0][k] + part * (points[0][k + 1] - points[0][k])
        y[i] = points[1][k] + part * (points[1][k + 1] - points[1][k])
        h = points[3][k] + part * (points[4][k] - points[3][k])
        if h != heading[i]:
            heading[i] = h
            if directed[i]:
                ux[i], uy[i] = direction(h)


def pieces(who: list[int], way: list[float], radius: list[float]) -> int:
    """In how many pieces the robots go their ways, so that none goes further than its radius at once."""
    most = 1.0
    for k in range(len(who)):
        i = who[k]
        if abs(way[i]) > most * radius[i]:
            most = abs(way[i]) / radius[i]
    return math.ceil(most)


def wander(
    part: float,
    who: list[int],
    way: list[float],
    turn: list[float],
    x: list[float],
    y: list[float],
    heading: list[float],
    ux: list[float],
    uy: list[float],
) -> None:
    """Moves the free robots along this part of the arc of their way and turn; (ux, uy) is where they look."""
    for k in range(len(who)):
        i = who[k]
        d = way[i] * part
        t = turn[i] * part
        if t == 0.0:
            if d != 0.0:
                x[i] += d * ux[i]
                y[i] += d * uy[i]
            continue
        h = heading[i] + t
        if h > math.pi:
            h -= 2.0 * math.pi
        elif h <= -math.pi:
            h += 2.0 * math.pi
        heading[i] = h
        cosine, sine = direction(h)
        if d != 0.0 and abs(t) < 1e-6:
            # A difference of two sines would be all error here; so is the chord's, but by t² only.
            x[i] += d * (ux[i] - t / 2.0 * uy[i])
            y[i] += d * (uy[i] + t / 2.0 * ux[i])
        elif d != 0.0:
            r = d / t
            x[i] += r * (sine - uy[i])
            y[i] += r * (ux[i] - cosine)
        ux[i] = cosine
        uy[i] = sine
