"""Motion against closed forms: straight lines, stopping distances, arcs, turns, roads."""

from __future__ import annotations

import math

import hypothesis
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.sim.agent_views import MOVING
from kitrobot.sim.devices.turn import ANGLE_LEFT
from kitrobot.sim.physics.angles import direction
from kitrobot.sim.physics.motion import move_freely, roll
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import ACCELERATION, BRAKING, HEADING, SPEED, TARGET, TURN, UX, UY, WAY, X, Y
from kitrobot.world.geometry import Corner, normalised
from kitrobot.world.model import Road, Start, World
from tests.sim.building import MOTOR, SIDE, WHEEL, avatar, empty_world, robots_with, run_of, shipped_world, steps


def driver(text: str, settings: str = 'speed="400" acceleration="1000000" braking="1000000"') -> Simulation:
    robot = avatar(WHEEL.format(settings=settings), MOTOR.format(settings='rate="90"'))
    return run_of({"robot-1": (robot, text)}, empty_world(**{"robot-1": (1000, 1000, math.pi / 6)}))


def test_a_second_at_half_speed_is_half_of_full_speed_in_mm() -> None:
    run = steps(driver("Wheel.Advance(50); WAIT(600);"), 50)
    pose = run.agents[0]
    # The first step gains the speed almost at once: 200 mm/s at 10^6 mm/s².
    assert math.hypot(pose.x_mm - 1000, pose.y_mm - 1000) == pytest.approx(200, abs=0.05)
    assert math.atan2(pose.y_mm - 1000, pose.x_mm - 1000) == pytest.approx(math.pi / 6)


def test_reverse_is_advance_the_other_way() -> None:
    there = steps(driver("Wheel.Advance(30); WAIT(600);"), 40).agents[0]
    back = steps(driver("Wheel.Reverse(30); WAIT(600);"), 40).agents[0]
    assert there.x_mm - 1000 == pytest.approx(1000 - back.x_mm)
    assert there.heading_rad == back.heading_rad


@pytest.mark.parametrize("percent", [1, 25, 50, 100])
def test_the_stopping_distance_is_v_squared_by_two_a(percent: int) -> None:
    v, braking = percent * 4.0, 350.0
    run = driver(
        f"Wheel.Advance({percent}); WAIT(5); Wheel.Stop(); WAIT(600);", 'speed="400" acceleration="1e5" braking="350"'
    )
    steps(run, 25)
    moving = run.agents[0]
    steps(run, 100)
    still = run.agents[0]
    assert not still.flags
    assert math.hypot(still.x_mm - moving.x_mm, still.y_mm - moving.y_mm) == pytest.approx(v * v / (2 * braking))


def test_speed_is_gained_at_the_acceleration_of_the_robot() -> None:
    run = steps(driver("Wheel.Advance(100); WAIT(600);", 'speed="400" acceleration="200" braking="9"'), 50)
    pose = run.agents[0]
    assert math.hypot(pose.x_mm - 1000, pose.y_mm - 1000) == pytest.approx(200 * 1.0**2 / 2)


@given(st.floats(-500, 500), st.floats(-500, 500), st.floats(1, 5000), st.integers(1, 50))
def test_the_way_of_many_short_steps_is_the_way_of_one_long_one(v: float, u: float, rate: float, parts: int) -> None:
    def way(count: int) -> tuple[float, float]:
        robots, total = robots_with({SPEED: [v], TARGET: [u], ACCELERATION: [rate], BRAKING: [rate]}), 0.0
        for _ in range(count):
            roll(0.5 / count, robots)
            total += robots.floats[WAY][0]
        return total, robots.floats[SPEED][0]

    assert way(parts) == pytest.approx(way(1), abs=1e-6)


@given(st.floats(-400, 400), st.floats(-3, 3), st.floats(-3, 3))
def test_driving_and_turning_at_once_is_an_arc_of_radius_v_by_omega(v: float, omega: float, heading: float) -> None:
    ux, uy = direction(heading)
    robots = robots_with({HEADING: [heading], UX: [ux], UY: [uy], WAY: [v * 0.02], TURN: [omega * 0.02]})
    x, y, h = (robots.floats[column] for column in (X, Y, HEADING))
    for _ in range(50):
        move_freely(0, robots)
    assert normalised(h[0] - heading - omega) == pytest.approx(0, abs=1e-9)
    if abs(omega) > 1e-3:
        radius = v / omega
        assert x[0] == pytest.approx(radius * (math.sin(heading + omega) - math.sin(heading)), abs=1e-6)
        assert y[0] == pytest.approx(radius * (math.cos(heading) - math.cos(heading + omega)), abs=1e-6)


