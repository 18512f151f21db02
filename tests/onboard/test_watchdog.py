"""Whatever goes wrong on a robot stops its devices and is told; the link stays, and the next start begins anew."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from kitrobot.compiler.compilation import compile_lll
from kitrobot.image.machine import Layout
from kitrobot.image.model import Image
from kitrobot.lll.parse_results import parse
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot_onboard.state import WRITE
from tests.boards import drivers
from tests.boards.program_files import device_lines, program_file
from tests.onboard.bench import Bench
from tests.patience import PATIENCE_S

XML = """<robot name="rig" version="1" tick="20" wait-unit="100">
  <actuator name="Wheel" device="drive">
    <procedure name="Advance" stop="Stop">
      <parameter name="power" min="0" max="100" default="50"/>
    </procedure>
    <procedure name="Turn" completes="later" stop="Stop">
      <parameter name="by" min="0" max="100" default="1"/>
    </procedure>
    <procedure name="Stop"/>
  </actuator>
  <actuator name="Lamp" device="lamp"><procedure name="On"/><procedure name="Off"/></actuator>
  <sensor name="Eye" device="range" min="0" max="100">
    <operation name="IsLess" test="less"><parameter name="value" min="0" max="100"/></operation>
  </sensor>
  <variable name="Count" type="integer" min="0" max="1000" initial="3"/>
