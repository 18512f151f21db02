"""Step by step, with all inputs held, a board's loop gives exactly the commands of the simulator's machine."""

from __future__ import annotations

import os
import random
import struct
from collections.abc import Callable, Sequence
from pathlib import Path

from kitrobot.image.machine import Machine
from kitrobot_onboard.state import CELLS
from tests.boards.program_files import hardwareless
from tests.onboard.bench import Bench
from tests.oracle.agreement import machine_for, random_case
from tests.strategies import TickInputs

BUDGET = int(os.environ.get("KITROBOT_BUDGET", "20"))


def commands_of(machine: Machine, payload: bytes) -> list[tuple[int, list[int]]]:
    """(command, arguments) out of the answer to `n`."""
    found = []
    at = 5
    while at < len(payload):
        _, actuator, procedure = machine.layout.commands[payload[at]]
        count = len(machine.robot.calls[actuator, procedure][1].parameters)
        found.append((payload[at], list(struct.unpack_from(f"<{count}i", payload, at + 1))))
        at += 1 + 4 * count
    return found


Ask = Callable[[str, bytes], tuple[str, bytes]]


def agreed(ask: Ask, machine: Machine, script: Sequence[TickInputs]) -> int:
    """Steps a board and a machine through a script and compares what they do; how many ticks that were."""
    layout = machine.layout
    held = {cell: machine.cells[cell] for cell in range(1, 1 + layout.inputs)}
    for cell, value in held.items():
        assert ask("f", struct.pack("<BBi", cell, 1, value)) == ("K", b"")
    for number, (inputs, done) in enumerate(script):
        changed = b""
        for name, value in inputs.items():
            machine.set_input(name, value)
            changed += struct.pack("<Bi", layout.sensors[name], value)
        for name, is_done in done.items():
            machine.set_done(name, is_done)
            changed += struct.pack("<Bi", layout.done[name], is_done)
        kind, payload = ask("n", changed)
        expected = [
            (layout.command[command.actuator, command.procedure], command.arguments) for command in machine.tick()
        ]
        assert (kind, commands_of(machine, payload)) == ("C", expected), number
        assert struct.unpack_from("<IB", payload) == (number + 1, machine.fault | 2 * machine.ended)
        if machine.ended:
            return number + 1
    return len(script)


def test_step_by_step_it_gives_the_commands_of_the_simulators_machine(tmp_path: Path) -> None:
    compared = ticks = 0
    for seed in range(BUDGET):
        case = random_case(random.Random(f"loop/{seed}"))
        machine = machine_for(case)
        if machine is None:
            continue
        with Bench(tmp_path, hardwareless(machine.image, case.robot)) as bench:
            bench.ask("x")
            ticks += agreed(bench.ask, machine, case.script)
            assert list(bench.robot[CELLS][: machine.layout.cells]) == machine.cells[: machine.layout.cells]
        compared += 1
    assert compared > 0.8 * BUDGET
    assert ticks > 5 * BUDGET
