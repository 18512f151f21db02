"""The drivers of kits for sensors, servos, lamps and sound, with recorded pins and buses."""

from __future__ import annotations

from typing import Any

import pytest

from tests.boards.kit_steps import FULL, results_of

STEPS = {
    "near": """
near = make("machine.near", trigger="14", echo="15", reach="120")
result = []
for width in (690, 710):
    near.finder.due = time.ticks_ms()
    widths[15] = width
    result.append(near.read())
""",
    "unplugged": """
sys.modules["kitrobot_onboard.drivers.machine.shared.echoes"].finders.clear()
finder = make("machine.ultrasonic", trigger="1", echo="2")
widths[2] = None
reads = 0
result = []
while not result:
    finder.finder.due = time.ticks_ms()
    reads += 1
    try:
        finder.read()
    except OSError as error:
        result = [reads, repr(error)]
for name, settings in (
    ("turn", dict(DRV8833, gyro="lsm6dso", sda="0", scl="1", address="99")), ("tcs34725", dict(sda="0", scl="1"))
):
    machine.registers.clear()
    try:
        make("machine." + name, **settings)
    except OSError as error:
        result.append(error.errno)
""",
    "colours": """
machine.registers[0x29] = {}
sensor = make("machine.tcs34725", sda="8", scl="9")
told = taken()
result = []
for clear, red, green, blue in (
    (900, 600, 100, 100), (900, 100, 600, 100), (900, 100, 100, 600), (900, 300, 280, 290), (20, 10, 1, 1)
):
    data = b""
    for value in (clear, red, green, blue):
        data += bytes((value % 256, value // 256))
    machine.registers[0x29][0xB4] = data
    result.append(sensor.read())
result = result, told
""",
    "time of flight": """
machine.registers[0x29] = {0xC0: b"\\xee"}
finder = make("machine.vl53l0x", sda="8", scl="9", min="0", max="100", reach="1000")
result = [taken(), finder.read()]
for status, mm in ((11, 250), (11, 2000), (4, 250), (11, 0)):
    data = bytes((status << 3,)) + bytes(9) + bytes((mm // 256, mm % 256))
    machine.registers[0x29].update({0x13: b"\\4", 0x14: data})
    result.append(finder.read())
machine.registers[0x29][0x13] = b"\\0"
result.append(finder.read())
finder.begun = time.ticks_add(time.ticks_ms(), -501)
for registers in ({0x29: machine.registers[0x29]}, {}):
    machine.registers.clear()
    machine.registers.update(registers)
    try:
        finder.read()
    except OSError as error:
        result.append(repr(error))
machine.registers[0x29] = {0xC0: b"\\x44"}
try:
    make("machine.vl53l0x", sda="8", scl="9")
except OSError as error:
    result.append(repr(error))
""",
    "marks": """
levels[19] = 0
marks = make("machine.marks", pin="19", gap="40")
result = []
for bars in (3, 1):
    for level in (1, 1, 0, 0) * bars:
        levels[19] = level
        marks.read()
    last = marks.read()
    begun = time.ticks_ms()
    while time.ticks_diff(time.ticks_ms(), begun) <= 41: pass
    result.append((last, marks.read(), marks.read()))
""",
    "patches": """
machine.registers[0x29] = {}
NOTHING, RED, GREEN, BLUE, DARK = (300, 290, 280), (600, 100, 100), (100, 600, 100), (100, 100, 600), (9, 1, 1)
def show(sensor, *colours):
    seen = []
    for colour in colours:
        data = b"" if colour is DARK else bytes((0, 3))
        for value in ((20,) if colour is DARK else ()) + colour:
            data += bytes((value % 256, value // 256))
        machine.registers[0x29][0xB4] = data
        seen.append(sensor.read())
    return seen
sign = make("machine.patches", sda="8", scl="9", red="7", blue="12", min="3", max="100")
result = [
    show(sign, NOTHING, RED, NOTHING, RED, RED, NOTHING, NOTHING, GREEN, GREEN),
    show(sign, BLUE, RED, BLUE, BLUE, DARK, DARK, RED, RED, RED),
]
once = make("machine.patches", sda="8", scl="9", green="0", steady="1", min="3", max="100")
result.append(show(once, NOTHING, GREEN, RED))
machine.registers.clear()
for settings in ({}, {"red": "1"}):
    try:
        make("machine.patches", sda="8", scl="9", **settings)
    except (OSError, ValueError) as error:
        result.append(repr(error))
machine.registers[0x29] = {}
lost = make("machine.patches", sda="8", scl="9", red="1")
machine.registers.clear()
try:
    lost.read()
except OSError as error:
    result.append(repr(error))
""",
    "counter": """
levels[12] = levels[13] = 1
counter = make("machine.counter", more="12", less="13", first="2", min="0", max="4")
result = [counter.read()]
for pin in (12, 12, 12, 13, 13, 13, 13, 13):
    levels[pin] = 0
    counter.read(), counter.read()
    levels[pin] = 1
    result.append(counter.read())
""",
    "lamps": """
result = []
for lamp, on, off in (
    (make("machine.switch", pin="6"), "SwitchOn", "SwitchOff"),
    (make("machine.rgb", red="1", green="2", blue="3", colour="yellow", active="low"), "LightOn", "LightOff"),
    (make("machine.neopixel_lamp", pin="7", count="2", red="9"), "LightOn", "LightOff"),
):
    taken()
    lamp.do(on, [])
    first = taken()
    lamp.do(off, [])
    second = taken()
    lamp.do(on, [])
    taken()
    lamp.stop()
    result.append((first, second, taken() == second))
""",
    "arm": """
arm = make("machine.arm", pin="20", rest="0", load="90", time="100")
taken()
begun = time.ticks_ms()
arm.do("Load", [])
while not arm.done(): pass
gone = time.ticks_diff(time.ticks_ms(), begun)
told = taken()
arm.do("Load", [])
arm.stop()
result = gone, told, arm.done(), taken()[-1]
""",
    "pen": """
pen = make("machine.pen", pin="26", time="40")
taken()
begun = time.ticks_ms()
pen.do("PenDown", [])
while not pen.done(): pass
gone = time.ticks_diff(time.ticks_ms(), begun)
pen.do("Colour", [3])
idle = pen.done()
pen.do("PenUp", [])
pen.stop()
result = gone, idle, pen.done(), taken()
""",
    "buzzer": """
buzzer = make("machine.buzzer", pin="18", loudness="100")
taken()
begun = time.ticks_ms()
buzzer.do("Tone", [880, 30])
told = taken()
while not buzzer.done(): pass
result = told, time.ticks_diff(time.ticks_ms(), begun), taken()
""",
    "a voltage": """
finder = make("machine.analog_range", pin="26", near="50000", far="10000", min="0", max="100")
result = []
for volt in (65535, 50000, 30000, 10000, 0):
    volts[26] = volt
    result.append(finder.read())
""",
    "warmth": """
sensor = make("machine.analog", pin="26", low="9929", high="19859", min="0", max="50")
result = []
for thousandths in (500, 750, 1000, 100, 3300):  # a TMP36 at 0, 25, 50, -40 and more than all degrees
    volts[26] = thousandths * 65535 // 3300
    result.append(sensor.read())
sensor = make("machine.analog", pin="26", low="9929", high="19859", floor="1986", min="0", max="50")
for voltage in (1986, 1985):
    volts[26] = voltage
    try:
        result.append(sensor.read())
    except OSError as error:
        result.append(str(error))
try:
    make("machine.analog", pin="26", low="7", high="7")
except ValueError as error:
    result.append(str(error))
""",
}


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    """The result of each of the steps."""
    return results_of(STEPS)


