"""How robots move in one step: loops over rows of numbers, in the Python that Numba compiles too.

Speed goes to its target at the acceleration (or braking) of the robot, and the way is the exact integral of that, so
the stopping distance is v²/2a whatever the step. A robot that moves freely follows the exact arc of constant speed
and turn.
"""

from __future__ import annotations

import math

from kitrobot.sim.physics.angles import direction
from kitrobot.sim.tables.columns import (
    ACCELERATION,
    AT,
    BRAKING,
    CLOSED,
    DIRECTED,
    FIRST,
    HEADING,
    LAST,
    NUDGED,
    PIECES,
    ROAD,
    SPEED,
    STRETCH,
    TARGET,
    TURN,
    UX,
    UY,
    WAY,
    X,
    Y,
)
from kitrobot.sim.tables.state import Roads, Robots


def roll(dt: float, robots: Robots) -> int:
    """Brings the speed of each robot nearer to its target; WAY is how far it rolls. Gives how many roll at all."""
    who = robots.solid
    floats = robots.floats
    speed = floats[SPEED]
    target = floats[TARGET]
    acceleration = floats[ACCELERATION]
    braking = floats[BRAKING]
    way = floats[WAY]
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


def move_along_roads(piece: int, robots: Robots, roads: Roads) -> None:
    """Moves the guided robots along their roads, by this piece of their way; at the end of an open road they stand."""
    who = robots.guided
    floats = robots.floats
    way = floats[WAY]
    speed = floats[SPEED]
    at = floats[AT]
    road = robots.ints[ROAD]
    count = robots.ints[PIECES]
    length = roads.length
    closed = roads.ints[CLOSED]
    for k in range(len(who)):
        i = who[k]
        if way[i] == 0.0 or road[i] < 0 or piece >= count[i]:
            continue
        r = road[i]
        s = at[i] + way[i] / count[i]
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


def place(robots: Robots, roads: Roads) -> None:
    """The pose of each guided robot from its place along its road; STRETCH remembers where to look first."""
    who = robots.guided
    ints = robots.ints
    road = ints[ROAD]
    stretch = ints[STRETCH]
    directed = ints[DIRECTED]
    floats = robots.floats
    at = floats[AT]
    x = floats[X]
    y = floats[Y]
    heading = floats[HEADING]
    ux = floats[UX]
    uy = floats[UY]
    firsts = roads.ints[FIRST]
    lasts = roads.ints[LAST]
    points = roads.points
    xs = points[0]
    ys = points[1]
    along = points[2]
    begins = points[3]
    ends = points[4]
    for n in range(len(who)):
        i = who[n]
        r = road[i]
        if r < 0:
            continue
        s = at[i]
        k = stretch[i]
        first = firsts[r]
        last = lasts[r]
        if k < first or k >= last:
            k = first
        while s < along[k] and k > first:
            k -= 1
        while s >= along[k + 1] and k < last - 1:
            k += 1
        stretch[i] = k
        part = (s - along[k]) / (along[k + 1] - along[k])
        x[i] = xs[k] + part * (xs[k + 1] - xs[k])
        y[i] = ys[k] + part * (ys[k + 1] - ys[k])
        h = begins[k] + part * (ends[k] - begins[k])
        if h != heading[i]:
            heading[i] = h
            if directed[i]:
                ux[i], uy[i] = direction(h)


def is_moving(i: int, piece: int, robots: Robots) -> bool:
    """Whether robot i goes a piece of its way in this one, or was pushed in this step by who does."""
    return piece < robots.ints[PIECES][i] or piece < robots.ints[NUDGED][i]


def nudge(i: int, j: int, robots: Robots) -> None:
    """One of two robots pushes the other in this step: both are looked at as long as either goes on."""
    count = robots.ints[PIECES]
    nudged = robots.ints[NUDGED]
    most = max(max(count[i], nudged[i]), max(count[j], nudged[j]))
    if most > 1:
        nudged[i] = most
        nudged[j] = most


def is_last(i: int, j: int, piece: int, robots: Robots) -> bool:
    """Whether neither of two robots goes on after this piece."""
    return piece + 1 == max(robots.ints[PIECES][i], robots.ints[PIECES][j])


def move_freely(piece: int, robots: Robots) -> None:
    """Moves the free robots along this piece of the arc of their way and turn; (UX, UY) is where they look."""
    who = robots.free
    floats = robots.floats
    way = floats[WAY]
    turn = floats[TURN]
    x = floats[X]
    y = floats[Y]
    heading = floats[HEADING]
    ux = floats[UX]
    uy = floats[UY]
    count = robots.ints[PIECES]
    for k in range(len(who)):
        i = who[k]
        if piece >= count[i]:
            continue
        part = 1.0 / count[i]
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
