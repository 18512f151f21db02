"""Latency, drop-outs and noise of devices, and what every device has in common."""

from __future__ import annotations

import inspect
import itertools
import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from statistics import mean, stdev

import pytest

from kitrobot.sim.agent_views import LAMP
from kitrobot.sim.devices import Device, Sensor, actuators, sensors
from kitrobot.sim.jit.compiler import loops
from tests.patience import PATIENCE_S
from tests.sim.building import WHEEL, avatar, empty_world, run_of, steps
from tests.sim.test_devices import RANGE, ROOT, SENSOR, sensed


def test_every_device_has_latency_and_drop_outs_and_every_measure_has_noise() -> None:
    for device in (*actuators().values(), *sensors().values()):
        names = {setting.name for setting in device.settings}
        assert {"latency", "dropout"} <= names, device.name
        certain = {"chance", "display", "lamp", "music", "pen", "pin-out", "random", "switch", "team", "work"}
        assert ("noise" in names) != (device.name in certain), device.name


def test_the_kinds_of_devices_are_numbered_in_the_order_of_their_names() -> None:
    for known in (actuators(), sensors()):
        assert [device.kind for device in known.values()] == list(range(len(known)))
        assert list(known) == sorted(known)


PARAMETERS = {
    "sense": ["first", "last", "step", "state"],
    "start": ["k", "command", "deviate", "state"],
    "advance": ["first", "last", "dt", "state"],
    "is_busy": ["k", "state"],
}


@pytest.mark.parametrize("device", [*actuators().values(), *sensors().values()], ids=lambda device: device.name)
def test_the_functions_of_every_device_have_the_same_form_and_are_told_to_numba(device: type[Device]) -> None:
    module = sys.modules[device.__module__]
    found = {name for name in PARAMETERS if hasattr(module, name)}
    assert found <= ({"sense"} if issubclass(device, Sensor) else {"start", "advance", "is_busy"})
    assert issubclass(device, Sensor) or "start" in found
    for name in found:
        assert list(inspect.signature(getattr(module, name)).parameters) == PARAMETERS[name]
        assert f"{module.__name__}.{name}" in loops()


NEW_SENSOR = """
from kitrobot.sim.tables.columns import S_VALUE
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, Sensor

class Beat(Sensor):
    name = "a-beat"
    settings = (LATENCY, LOST_READINGS)

def sense(first, last, step, state):
    for k in range(first, last):
        state.sensors.ints[S_VALUE][k] = 10 * step
"""

NEW_ACTUATOR = """
from kitrobot.sim.tables.columns import A_DONE, A_OWN
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command

REMAINING_S = A_OWN[0]

class Timer(Actuator):
    name = "a-timer"
    procedures = ("Run",)
    settings = (LATENCY, LOST_COMMANDS)

def start(k, command, deviate, state):
    state.actuators.floats[REMAINING_S][k] = command.first / 10
    state.actuators.ints[A_DONE][k] = 0

def advance(first, last, dt, state):
    left = state.actuators.floats[REMAINING_S]
    for k in range(first, last):
        left[k] -= dt
        if left[k] < 1e-9:
            state.actuators.ints[A_DONE][k] = 1
"""

NEW_DEVICES = """
from tests.sim.building import WHEEL, avatar, empty_world, run_of
robot = avatar(
    '<sensor name="Beat" device="a-beat" min="0" max="1000"><operation name="Value" value="yes"/></sensor>',
    '<actuator name="Timer" device="a-timer"><procedure name="Run" completes="later">'
    '<parameter name="tenths" min="0" max="100"/></procedure></actuator>',
    '<sensor name="Speed" device="speedometer" min="0" max="100"><operation name="Value" value="yes"/></sensor>',
    WHEEL.format(settings='speed="400"'),
)
run = run_of({"a": (robot, "Timer.Run(4); Wheel.Advance(50);")}, empty_world(a=(1000, 1000, 0)))
run.advance(6)
assert run.agents[0].inputs["Beat"] == 50
assert run.agents[0].state == "running"
while run.outcome is None:
    run.advance(1)
assert run.tick == 21, run.tick
driving = run_of({"a": (robot, "Wheel.Advance(50); WAIT(50);")}, empty_world(a=(1000, 1000, 0)))
driving.advance(100)
assert driving.agents[0].inputs["Speed"] == 50
"""


def speedometer() -> str:
    """The device that docs/devices.md shows."""
    found = re.search(r"```python\n(.*?)```", (ROOT / "docs" / "devices.md").read_text(encoding="utf-8"), re.DOTALL)
    assert found
    return found[1]


