"""The loop of a board, on CPython: with all inputs held it gives, tick by tick, exactly what the simulator's machine gives."""

from __future__ import annotations

import os
import random
import struct
from collections import deque
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from kitrobot.image import Machine
from kitrobot_onboard.equip import equip
from kitrobot_onboard.link import unwrap, wrap
from kitrobot_onboard.program import load
from kitrobot_onboard.robot import Robot
from tests.boards import drivers
from tests.boards.program_files import hardwareless
from tests.oracle.agreement import machine_for, random_case

BUDGET = int(os.environ.get("KITROBOT_BUDGET", "60"))


class Wire:
    """A port whose clock stands still unless somebody waits, and which hands over what was put into it."""

    BYTE_US = 87

    def __init__(self) -> None:
        self.now = 0
        self.coming: deque[bytes] = deque()
        self.sent = b""
        self.shows = False

    def ticks(self) -> int:
        return self.now

    def diff(self, later: int, earlier: int) -> int:
        return later - earlier

    def add(self, ticks: int, ms: int) -> int:
        return ticks + ms

    def read(self, ms: int) -> bytes:
        if self.coming:
            return self.coming.popleft()
        self.now += ms
        return b""

    def write(self, data: bytes) -> None:
        self.now += len(data) * self.BYTE_US // 1000
        self.sent += data

    def free(self) -> int:
        return 4321

    def identify(self, on: bool) -> None:
        self.shows = on

    def driver(self, name: str) -> SimpleNamespace:
        return drivers.driver(name)


def robot_with(path: Path, data: bytes) -> tuple[Robot, Wire]:
    """A robot that has loaded a program file, and its port."""
    path.write_bytes(data)
    wire = Wire()
    robot = Robot(wire, "c0ffee00 12345678", 7)
    loaded = load(str(path))
    assert equip(robot, loaded[3]) == ""
    robot.take(str(path), loaded)
    return robot, wire


def ask(robot: Robot, wire: Wire, kind: str, data: bytes = b"", number: int = 1) -> tuple[str, bytes]:
    """Sends a request; the kind and payload of its answer."""
    wire.sent = b""
    robot.hear(wrap(kind, number, data))
    answers = [found for part in wire.sent.split(b"~") if part and (found := unwrap(part)) and found[1] == number]
    assert len(answers) == 1, wire.sent
    return answers[0][0], answers[0][2]


def commands_of(machine: Machine, payload: bytes) -> list[tuple[int, list[int]]]:
    """(command, arguments) out of the answer to `n`."""
    found = []
    at = 5
    while at < len(payload):
        number = payload[at]
        _, actuator, procedure = machine.layout.commands[number]
        count = len(machine.robot.calls[actuator, procedure][1].parameters)
        found.append((number, list(struct.unpack_from(f"<{count}i", payload, at + 1))))
        at += 1 + 4 * count
    return found


def agreed(robot: Robot, wire: Wire, machine: Machine, script: Any) -> int:
    """Steps both through a script and compares them; how many ticks that were."""
    layout = machine.layout
    now = dict.fromkeys(range(1, 1 + layout.inputs), 0) | dict.fromkeys(layout.done.values(), 1)
    begun = list(machine.cells)
    for number, (inputs, done) in enumerate(script):
        for name, value in inputs.items():
            machine.set_input(name, value)
            now[layout.sensors[name]] = value
        for name, is_done in done.items():
            machine.set_done(name, is_done)
            now[layout.done[name]] = int(is_done)
        if number == 0:
            for cell in range(1, 1 + layout.inputs):
                now[cell] = begun[cell] if cell not in now else now[cell]
        for cell, value in now.items():
            assert ask(robot, wire, "f", struct.pack("<BBi", cell, 1, value), cell % 255 + 1)[0] == "K"
        kind, payload = ask(robot, wire, "n", b"", number % 2 + 1)
        given = machine.tick()
        expected = [(layout.command[command.actuator, command.procedure], command.arguments) for command in given]
        assert (kind, commands_of(machine, payload)) == ("C", expected), number
        tick, flags = struct.unpack_from("<IB", payload)
        assert (tick, flags) == (number + 1, machine.fault | 2 * machine.ended)
        assert robot.cells[: layout.cells] == machine.cells[: layout.cells]
        if machine.ended:
            return number
    return len(script)


def test_step_by_step_it_gives_the_commands_of_the_simulators_machine(tmp_path: Path) -> None:
    compared = ticks = 0
    for seed in range(BUDGET):
        case = random_case(random.Random(f"loop/{seed}"))
        machine = machine_for(case)
        if machine is None:
            continue
        robot, wire = robot_with(tmp_path / "program", hardwareless(machine.image, case.robot))
        ticks += agreed(robot, wire, machine, case.script)
        compared += 1
    assert compared > 0.8 * BUDGET
    assert ticks > 5 * BUDGET
