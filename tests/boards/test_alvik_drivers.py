"""The drivers that move an Arduino Alvik, on a current MicroPython: what they write to the UART, and make of what they
read."""

from __future__ import annotations

from typing import Any

import pytest

from tests.boards.alvik import BEFORE, HEARD, frame
from tests.boards.kit_steps import results_of

LIGHT = frame("L", "B", 2)
BEHAVIOUR = frame("B", "B", 1)
STOPPED = [frame("J", "2f", 0, 0), HEARD]
EYES = [frame("l", "3h", *eyes) for eyes in ((0, 900, 0), (900, 0, 0), (0, 0, 900), (900, 900, 900))]

STEPS = {
    "before": BEFORE,
    "start": """
begin_alvik(STANDING, b"", b"", STANDING)
Clock.slept = 0
robot = alvik.robot()
result = taken(), Clock.slept, alvik.robot() is robot
""",
    "off": """
begin_alvik()
levels[13] = 0
result = [error_of(make, "machine.alvik_drive"), written()]
begin_alvik(b"", b"noise")
Clock.slept = 0
result += [error_of(make, "machine.alvik_drive"), Clock.slept, written()]
drive, key = (ready(), make("machine.alvik_drive"))[1], make("machine.alvik_touch")
levels[13] = 0
for call, arguments in ((drive.do, ("Advance", [50])), (key.read, ())):
    result.append(error_of(call, *arguments))
taken()
drive.stop()
result.append(written())
""",
    "wheels": """
ready()
drive, turn = make("machine.alvik_drive"), make("machine.alvik_turn")
left, right = make("machine.alvik_wheel", side="left"), make("machine.alvik_wheel", side="right")
result = []
for part, procedure, arguments in (
    (drive, "Advance", [50]), (drive, "Advance", [50]), (drive, "Reverse", [100]), (turn, "Turn", [40]),
    (drive, "Advance", [80]), (turn, "Stop", []), (drive, "Stop", []), (left, "Forward", [30]),
    (right, "Backward", [60]), (left, "Stop", []),
):
    part.do(procedure, arguments)
    result.append(written())
for part in (left, turn):
    part.stop()
    result.append(written())
left.do("Forward", [20])
result.append(written())
""",
    "turn": """
robot = ready()
turn, drive = make("machine.alvik_turn"), make("machine.alvik_drive")
result = []
def trip(*pieces):
    said.extend(pieces)
    done = turn.done()
    result.append((done, written()))
drive.do("Advance", [50])
turn.do("AbsoluteTurn", [25, 60])
trip(STANDING)
trip()
drive.do("Advance", [100])
trip()
trip(STANDING[:3])
trip(STANDING[3:] + TURNED[:4])
trip(TURNED[4:])
trip()
turn.do("AbsoluteTurn", [50, 60])  # the STM32 has not heard yet that the last turn is over
trip(TURNED)
trip(TURNED)
trip(STANDING)
trip(TURNED)
result.append(Clock.slept)
""",
    "by": """
ready()
turn, drive = make("machine.alvik_turn"), make("machine.alvik_drive", speed="1000")
result = []
for procedure, arguments in (("AbsoluteTurn", [25, 50]), ("LeftBy", [90]), ("RightBy", [90])):
    turn.stop()
    said.append(STANDING)
    turn.done()
    written()
    turn.do(procedure, arguments)
    turn.done()
    result.append(written())
turn.stop()
import kitrobot_onboard.drivers.machine.alvik_drive as alvik_drive
alvik_drive.time = Clock
for procedure in ("DriveBy", "BackBy"):
    drive.do("Stop", [])
    written()
    drive.do(procedure, [30])
    told = [drive.done(), written()]
    Clock.now += 599
    told.append(drive.done())
    Clock.now += 1
    result.append(told + [drive.done(), written()])
""",
    "turns that end": """
ready()
turn = make("machine.alvik_turn", rate="200")
result = []
said.append(STANDING)
for procedure, arguments in (("AbsoluteTurn", [0, 50]), ("AbsoluteTurn", [25, 0]), ("AbsoluteTurn", [25, 50]),
    ("Stop", []), ("AbsoluteTurn", [100, 50])):
    turn.do(procedure, arguments)
    result.append((turn.done(), written()))
turn.stop()
result.append((turn.done(), written()))
turn.do("AbsoluteTurn", [25, 50])  # what was acknowledged before the stop is not known any more
result.append((turn.done(), written()))
said.append(STANDING)
result.append((turn.done(), written()))
Clock.now += 600
said.append(b"")
result.append(error_of(turn.done))
for _ in range(3):
    Clock.now += 200
    result.append(error_of(turn.done))
""",
    "after a pause": """
ready()
turn = make("machine.alvik_turn")
Clock.now += 251
said.append(TURNED)  # what waits is old
turn.do("AbsoluteTurn", [25, 50])
result = [written()]
for piece in (b"", TURNED, STANDING):
    said.append(piece)
    turn.done()
    result.append(written())
""",
    "road": f"""
ready()
road = make("machine.alvik_road")
result = []
road.do("Advance", [50])
for eyes in {EYES!r}:
    said.append(eyes)
    road.tend()
    result.append(written())
road.do("Reverse", [50])
result.append(written())
road.stop()
road.tend()
result.append(written())
""",
}