@pytest.mark.parametrize(("angle", "speed", "ticks"), [(25, 100, 50), (25, 50, 100), (100, 100, 200), (1, 100, 2)])
def test_an_absolute_turn_turns_by_a_part_of_a_full_turn_in_angle_by_rate(angle: int, speed: int, ticks: int) -> None:
    run = driver(f"Motor.AbsoluteTurn({angle}, {speed}); Wheel.Advance(10);")
    while run.outcome is None:
        run.step()
    assert normalised(run.agents[0].heading_rad - math.pi / 6 - angle / 100 * math.tau) == pytest.approx(0, abs=1e-9)
    # The tick after the last one of the turn sees that it is done.
    assert run.tick == ticks + 1


def test_turn_goes_on_until_stop() -> None:
    run = steps(driver("Motor.Turn(50); WAIT(10); Motor.Stop(); WAIT(600);"), 120)
    assert run.agents[0].heading_rad == pytest.approx(math.pi / 6 + math.radians(45))


def test_a_square_comes_back_to_where_it_began() -> None:
    run = driver("4*( Wheel.Advance(50); WAIT(10); Wheel.Stop(); WAIT(1); Motor.AbsoluteTurn(25, 100); )")
    while run.outcome is None:
        run.step()
    pose = run.agents[0]
    assert (pose.x_mm, pose.y_mm) == pytest.approx((1000, 1000), abs=1e-6)


def test_a_carrier_follows_its_road() -> None:
    ring = shipped_world("ring")
    guided = avatar(WHEEL.format(settings='guide="road" speed="400" acceleration="1e6" braking="1e6"'))
    run = run_of({"carrier-1": (guided, "Wheel.Advance(100); WAIT(600);")}, ring)
    line = ring.roads[0].line
    for second in range(1, 11):
        pose = steps(run, 50).agents[0]
        _, away = line.nearest(pose.x_mm, pose.y_mm)
        assert away < 1e-6
        assert run.stage.bodies.at[0] == pytest.approx((1600 + 400 * second) % line.length_mm, abs=0.2)
        assert normalised(pose.heading_rad - line.pose_at(run.stage.bodies.at[0]).heading_rad) == pytest.approx(0)


def test_at_the_end_of_an_open_road_a_carrier_stands() -> None:
    road = Road("lane", 100, False, (Corner(100, 100), Corner(600, 100)))
    world = World("lane", 1000, 1000, roads=(road,), starts=(Start("a", road="lane", at_mm=300),))
    guided = avatar(WHEEL.format(settings='guide="road"'))
    forward = steps(run_of({"a": (guided, "Wheel.Advance(100); WAIT(600);")}, world), 200).agents[0]
    assert (forward.x_mm, forward.y_mm) == (600, 100)
    back = steps(run_of({"a": (guided, "Wheel.Reverse(100); WAIT(600);")}, world), 200).agents[0]
    assert (back.x_mm, back.y_mm) == (100, 100)


@pytest.mark.parametrize("speed", [400, 20_000, 100_000])
def test_nobody_is_so_fast_that_it_goes_through_a_wall(speed: int) -> None:
    rocket = avatar(WHEEL.format(settings=f'speed="{speed}" acceleration="1e6"'))
    run = run_of({"a": (rocket, "Wheel.Advance(100); WAIT(600);")}, empty_world(a=(1000, 1000, 0.3)))
    for _ in range(600):
        pose = steps(run, 1).agents[0]
        assert 60 < pose.x_mm < 3940
        assert 60 < pose.y_mm < 2440
    assert run.collisions >= 1


# ---- two wheels

SWIFT = 'speed="400" acceleration="1e6" braking="1e6" track="80"'


def tank(text: str, settings: str = SWIFT, twice: bool = False) -> Simulation:
    """A robot of two wheels in the middle of the room, looking along +x; and one that only waits."""
    parts = [
        SIDE.format(name=side.title(), settings=f'side="{side}" length="80" {settings}') for side in ("left", "right")
    ]
    agents = {"a": (avatar(*parts, name="tank"), text)}
    if twice:
        agents["b"] = avatar(*parts, name="idler"), "WAIT(600);"
    return run_of(agents, empty_world(a=(2000, 1250, 0), b=(300, 300, 0)))


