"""What a ray meets: module-level loops over flat lists of numbers, in the Python that Numba compiles too."""

from __future__ import annotations

import math


def ray_to_walls(
    x: float, y: float, angle: float, reach: float, x1: list[float], y1: list[float], x2: list[float], y2: list[float]
) -> float:
    """How far a ray goes until it meets a wall, `reach` at most."""
    ux = math.cos(angle)
    uy = math.sin(angle)
    best = reach
    for w in range(len(x1)):
        dx = x2[w] - x1[w]
        dy = y2[w] - y1[w]
        across = ux * dy - uy * dx
        if abs(across) < 1e-12:
            continue
        ax = x1[w] - x
        ay = y1[w] - y
        far = (ax * dy - ay * dx) / across
        part = (ax * uy - ay * ux) / across
        if 0.0 <= far < best and 0.0 <= part <= 1.0:
            best = far
    return best


def ray_to_discs(
    x: float,
    y: float,
    angle: float,
    reach: float,
    me: int,
    disc_x: list[float],
    disc_y: list[float],
    radius: list[float],
    solid: list[int],
) -> float:
    """How far a ray goes until it meets another solid robot, `reach` at most; 0 when it begins inside one."""
    ux = math.cos(angle)
    uy = math.sin(angle)
    best = reach
    for i in range(len(disc_x)):
        if i == me or solid[i] == 0:
            continue
        ax = disc_x[i] - x
        ay = disc_y[i] - y
        along = ax * ux + ay * uy
        squared = ax * ax + ay * ay
        inside = radius[i] * radius[i] - (squared - along * along)
        if inside < 0.0:
            continue
        half = math.sqrt(inside)
        if along + half < 0.0:
            continue
        far = max(0.0, along - half)
        if far < best:
            best = far
    return best


def distance_to_path(x: float, y: float, path_x: list[float], path_y: list[float], first: int, last: int) -> float:
    """From a point to the path through the points `first`…`last`."""
    best = math.inf
    for k in range(first, last):
        dx = path_x[k + 1] - path_x[k]
        dy = path_y[k + 1] - path_y[k]
        squared = dx * dx + dy * dy
        part = 0.0
        if squared > 0.0:
            part = max(0.0, min(1.0, ((x - path_x[k]) * dx + (y - path_y[k]) * dy) / squared))
        ax = x - path_x[k] - part * dx
        ay = y - path_y[k] - part * dy
        best = min(best, math.sqrt(ax * ax + ay * ay))
    return best