def wheels(left: float, right: float) -> bytes:
    """What tells the speeds of the wheels, in percent of 70 revolutions a minute."""
    return frame("J", "2f", left * 0.7, right * 0.7)


def turn(degrees: float) -> bytes:
    return frame("R", "f", degrees)


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    """The result of each of the steps."""
    return results_of(STEPS)


def test_the_stm32_is_started_anew_and_heard_before_it_is_told_anything(found: dict[str, Any]) -> None:
    told, slept, one = found["start"]
    assert told[0] == (13, "in", 3)
    assert [entry for entry in told if entry[1] == "value"] == [
        (5, "value", 0),
        (7, "value", 0),
        (6, "value", 0),
        (6, "value", 1),
    ]
    assert ("uart", 115200, (1, 43, 44)) in told
    assert [entry[2] for entry in told if entry[1] == "write"] == [LIGHT, BEHAVIOUR]
    assert slept == 100 + 3 * 5  # what it said before counts for nothing
    assert one


def test_an_alvik_that_is_off_or_silent_is_a_fault_that_says_so_and_is_told_to_stop_all_the_same(
    found: dict[str, Any],
) -> None:
    off, nothing, silent, slept, still_nothing, drive, key, stopped = found["off"]
    assert off == drive == key == "the Alvik is switched off"
    assert silent == "no answer from the Alvik"
    assert nothing == still_nothing == []
    assert 6000 < slept < 6200
    assert stopped == STOPPED


def test_degrees_are_told_as_they_are_and_distances_go_by_the_clock(found: dict[str, Any]) -> None:
    quarter, left, right, ahead, back = found["by"]
    assert left == quarter
    assert right != left
    assert len(right) == len(left)
    for told, other in ((ahead, back), (back, ahead)):
        begun, going, nearly, ended, stood = told
        assert (begun, nearly, ended) == (False, False, True)
        assert going
        assert going != other[1]
        assert stood == other[4]


def test_wheels_drive_and_turn_at_once_and_what_is_known_is_not_told_again(found: dict[str, Any]) -> None:
    assert found["wheels"] == [
        [wheels(50, 50)],
        [],
        [wheels(-100, -100)],
        [wheels(-100, -60)],  # counter-clockwise, and no faster than full speed
        [wheels(40, 100)],
        [wheels(80, 80)],
        [wheels(0, 0)],
        [wheels(30, 0)],
        [wheels(30, -60)],
        [wheels(0, -60)],
        STOPPED,
        STOPPED,
        [wheels(20, 0)],  # what was wanted before the stop is forgotten
    ]


def test_a_turn_is_done_when_the_stm32_says_so_and_no_older_word_of_it_ends_it(found: dict[str, Any]) -> None:
    *steps, slept = found["turn"]
    assert steps == [
        (False, [wheels(50, 50), turn(90)]),
        (False, []),
        (False, []),  # driving waits
        (False, []),
        (False, []),
        (True, [HEARD, wheels(100, 100)]),
        (True, []),
        (False, [HEARD]),
        (False, [HEARD]),
        (False, [turn(180)]),
        (True, [HEARD, wheels(100, 100)]),
    ]
    assert slept == 0


def test_a_turn_of_no_angle_is_done_one_without_speed_never_and_stop_ends_any(found: dict[str, Any]) -> None:
    none, still, quarter, ended, full, stopped, unknown, known, *silent = found["turns that end"]
    assert none == (True, [wheels(0, 0)])
    assert still == (False, [])
    assert quarter == (False, [turn(90 * 180 / 200)])
    assert ended == (True, [wheels(0, 0)])
    assert full == (False, [turn(360 * 180 / 200)])
    assert stopped == (True, STOPPED)
    assert unknown == (False, [wheels(0, 0)])
    assert known == (False, [turn(90 * 180 / 200)])
    assert silent == [False, False, False, "no answer from the Alvik"]


def test_what_was_acknowledged_before_a_pause_counts_for_nothing(found: dict[str, Any]) -> None:
    assert found["after a pause"] == [[wheels(0, 0)], [], [HEARD], [turn(90)]]


def test_an_alvik_on_a_road_slows_the_wheel_on_the_side_that_sees_the_line_and_only_forward(
    found: dict[str, Any],
) -> None:
    assert found["road"] == [
        [wheels(50, 50)],
        [wheels(20, 50)],
        [wheels(50, 20)],
        [wheels(20, 20)],
        [wheels(-50, -50)],
        STOPPED,
    ]
