"""The drivers of an Arduino Alvik on a current MicroPython: what they write to the UART, and make of what they read."""

from __future__ import annotations

from typing import Any

import pytest

from tests.boards.alvik import HEARD, STANDING, TURNED, checksum, frame
from tests.boards.kit_steps import results_of

LIGHT = frame("L", "B", 2)
BEHAVIOUR = frame("B", "B", 1)
STOPPED = [frame("J", "2f", 0, 0), HEARD]

RAW = (
    (400, 230, 220),
    (180, 450, 250),
    (170, 220, 500),
    (450, 500, 510),
    (160, 200, 190),
    (-5, 0, 9),
    (2000, 220, 200),
)
COLOURS = [frame("c", "3h", *raw) for raw in RAW]
EYES = [frame("l", "3h", *eyes) for eyes in ((0, 900, 0), (900, 0, 0), (0, 0, 900), (900, 900, 900))]

BEFORE = f"""
from kitrobot_onboard.drivers.machine.shared import alvik
STANDING, TURNED = {STANDING!r}, {TURNED!r}
class Clock:  # stands, but for sleep
    now = 1000
    slept = 0
    @staticmethod
    def ticks_ms(): return Clock.now
    @staticmethod
    def ticks_diff(end, start): return end - start
    @staticmethod
    def sleep_ms(ms):
        Clock.now += ms
        Clock.slept += ms
alvik.time = Clock
said = []  # what the STM32 says, a piece at each look
def stm32(data):
    return said.pop(0) if said and not data else b""
machine.partners[1] = stm32
def begin_alvik(*pieces):
    alvik.robots.clear()
    levels[13] = 1
    said[:] = pieces or (b"", STANDING)
def ready():
    begin_alvik()
    robot = alvik.robot()
    taken()
    Clock.slept = 0
    return robot
def written():
    return [value for name, what, value in taken() if what == "write"]
def error_of(call, *arguments):
    try:
        return call(*arguments)
    except OSError as error:
        return str(error)
result = None
"""

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
""",
    "turn": """
robot = ready()
turn, drive = make("machine.alvik_turn"), make("machine.alvik_drive")
result = []
def step(*pieces):
    said.extend(pieces)
    done = turn.done()
    result.append((done, written()))
