"""The drivers for boards with the module `machine`, on a current MicroPython with pins that only remember."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

import kitrobot_onboard
from kitrobot.deploy.line.line import Line
from tests.boards.modern import ModernBoard, onboard_files
from tests.patience import PATIENCE_S

FOLDER = Path(kitrobot_onboard.__file__).parent / "drivers"
NAMES = sorted(path.stem for path in (FOLDER / "machine").glob("*.py") if path.stem not in ("__init__", "pins"))

RAW = b"raw REPL; CTRL-B to exit\r\n>"
"""What MicroPython says when it takes programs."""

HEAD = """
import machine, time
from machine import levels, log, volts, widths
def make(name, **settings):
    module = __import__("kitrobot_onboard.drivers." + name)
    for word in ("drivers." + name).split("."):
        module = getattr(module, word)
    return module.make(settings)
def taken():
    new = log[:]
    log.clear()
    return new
"""


OnBoard = Callable[[str], Any]


@pytest.fixture(scope="module")
def on_board() -> Iterator[OnBoard]:
    """What a program leaves in `result`, run by MicroPython, which begins anew for each."""
    with ModernBoard(onboard_files()) as board, closing(Line(board.address)) as line:

        def result_of(program: str) -> Any:
            line.write(b"\r\x03\x03\r\x01")
            line.read_until(RAW, PATIENCE_S)
            line.write(b"\x04")
            line.read_until(RAW, PATIENCE_S)
            line.write(f"{HEAD}\n{program}\nprint(repr(result))\n\x04".encode())
            answer = line.read_until(b"\x04>", PATIENCE_S).removeprefix(b"OK").removesuffix(b"\x04>")
            printed, _, error = answer.decode().partition("\x04")
            assert error == ""
            return ast.literal_eval(printed)

        yield result_of


def test_every_driver_is_tried_here() -> None:
    text = "".join(path.read_text(encoding="utf-8") for path in Path(__file__).parent.glob("test_*.py"))
    for name in NAMES:
        assert f'make("machine.{name}"' in text, name


def test_a_motor_turns_as_fast_as_it_is_told_by_one_input_at_a_time(on_board: OnBoard) -> None:
    result = on_board("""
motor = make("machine.pwm_motor", forward="2", backward="3", frequency="500")
result = [taken()]
told = (
    ("Forward", [50]), ("Forward", [50]), ("Backward", [100]), ("Backward", [20]), ("Stop", []), ("Forward", [130])
)
for procedure, arguments in told:
    motor.do(procedure, arguments)
    result.append(taken())
motor.stop()
result.append(taken())
""")
    still = [(2, "duty", 0), (3, "duty", 0)]
    assert result == [
        [(2, "freq", 500), (2, "duty", 0), (3, "freq", 500), (3, "duty", 0)],
        # One that is told the same again, or another speed, is not without power in between.
        [(3, "duty", 0), (2, "duty", 32767)],
        [(3, "duty", 0), (2, "duty", 32767)],
        [(2, "duty", 0), (3, "duty", 65535)],
        [(2, "duty", 0), (3, "duty", 13107)],
        still,
        [(3, "duty", 0), (2, "duty", 65535)],
        still,
    ]


def test_a_motor_needs_no_more_than_an_old_pwm_has(on_board: OnBoard) -> None:
    result = on_board("""
machine.PWM = machine.OldPWM
motor = make("machine.pwm_motor", forward="2", backward="3")
taken()
motor.do("Forward", [50])
result = taken()
""")
    assert result == [(3, "duty10", 0), (2, "duty10", 511)]


@pytest.mark.parametrize(("reach", "least", "most"), [(1000, 0, 100), (400, 10, 30), (4000, 0, 4000)])
def test_a_range_finder_gives_what_the_speed_of_sound_says(
    on_board: OnBoard, reach: int, least: int, most: int
) -> None:
    distances = [0, 1, 20, reach // 3, reach // 2, reach - 1, reach, reach + 50]
    # There and back at 343 m/s.
    widths = [round(2 * distance / 0.343) for distance in distances]
    result = on_board(f"""
