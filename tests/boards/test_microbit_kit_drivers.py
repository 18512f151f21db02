"""The drivers of a micro:bit's kits, on a current MicroPython with a bus and pins that only remember; in one run."""

from __future__ import annotations

import ast
from pathlib import Path
from typing import Any

import pytest

import kitrobot_onboard
from tests.boards.modern import onboard_files, run
from tests.boards.test_machine_drivers import HEAD

SHOWN = {"display", "music", "accelerometer", "key", "pin_in", "pin_out", "pins", "__init__"}
"""Drivers of what the board itself has, which are tried on its firmware."""

STEPS = """
found = {}
for kit in ("maqueen", "cutebot", "move"):
    drive, turn = make("microbit.drive", kit=kit), make("microbit.turn", kit=kit, rate="2000")
    left, right = make("microbit.wheel", kit=kit, side="left"), make("microbit.wheel", kit=kit, side="right")
    drive.stop()
    rows = [taken()]
    for part, procedure, arguments in (
        (drive, "Advance", [50]), (drive, "Advance", [50]), (drive, "Reverse", [100]), (drive, "Stop", []),
        (turn, "Turn", [20]), (turn, "Stop", []), (left, "Forward", [100]), (right, "Backward", [40]),
    ):
        part.do(procedure, arguments)
        drive.tend()
        rows.append(taken())
    right.stop()
    rows.append(taken())
    found[kit] = rows
begun = time.ticks_ms()
turn.do("AbsoluteTurn", [25, 50])  # 90 degrees at 1000 degrees a second
turn.tend()
while not turn.done(): pass
turn.tend()
found["turn"] = time.ticks_diff(time.ticks_ms(), begun), taken()[-1]
found["by"] = []
for part, procedure, arguments in (
    (turn, "RightBy", [90]), (make("microbit.drive", kit=kit, speed="5000"), "BackBy", [50]), (turn, "LeftBy", [0])
):
    begun = time.ticks_ms()
    part.do(procedure, arguments)
    part.tend()
    going = taken()
    while not part.done(): pass
    part.tend()
    found["by"].append((going, time.ticks_diff(time.ticks_ms(), begun), taken()))
import microbit
def refuse(*words):
    raise OSError(19)
usual, microbit.i2c.write = microbit.i2c.write, refuse
part.do("Turn", [30])
try:
    part.tend()
except OSError:
    found["refused"] = taken()
microbit.i2c.write = usual
part.tend()
found["again"] = taken()
line = make("microbit.line", pin="13", dark="low", min="1")
seen = []
for level in (0, 1):
    levels[13] = level
    seen.append(line.read())
found["line"] = seen
near = make("microbit.ultrasonic", trigger="1", echo="2", min="0", max="1", reach="120", near="yes")
far = make("microbit.ultrasonic", trigger="1", echo="2")
seen = []
for width in (583, 2915, 9000, 100000):
    widths[2] = width
    near.due = far.due = 0
    seen.append((near.read(), far.read()))
found["range"] = seen
widths[2] = None
reads = 0
while "unplugged" not in found:
    far.due = 0
    reads += 1
    try:
        far.read()
    except OSError as error:
        found["unplugged"] = reads, repr(error)
taken()
for name, lamp in (("led", make("microbit.led", pin="8")), ("picture", make("microbit.picture_lamp"))):
    taken()
    lamp.do("LightOn", [])
    lamp.stop()
    found[name] = taken()
doors = []
for kit in ("maqueen", "cutebot"):
    door = make("microbit.kit_servo", kit=kit, number="2", open="100", time="30")
    door.do("Open", [])
    busy = not door.done()
    while not door.done(): pass
    door.do("Close", [])
    door.stop()
    doors.append((busy, door.done(), taken()))
found["doors"] = doors
print(repr(found))
"""


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    text = f"{HEAD}\n{STEPS}"
    results: dict[str, Any] = ast.literal_eval(run({**onboard_files(), "test.py": text.encode()}, "test.py"))
    return results


def test_every_driver_of_a_kit_is_tried() -> None:
    folder = Path(kitrobot_onboard.__file__).parent / "drivers" / "microbit"
    text = "".join(path.read_text(encoding="utf-8") for path in Path(__file__).parent.glob("test_*.py"))
    for name in {path.stem for path in folder.glob("*.py")} - SHOWN:
        assert f'make("microbit.{name}"' in text, name


