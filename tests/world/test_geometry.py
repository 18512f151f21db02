"""Lines against closed forms: lengths of arcs, poses, the way back to mm, distances round a ring."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.world.geometry import SAGITTA_MM, Corner, Polyline, distance_to_stretch, normalised, polyline

SQUARE = [Corner(0, 0, 100), Corner(1000, 0, 100), Corner(1000, 600, 100), Corner(0, 600, 100)]


def rounded() -> Polyline:
    return polyline(SQUARE, closed=True)


def test_a_straight_line_is_as_long_as_its_ends_are_apart() -> None:
    line = polyline([Corner(10, 20), Corner(310, 420)], closed=False)
    assert line.length_mm == pytest.approx(500)
    pose = line.pose_at(250)
    assert (pose.x_mm, pose.y_mm) == pytest.approx((160, 220))
    assert pose.heading_rad == pytest.approx(math.atan2(400, 300))


def test_a_rounded_rectangle_is_its_straights_and_one_circle() -> None:
    assert rounded().length_mm == pytest.approx(2 * 800 + 2 * 400 + 2 * math.pi * 100)


def test_half_way_round_a_corner_the_heading_has_turned_half() -> None:
    line = polyline([Corner(0, 0), Corner(500, 0, 200), Corner(500, 500)], closed=False)
    pose = line.pose_at(300 + 200 * math.pi / 4)
    assert pose.heading_rad == pytest.approx(math.pi / 4)
    assert pose.x_mm == pytest.approx(300 + 200 * math.sin(math.pi / 4), abs=SAGITTA_MM)
    assert pose.y_mm == pytest.approx(200 * (1 - math.cos(math.pi / 4)), abs=SAGITTA_MM)


def test_samples_of_an_arc_lie_on_it_and_chords_leave_it_by_no_more_than_promised() -> None:
    line = polyline([Corner(0, 0), Corner(500, 0, 200), Corner(500, 500)], closed=False)
    for x, y in list(zip(line.xs, line.ys, strict=True))[1:-1]:
        assert math.hypot(x - 300, y - 200) == pytest.approx(200)
    for part in range(100):
        pose = line.pose_at(300 + part * math.pi)
        assert 200 - SAGITTA_MM <= math.hypot(pose.x_mm - 300, pose.y_mm - 200) <= 200 + 1e-9


def test_a_closed_line_ends_where_it_begins() -> None:
    line = rounded()
    first, last = line.pose_at(0), line.pose_at(line.length_mm - 1e-7)
    assert (first.x_mm, first.y_mm) == pytest.approx((last.x_mm, last.y_mm), abs=1e-5)
    assert normalised(first.heading_rad - last.heading_rad) == pytest.approx(0, abs=1e-5)


@given(st.floats(-1e5, 1e5))
def test_nearest_is_the_way_back_from_a_pose(at: float) -> None:
    line = rounded()
    pose = line.pose_at(at)
    found, away = line.nearest(pose.x_mm, pose.y_mm)
    assert away < 1e-6
    away = abs(found - line.wrapped(at))
    assert min(away, line.length_mm - away) < 1e-3


def test_an_open_line_is_held_at_its_ends() -> None:
    line = polyline([Corner(0, 0), Corner(100, 0)], closed=False)
    assert line.pose_at(-5).x_mm == 0
    assert line.pose_at(105).x_mm == 100


def test_from_a_point_to_a_stretch() -> None:
    assert distance_to_stretch(5, 3, 0, 0, 10, 0) == (3, 0.5)
    assert distance_to_stretch(13, 4, 0, 0, 10, 0) == (5, 1)
    assert distance_to_stretch(3, 4, 0, 0, 0, 0) == (5, 0)


@pytest.mark.parametrize(
    ("corners", "closed", "words"),
    [
        ([Corner(0, 0)], False, "two points"),
        ([Corner(0, 0), Corner(9, 9)], True, "closed one three"),
        ([Corner(0, 0), Corner(0, 0)], False, "the same"),
        ([Corner(0, 0), Corner(100, 0, 101), Corner(100, 100)], False, "no room"),
        ([Corner(0, 0), Corner(100, 0, 5), Corner(0, 0)], False, "no room"),
        ([Corner(0, 0, 60), Corner(100, 0, 60), Corner(100, 200), Corner(0, 200)], True, "no room"),
    ],
)
def test_a_line_that_cannot_be_drawn_says_why(corners: list[Corner], closed: bool, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        polyline(corners, closed)


def test_a_radius_that_just_fits_is_drawn() -> None:
    corners = [Corner(0, 0), Corner(100, 0, 100), Corner(100, 100)]
    assert polyline(corners, closed=False).length_mm == pytest.approx(50 * math.pi)