def test_something_is_near_when_its_echo_comes_sooner_than_from_reach(found: dict[str, Any]) -> None:
    assert found["near"] == [1, 0]


def test_a_sensor_that_is_not_plugged_in_is_an_error_and_not_a_number(found: dict[str, Any]) -> None:
    reads, error, gyro, colour = found["unplugged"]
    assert reads == 5
    assert "not plugged in" in error
    assert (gyro, colour) == (19, 19)


def test_a_colour_is_the_one_that_is_clearly_larger_than_the_others(found: dict[str, Any]) -> None:
    seen, told = found["colours"]
    assert seen == [1, 2, 3, 0, 0]
    assert [entry[1:] for entry in told] == [(0x80, b"\x03"), (0x81, b"\xf6"), (0x8F, b"\x01")]


def test_a_time_of_flight_finder_is_asked_again_when_it_has_seen_something_and_silence_is_an_error(
    found: dict[str, Any],
) -> None:
    begun, *seen, silent, gone, other = found["time of flight"]
    assert begun == [(0x29, 0x0B, b"\1"), (0x29, 0x00, b"\1")]
    assert seen == [100, 25, 100, 100, 0, 0]
    assert "not plugged in" in silent
    assert "19" in gone
    assert "no VL53L0X" in other


def test_bars_beside_a_road_are_counted_until_the_next_ones(found: dict[str, Any]) -> None:
    assert found["marks"] == [(0, 2, 2), (2, 0, 0)]