drive.do("Advance", [50])
turn.do("AbsoluteTurn", [25, 60])
step(STANDING)
step()
drive.do("Advance", [100])
step()
step(STANDING[:3])
step(STANDING[3:] + TURNED[:4])
step(TURNED[4:])
step()
turn.do("AbsoluteTurn", [50, 60])  # the STM32 has not heard yet that the last turn is over
step(TURNED)
step(TURNED)
step(STANDING)
step(TURNED)
result.append(Clock.slept)
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
    "frames": f"""
key = (ready(), make("machine.alvik_touch", which="left"))[1]
touched, free = {frame("t", "B", 0b100001)!r}, {frame("t", "B", 0)!r}
wrong = touched[:-1] + bytes((touched[-1] ^ 1,))
long = {frame("t", "2B", 0b100001, 0)!r}
inside = {frame("f", "7h", *[0x4141] * 7)!r}  # values that look like the beginning of a frame
result = []
for noise in (b"", b"A", b"#", b"AA", b"A\\2", b"A\\xff", b"A\\0#\\0", wrong, long, inside, touched[:-1], bytes(200)):
    said.append(free)
    before = key.read()
    for at in range(len(touched) + 1):
        said.extend((noise + touched[:at], touched[at:] + STANDING * 8))
        key.read()
        seen = key.read()
        said.extend((free, STANDING * 8))
        again = key.read()
        key.read()
        result.append((before, seen, again))
said.append(wrong + long)
result.append((key.read(), 0, 0))
""",
    "sensors": f"""
robot = ready()
parts = [
    make("machine.alvik_range", min="0", max="100", reach="1000"),
    make("machine.alvik_range", min="10", max="30", reach="400", zone="bottom"),
    make("machine.alvik_near", reach="120"),
    make("machine.alvik_line", eye="left"), make("machine.alvik_line", eye="center", threshold="700", min="3"),
    make("machine.alvik_line", eye="right"), make("machine.alvik_touch"), make("machine.alvik_touch", which="right"),
]
result = [[part.read() for part in parts]]
for piece in (
    {frame("f", "7h", 90, 500, 255, 500, 90, 90, 200) + frame("l", "3h", 512, 699, 511) + frame("t", "B", 0x81)!r},
    {frame("f", "7h", 9, 130, -1, 119, 9, 9, 900) + frame("l", "3h", 0, 1023, 1023) + frame("t", "B", 0x03)!r},
    b"",
):
    said.append(piece)
    result.append([part.read() for part in parts])
for late in (200, 200, 200):
    Clock.now += late
    said.append(STANDING)
    answers = [error_of(part.read) for part in parts]
result.append(answers)
Clock.now += 251  # nobody listened: what waits is old
said.append({frame("t", "B", 0)!r})
result.append([parts[6].read(), parts[6].read()])
said.append({frame("t", "B", 0)!r})
result.append([parts[6].read(), Clock.slept])
""",
    "colours": f"""
ready()
sensor = make("machine.alvik_colour")
other = make("machine.alvik_colour", revision="1.6")
result = [sensor.read()]
for piece in {COLOURS!r}:
    said.append(piece)
    result.append(sensor.read())
said.append({frame("c", "3h", 700, 850, 430)!r})
result.append(other.read())
""",
    "lights": f"""
ready()
left, both = make("machine.alvik_lamp", light="left", colour="red"), make("machine.alvik_lamp", colour="blue")
taken()
result = []
for part, way in ((left, "On"), (both, "On"), (left, "Off"), (both, "Off"), (both, "On")):
    part.do("Light" + way, [])
    result.append(written())
left.stop(), both.stop()
result.append(written())
drive = make("machine.alvik_drive")
both.do("LightOn", [])
drive.do("Advance", [50])
taken()
said.append({frame(chr(0x7E), "3B", 1, 1, 0)!r})  # the STM32 has begun anew
drive.tend()
result.append(written())
drive.do("Advance", [50])
result.append(written())
levels[13] = 0
both.stop()
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


def test_a_frame_is_what_its_format_says_byte_by_byte() -> None:
    assert checksum(b"123456789") == 0xA1  # the check value of CRC-8 of Maxim
    assert wheels(100, -100) == bytes.fromhex("41 09 4a 00008c42 00008cc2 23") + bytes(
        [checksum(bytes.fromhex("4a00008c4200008cc2"))]
    )
    assert HEARD[:5] == bytes.fromhex("41 02 58 4b 23")


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


def test_frames_that_are_cut_garbled_or_of_another_length_hide_no_good_one(found: dict[str, Any]) -> None:
    *seen, last = found["frames"]
    assert len(seen) == 12 * 7
    assert set(seen) == {(0, 1, 0)}
    assert last == (0, 0, 0)


def test_sensors_give_what_was_measured_last_and_silence_is_an_error(found: dict[str, Any]) -> None:
    none, first, second, same, silent, paused, after = found["sensors"]
    assert none == [100, 30, 0, 0, 3, 0, 0, 0]
    assert first == [26, 20, 0, 1, 3, 0, 0, 1]
    assert second == same == [0, 30, 1, 0, 4, 1, 1, 0]
    assert set(silent) == {"no answer from the Alvik"}
    assert paused == [1, 1]
    assert after == [0, 0]


def test_a_colour_is_the_one_that_is_clearly_larger_than_the_others_between_black_and_white(
    found: dict[str, Any],
) -> None:
    assert found["colours"] == [0, 1, 2, 3, 0, 0, 0, 1, 1]


def test_lights_keep_each_other_and_that_of_the_eyes_and_are_told_again_when_the_stm32_begins_anew(
    found: dict[str, Any],
) -> None:
    def lights(bits: int) -> list[bytes]:
        return [frame("L", "B", bits)]

    red, blue = 0b100, 0b10010000
    *told, stopped, anew, wheels_anew, off = found["lights"]
    assert told == [lights(2 + red), lights(2 + red + blue), lights(2 + blue), lights(2), lights(2 + blue)]
    assert stopped == lights(2 + blue) + lights(2)
    assert anew == [*lights(2 + blue), BEHAVIOUR]
    assert wheels_anew == [wheels(50, 50)]
    assert off == lights(2)


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
