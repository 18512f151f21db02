"""Boxes and balls: pushed by robots and by each other, stopped by friction and walls, the same bits on both steps."""

from __future__ import annotations

import math
import random
from dataclasses import replace

import pytest

from kitrobot.sim.physics.pushable_grid import PUSH_HALF_HEIGHT, PUSH_HALF_WIDTH, PUSH_IS_BALL, PUSH_X, PUSH_Y
from kitrobot.sim.recorder import Recorder
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import RADIUS
from kitrobot.world.model import Ball, Box, Wall
from tests.sim.building import catalogue, empty_world, run_of

PUSH = "Wheel.Advance(50); WAIT(40); Wheel.Stop(); WAIT(60);"


def pushing(*things: Box | Ball, text: str = PUSH, walls: tuple[Wall, ...] = (), robots: int = 1) -> Simulation:
    poses = {f"r{n}": (500.0, 500.0 + 200 * n, 0.0) for n in range(robots)}
    world = replace(
        empty_world(**poses),
        walls=walls,
        boxes=tuple(one for one in things if isinstance(one, Box)),
        balls=tuple(one for one in things if isinstance(one, Ball)),
    )
    return run_of(dict.fromkeys(poses, (catalogue().robots["mini-robot"], text)), world, seconds=60)


def places(run: Simulation) -> list[tuple[float, float]]:
    floats = run.state.pushables.floats
    return [(float(x), float(y)) for x, y in zip(floats[PUSH_X], floats[PUSH_Y], strict=True)]


def to(run: Simulation, tick: int) -> Simulation:
    while run.tick < tick and run.advance(tick - run.tick):
        pass
    return run


def box(x: float, y: float, mass: float = 200.0, friction: float = 0.5) -> Box:
    return Box(x, y, 60.0, 60.0, mass, friction)


def test_a_box_is_pushed_and_pushes_the_next_and_stays_where_it_was_left() -> None:
    run = to(pushing(box(700, 500), box(800, 510)), 190)
    (x, y), (other, _) = places(run)
    robot, *_ = run.poses()[0]
    assert y == 500.0
    assert other - x == pytest.approx(60, abs=0.5)
    assert x - robot == pytest.approx(67.5 + 30, abs=1)
    left = places(to(run, 240))
    assert places(to(run, 300)) == left


def test_a_ball_rolls_on_and_its_friction_stops_it() -> None:
    rough, smooth = (to(pushing(Ball(700, 500, 30, 50, friction)), 400) for friction in (0.05, 0.005))
    robot, *_ = rough.poses()[0]
    assert robot + 110 < places(rough)[0][0] < places(smooth)[0][0]


def test_the_heavier_a_box_the_slower_the_robot() -> None:
    reached = [to(pushing(box(640, 500, mass)), 150).poses()[0][0] for mass in (10, 1000, 20_000, 1_000_000)]
    assert reached == sorted(reached, reverse=True)
    assert reached[0] > 900
    assert reached[-1] < 560


def test_walls_stop_things_and_what_a_robot_does_not_touch_stays_to_the_bit() -> None:
    wall = Wall(900, 0, 900, 1000)
    run = to(pushing(box(700, 500), Ball(700, 900, 25, 50, 0.02), walls=(wall,)), 300)
    (x, _), ball = places(run)
    assert x <= 870.5
    assert ball == (700.0, 900.0)


def test_a_range_sensor_sees_boxes_and_balls() -> None:
    for thing in (box(900, 500), Ball(900, 500, 30, 50, 0.02)):
        run = pushing(thing, text="WAIT(9);")
        run.step()
        assert run.agents[0].inputs["Captor"] == round((900 - 30 - 567.5) / 10)


def test_a_world_without_things_has_no_columns_for_them_and_one_with_them_has_their_places() -> None:
    assert not [one for one in Recorder(pushing()).header.columns if one.name.startswith("thing")]
    run = to(pushing(box(700, 500)), 150)
    recorder = Recorder(run)
    x = next(at for at, one in enumerate(recorder.header.columns) if one.name == "thing 0 x_mm")
    assert recorder.record().numbers[x] == round(places(run)[0][0] * 10)


def test_a_run_goes_on_while_a_ball_rolls_and_goes_on_alike_from_a_snapshot() -> None:
    run = to(pushing(Ball(700, 500, 30, 50, 0.05), box(1300, 500), robots=2), 120)
    other = pushing(Ball(700, 500, 30, 50, 0.05), box(1300, 500), robots=2)
    other.restore(run.snapshot())
    assert to(run, 260).snapshot() == to(other, 260).snapshot()
    assert places(run)[0][0] > 900


def crowd(seed: int) -> Simulation:
    chance = random.Random(seed)
    things: list[Box | Ball] = []
    for n in range(30):
        x, y = 650 + 110 * (n % 6) + chance.uniform(-9, 9), 450 + 120 * (n // 6)
        size, mass, friction = chance.uniform(20, 90), chance.uniform(5, 900), chance.choice((0.0, 0.01, 0.3, 0.9))
        things.append(
            Box(x, y, size, chance.uniform(20, 90), mass, friction) if n % 3 else Ball(x, y, size / 2, mass, friction)
        )
    text = "*( Wheel.Advance({a}); WAIT(9); Motor.AbsoluteTurn({b}, 90); Wheel.Reverse(30); WAIT(2); );"
    walls = (Wall(400, 300, 1500, 300), Wall(1500, 300, 1400, 1300))
    numbers = {"a": chance.randint(30, 100), "b": chance.randint(1, 60)}
    return pushing(*things, text=text.format(**numbers), walls=walls, robots=3)


def test_the_same_bits_plain_and_compiled(with_numba: None) -> None:
    for seed in range(3):
        plain, compiled = crowd(seed), crowd(seed)
        plain.stays_plain = True
        assert compiled.compile_step()
        for tick in (1, 2, 80, 200):
            assert to(plain, tick).snapshot() == to(compiled, tick).snapshot()


@pytest.mark.parametrize("seed", range(3))
def test_nothing_gets_lost_or_stands_in_another_for_long(seed: int) -> None:
    run = to(crowd(seed), 300)
    floats, ball = run.state.pushables.floats, run.state.pushables.ints[PUSH_IS_BALL]
    assert all(math.isfinite(number) for row in floats for number in row)
    robots = [(x, y, float(run.state.robots.floats[RADIUS][n])) for n, (x, y, *_) in enumerate(run.poses())]
    for i, (x, y) in enumerate(places(run)):
        for rx, ry, radius in robots:
            dx, dy = abs(x - rx), abs(y - ry)
            if not ball[i]:
                dx, dy = max(0.0, dx - floats[PUSH_HALF_WIDTH][i]), max(0.0, dy - floats[PUSH_HALF_HEIGHT][i])
            assert math.hypot(dx, dy) > radius - 20