finder = make("machine.ultrasonic", trigger="14", echo="15", reach="{reach}", min="{least}", max="{most}")
result = []
for width in {widths}:
    finder.finder.due = time.ticks_ms()
    widths[15] = width
    result.append(finder.read())
""")
    for distance, seen in zip(distances, result, strict=True):
        exact = least + min(distance / reach, 1) * (most - least)
        assert abs(seen - exact) <= 0.5 + (most - least) / reach * 0.2, (distance, seen)


def test_a_range_finder_that_hears_nothing_sees_as_far_as_it_can_and_waits_no_longer_than_sound_takes(
    on_board: OnBoard,
) -> None:
    result = on_board("""
finder = make("machine.ultrasonic", trigger="14", echo="15", reach="1000", min="0", max="100")
taken()
silent = finder.read()
first = taken()
finder.finder.due = time.ticks_ms()
widths[15] = 30000
result = silent, first, finder.read(), taken()[-1]
""")
    silent, asked, late, last = result
    assert (silent, late) == (100, 100)
    assert [entry[:2] for entry in asked] == [(14, "value"), (14, "value"), (15, "wait")]
    assert [value for _, _, value in asked[:2]] == [1, 0]
    assert last[2] == asked[2][2] <= 1000 + math.ceil(2 * 1000 / 0.343) + 2


def test_range_finders_take_turns_and_give_what_they_saw_in_between(on_board: OnBoard) -> None:
    result = on_board("""
left = make("machine.ultrasonic", trigger="1", echo="2", min="0", max="100")
right = make("machine.ultrasonic", trigger="3", echo="4", min="0", max="100")
from kitrobot_onboard.drivers.machine.shared import echoes
class Clock:  # one that stands still while the finders look
    now = left.finder.due
    def ticks_ms(self): return self.now
    def ticks_diff(self, later, earlier): return time.ticks_diff(later, earlier)
    def ticks_add(self, begun, passed): return time.ticks_add(begun, passed)
    def sleep_us(self, passed): pass
clock = echoes.time = Clock()
for finder in (left, right):
    finder.finder.due = clock.now
widths[2] = 2915
widths[4] = 1458
taken()
asked = []
passed = 0
def look():
    global passed
    values = left.read(), right.read()
    pins = [entry[0] for entry in taken() if entry[1] == "wait"]
    passed += 1
    clock.now = time.ticks_add(clock.now, 1)
    return values, pins
first = None
while len(asked) < 6:
    values, pins = look()
    asked += [(pin, passed) for pin in pins]
    if first is None and len(asked) == 2:
        first = values
levels[4] = 1  # stuck, as when it is not wired
stuck = []
while len(stuck) < 3:
    stuck += look()[1]
result = asked, first, stuck, right.read()
""")
    asked, first, stuck, right = result
    assert asked == [(2, 1), (4, 31), (2, 61), (4, 91), (2, 121), (4, 151)]
    assert first == (50, 25)
    assert stuck == [2, 2, 2]
    assert right == 25


def test_a_line_sensor_tells_dark_from_bright(on_board: OnBoard) -> None:
    result = on_board("""
result = []
for settings in ({"dark": "high"}, {"dark": "low"}, {}):
    line = make("machine.line", pin="16", min="0", max="3", **settings)
    for level in (0, 1):
        levels[16] = level
        result.append(line.read())
for settings in ({"dark": "high"}, {"dark": "low"}):
    line = make("machine.line", pin="26", threshold="30000", min="5", max="6", **settings)
    for volt in (0, 29999, 30000, 65535):
        volts[26] = volt
        result.append(line.read())
""")
    assert result == [0, 1, 1, 0, 0, 1, 5, 5, 6, 6, 6, 6, 5, 5]


def test_a_servo_gets_pulses_of_its_angle_and_is_done_by_the_clock(on_board: OnBoard) -> None:
    result = on_board("""