</robot>
"""
FOREVER = "Lamp.On(); *[Eye.IsLess(200)](Wheel.Advance(20); WAIT(1); Wheel.Turn(3); );"


def rig(text: str = FOREVER) -> tuple[Image, Robot]:
    robot, problems = read_robot(XML.encode(), "rig.robot.xml")
    assert robot is not None, problems
    parsed = parse(text)
    compiled = compile_lll(parsed.program, robot)
    assert compiled.image is not None, compiled.diagnostics
    return compiled.image, robot


def file(wheel: str = "stores", lamp: str = "stores", eye: str = "zero", text: str = FOREVER) -> bytes:
    image, robot = rig(text)
    words = {"Wheel": wheel, "Lamp": lamp, "Eye": eye}
    return program_file(image.to_bytes(), device_lines(robot, lambda p: words[p.name], lambda p: words[p.name]))


def faults(frames: list[tuple[str, int, bytes]]) -> list[tuple[int, int, int, str]]:
    """(number, instruction, tick, text) of each F."""
    return [(*struct.unpack("<BHI", data[:7]), data[7:].decode()) for kind, _, data in frames if kind == "F"]


def state(bench: Bench) -> tuple[int, int]:
    """State and fault, as H tells them."""
    kind, data = bench.ask("h", b"\1")
    assert kind == "H"
    return data[1], data[2]


def acts(command: str) -> set[int]:
    """The instructions that give a command."""
    image, robot = rig()
    actuator, procedure = command.split(".")
    number = Layout(robot).command[actuator, procedure]
    return {at // 4 for at in range(0, len(image.code), 4) if image.code[at] == 15 and image.code[at + 1] == number}


def test_a_driver_that_fails_stops_every_device_and_names_the_instruction(tmp_path: Path) -> None:
    drivers.log.clear()
    with Bench(tmp_path, file(wheel="broken on=do")) as bench:
        (fault,) = faults(bench.wait(100))
        assert fault[0] == 1
        assert fault[1] in acts("Wheel.Advance")
        assert fault[2] == 1
        assert fault[3].startswith("a0 ValueError")
        assert [word for word, _ in drivers.log].count("stop") == 2
        assert state(bench) == (4, 1)
        assert faults([("F", 0, bench.ask("l")[1])]) == [fault]
        assert bench.wait(500) == []
        drivers.log.clear()
        assert bench.ask("s", b"\0") == ("K", b"")
        bench.wait(100)
        assert ("Advance", [20]) in drivers.log, "it began anew"
        assert state(bench) == (4, 1)


def test_a_sensor_that_fails_has_no_instruction(tmp_path: Path) -> None:
    with Bench(tmp_path, file(eye="broken on=read")) as bench:
        (fault,) = faults(bench.wait(100))
        assert fault[:2] == (1, 65535)
        assert fault[3].startswith("s1 ValueError")


def test_a_device_that_fails_while_it_is_asked_names_what_it_was_doing(tmp_path: Path) -> None:
    with Bench(tmp_path, file(wheel="broken on=done")) as bench:
        (fault,) = faults(bench.wait(1000))
        assert fault[0] == 1
        assert fault[1] in acts("Wheel.Turn")


@pytest.mark.parametrize(("words", "limit_ms"), [("stuck", 30_000), ("stuck limit=2", 2_000)])
def test_a_device_that_is_never_done_is_given_up_after_its_limit(tmp_path: Path, words: str, limit_ms: int) -> None:
    with Bench(tmp_path, file(wheel=words)) as bench:
        assert faults(bench.wait(limit_ms)) == []
        (fault,) = faults(bench.wait(1000))
        assert fault[0] == 2
        assert fault[1] in acts("Wheel.Turn")
        assert fault[3] == "a0 not done"


def test_no_memory_is_a_fault_and_not_the_end(tmp_path: Path) -> None:
    with Bench(tmp_path, file(wheel="broken on=do error=memory")) as bench:
        (fault,) = faults(bench.wait(100))
        assert fault[0] == 3
        assert fault[1] in acts("Wheel.Advance")
        assert state(bench) == (4, 3)


def test_a_missing_driver_is_named(tmp_path: Path) -> None:
    assert Layout(rig()[1]).sensors["Eye"] == 1
    with Bench(tmp_path, file(eye="no-such-thing")) as bench:
        kind, data = bench.ask("l")
        (fault,) = faults([(kind, 0, data)])
        assert fault[0] == 5
        assert fault[3].startswith("s1 no-such-thing ImportError")
        assert state(bench) == (4, 5)


def test_a_held_run_ends_when_nobody_is_heard_for_a_while(tmp_path: Path) -> None:
    with Bench(tmp_path, file()) as bench:
        assert bench.ask("s", b"\1") == ("K", b"")
        for _ in range(5):
            assert faults(bench.wait(700)) == []
            assert bench.ask("p") == ("K", b"")
        assert [fault[0] for fault in faults(bench.wait(900))] == [6]
        assert state(bench) == (4, 6)


def test_the_time_that_a_request_takes_is_no_silence(tmp_path: Path) -> None:
    with Bench(tmp_path, file()) as bench:
        write = bench.robot[WRITE]

        def write_late(data: bytes) -> None:
            bench.wire.now += 2000
            bench.robot[WRITE] = write
            write(data)

        assert bench.ask("s", b"\1") == ("K", b"")
        bench.robot[WRITE] = write_late
        assert bench.ask("p") == ("K", b"")
        assert faults(bench.wait(700)) == []
        assert [fault[0] for fault in faults(bench.wait(900))] == [6]


def test_a_board_that_was_held_up_reads_what_waits_before_it_says_that_nobody_is_heard(tmp_path: Path) -> None:
    with Bench(tmp_path, file()) as bench:
        assert bench.ask("s", b"\1") == ("K", b"")
        for _ in range(3):
            assert faults(bench.wait(500)) == []
            bench.wire.now += 2000
            assert bench.ask("p") == ("K", b"")
        assert faults(bench.wait(500)) == []
        bench.wire.now += 2000
        assert [fault[0] for fault in faults(bench.wait(200))] == [6]


def test_a_free_run_needs_nobody(tmp_path: Path) -> None:
    with Bench(tmp_path, file()) as bench:
        assert bench.ask("s", b"\0") == ("K", b"")
        assert faults(bench.wait(10_000)) == []
        assert state(bench) == (2, 0)


def test_every_device_is_stopped_though_the_first_will_not(tmp_path: Path) -> None:
    with Bench(tmp_path, file(wheel="broken on=stop", lamp="stores pin=9")) as bench:
        drivers.log.clear()
        assert bench.ask("x") == ("K", b"")
        assert ("stop", "9") in drivers.log
        assert state(bench) == (4, 1)


def test_an_interrupt_twice_stops_and_leaves_and_a_single_one_does_nothing(tmp_path: Path) -> None:
    with Bench(tmp_path, file()) as bench:
        bench.send(b"a\x03b\x03 ~~\x03~")
        assert state(bench) == (2, 0)
        drivers.log.clear()
        bench.send(b"~h\x01\r\x03")
        bench.thread.join(PATIENCE_S)
        assert not bench.thread.is_alive()
        assert [word for word, _ in drivers.log].count("stop") == 2
