"""The drivers of kits, on a current MicroPython with pins and buses that only remember; all of it in one run."""

from __future__ import annotations

import ast
from typing import Any

import pytest

from tests.boards.modern import onboard_files, run
from tests.boards.test_machine_drivers import HEAD

FULL = 65535
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
arm.do("Load", [])
begun = time.ticks_ms()
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
pen.do("PenDown", [])
begun = time.ticks_ms()
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
buzzer.do("Tone", [880, 30])
told = taken()
begun = time.ticks_ms()
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
try:
    make("machine.analog", pin="26", low="7", high="7")
except ValueError as error:
    result.append(str(error))
""",
}
BEFORE = """
import sys
DRV8833 = {"left-forward": "2", "left-backward": "3", "right-forward": "4", "right-backward": "5"}
TB6612 = {"left-forward": "6", "left-backward": "7", "left-power": "8", "right-forward": "9", "right-backward": "10",
    "right-power": "11"}
DRV8835 = {"bridge": "direction", "left-forward": "13", "left-backward": "12", "right-forward": "15",
    "right-backward": "14", "left-flipped": "yes"}
heard = {}
def duties():
    for name, what, value in taken():
        if what == "duty":
            heard[name] = (value * 100 + 32767) // 65535
    return [heard.get(name, 0) for name in (2, 3, 4, 5)]
found = {}
def begin():
    from kitrobot_onboard.drivers.machine.shared.motors import bases
    for each in (bases, heard, levels, log):
        each.clear()
"""


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    """The result of each of the steps."""
    steps = [f"begin()\n{program}\nfound[{name!r}] = result\n" for name, program in STEPS.items()]
    text = "\n".join([HEAD, BEFORE, *steps, "print(repr(found))"])
    results: dict[str, Any] = ast.literal_eval(run({**onboard_files(), "test.py": text.encode()}, "test.py"))
    return results


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


def test_bars_beside_a_road_are_counted_until_the_next_ones(found: dict[str, Any]) -> None:
    assert found["marks"] == [(0, 2, 2), (2, 0, 0)]


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
    *degrees, wrong = found["warmth"]
    assert degrees == [0, 25, 50, 0, 50]
    assert wrong == "low and high are the same"
