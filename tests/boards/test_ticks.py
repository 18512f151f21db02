"""A board gives, tick by tick, the very commands that the simulator's machine gives for the same inputs."""

from __future__ import annotations

import os
import random
from pathlib import Path
from typing import Any

import pytest

from kitrobot.deploy import connect, deploy
from kitrobot.image import Image, Machine
from kitrobot.workspace import BoardProgram, find_robot
from tests.boards.bench import PROGRAMS, bench_program

TICKS = 2000 if os.environ.get("KITROBOT_THOROUGH") else 150


def compared(address: str, program: BoardProgram, folder: Path, seed: int) -> None:
    """Steps a board and a machine through the same inputs."""
    robot = find_robot(str(folder / "bench.robot.xml"))
    machine = Machine(Image.from_bytes(program.file.image), robot)
    chance = random.Random(seed)
    with connect(address, 10) as board:
        board.stop()
        board.arguments = list(program.names.arguments)
        for tick in range(TICKS):
            captor, done = chance.randrange(101), chance.random() < 0.7
            machine.set_input("Captor", captor)
            machine.set_done("Motor", done)
            given = [(command.actuator, command.procedure, tuple(command.arguments)) for command in machine.tick()]
            step = board.step({machine.layout.sensors["Captor"]: captor, machine.layout.done["Motor"]: int(done)})
            found = [(*machine.layout.commands[number][1:], arguments) for number, arguments in step.commands]
            assert found == given, f"tick {tick}"
            assert step.tick == tick + 1
            assert step.fault_flag == bool(machine.fault)
            assert step.ended == machine.ended
            if machine.ended:
                break


@pytest.mark.parametrize("text", PROGRAMS)
def test_the_same_commands_in_every_tick(board: Any, tmp_path: Path, text: str) -> None:
    program = bench_program(tmp_path, text)
    deploy(board.address, program.file.to_bytes(), program.package)
    compared(board.address, program, tmp_path, seed=7)
