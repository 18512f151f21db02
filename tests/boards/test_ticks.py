"""A board gives, tick by tick, the very commands that the simulator's machine gives for the same inputs."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest

from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.handshake import connect
from kitrobot.image.machine import Machine
from kitrobot.image.model import Image
from kitrobot.primitives.robot import Robot
from kitrobot.robots.program import BoardProgram
from tests.boards.bench import PROGRAMS, TURNS, bench_program, bench_robot
from tests.effort import THOROUGH, cases
from tests.patience import PATIENCE_S

TICKS = 2000 if THOROUGH else 60


def compared(address: str, program: BoardProgram, robot: Robot, seed: int, ticks: int = TICKS) -> None:
    """Steps a board and a machine through the same inputs."""
    machine = Machine(Image.from_bytes(program.file.image), robot)
    layout = machine.layout
    chance = random.Random(seed)
    with connect(address, PATIENCE_S) as board:
        board.stop()
        board.arguments = list(program.names.arguments)
        held: dict[int, int] = {}
        for tick in range(ticks):
            inputs: dict[int, int] = {}
            for sensor, cell in layout.sensors.items():
                least, most = layout.ranges[sensor].minimum, layout.ranges[sensor].maximum
                machine.set_input(sensor, inputs.setdefault(cell, chance.randint(least, most)))
            for actuator, cell in layout.done.items():
                machine.set_done(actuator, bool(inputs.setdefault(cell, int(chance.random() < 0.7))))
            given = [(command.actuator, command.procedure, tuple(command.arguments)) for command in machine.tick()]
            # What a board was told to hold, it holds.
            step = board.step({cell: value for cell, value in inputs.items() if held.get(cell) != value})
            held = inputs
            found = [(*layout.commands[number][1:], arguments) for number, arguments in step.commands]
            assert found == given, f"tick {tick}"
            assert step.tick == tick + 1
            assert step.fault_flag == bool(machine.fault)
            assert step.ended == machine.ended
            if machine.ended:
                break


@pytest.mark.parametrize("text", cases([TURNS], [text for text in PROGRAMS if text != TURNS]))
def test_the_same_commands_in_every_tick(board: Any, tmp_path: Path, text: str) -> None:
    program = bench_program(tmp_path, text)
    deploy(board.address, program.file.to_bytes(), program.package)
    compared(board.address, program, bench_robot(tmp_path), seed=7)