def test_a_patch_of_colour_is_the_number_that_it_stands_for_until_the_next_one(found: dict[str, Any]) -> None:
    first, second, once, *_ = found["patches"]
    assert first == [3, 3, 3, 3, 7, 7, 7, 7, 7]  # a colour without a number changes nothing
    assert second == [7, 7, 7, 12, 12, 12, 12, 7, 7]
    assert once == [3, 0, 0]


def test_patches_without_a_number_or_a_sensor_are_an_error(found: dict[str, Any]) -> None:
    *_, useless, missing, lost = found["patches"]
    assert "no colour has a number" in useless
    assert "19" in missing
    assert "19" in lost


def test_what_passes_a_light_barrier_is_counted_up_and_down_within_the_range(found: dict[str, Any]) -> None:
    assert found["counter"] == [2, 3, 4, 4, 3, 2, 1, 0, 0]


def test_switch_lamp_of_three_colours_and_neopixels_go_on_and_off_and_stop_is_off(found: dict[str, Any]) -> None:
    switch, rgb, pixels = found["lamps"]
    assert switch == ([(6, "value", 1)], [(6, "value", 0)], True)
    assert rgb == (
        [(1, "value", 0), (2, "value", 0), (3, "value", 1)],
        [(1, "value", 1), (2, "value", 1), (3, "value", 1)],
        True,
    )
    assert pixels == ([(7, "pixels", [(9, 40, 40)] * 2)], [(7, "pixels", [(0, 0, 0)] * 2)], True)


def test_an_arm_goes_to_the_box_and_back_and_has_no_force_after_stop(found: dict[str, Any]) -> None:
    gone, told, done, last = found["arm"]
    assert 100 <= gone < 1000
    assert [duty / FULL * 20 for _, _, duty in told] == pytest.approx([1.5, 0.5], abs=0.01)
    assert (done, last) == (True, (20, "duty", 0))


def test_a_pen_goes_down_and_up_and_keeps_its_colour(found: dict[str, Any]) -> None:
    gone, idle, done, told = found["pen"]
    assert 40 <= gone < 1000
    assert (idle, done) == (True, True)
    assert [duty / FULL * 20 for _, _, duty in told] == pytest.approx([1.5, 0.5, 0], abs=0.01)


def test_a_buzzer_sounds_for_as_long_as_it_is_told(found: dict[str, Any]) -> None:
    told, gone, after = found["buzzer"]
    assert told == [(18, "duty", 0), (18, "freq", 880), (18, "duty", FULL // 2)]
    assert 30 <= gone < 1000
    assert after == [(18, "duty", 0)]


def test_a_voltage_is_a_distance_in_a_straight_line_between_two_ends(found: dict[str, Any]) -> None:
    assert found["a voltage"] == [0, 0, 50, 100, 100]


def test_a_sensor_of_warmth_says_degrees_from_its_voltage(found: dict[str, Any]) -> None:
    *degrees, least, nothing, wrong = found["warmth"]
    assert degrees == [0, 25, 50, 0, 50]
    assert (least, nothing) == (0, "no answer: not plugged in?")
    assert wrong == "low and high are the same"
