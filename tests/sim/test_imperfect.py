"""Every device of the paper, and the wheel, is as late, noisy and lossy as its XML says; the same for the same seed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from statistics import mean, stdev

import pytest

from kitrobot.primitives.robot import Robot
from kitrobot.sim.agent_views import LAMP
from kitrobot.sim.devices.door import OPENING
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import A_ACTION, HEADING, SPEED
from kitrobot.world.model import Floor, World, rectangle_corners
from tests.sim.building import MOTOR, SIDE, WHEEL, avatar, empty_world, run_of, steps

DOOR = """<actuator name="Door" device="door" {settings}>
  <procedure name="Open" completes="later"/><procedure name="Close" completes="later"/></actuator>"""
LIGHT = """<actuator name="Light" device="lamp" {settings}>
  <procedure name="LightOn" stop="LightOff"/><procedure name="LightOff"/></actuator>"""
SWITCH = """<actuator name="Switch" device="switch" {settings}>
  <procedure name="SwitchOn" stop="SwitchOff"/><procedure name="SwitchOff"/></actuator>"""

ACTUATORS: dict[str, tuple[str, str, Callable[[Simulation], float]]] = {
    "motor": (MOTOR, "Motor.Turn(50);", lambda run: run.state.robots.floats[HEADING][0]),
    "drive": (WHEEL, "Wheel.Advance(50);", lambda run: run.state.robots.floats[SPEED][0]),
    "wheel": (SIDE.replace("{name}", "Left"), "Left.Forward(50);", lambda run: run.state.robots.floats[SPEED][0]),
    "door": (DOOR, "Door.Open();", lambda run: run.state.actuators.floats[OPENING][0]),
    "light": (LIGHT, "Light.LightOn();", lambda run: run.agents[0].flags & LAMP),
    "switch": (SWITCH, "Switch.SwitchOn();", lambda run: run.state.actuators.ints[A_ACTION][0]),
}
"""What it is in XML, how it is told to do something, and what changes when it does."""

SWIFT = WHEEL.format(settings='speed="1000" acceleration="1e6" length="100"')
SENSORS = {
    "captor": '<sensor name="Eye" device="range" min="0" max="100" {settings}>'
    '<operation name="Value" value="yes"/></sensor>',
    "light": '<sensor name="Eye" device="colour" min="0" max="3" {settings}>'
    '<operation name="Value" value="yes"/></sensor>',
    "button": '<sensor name="Eye" device="button" type="boolean" {settings}>'
    '<operation name="IsPressed" test="equal" to="1"/></sensor>',
}


def told(device: str, settings: str, seed: int = 1) -> Simulation:
    part, text, _ = ACTUATORS[device]
    robot = avatar(part.format(settings=settings))
    return run_of({"a": (robot, f"{text} WAIT(600);")}, empty_world(a=(1000, 1000, 0)), seed=seed)


def first_change(device: str, run: Simulation, most: int = 60) -> int | None:
    """The step in which something came of it; None when nothing did."""
    look = ACTUATORS[device][2]
    before = look(run)
    for step in range(1, most + 1):
        run.step()
        if look(run) != before:
            return step
    return None


@pytest.mark.parametrize("device", ACTUATORS)
def test_a_command_comes_to_an_actuator_as_late_as_its_xml_says(device: str) -> None:
    now = first_change(device, told(device, ""))
    assert now is not None
    assert first_change(device, told(device, 'latency="100"')) == now + 5
    assert first_change(device, told(device, 'latency="101"')) == now + 6


@pytest.mark.parametrize("device", ACTUATORS)
def test_a_command_to_an_actuator_is_lost_as_often_as_its_xml_says_and_by_the_seed(device: str) -> None:
    assert first_change(device, told(device, 'dropout="100"')) is None

    def arrived(runs: int) -> list[bool]:
        return [first_change(device, told(device, 'dropout="40"', seed), 5) is not None for seed in range(runs)]

    once = arrived(100)
    assert 45 <= sum(once) <= 75
    assert arrived(20) == once[:20]


@pytest.mark.parametrize("device", ["motor", "drive", "wheel"])
def test_what_an_actuator_does_is_off_by_the_standard_deviation_in_its_xml(device: str) -> None:
    def effect(seed: int, settings: str) -> float:
        return ACTUATORS[device][2](steps(told(device, settings, seed), 40))

    exact = effect(1, "")
    parts = [effect(seed, 'noise="10"') / exact for seed in range(60)]
    assert mean(parts) == pytest.approx(1, abs=0.05)
    assert stdev(parts) == pytest.approx(0.1, rel=0.3)
    assert effect(3, 'noise="10"') == effect(3, 'noise="10"')


def sensing(sensor: str, settings: str, seed: int = 1) -> list[int]:
    """What a robot reads that drives over a red patch into the wall."""
    robot: Robot = avatar(SWIFT, SENSORS[sensor].format(settings=settings))
    patch = Floor("red", rectangle_corners(3200, 900, 300, 200))
    world: World = replace(empty_world(a=(3000, 1000, 0)), floors=(patch,))
    run = run_of({"a": (robot, "Wheel.Advance(100); WAIT(600);")}, world, seed=seed)
    return [steps(run, 1).agents[0].inputs["Eye"] for _ in range(80)]


@pytest.mark.parametrize("sensor", SENSORS)
def test_a_reading_is_as_old_as_its_xml_says(sensor: str) -> None:
    fresh, old = sensing(sensor, ""), sensing(sensor, 'latency="120"')
    assert len(set(fresh)) > 1
    assert old[6:] == fresh[:-6]


@pytest.mark.parametrize("sensor", SENSORS)
def test_a_lost_reading_is_the_one_before_as_often_as_its_xml_says(sensor: str) -> None:
    assert set(sensing(sensor, 'dropout="100"')) == {0}
    fresh, lossy = sensing(sensor, ""), sensing(sensor, 'dropout="60"')
    kept = 0
    for step, value in enumerate(lossy):
        assert value == fresh[step] or value == (lossy[step - 1] if step else 0)
        kept += value != fresh[step]
    assert kept > 0
    assert lossy == sensing(sensor, 'dropout="60"')


@pytest.mark.parametrize("sensor", SENSORS)
def test_a_noisy_sensor_is_wrong_by_the_seed(sensor: str) -> None:
    runs = [sensing(sensor, 'noise="20"', seed) for seed in (1, 1, 2)]
    assert runs[0] == runs[1]
    assert runs[0] != runs[2]
    assert sum(one != other for one, other in zip(runs[0], sensing(sensor, ""), strict=True)) > 5
