"""Colour sensors over lines and coloured floor."""

from __future__ import annotations

import itertools
import math
import random
from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from kitrobot.sim.physics.sight import floor_at
from kitrobot.sim.tables.state import Floors
from kitrobot.world.geometry import Corner
from kitrobot.world.model import ColouredLine, Floor, rectangle_corners
from tests.sim.building import catalogue, empty_world, run_of
from tests.sim.test_devices import sensed


def test_a_colour_sensor_reads_lines_and_nothing_beside_them() -> None:
    lines = (
        ColouredLine("blue", 40, (Corner(0, 1000), Corner(4000, 1000))),
        ColouredLine("red", 40, (Corner(2000, 0), Corner(2000, 2500))),
    )
    mini = catalogue().robots["mini-robot"]

    def colour(x: float, y: float) -> int:
        world = replace(empty_world(a=(x, y, 0)), lines=lines)
        return sensed(run_of({"a": (mini, "WAIT(9);")}, world), "Light")

    assert [colour(500, 1000), colour(500, 1019.9), colour(500, 1020.1), colour(2000, 500), colour(2000, 1000)] == [
        3,
        3,
        0,
        1,
        1,
    ]


def test_a_colour_sensor_reads_coloured_floor_below_lines_the_last_on_top() -> None:
    circle = tuple(Corner(x, y, 200) for x, y in ((600, 600), (1000, 600), (1000, 1000), (600, 1000)))
    floors = (
        Floor("red", rectangle_corners(500, 500, 300, 300)),
        Floor("blue", circle),
        Floor("green", (Corner(2000, 0), Corner(3000, 0), Corner(2000, 1000))),
    )
    lines = (ColouredLine("red", 40, (Corner(900, 800), Corner(3000, 800))),)
    mini = catalogue().robots["mini-robot"]

    def colour(x: float, y: float) -> int:
        world = replace(empty_world(a=(x, y, 0)), floors=floors, lines=lines)
        return sensed(run_of({"a": (mini, "WAIT(9);")}, world), "Light")

    places = [(510, 510), (490, 510), (780, 780), (640, 640), (800, 995), (800, 1005), (950, 800), (950, 830)]
    assert [colour(*place) for place in places] == [1, 0, 3, 1, 3, 0, 1, 3]
    assert [colour(2400, 590), colour(2400, 610), colour(2190, 810)] == [2, 0, 1]


@given(st.lists(st.tuples(st.integers(0, 40), st.integers(0, 40)), min_size=3, max_size=8), st.randoms())
def test_a_point_is_on_a_floor_when_its_border_winds_around_it(
    corners: list[tuple[int, int]], rng: random.Random
) -> None:
    x, y = rng.uniform(-2, 42), rng.uniform(-2, 42)
    border = [*corners, corners[0]]
    angles = [math.atan2(b - y, a - x) for a, b in border]
    winding = sum(math.remainder(after - before, math.tau) for before, after in itertools.pairwise(angles))
    xs, ys = ([float(point[n]) for point in border] for n in (0, 1))
    box = [[min(xs)], [min(ys)], [max(xs)], [max(ys)]]
    inside = round(winding / math.tau) % 2 == 1
    assert floor_at(x, y, Floors([[2], [0], [len(xs) - 1]], box, [xs, ys])) == (2 if inside else 0)