def bytes_of(rows: list[list[tuple[int, str, bytes]]], address: int) -> list[list[tuple[int, ...]]]:
    for row in rows:
        assert all(entry[:2] == (address, "i2c") for entry in row)
    return [[tuple(data) for _, _, data in row] for row in rows]


def test_the_motors_of_a_maqueen_get_a_register_a_direction_and_a_speed(found: dict[str, Any]) -> None:
    made, advance, again, reverse, stop, turn, straight, left, right, end = bytes_of(found["maqueen"], 0x10)
    assert made[-2:] == [(0, 0, 0), (2, 0, 0)]
    assert advance == [(0, 0, 127), (2, 0, 127)]
    assert again == []
    assert reverse == [(0, 1, 255), (2, 1, 255)]
    assert stop == straight == end == [(0, 0, 0), (2, 0, 0)]
    assert turn == [(0, 1, 51), (2, 0, 51)]  # counter-clockwise
    assert (left, right) == ([(0, 0, 255)], [(2, 1, 102)])


def test_the_motors_of_a_cutebot_get_a_wheel_a_direction_and_percent(found: dict[str, Any]) -> None:
    _, advance, _, reverse, stop, turn, _, left, right, end = bytes_of(found["cutebot"], 0x10)
    assert advance == [(1, 2, 50, 0), (2, 2, 50, 0)]
    assert reverse == [(1, 1, 100, 0), (2, 1, 100, 0)]
    assert stop == end == [(1, 2, 0, 0), (2, 2, 0, 0)]
    assert turn == [(1, 1, 20, 0), (2, 2, 20, 0)]
    assert (left, right) == ([(1, 2, 100, 0)], [(2, 1, 40, 0)])


def test_the_motors_of_a_move_motor_are_woken_and_get_power_at_one_of_two_registers(found: dict[str, Any]) -> None:
    made, advance, _, reverse, stop, turn, _, _, _, end = bytes_of(found["move"], 0x62)
    assert made[:3] == [(0, 0), (1, 4), (8, 0xAA)]
    assert advance == [(5, 0), (4, 127), (2, 0), (3, 127)]
    assert reverse == [(4, 0), (5, 255), (3, 0), (2, 255)]
    for still in (stop, end):
        assert {register for register, _ in still} == {2, 3, 4, 5}
        assert {power for _, power in still} == {0}
    assert turn == [(4, 0), (5, 51), (2, 0), (3, 51)]


def test_a_turn_lasts_as_long_as_its_angle_takes_and_then_the_motors_stand(found: dict[str, Any]) -> None:
    gone, last = found["turn"]
    assert 90 <= gone < 1000
    assert last[2][1] == 0


def test_degrees_and_distances_are_done_at_half_speed_and_then_the_motors_stand(found: dict[str, Any]) -> None:
    (right, turned, stood), (back, driven, end), _ = found["by"]
    right_sent, back_sent = bytes_of([right, back], 0x62)
    assert right_sent[-4:] == [(5, 0), (4, 127), (3, 0), (2, 127)]
    assert back_sent[-4:] == [(4, 0), (5, 127), (3, 0), (2, 127)]
    assert 90 <= turned < 1000
    assert 200 <= driven < 1100
    assert stood[-1][2][1] == end[-1][2][1] == 0


def test_what_a_chip_did_not_take_is_told_again(found: dict[str, Any]) -> None:
    assert found["refused"] == []
    (again,) = bytes_of([found["again"]], 0x62)
    assert [data for data in again if data[1]] == [(5, 76), (3, 76)]


def test_eyes_range_finder_lamps_and_servos_do_what_their_kits_say(found: dict[str, Any]) -> None:
    assert found["line"] == [2, 1]
    assert found["range"] == [(1, 9), (0, 49), (0, 100), (0, 100)]
    reads, error = found["unplugged"]
    assert reads == 5
    assert "not plugged in" in error
    assert found["led"] == [(8, "value", 1), (8, "value", 0)]
    assert [picture for _, _, picture in found["picture"]] == ["99999:99999:99999:99999:99999", ""]
    maqueen, cutebot = found["doors"]
    assert maqueen == (True, True, [(16, "i2c", bytes((0x15, 100))), (16, "i2c", bytes((0x15, 0)))])
    assert cutebot == (True, True, [(16, "i2c", bytes((6, 100, 0, 0))), (16, "i2c", bytes((6, 0, 0, 0)))])