door = make("machine.servo", pin="22", open="90", closed="0", time="40")
result = [taken(), door.done()]
begun = time.ticks_ms()
door.do("Open", [])
result.append(door.done())
while not door.done(): pass
result.append(time.ticks_diff(time.ticks_ms(), begun))
door.do("Close", [])
result.append(door.done())
door.stop()
result += [door.done(), taken()]
""")
    made, idle, begun, needed, closing, stopped, told = result
    assert made == [(22, "freq", 50), (22, "duty", 0)]
    assert (idle, begun, closing, stopped) == (True, False, False, True)
    assert 40 <= needed < 1000
    pulses_ms = [duty / 65535 * 20 for _, _, duty in told]
    assert pulses_ms == pytest.approx([1.5, 0.5, 0], abs=0.01)


def test_a_lamp_lights_and_goes_out_also_when_low_lights_it(on_board: OnBoard) -> None:
    result = on_board("""
result = []
for settings in ({"pin": "LED"}, {"pin": "7", "active": "low"}):
    lamp = make("machine.led", **settings)
    lamp.do("LightOn", [])
    lamp.do("LightOff", [])
    lamp.do("LightOn", [])
    lamp.stop()
    result.append([entry for entry in taken() if entry[1] == "value"])
""")
    assert result == [
        [("LED", "value", level) for level in (0, 1, 0, 1, 0)],
        [(7, "value", level) for level in (1, 0, 1, 0, 1)],
    ]


def test_a_key_is_pressed_when_its_pin_is_low(on_board: OnBoard) -> None:
    result = on_board("""
key = make("machine.key", pin="9")
result = taken()
for level in (1, 0):
    levels[9] = level
    result.append(key.read())
""")
    assert result == [(9, "in", 2), 0, 1]


def test_a_pin_is_written_and_used_as_a_wave_and_as_a_servo(on_board: OnBoard) -> None:
    result = on_board("""
out = make("machine.pin_out", pin="5")
taken()
result = []
for procedure, value in (("Write", 1), ("Analog", 1023), ("Analog", 512), ("Servo", 180), ("Write", 0), ("Servo", 200)):
    out.do(procedure, [value])
    result.append(taken())
out.stop()
result.append(taken())
""")
    assert result[0] == [(5, "value", 1)]
    assert result[1] == [(5, "freq", 1000), (5, "duty", 0), (5, "duty", 65535)]
    assert result[2] == [(5, "duty", 512 * 65535 // 1023)]
    assert [entry[1] for entry in result[3]] == ["freq", "duty"]
    assert result[3][1][2] / 65535 * 20 == pytest.approx(2.5, abs=0.01)
    assert [entry[1] for entry in result[4]] == ["deinit", "out", "value"]
    assert result[5][-1][2] == result[3][1][2]
    assert result[6][-1] == (5, "value", 0)


def test_a_pin_is_read_as_a_level_and_as_a_voltage(on_board: OnBoard) -> None:
    result = on_board("""
digital = make("machine.pin_in", pin="4", min="0", max="1")
analog = make("machine.pin_in", pin="27", mode="analog", min="0", max="1023")
result = [digital.read(), analog.read()]
levels[4] = 1
volts[27] = 65535
result += [digital.read(), analog.read()]
""")
    assert result == [0, 0, 1, 1023]


def test_chance_gives_every_number_of_its_range_and_no_other(on_board: OnBoard) -> None:
    result = on_board("""
dice = make("any.random", min="1", max="6")
result = sorted(set([dice() for _ in range(500)]))
""")
    assert result == [1, 2, 3, 4, 5, 6]


def test_a_pin_that_the_board_does_not_have_is_refused_when_the_driver_is_made(on_board: OnBoard) -> None:
    result = on_board("""
result = []
for pin in ("99", "XYZ"):
    try:
        make("machine.led", pin=pin)
    except ValueError as error:
        result.append(repr(error))
""")
    assert result == ["ValueError('invalid pin',)"] * 2
