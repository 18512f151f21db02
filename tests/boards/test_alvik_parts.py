"""The line to the STM32 of an Arduino Alvik, and the drivers of its sensors, lights and servos."""

from __future__ import annotations

from typing import Any

import pytest

from tests.boards.alvik import BEFORE, HEARD, checksum, frame
from tests.boards.kit_steps import results_of

BEHAVIOUR = frame("B", "B", 1)
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

STEPS = {
    "before": BEFORE,
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
said.append(wrong + long + touched[:-2] + b"!" + touched[-1:])
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
    "servos": """
ready()
door, other = make("machine.alvik_servo", time="40"), make("machine.alvik_servo", servo="b", open="120", closed="10")
result = [written()]
door.do("Open", [])
begun = time.ticks_ms()
while not door.done(): pass
result += [written(), 40 <= time.ticks_diff(time.ticks_ms(), begun) < 1000]
for part, procedure in ((other, "Open"), (door, "Close"), (other, "Close")):
    part.do(procedure, [])
    result.append(written())
result.append(other.done())
other.stop()
result += [other.done(), written()]
levels[13] = 0
result.append(error_of(door.do, "Open", []))
""",
}


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    """The result of each of the steps."""
    return results_of(STEPS)


def test_a_frame_is_what_its_format_says_byte_by_byte() -> None:
    assert checksum(b"123456789") == 0xA1  # the check value of CRC-8 of Maxim
    assert frame("J", "2f", 70, -70) == bytes.fromhex("41 09 4a 00008c42 00008cc2 23") + bytes(
        [checksum(bytes.fromhex("4a00008c4200008cc2"))]
    )
    assert HEARD[:5] == bytes.fromhex("41 02 58 4b 23")


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
    assert wheels_anew == [frame("J", "2f", 35, 35)]
    assert off == lights(2)


def test_a_door_at_one_connector_for_servos_leaves_the_other_one_where_it_is(found: dict[str, Any]) -> None:
    def servos(*angles: int) -> list[bytes]:
        return [frame("S", "2B", *angles)]

    assert found["servos"] == [
        [],
        servos(90, 0),
        True,
        servos(90, 120),
        servos(0, 120),
        servos(0, 10),
        False,
        True,
        [],
        "the Alvik is switched off",
    ]