@given(st.integers(-100, 100), st.integers(-100, 100))
@hypothesis.settings(max_examples=40)
def test_two_wheels_drive_an_arc_of_radius_of_their_sum_by_their_difference_and_half_the_track(
    left: int, right: int
) -> None:
    ways = ["Forward" if percent >= 0 else "Backward" for percent in (left, right)]
    run = steps(tank(f"Left.{ways[0]}({abs(left)}); Right.{ways[1]}({abs(right)}); WAIT(600);"), 1)
    begin = run.agents[0]
    pose = steps(run, 50).agents[0]
    v, omega = 4.0 * (left + right) / 2, 4.0 * (right - left) / 80
    heading = begin.heading_rad
    assert normalised(pose.heading_rad - heading - omega) == pytest.approx(0, abs=1e-6)
    if left == right:
        expected = v * math.cos(heading), v * math.sin(heading)
    else:
        radius = (right + left) / (right - left) * 80 / 2
        expected = (
            radius * (math.sin(heading + omega) - math.sin(heading)),
            radius * (math.cos(heading) - math.cos(heading + omega)),
        )
    assert (pose.x_mm - begin.x_mm, pose.y_mm - begin.y_mm) == pytest.approx(expected, abs=1e-5)


def test_the_left_wheel_forward_and_the_right_one_backward_turn_clockwise_on_the_spot() -> None:
    pose = steps(tank("Left.Forward(10); Right.Backward(10); WAIT(600);"), 25).agents[0]
    assert (pose.x_mm, pose.y_mm) == pytest.approx((2000, 1250), abs=1e-9)
    assert pose.heading_rad == pytest.approx(-(2 * 40 / 80) * 0.5, abs=0.01)
    assert pose.flags & MOVING


def test_one_wheel_that_goes_alone_drives_around_the_other_one() -> None:
    run = tank("Right.Forward(50); WAIT(600);")
    for _ in range(60):
        pose = steps(run, 1).agents[0]
        left = pose.x_mm - 40 * math.sin(pose.heading_rad), pose.y_mm + 40 * math.cos(pose.heading_rad)
        assert left == pytest.approx((2000, 1290), abs=1e-6)


@pytest.mark.parametrize("percent", [10, 50, 100])
def test_wheels_gain_and_lose_speed_as_their_xml_says(percent: int) -> None:
    v, gain, braking = percent * 4.0, 500.0, 350.0
    both = "Left.{0}; Right.{0};"
    run = tank(
        f"{both.format(f'Forward({percent})')} WAIT(30); {both.format('Stop()')} WAIT(600);",
        f'speed="400" acceleration="{gain}" braking="{braking}" track="80"',
    )
    while run.state.actuators.floats[ANGLE_LEFT][0] != 0 or run.tick < 2:
        run.step()
    # Three seconds, and the one step in which it is told to stop has begun to brake.
    steps(run, 200)
    pose = run.agents[0]
    assert not pose.flags
    assert pose.y_mm == pytest.approx(1250)
    assert pose.x_mm - 2000 == pytest.approx(v * 3.0 - v * v / (2 * gain) + v * v / (2 * braking), abs=1e-6)


def test_a_run_of_wheels_is_over_only_when_they_stand() -> None:
    run = tank("Left.Forward(50); <Fault.IsRaised()>(); ")
    steps(run, 500)
    assert run.outcome is None
    assert run.agents[0].state == "running"


def test_the_wheels_of_a_robot_that_fails_brake_and_go_on_when_it_is_revived() -> None:
    run = tank(
        "Left.Forward(50); Right.Forward(50); WAIT(600);", SWIFT.replace('braking="1e6"', 'braking="400"'), twice=True
    )
    moving = steps(run, 50).agents[0]
    run.inject_fault("a", "fail")
    still = steps(run, 100).agents[0]
    assert still.x_mm - moving.x_mm == pytest.approx(200 * 200 / (2 * 400), abs=1e-6)
    run.inject_fault("a", "revive")
    assert steps(run, 50).agents[0].x_mm - still.x_mm == pytest.approx(200, abs=0.1)
