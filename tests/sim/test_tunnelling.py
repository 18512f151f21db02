"""Nothing goes through anything, however long a tick and however fast a robot is; who is far away changes nothing."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise

import pytest

from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.sim.physics.pushable_grid import PUSH_X, PUSH_Y
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import AT, HEADING, SPEED, X, Y
from kitrobot.world.model import Ball, Box, Wall, World
from tests.effort import cases, examples
from tests.sim.building import AVATAR, WHEEL, catalogue, empty_world, run_of, transport

GO = "Wheel.Advance(100); WAIT(200);"
BACK = "Wheel.Advance(100); WAIT(9); Wheel.Reverse(100); WAIT(7); Wheel.Advance(70); WAIT(20);"


def driver(speed: float = 400, tick: int = 20, length: float = 135, name: str = "avatar") -> Robot:
    """A robot that reaches its full speed at once."""
    settings = f'speed="{speed}" acceleration="1000000" braking="1000000" length="{length}" width="{length}"'
    text = AVATAR.format(tick=tick, parts=WHEEL.format(settings=settings)).replace('"avatar"', f'"{name}"', 1)
    made, problems = read_robot(text.encode(), "avatar.robot.xml")
    assert made is not None, problems
    return made


def room(
    poses: Mapping[str, tuple[float, float, float]],
    *walls: Wall,
    boxes: tuple[Box, ...] = (),
    balls: tuple[Ball, ...] = (),
) -> World:
    return replace(empty_world(**poses), width_mm=100_000.0, height_mm=3000.0, walls=walls, boxes=boxes, balls=balls)


def ended(run: Simulation, seconds: float = 4) -> Simulation:
    while run.outcome is None and run.seconds < seconds:
        run.step()
    return run


def rows(run: Simulation, count: int) -> list[list[float]]:
    """Where the first robots are, to the bit."""
    return [[float(run.state.robots.floats[column][i]) for column in (X, Y, HEADING, SPEED)] for i in range(count)]


HEAD_ON = {"a": (2000.0, 1000.0, 0.0), "b": (4100.0, 1000.0, 3.141592653589793)}


@pytest.mark.parametrize("tick", cases([20, 200, 1000], [40, 50, 130]))
@pytest.mark.parametrize("speed", cases([400, 20_000], [3000, 100_000]))
@pytest.mark.parametrize("length", [20, 135])
def test_two_that_meet_head_on_stand_against_each_other(tick: int, speed: float, length: float) -> None:
    run = ended(run_of(dict.fromkeys(HEAD_ON, (driver(speed, tick, length), GO)), room(HEAD_ON)))
    (one, y, _, _), (other, z, _, _) = rows(run, 2)
    assert other - one == pytest.approx(length, abs=1)
    assert [y, z] == pytest.approx([1000, 1000], abs=1e-3)
    assert run.collisions == 1


@pytest.mark.parametrize("tick", cases([200], [40, 1000]))
@pytest.mark.parametrize("speed", [400, 20_000])
def test_who_is_far_away_changes_nothing(tick: int, speed: float) -> None:
    far = {"c": (90_000.0, 2800.0, 0.0), "d": (80_000.0, 2500.0, 0.0), "e": (70_000.0, 200.0, 0.0)}
    agents = dict.fromkeys(HEAD_ON, (driver(speed, tick), GO))
    others = {
        "c": (catalogue().robots["mini-robot"], "WAIT(10);"),
        "d": (driver(90_000, tick, 4, "fast"), "WAIT(3); Wheel.Advance(3); WAIT(2); Wheel.Stop();"),
        "e": (driver(1000, 20, 2, "tiny"), "Wheel.Advance(100); WAIT(20); Wheel.Stop();"),
    }
    things = (Box(2900.0, 1010.0, 60.0, 60.0, 200.0, 0.5),)
    alone = run_of(agents, room(HEAD_ON, boxes=things))
    beside = run_of(agents | others, room(HEAD_ON | far, boxes=(*things, Box(60_000.0, 300.0, 2.0, 2.0, 1.0, 0.5))))
    for _ in range(150):
        alone.step()
        beside.step()
        assert rows(alone, 2) == rows(beside, 2)
        for column in (PUSH_X, PUSH_Y):
            assert float(alone.state.pushables.floats[column][0]) == float(beside.state.pushables.floats[column][0])


@pytest.mark.parametrize(("speed", "tick"), cases([(400, 1000), (20_000, 20)], [(3000, 20), (100_000, 200)]))
@pytest.mark.parametrize(
    "thing",
    [
        Box(3000.0, 1000.0, 60.0, 60.0, 100_000.0, 0.5),
        Box(3000.0, 1000.0, 4.0, 80.0, 20.0, 0.5),
        Ball(3000.0, 1000.0, 8.0, 20.0, 0.05),
    ],
)
def test_nobody_jumps_over_a_box_or_a_ball_and_a_wall_holds_it(speed: float, tick: int, thing: Box | Ball) -> None:
    start = {"a": (2000.0, 1000.0, 0.0)}
    boxes = (thing,) if isinstance(thing, Box) else ()
    balls = (thing,) if isinstance(thing, Ball) else ()
    wall = Wall(5000.0, 0.0, 5000.0, 3000.0)
    # As long as it takes to the wall and as long again, once it presses against that.
    made = run_of({"a": (driver(speed, tick), GO)}, room(start, wall, boxes=boxes, balls=balls))
    run = ended(made, max(15 * 400 / speed, 1.0))
    place = float(run.state.pushables.floats[PUSH_X][0])
    robot = rows(run, 1)[0][0]
    if isinstance(thing, Box):
        assert robot < place < 5000
    assert place < 5000
    assert robot <= 5000 - 67


@pytest.mark.parametrize("length", [40, 60, 120])
@pytest.mark.parametrize("radii", [1, 2, 7])
def test_a_wall_holds_who_goes_its_own_radius_in_a_step(length: float, radii: int) -> None:
    """Its middle would come exactly onto the wall, which then knows no side."""
    robot = driver(radii * length / 2 / 0.02, 20, length)
    run = ended(run_of({"a": (robot, GO)}, room({"a": (700.0, 600.0, 0.0)}, Wall(1200.0, 0.0, 1200.0, 1200.0))))
    assert rows(run, 1)[0][0] == pytest.approx(1200 - length / 2, abs=1e-6)


@pytest.mark.parametrize("speed", [400, 2000, 10_000])
@pytest.mark.parametrize("mass_g", [20.0, 1000.0, 100_000.0])
@pytest.mark.parametrize("shape", [Box, Ball])
def test_a_wall_holds_who_is_pressed_against_it_by_an_object(shape: type, mass_g: float, speed: float) -> None:
    ball = Ball(300.0, 600.0, 40.0, mass_g, 0.05)
    box = Box(300.0, 600.0, 60.0, 60.0, mass_g, 0.5)
    things = {"boxes": (box,)} if shape is Box else {"balls": (ball,)}
    poses = {"a": (180.0, 600.0, 0.0), "b": (600.0, 600.0, 3.141592653589793)}
    agents = {"a": (driver(1000, name="a"), "Wheel.Reverse(100); WAIT(40);"), "b": (driver(speed, name="b"), GO)}
    run = ended(run_of(agents, room(poses, Wall(100.0, 0.0, 100.0, 1200.0), **things)))
    (held, _, _, _), (pushing, _, _, _) = rows(run, 2)
    assert 100 + 67.4 < held < pushing
    assert float(run.state.pushables.floats[PUSH_X][0]) > 100


@pytest.mark.parametrize("seed", range(examples(12, 1000)))
def test_nobody_is_pushed_through_the_walls_of_a_closed_room(seed: int) -> None:
    """Robots that are pressed against a wall by others, balls that are pushed into a corner."""
    rng = random.Random(seed)
    size = 900.0
    places = [(x, y) for x in (150.0, 350.0, 550.0, 750.0) for y in (150.0, 350.0, 550.0, 750.0)]
    rng.shuffle(places)
    poses = {f"r{n}": (x, y, rng.uniform(-3.1, 3.1)) for n, (x, y) in enumerate(places[:6])}
    agents = {
        name: (driver(rng.choice([400, 1000, 2000, 5000]), 20, rng.choice([60, 100, 135]), f"avatar-{name}"), BACK)
        for name in poses
    }
    balls = tuple(Ball(x, y, rng.uniform(10, 40), 20.0, 0.05) for x, y in places[6:8])
    corners = [(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)]
    walls = [Wall(*one, *other) for one, other in pairwise([*corners, corners[0]])]
    run = run_of(agents, room(poses, *walls, balls=balls))
    floats = run.state.pushables.floats
    while run.outcome is None and run.seconds < 4:
        run.step()
        middles = [(x, y) for x, y, _, _ in rows(run, 6)]
        middles += [(float(floats[PUSH_X][k]), float(floats[PUSH_Y][k])) for k in range(2)]
        assert all(0 < x < size and 0 < y < size for x, y in middles), (run.seconds, middles)


@pytest.mark.parametrize(("speed", "tick"), cases([(400, 1000), (60_000, 20)], [(8000, 20), (60_000, 1000)]))
def test_nobody_overtakes_on_a_road(speed: float, tick: int) -> None:
    text = AVATAR.replace('"avatar"', '"{name}"')
    robots = []
    for name, own in (("quick", speed), ("slow", 100)):
        settings = f'guide="road" speed="{own}" acceleration="1000000" braking="1000000"'
        made, problems = read_robot(
            text.format(name=name, tick=tick, parts=WHEEL.format(settings=settings)).encode(), "r"
        )
        assert made is not None, problems
        robots.append(made)
    run = run_of(
        {"carrier-1": (robots[1], GO), "carrier-2": (robots[0], GO), "carrier-3": (robots[1], GO)}, transport(1).world
    )
    length = run.state.roads.length[0]
    at = run.state.robots.floats[AT]
    order = sorted(range(3), key=lambda i: float(at[i]))
    for _ in range(300):
        run.step()
        places = [float(run.state.robots.floats[AT][i]) for i in order]
        gaps = [(b - a) % length for a, b in pairwise([*places, places[0]])]
        assert sum(gaps) == pytest.approx(length)
        assert min(gaps) > 134


@pytest.mark.usefixtures("with_numba")
def test_what_is_very_fast_moves_alike_plain_and_compiled() -> None:
    runs = []
    for plain in (True, False):
        agents = dict.fromkeys(HEAD_ON, (driver(30_000, 40), GO))
        balls = (Ball(3000.0, 1000.0, 8.0, 20.0, 0.05), Ball(3100.0, 1020.0, 30.0, 20.0, 0.05))
        run = run_of(agents, room(HEAD_ON, Wall(4500.0, 0.0, 4500.0, 3000.0), balls=balls))
        run.stays_plain = plain
        if not plain:
            assert run.compile_step()
        run.advance(60)
        runs.append(run.snapshot())
    assert runs[0] == runs[1]
