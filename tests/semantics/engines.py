"""The two that must agree on the meaning of a program, behind one face: the oracle and the real machine."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from kitrobot.compiler.compilation import compile_lll
from kitrobot.image.machine import Machine
from kitrobot.lll.tree import Seq
from kitrobot.primitives.robot import Robot
from tests.oracle import Oracle, Outcome


class Engine(Protocol):
    """Something that reacts in ticks."""

    def tick(self, inputs: Mapping[str, int] | None = None, done: Mapping[str, bool] | None = None) -> Outcome: ...


class CompiledMachine:
    """A program that went through compiler, image (as bytes) and the onboard interpreter."""

    def __init__(self, program: Seq, robot: Robot) -> None:
        compiled = compile_lll(program, robot)
        assert compiled.image is not None, [item.message for item in compiled.diagnostics]
        self.machine = Machine(type(compiled.image).from_bytes(compiled.image.to_bytes()), robot)

    def tick(self, inputs: Mapping[str, int] | None = None, done: Mapping[str, bool] | None = None) -> Outcome:
        for sensor, value in (inputs or {}).items():
            self.machine.set_input(sensor, value)
        for actuator, is_done in (done or {}).items():
            self.machine.set_done(actuator, is_done)
        commands = [(f"{command.actuator}.{command.procedure}", command.arguments) for command in self.machine.tick()]
        return Outcome(commands, self.machine.variables(), self.machine.fault, self.machine.ended)


def start(engine: str, program: Seq, robot: Robot) -> Engine:
    """An engine by name, ready for its first tick."""
    return Oracle(program, robot) if engine == "oracle" else CompiledMachine(program, robot)