def test_a_new_device_is_one_file_beside_the_others(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "src", tmp_path / "src", ignore=shutil.ignore_patterns("static", "__pycache__"))
    devices = tmp_path / "src" / "kitrobot" / "sim" / "devices"
    (devices / "beat.py").write_text(NEW_SENSOR)
    (devices / "speedometer.py").write_text(speedometer())
    (devices / "timer.py").write_text(NEW_ACTUATOR)
    path = os.pathsep.join(map(str, (tmp_path / "src", ROOT)))
    subprocess.run(
        [sys.executable, "-c", NEW_DEVICES],
        env={**os.environ, "PYTHONPATH": path, "KITROBOT_COMPILE": "no"},
        check=True,
        timeout=PATIENCE_S,
    )


def test_a_lost_reading_leaves_the_one_before() -> None:
    fast = WHEEL.format(settings='speed="1000" acceleration="1e6"')
    eyes = [RANGE.format(most=1000, settings=f'reach="1000" {lost}') for lost in ("", 'dropout="50"', 'dropout="100"')]
    runs = [
        run_of({"a": (avatar(fast, eye), "Wheel.Advance(100); WAIT(600);")}, empty_world(a=(2900, 1000, 0)))
        for eye in eyes
    ]
    fresh, half, never = ([sensed(run, "Captor") for _ in range(40)] for run in runs)
    assert never == [0] * 40
    kept = [now == before for before, now in itertools.pairwise(half)]
    assert 8 < sum(kept) < 32
    assert all(value in ([0, *fresh]) for value in half)
    assert all(now in (true, before) for before, now, true in zip([0, *half], half, fresh, strict=False))


def test_a_boolean_sensor_with_noise_is_wrong_as_often_as_it_says() -> None:
    robot = avatar(WHEEL.format(settings=""), SENSOR.format(name="Button", device="button", settings='noise="30"'))
    run = run_of({"a": (robot, "WAIT(600);")}, empty_world(a=(1000, 1000, 0)), seconds=100)
    readings = [sensed(run, "Button") for _ in range(2000)]
    assert mean(readings) == pytest.approx(0.3, abs=0.04)


def test_a_colour_sensor_with_noise_reads_every_other_colour_now_and_then() -> None:
    eye = """<sensor name="Light" device="colour" min="0" max="3" noise="50">
      <operation name="Value" value="yes"/></sensor>"""
    robot = avatar(WHEEL.format(settings=""), eye)
    run = run_of({"a": (robot, "WAIT(600);")}, empty_world(a=(1000, 1000, 0)), seconds=100)
    readings = [sensed(run, "Light") for _ in range(2000)]
    counts = [readings.count(colour) / 2000 for colour in range(4)]
    assert counts == pytest.approx([0.5, 1 / 6, 1 / 6, 1 / 6], abs=0.04)


LIGHT = """<actuator name="Light" device="lamp" {settings}>
  <procedure name="LightOn"/><procedure name="LightOff"/></actuator>"""


def test_a_lost_command_says_so_and_the_next_one_may_arrive() -> None:
    lossy = avatar(LIGHT.format(settings='dropout="90"'), '<variable name="Go" type="boolean" initial="true"/>')
    run = run_of({"a": (lossy, "*[Go.IsTrue()]( Light.LightOn(); );")}, empty_world(a=(1000, 1000, 0)))
    texts = [event.text for _ in range(60) for event in steps(run, 1).events]
    assert 0 < len(texts) < 59
    assert set(texts) == {"a command did not reach Light"}
    assert run.agents[0].flags & LAMP
    never = avatar(LIGHT.format(settings='dropout="100"'))
    run = steps(run_of({"a": (never, "Light.LightOn(); WAIT(9);")}, empty_world(a=(1000, 1000, 0))), 2)
    assert not run.agents[0].flags & LAMP


def test_a_door_with_noise_takes_a_little_more_or_less_each_time() -> None:
    door = """<actuator name="Door" device="door" time="1000" noise="10">
      <procedure name="Open" completes="later"/><procedure name="Close" completes="later"/></actuator>"""
    text = "9*( Door.Open(); Door.Close(); );"
    run = run_of({"a": (avatar(door), text)}, empty_world(a=(1000, 1000, 0)), seconds=100)
    while run.outcome is None:
        run.step()
    assert run.tick == pytest.approx(18 * 50, rel=0.1)
    assert run.tick != 18 * 50 + 1


def test_a_motor_with_noise_turns_by_about_the_angle() -> None:
    motor = """<actuator name="Motor" device="turn" rate="720" noise="5">
      <procedure name="AbsoluteTurn" completes="later">
      <parameter name="angle" min="0" max="100"/><parameter name="speed" min="0" max="100"/></procedure></actuator>"""

    def turned(seed: int) -> float:
        run = run_of({"a": (avatar(motor), "Motor.AbsoluteTurn(25, 100);")}, empty_world(a=(1000, 1000, 0)), seed=seed)
        while run.outcome is None:
            run.step()
        return run.agents[0].heading_rad

    angles = [turned(seed) for seed in range(40)]
    assert mean(angles) == pytest.approx(math.pi / 2, rel=0.04)
    assert stdev(angles) == pytest.approx(0.05 * math.pi / 2, rel=0.4)
