"""The drivers of kits that move a robot: motors behind all kinds of chips, turns that are measured, roads."""

from __future__ import annotations

from typing import Any

import pytest

from tests.boards.kit_steps import FULL, results_of

STEPS = {
    "two inputs": """
drive, turn = make("machine.drive", **DRV8833), make("machine.turn", rate="360", **DRV8833)
result = [taken()]
for part, procedure, arguments in (
    (drive, "Advance", [50]), (drive, "Reverse", [100]), (drive, "Stop", []), (turn, "Turn", [40]),
    (drive, "Advance", [80]), (turn, "Stop", []),
):
    part.do(procedure, arguments)
    result.append(duties())
turn.stop()
result.append(duties())
""",
    "three inputs": """
drive = make("machine.drive", **TB6612)
taken()
result = []
for procedure, arguments in (("Advance", [50]), ("Reverse", [20]), ("Stop", [])):
    drive.do(procedure, arguments)
    result.append(taken())
""",
    "a direction and power": """
drive = make("machine.drive", **DRV8835)
taken()
result = []
for procedure, arguments in (("Advance", [50]), ("Reverse", [20]), ("Stop", [])):
    drive.do(procedure, arguments)
    result.append(taken())
""",
    "trim": """
drive = make("machine.drive", least="20", **{"left-trim": "90"}, **dict(DRV8833, frequency="50"))
taken()
drive.do("Advance", [50])
result = taken()
""",
    "wheels": """
left, right = make("machine.wheel", side="left", **DRV8833), make("machine.wheel", side="right", **DRV8833)
taken()
result = []
for part, procedure, arguments in (
    (left, "Forward", [30]), (right, "Backward", [60]), (left, "Stop", []), (right, "Forward", [100])
):
    part.do(procedure, arguments)
    result.append(duties())
right.stop()
result.append(duties())
""",
    "turn by the clock": """
turn = make("machine.turn", rate="2000", **DRV8833)
begun = time.ticks_ms()
turn.do("AbsoluteTurn", [25, 50])  # 90 degrees at 1000 degrees a second
busy = turn.done()
going = duties()
while not turn.done(): pass
result = busy, going, time.ticks_diff(time.ticks_ms(), begun), duties()
turn.do("AbsoluteTurn", [25, 0])
result += (turn.done(),)
turn.stop()
result += (turn.done(),)
""",
    "distances": """
drive = make("machine.drive", speed="5000", **DRV8833)
result = []
for procedure, arguments in (("DriveBy", [50]), ("BackBy", [50]), ("DriveBy", [0])):
    begun = time.ticks_ms()
    drive.do(procedure, arguments)
    going = duties()
    while not drive.done(): pass
    result.append((going, time.ticks_diff(time.ticks_ms(), begun), duties()))
drive.do("DriveBy", [500])
drive.do("Stop", [])
result.append((drive.done(), duties()))
""",
    "degrees": """
turn = make("machine.turn", rate="2000", **DRV8833)
result = []
for procedure, arguments in (("LeftBy", [90]), ("RightBy", [90]), ("RightBy", [0])):
    begun = time.ticks_ms()
    turn.do(procedure, arguments)
    going = duties()
    while not turn.done(): pass
    result.append((going, time.ticks_diff(time.ticks_ms(), begun), duties()))
""",
    "right by encoders": """
turn = make("machine.turn", counts="360", **dict(DRV8833, **{"left-count": "10", "right-count": "11"}))
turn.do("RightBy", [45])
edges = 0
while not turn.done():
    machine.watchers[10 + edges % 2](None)
    edges += 1
result = edges, duties()
""",
    "turn by encoders": """
turn = make("machine.turn", counts="400", **dict(DRV8833, **{"left-count": "10", "right-count": "11"}))
turn.do("AbsoluteTurn", [50, 30])
edges = 0
while not turn.done():
    machine.watchers[10 + edges % 2](None)
    edges += 1
result = edges, duties()
""",
    "turn by a gyroscope": """
machine.registers[107] = {0x0F: b"l", 0x26: bytes((10, 0))}
turn = make("machine.turn", gyro="lsm6dso", sda="4", scl="5", **DRV8833)
told = taken()
machine.registers[107][0x26] = bytes((0, 100))  # 25600 - 10 times 17.5 thousandths of a degree a second
begun = time.ticks_us()
turn.do("AbsoluteTurn", [5, 30])
while not turn.done(): pass
gone = time.ticks_diff(time.ticks_us(), begun)
result = [entry for entry in told if isinstance(entry[0], int) and entry[0] == 107], gone, duties()
""",
    "road": """
levels.clear()
road = make("machine.road", **dict(DRV8833, **{"left-eye": "16", "right-eye": "17"}))
taken()
result = []
road.do("Advance", [50])
for left, right in ((0, 0), (1, 0), (0, 1), (1, 1)):
    levels[16], levels[17] = left, right
    road.tend()
    result.append(duties())
road.do("Reverse", [50])
result.append(duties())
road.stop()
road.tend()
result.append(duties())
""",
}


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    """The result of each of the steps."""
    return results_of(STEPS)


