"""Whether a driven path is a regular figure, such as a square.

The path, points in mm, is simplified (Ramer-Douglas-Peucker) so that no point of it is further than the tolerance from
the simplified line. It is the figure when all of these hold:

- it ends at most the tolerance away from where it began,
- the simplified line has exactly as many corners as the figure; a beginning in the middle of a side is no corner,
- each side is at least as long as asked for, and no two sides differ by more than twice the tolerance,
- the direction changes at each corner by 360° / corners, give or take `ANGLE_TOLERANCE` degrees, always the same
  way round.

So the size, the place and the direction of the figure are the child's choice; one round is driven.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from kitrobot.exercise.evidence import PathPoint
from kitrobot.text.sentences import Sentence

ANGLE_TOLERANCE = 15.0
"""Degrees that the turn at a corner may be off."""

_ROUNDS = 4
"""How often corners are moved to where they belong."""

Place = tuple[float, float]


def figure_fault(path: Sequence[PathPoint], corners: int, side: float, tolerance: float) -> Sentence | None:
    """Why a path is not the figure; None when it is.

    Args:
        path: where the robot was, in order; at least one point.
        corners: how many the figure has, 3 or more.
        side: the least length of a side, in mm.
        tolerance: in mm, more than 0.
    """
    places = [(point.x, point.y) for point in path]
    away = math.dist(places[0], places[-1])
    if max(math.dist(places[0], place) for place in places) < side / 2:
        return Sentence("the robot hardly moved")
    if away > tolerance:
        return Sentence(
            "the robot ends {away} mm away from where it began; at most {most} mm are allowed",
            round(away),
            f"{tolerance:g}",
        )
    found = _corners(places, tolerance, 360 / corners)
    if len(found) != corners:
        return Sentence("expected a way with {corners} corners, found {found}", corners, len(found))
    sides = [math.dist(found[i - 1], found[i]) for i in range(corners)]
    if min(sides) < side - tolerance:
        return Sentence("a side is {found} mm long; at least {side} mm are asked for", round(min(sides)), f"{side:g}")
    if max(sides) - min(sides) > 2 * tolerance:
        return Sentence(
            "the sides are not of one length: the shortest has {least} mm, the longest {most} mm",
            round(min(sides)),
            round(max(sides)),
        )
    turns = [_turn(found[i - 2], found[i - 1], found[i]) for i in range(corners)]
    wanted = 360 / corners
    way = math.copysign(1, sum(turns))
    wrong = max(turns, key=lambda turn: abs(turn * way - wanted))
    if abs(wrong * way - wanted) > ANGLE_TOLERANCE:
        return Sentence(
            "at a corner the way turns by {found} degrees instead of {wanted}", round(abs(wrong)), round(wanted)
        )
    return None


def _corners(places: Sequence[Place], tolerance: float, turn: float) -> list[Place]:
    """The corners of a closed path; a point where the way turns by less than half of `turn` degrees is none."""
    far = max(range(len(places)), key=lambda i: math.dist(places[0], places[i]))
    kept = [*_simplified(places, 0, far, tolerance)[:-1], *_simplified(places, far, len(places) - 1, tolerance)[:-1]]
    kept = _sharp(places, kept, turn / 2)
    if len(kept) >= 3:
        for _ in range(_ROUNDS):
            _settle(places, kept)
        kept = _sharp(places, kept, turn / 2)
    return [places[i] for i in kept]


def _sharp(places: Sequence[Place], kept: list[int], least: float) -> list[int]:
    """Those of the points at which the line through them turns by at least so many degrees."""
    if len(kept) < 3:
        return kept
    around = zip(kept[-1:] + kept[:-1], kept, kept[1:] + kept[:1], strict=True)
    return [i for before, i, after in around if abs(_turn(places[before], places[i], places[after])) >= least]


def _settle(places: Sequence[Place], kept: list[int]) -> None:
    """Moves each corner to the point between its neighbours that is furthest from the line through them.

    Simplifying keeps points that are far from long lines, which need not be the corners themselves.
    """
    count = len(places)
    for k in range(len(kept)):
        before, after = kept[k - 1], kept[(k + 1) % len(kept)]
        between = [i % count for i in range(before + 1, after if after > before else after + count)]
        kept[k] = max(between, key=lambda i: _away(places[i], places[before], places[after]), default=kept[k])
    kept.sort()


def _simplified(places: Sequence[Place], begin: int, end: int, tolerance: float) -> list[int]:
    """Some of the points from `begin` to `end`, both among them, from whose line none is further than the tolerance."""
    keep = {begin, end}
    waiting = [(begin, end)]
    while waiting:
        first, last = waiting.pop()
        if last - first < 2:
            continue
        furthest = max(range(first + 1, last), key=lambda i: _away(places[i], places[first], places[last]))
        if _away(places[furthest], places[first], places[last]) > tolerance:
            keep.add(furthest)
            waiting += [(first, furthest), (furthest, last)]
    return sorted(keep)


def _away(place: Place, one: Place, other: Place) -> float:
    """How far a place is from the line between two others, in mm."""
    dx, dy = other[0] - one[0], other[1] - one[1]
    length = dx * dx + dy * dy
    along = 0.0 if length == 0 else ((place[0] - one[0]) * dx + (place[1] - one[1]) * dy) / length
    along = min(1.0, max(0.0, along))
    return math.dist(place, (one[0] + along * dx, one[1] + along * dy))


def _turn(before: Place, at: Place, after: Place) -> float:
    """By how many degrees the direction changes at a corner, -180 to 180."""
    one = math.atan2(at[1] - before[1], at[0] - before[0])
    other = math.atan2(after[1] - at[1], after[0] - at[0])
    return math.degrees(math.remainder(other - one, math.tau))
