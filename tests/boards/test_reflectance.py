"""Reflectance sensors whose capacitor is charged and whose time is taken, and those that give a voltage."""

from __future__ import annotations

from typing import Any

import pytest

from tests.boards.kit_steps import results_of

STEPS = {
    "a look": """
sensor = make("machine.qtr_line", pin="22", emitter="26", threshold="300", min="2")
taken()
machine.widths[22] = 100
value = sensor.read()
result = [value, taken()]
for width in (299, 300, 5000, None):
    machine.widths[22] = width
    result.append(sensor.read())
taken()
""",
    "a bumper": """
machine.widths[17], machine.widths[16] = 200, 300
bumper = make("machine.qtr_bump", left="17", right="16", emitter="23")
result = [bumper.read()]
for left, right in ((319, 479), (321, 300), (281, 300), (279, 300), (200, 5000), (200, 421), (200, 419)):
    machine.widths[17], machine.widths[16] = left, right
    result.append(bumper.read())
machine.widths[17] = 5000
try:
    make("machine.qtr_bump", left="17", right="16", emitter="23")
except OSError as error:
    result.append(repr(error))
""",
    "a road": """
machine.widths[22] = machine.widths[18] = 100
EYES = {"eyes": "qtr", "emitter": "26", "left-eye": "22", "right-eye": "18"}
road = make("machine.road", steer="50", **dict(DRV8833, **EYES))
road.do("Advance", [60])
result = [duties()]
for left, right in ((800, 100), (100, 800), (100, 100)):
    machine.widths[22], machine.widths[18] = left, right
    road.tend()
    result.append(duties())
road.stop()
result.append(duties())
""",
    "a voltage": """
from machine import volts
result = []
for dark in ("high", "low"):
    eye = make("microbit.analog_line", pin="2", threshold="600", dark=dark, min="4")
    for value in (599, 600):
        volts[2] = value
        result.append(eye.read())
""",
}


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    return results_of(STEPS)


def test_a_sensor_is_lit_and_charged_and_its_time_is_taken_up_to_the_threshold(found: dict[str, Any]) -> None:
    value, log, *others = found["a look"]
    lit, charged, read, dark = [(26, "out", None), (26, "value", 1)], [(22, "out", None), (22, "value", 1)], 300, "in"
    assert log == [*lit, *charged, (22, "in", None), (22, "wait", read), (26, dark, None)]
    assert (value, others) == (2, [2, 3, 3, 2]), "without an answer it was low at once, which is bright"


def test_a_bumper_is_pressed_above_160_percent_of_what_it_read_free_and_until_below_140(found: dict[str, Any]) -> None:
    *values, unplugged = found["a bumper"]
    assert values == [0, 0, 1, 1, 0, 1, 1, 0]
    assert "no light comes back" in unplugged


def test_a_road_is_followed_by_such_eyes(found: dict[str, Any]) -> None:
    assert found["a road"] == [[60, 0, 60, 0], [30, 0, 60, 0], [60, 0, 30, 0], [60, 0, 60, 0], [0, 0, 0, 0]]


def test_an_eye_that_gives_a_voltage_is_compared_with_its_threshold(found: dict[str, Any]) -> None:
    assert found["a voltage"] == [4, 5, 5, 4]