def test_two_motors_with_two_inputs_each_drive_turn_and_do_both_at_once(found: dict[str, Any]) -> None:
    made, advance, reverse, stop, turns, both, straight, stopped = found["two inputs"]
    assert {entry for entry in made if entry[1] == "duty"} == {(pin, "duty", 0) for pin in (2, 3, 4, 5)}
    assert advance == [50, 0, 50, 0]
    assert reverse == [0, 100, 0, 100]
    assert stop == [0, 0, 0, 0]
    assert turns == [0, 40, 40, 0]  # counter-clockwise
    assert both == [40, 0, 100, 0]  # no faster than full speed
    assert straight == [80, 0, 80, 0]
    assert stopped == [0, 0, 0, 0]


def test_motors_behind_a_tb6612_or_an_l298n_get_a_direction_at_two_pins_and_power_at_a_third(
    found: dict[str, Any],
) -> None:
    advance, reverse, stop = found["three inputs"]
    half, fifth = 50 * FULL // 100, 20 * FULL // 100
    assert advance == [
        *[(7, "value", 0), (6, "value", 1), (8, "duty", half)],
        *[(10, "value", 0), (9, "value", 1), (11, "duty", half)],
    ]
    assert reverse[:3] == [(6, "value", 0), (7, "value", 1), (8, "duty", fifth)]
    assert [entry for entry in stop if entry[2]] == []


def test_motors_behind_a_drv8835_get_a_direction_and_power_and_one_may_be_wired_backward(found: dict[str, Any]) -> None:
    advance, reverse, stop = found["a direction and power"]
    assert [entry for entry in advance if entry[1] == "value"] == [(12, "value", 1), (14, "value", 0)]
    assert [entry for entry in reverse if entry[1] == "value"] == [(12, "value", 0), (14, "value", 1)]
    assert {entry[2] for entry in stop} == {0}


def test_a_motor_that_needs_power_to_begin_and_one_that_is_faster_than_the_other_are_told_less_and_more(
    found: dict[str, Any],
) -> None:
    duties = {pin: value for pin, what, value in found["trim"] if what == "duty" and value}
    assert duties == {2: 60 * 90 * FULL // 10000, 4: 60 * FULL // 100}


def test_each_wheel_by_itself(found: dict[str, Any]) -> None:
    assert found["wheels"] == [[30, 0, 0, 0], [30, 0, 0, 60], [0, 0, 0, 60], [0, 0, 100, 0], [0, 0, 0, 0]]


def test_a_turn_by_the_clock_lasts_as_long_as_its_angle_takes(found: dict[str, Any]) -> None:
    busy, going, gone, stopped, never, after_stop = found["turn by the clock"]
    assert (busy, never, after_stop) == (False, False, True)
    assert going == [0, 50, 50, 0]
    assert 90 <= gone < 1000
    assert stopped == [0, 0, 0, 0]


def test_a_distance_and_an_angle_last_as_long_as_they_take_at_half_speed(found: dict[str, Any]) -> None:
    (ahead, needed, stood), (back, _, _), (_, nothing, _), stopped = found["distances"]
    assert (ahead, back, stood) == ([50, 0, 50, 0], [0, 50, 0, 50], [0, 0, 0, 0])
    assert 200 <= needed < 1100
    assert nothing < 900
    assert stopped == (True, [0, 0, 0, 0])
    (left, needed, stood), (right, _, _), _ = found["degrees"]
    assert (left, right, stood) == ([0, 50, 50, 0], [50, 0, 0, 50], [0, 0, 0, 0])
    assert 90 <= needed < 1000
    assert found["right by encoders"] == (45, [0, 0, 0, 0])


def test_a_turn_by_encoders_ends_with_the_edge_that_completes_its_angle(found: dict[str, Any]) -> None:
    assert found["turn by encoders"] == (200, [0, 0, 0, 0])


def test_a_turn_by_a_gyroscope_ends_when_its_rates_have_come_to_the_angle(found: dict[str, Any]) -> None:
    told, gone_us, stopped = found["turn by a gyroscope"]
    assert told == [(107, 0x12, b"\x44"), (107, 0x11, b"\x54")]
    exact_us = 18 / (25590 * 0.0175) * 1_000_000
    assert exact_us * 0.95 <= gone_us < exact_us + 400_000
    assert stopped == [0, 0, 0, 0]


def test_a_robot_on_a_road_slows_the_wheel_on_the_side_that_sees_the_line_and_only_forward(
    found: dict[str, Any],
) -> None:
    assert found["road"] == [
        [50, 0, 50, 0],
        [20, 0, 50, 0],
        [50, 0, 20, 0],
        [20, 0, 20, 0],
        [0, 50, 0, 50],
        [0, 0, 0, 0],
    ]
