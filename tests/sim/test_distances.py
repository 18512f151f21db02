"""Distances and degrees end by themselves, exactly."""

from __future__ import annotations

import math

import pytest

import kitrobot
from kitrobot import Agent, Mission, Pose, Simulation, Start, Team, Wall, World


def simulation(text: str, *walls: Wall) -> Simulation:
    program = kitrobot.read_program(text, robot="mini-robot", name="walk")
    start = Start("ada", pose=Pose(2000, 2000, 0.3))
    world = World("yard", width_mm=4000, height_mm=4000, walls=walls, starts=(start,))
    team = Team([Agent("ada", program="walk")])
    return kitrobot.open_mission(Mission(programs=[program], team=team, own_world=world)).simulation(seed=1)


def end_of(text: str, *walls: Wall) -> tuple[float, float, float]:
    run = simulation(text, *walls)
    heading = run.agent("ada").heading_rad
    while run.outcome is None:
        run.advance(1000)
    ada = run.agent("ada")
    return ada.x_mm - 2000, ada.y_mm - 2000, math.remainder(ada.heading_rad - heading, 2 * math.pi)


@pytest.mark.parametrize(("sides", "angle"), [(3, 120), (4, 90), (5, 72), (6, 60), (8, 45), (360, 1)])
@pytest.mark.parametrize("turn", ["LeftBy", "RightBy"])
def test_a_polygon_closes(sides: int, angle: int, turn: str) -> None:
    x, y, heading = end_of(f"{sides}*( Wheel.DriveBy(7); Motor.{turn}({angle}); );")
    assert math.hypot(x, y) < 1e-6
    assert abs(heading) < 1e-9


@pytest.mark.parametrize("distance", [*range(13), 150])
def test_it_drives_as_far_as_it_says_and_back(distance: int) -> None:
    x, y, _ = end_of(f"Wheel.DriveBy({distance});")
    assert math.isclose(x * math.cos(0.3) + y * math.sin(0.3), distance * 10, abs_tol=1e-6)
    x, y, _ = end_of(f"Wheel.DriveBy({distance}); Wheel.BackBy({distance});")
    assert math.hypot(x, y) < 1e-6


def test_it_gains_and_loses_speed_as_its_wheels_can() -> None:
    run = simulation("Wheel.DriveBy(30);")
    ways = []
    before = run.agent("ada")
    while run.outcome is None:
        run.step()
        now = run.agent("ada")
        ways.append(math.hypot(now.x_mm - before.x_mm, now.y_mm - before.y_mm))
        before = now
    step = 800 * 0.02 * 0.02  # mm in a step more or less than in the step before
    assert all(abs(after - way) <= step + 1e-6 for way, after in zip([0.0, *ways], [*ways, 0.0], strict=True))
    assert max(ways) == pytest.approx(200 * 0.02)


@pytest.mark.parametrize(("text", "degrees"), [("LeftBy(45)", 45), ("RightBy(90)", -90), ("LeftBy(0)", 0)])
def test_it_turns_by_whole_degrees(text: str, degrees: int) -> None:
    assert math.degrees(end_of(f"Motor.{text};")[2]) == pytest.approx(degrees)


def test_a_full_turn_is_seen_and_ends_where_it_began() -> None:
    run = simulation("Motor.RightBy(360);")
    run.advance(100)
    assert run.outcome is None
    assert end_of("Motor.RightBy(360);")[2] == pytest.approx(0.0, abs=1e-9)


def test_a_distance_ends_at_a_wall_and_after_a_stop() -> None:
    x, _, _ = end_of("Wheel.DriveBy(150);", Wall(2300, 0, 2300, 4000))
    assert 150 < x < 300
    moved = end_of("//( Wheel.DriveBy(150);, WAIT(5); Wheel.Stop(); );")
    assert 20 < math.hypot(moved[0], moved[1]) < 150


def test_who_rolls_the_other_way_brakes_first() -> None:
    x, y, _ = end_of("Wheel.Advance(100); WAIT(10); Wheel.BackBy(10);")
    forward, _, _ = end_of("Wheel.Advance(100); WAIT(10); Wheel.Stop(); WAIT(10);")
    assert math.hypot(x, y) < math.hypot(forward / math.cos(0.3), 0)


def test_a_failed_robot_goes_on_with_what_is_left() -> None:
    run = simulation("Wheel.DriveBy(60);")
    run.advance(30)
    run.inject_fault("ada", "fail")
    run.advance(60)
    run.inject_fault("ada", "revive")
    while run.outcome is None:
        run.advance(100)
    ada = run.agent("ada")
    assert math.hypot(ada.x_mm - 2000, ada.y_mm - 2000) >= 600 - 1e-6
