"""The drivers of parts that are wired to the edge of a micro:bit, on a current MicroPython with recorded pins."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from kitrobot.deploy.line.handshake import connect
from tests.boards.kit_steps import results_of
from tests.boards.modern import ModernBoard
from tests.boards.test_microbit_v2 import board, goes_on
from tests.boards.test_modern_robot import deploy_by_command, pins_told
from tests.boards.test_motor_chips import fault_of

STEPS = {
    "motors": """
from kitrobot_onboard.drivers.microbit.shared import motors
DRV8833 = {"kit": "pins", "left-forward": "0", "left-backward": "1", "right-forward": "2", "right-backward": "8"}
TB6612 = dict(DRV8833)
TB6612.update({"left-power": "12", "right-power": "13"})
result = []
for wires in (DRV8833, TB6612):
    del motors.told[2:]
    drive, turn = make("microbit.drive", **wires), make("microbit.turn", rate="200", **wires)
    right = make("microbit.wheel", side="right", **wires)
    drive.stop()
    rows = [taken()]
    for part, procedure, arguments in (
        (drive, "Advance", [50]), (drive, "Advance", [50]), (drive, "Reverse", [100]), (drive, "Stop", []),
        (turn, "Turn", [20]), (turn, "Stop", []), (right, "Backward", [40]),
    ):
        part.do(procedure, arguments)
        drive.tend()
        rows.append(taken())
    right.stop()
    rows.append(taken())
    result.append(rows)
""",
    "servos": """
door = make("microbit.servo", pin="14", open="90", closed="0", time="40")
arm = make("microbit.arm", pin="15", load="180", rest="0", time="100")
result = [taken()]
door.do("Open", [])
busy = door.done()
while not door.done(): pass
door.do("Close", [])
door.stop()
result += [busy, door.done(), taken()]
begun = time.ticks_ms()
arm.do("Load", [])
while not arm.done(): pass
result += [time.ticks_diff(time.ticks_ms(), begun), taken()]
arm.do("Load", [])
arm.stop()
result += [arm.done(), taken()]
""",
    "switches": """
result = []
for active in ("high", "low"):
    switch = make("microbit.switch", pin="16", active=active)
    switch.do("SwitchOn", [])
    switch.do("SwitchOff", [])
    switch.do("SwitchOn", [])
    switch.stop()
    result.append([value for _, _, value in taken()])
""",
    "lamp": """
lamp = make("microbit.neopixel_lamp", pin="0", count="2", red="9", green="8", blue="7")
lamp.do("LightOn", [])
lamp.stop()
result = taken()
""",
    "counts": """
levels[1] = levels[2] = 1
store = make("microbit.counter", more="1", less="2", first="4", min="0", max="5")
result = [taken()]
for more, less in ((0, 1), (0, 1), (1, 1), (0, 1), (1, 0), (1, 1)):
    levels[1], levels[2] = more, less
    result.append(store.read())
sign = make("microbit.marks", pin="3", gap="40")
for level in (1, 0, 1, 0, 1, 0):
    levels[3] = level
    sign.read()
begun = time.ticks_ms()
while time.ticks_diff(time.ticks_ms(), begun) < 60: pass
result.append(sign.read())
""",
    "colours": """
machine.registers[0x29] = {}
sensor = make("microbit.tcs34725")
patches = make("microbit.patches", red="7", steady="1")
result = [taken()]
for counts in ((400, 200, 100, 90), (400, 100, 250, 100), (400, 90, 80, 250), (400, 130, 130, 130), (9, 9, 1, 1)):
    data = b"".join(count.to_bytes(2, "little") for count in counts)
    machine.registers[0x29][0xB4] = data
    result.append((sensor.read(), patches.read()))
machine.registers.clear()
try:
    sensor.read()
except OSError as error:
    result.append(error.args)
