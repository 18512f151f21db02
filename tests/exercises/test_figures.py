"""A driven path is the figure that a child meant, or it is said in what it differs."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from kitrobot.exercise.evidence import PathPoint
from kitrobot.exercise.figures import figure_fault

Places = list[tuple[float, float]]


def driven(corners: Places, step: float = 5.0) -> list[PathPoint]:
    """A path along these corners, a point each so many mm."""
    made = [PathPoint(*corners[0], 0.0)]
    for (x, y), (u, v) in pairwise(corners):
        pieces = max(1, round(math.dist((x, y), (u, v)) / step))
        made += [PathPoint(x + (u - x) * i / pieces, y + (v - y) * i / pieces, 0.0) for i in range(1, pieces + 1)]
    return made


def polygon(corners: int, side: float, turned: float = 0.3) -> Places:
    places = [(100.0, 200.0)]
    for n in range(corners):
        angle = turned + n * math.tau / corners
        x, y = places[-1]
        places.append((x + side * math.cos(angle), y + side * math.sin(angle)))
    return places


@pytest.mark.parametrize("corners", [3, 4, 5, 8, 12])
@pytest.mark.parametrize("way", [1, -1])
def test_a_regular_figure_is_one_whichever_way_round_and_of_no_other_number_of_corners(corners: int, way: int) -> None:
    path = driven(polygon(corners, 400)[::way])
    assert figure_fault(path, corners, 150, 30) is None
    other = corners + 1 if corners < 12 else corners - 1
    assert "corners, found" in str(figure_fault(path, other, 150, 30))


def test_a_square_that_begins_in_the_middle_of_a_side_is_a_square() -> None:
    places: Places = [(0, 0), (200, 0), (200, 400), (-200, 400), (-200, 0), (0, 0)]
    assert figure_fault(driven(places), 4, 150, 30) is None


def test_standing_at_the_end_and_turning_there_is_no_corner() -> None:
    path = driven(polygon(4, 300))
    assert figure_fault([*path, *[path[-1]] * 50], 4, 150, 30) is None


@pytest.mark.parametrize(
    ("places", "said"),
    [
        ([(0, 0), (0, 1)], "the robot hardly moved"),
        ([(0, 0), (400, 0), (400, 400), (0, 400)], "the robot ends 400 mm away from where it began"),
        ([(0, 0), (400, 0), (400, 200), (0, 200), (0, 0)], "the sides are not of one length: the shortest has 200 mm"),
        ([(0, 0), (400, 0), (600, 346), (200, 346), (0, 0)], "the way turns by "),
        ([(0, 0), (100, 0), (100, 100), (0, 100), (0, 0)], "a side is 100 mm long; at least 150 mm are asked for"),
        ([(0, 0), (400, 0), (0, 0)], "expected a way with 4 corners, found 2"),
        (polygon(24, 100), "expected a way with 4 corners, found "),
    ],
)
def test_what_is_no_square_is_said(places: Places, said: str) -> None:
    assert said in str(figure_fault(driven(places), 4, 150, 30))


def test_twice_around_is_not_once_around() -> None:
    square = polygon(4, 300)
    assert figure_fault(driven([*square, *square[1:]]), 4, 150, 30) is not None


def test_the_tolerance_is_held_at_its_limit() -> None:
    def ends(away: float) -> Places:
        return [(0, 0), (400, 0), (400, 400), (0, 400), (0, away)]

    assert figure_fault(driven(ends(30)), 4, 150, 30) is None
    assert "31 mm away" in str(figure_fault(driven(ends(31)), 4, 150, 30))
