"""What a program tells the motors of its robot, as a speed and a rate of turning."""

from __future__ import annotations

import math

import pytest

import kitrobot
from kitrobot import Agent, Mission, Pose, Simulation, Start, Team, World


def simulation(robot: str, text: str) -> Simulation:
    program = kitrobot.read_program(f"{text} WAIT(1000);", robot=robot, name="walk")
    world = World("yard", width_mm=4000, height_mm=4000, starts=(Start("ada", pose=Pose(2000, 2000, 0.3)),))
    team = Team([Agent("ada", program="walk")])
    run = kitrobot.open_mission(Mission(programs=[program], team=team, own_world=world)).simulation(seed=1)
    run.advance(60)
    return run


@pytest.mark.parametrize(
    ("text", "speed", "rate"),
    [
        ("Wheel.Advance(50);", 200, 0),
        ("Wheel.Reverse(25);", -100, 0),
        ("Wheel.DriveBy(100);", 200, 0),
        ("Motor.Turn(50);", 0, math.pi / 2),
        ("Motor.RightBy(180);", 0, -math.pi / 2),
        ("Wheel.Advance(50); Motor.Turn(50);", 200, math.pi / 2),
        ("Wheel.Advance(50); Wheel.Stop();", 0, 0),
    ],
)
def test_drive_and_motor_are_told_a_speed_and_a_rate(text: str, speed: float, rate: float) -> None:
    (robot,) = simulation("mini-robot", text).members
    assert robot.commanded_motion == pytest.approx((speed, rate))
    assert robot.motion == pytest.approx((speed, rate))


def test_two_wheels_are_told_an_arc() -> None:
    (robot,) = simulation("line-follower", "LeftWheel.Forward(20); RightWheel.Forward(60);").members
    # 20 and 60 % of 300 mm/s, give or take 1 %, on a track of 90 mm.
    assert robot.commanded_motion == pytest.approx((120, 120 / 90), rel=0.05)
    assert robot.motion == pytest.approx(robot.commanded_motion)


def test_a_robot_that_failed_is_told_nothing_and_one_that_stalled_goes_on() -> None:
    run = simulation("mini-robot", "Wheel.Advance(50); Motor.Turn(50);")
    (robot,) = run.members
    run.inject_fault("ada", "stall")
    run.advance(1)
    assert robot.commanded_motion == pytest.approx((200, math.pi / 2))
    run.inject_fault("ada", "fail")
    run.advance(1)
    assert robot.commanded_motion == (0, 0)