""",
}


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    return results_of(STEPS)


def test_a_motor_board_with_two_inputs_a_motor_has_power_at_one_of_them(found: dict[str, Any]) -> None:
    still, advance, again, reverse, stop, turn, _, right, end = found["motors"][0]
    off = [(1, "value", 0), (0, "analog", 0), (8, "value", 0), (2, "analog", 0)]
    assert still == stop == end == off
    assert advance == [(1, "value", 0), (0, "analog", 511), (8, "value", 0), (2, "analog", 511)]
    assert again == []
    assert reverse == [(0, "value", 0), (1, "analog", 1023), (2, "value", 0), (8, "analog", 1023)]
    assert turn == [(0, "value", 0), (1, "analog", 204), (8, "value", 0), (2, "analog", 204)], "counter-clockwise"
    assert right[-2:] == [(2, "value", 0), (8, "analog", 409)]


def test_a_motor_board_with_three_inputs_a_motor_has_the_direction_at_two(found: dict[str, Any]) -> None:
    still, advance, _, reverse, stop, *_, end = found["motors"][1]
    assert still == stop == end
    assert still == [(pin, "value", 0) for pin in (1, 0)] + [(12, "analog", 0)] + [
        (pin, "value", 0) for pin in (8, 2)
    ] + [(13, "analog", 0)]
    assert advance[:3] == [(1, "value", 0), (0, "value", 1), (12, "analog", 511)]
    assert reverse[3:] == [(2, "value", 0), (8, "value", 1), (13, "analog", 1023)]


def test_servos_go_to_their_angles_and_are_left_without_force(found: dict[str, Any]) -> None:
    made, busy, done, door, arm_ms, arm, arm_done, stopped = found["servos"]
    assert made == [(14, "value", 0), (15, "value", 0)]
    assert (busy, done, arm_done) == (False, True, True)
    # 1.5 ms and 0.5 ms of 20 ms, in 1023rds.
    assert door == [(14, "period", 20), (14, "analog", 77), (14, "period", 20), (14, "analog", 26), (14, "value", 0)]
    assert arm_ms >= 100
    assert arm == [(15, "period", 20), (15, "analog", 128), (15, "period", 20), (15, "analog", 26)]
    assert stopped[-1] == (15, "value", 0)


def test_switches_and_lamps_are_off_when_they_are_made_and_when_they_stop(found: dict[str, Any]) -> None:
    high, low = found["switches"]
    assert (high, low) == ([0, 1, 0, 1, 0], [1, 0, 1, 0, 1])
    dark, lit = [(0, 0, 0)] * 2, [(9, 8, 7)] * 2
    assert found["lamp"] == [(0, "pixels", dark), (0, "pixels", lit), (0, "pixels", dark)]


def test_a_store_counts_what_passes_and_a_sign_its_bars(found: dict[str, Any]) -> None:
    pulls, *counted, sign = found["counts"]
    assert pulls == [(1, "pull", 1), (2, "pull", 1)]
    assert counted == [5, 5, 5, 5, 4, 4]
    assert sign == 2


def test_a_colour_is_read_from_the_bus_and_a_sensor_that_is_gone_is_an_error(found: dict[str, Any]) -> None:
    told, *seen, gone = found["colours"]
    assert told == [(0x29, "i2c", bytes(pair)) for pair in ((0x80, 3), (0x81, 0xF6), (0x8F, 1))] * 2
    assert seen == [(1, 7), (2, 7), (3, 7), (0, 7), (0, 7)]
    assert gone == (19,)


ROBOT = """<robot name="crane" version="1">
  <actuator name="Wheel" device="drive">
    <procedure name="Advance"><parameter name="speed" min="0" max="100" default="50"/></procedure>
    <procedure name="Stop"/>
  </actuator>
  <actuator name="Door" device="door" time="1000">
    <procedure name="Open" completes="later"/><procedure name="Close" completes="later"/>
  </actuator>
  <actuator name="Arm" device="arm" time="2000"><procedure name="Load" completes="later"/></actuator>
  <actuator name="Switch" device="switch"><procedure name="SwitchOn"/><procedure name="SwitchOff"/></actuator>
  <actuator name="Lamp" device="lamp"><procedure name="LightOn"/><procedure name="LightOff"/></actuator>
  <actuator name="Pen" device="pen"><procedure name="PenDown"/></actuator>
</robot>
"""
KIT = """<board name="edge" version="1" family="microbit" pins="0..16 19 20">
  <actuator device="drive" kit="pins" left-forward="0" left-backward="1" right-forward="2" right-backward="8"/>
  <actuator device="door" driver="servo" pin="12" time="60000"/>
  <actuator device="arm" pin="13" time="60000"/>
  <actuator device="switch" pin="14"/>
  <actuator device="lamp" driver="neopixel-lamp" pin="15"/>
  <actuator device="pen" driver="hot"/>
</board>
"""
HOT = """
class Hot:
    def do(self, procedure, arguments):
        raise OSError("too hot")
    def stop(self):
        pass
def make(settings):
    return Hot()
"""
GOES = "Wheel.Advance(50); Switch.SwitchOn(); Lamp.LightOn(); //( Door.Open();, Arm.Load();, {then} );"


@pytest.fixture(scope="module")
def v2() -> Iterator[ModernBoard]:
    with board("nRF52833") as found:
        yield found


@pytest.mark.parametrize("end", ["STOP", "a fault of another part", "the one who holds it falls silent"])
def test_on_a_v2_motors_servos_switch_and_lamp_are_off_after(end: str, v2: ModernBoard, tmp_path: Path) -> None:
    v2.cut_power()
    for name, text in (("crane.robot.xml", ROBOT), ("edge.board.xml", KIT), ("hot.driver.py", HOT)):
        (tmp_path / name).write_text(text, encoding="utf-8")
    path = tmp_path / "go.lll"
    path.write_text(GOES.format(then="WAIT(20); Pen.PenDown();" if end.startswith("a fault") else "WAIT(6000);"))
    kit = str(tmp_path / "edge.board.xml")
    deploy_by_command(path, v2, "--robot", str(tmp_path / "crane.robot.xml"), "--board", kit)
    with connect(v2.address, 20) as robot:
        robot.start(held=end.startswith("the one"))
        if end == "STOP":
            goes_on(robot)
            robot.stop()
        else:
            robot._held = False  # nobody speaks to it any more
            assert fault_of(robot).number == (1 if end.startswith("a fault") else 6)
    told = pins_told(v2)
    moved = [(0, "analog", 511), (2, "analog", 511), (12, "analog", 77), (13, "analog", 77), (14, "value", 1)]
    for one in [*moved, (15, "pixels", [(40, 40, 40)])]:
        assert one in told
    last = {name: (what, value) for name, what, value in told if what != "period"}
    assert [last[pin] for pin in (1, 8, 12, 13, 14)] == [("value", 0)] * 5
    assert [last[pin] for pin in (0, 2)] == [("analog", 0)] * 2
    assert last[15] == ("pixels", [(0, 0, 0)])
