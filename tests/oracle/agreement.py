"""Compares the oracle with the real machine on a program: the heart of the property tests and of the volume runs."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from kitrobot.compiler.compilation import compile_lll
from kitrobot.image.machine import Machine
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Seq
from kitrobot.primitives.robot import Robot
from tests.oracle.interpreter import Oracle, Outcome
from tests.strategies import Shape, TickInputs, random_program, random_robot, random_script, shipped_robots, shrink

TOO_LARGE = "too-large"


class Case(NamedTuple):
    """A program, the robot it is for, and what happens around it."""

    program: Seq
    robot: Robot
    script: list[TickInputs]


@dataclass(frozen=True)
class Disagreement:
    """The first tick in which the two differ."""

    tick: int
    oracle: Outcome
    machine: Outcome

    def __str__(self) -> str:
        differ = [
            f"  {name}: oracle {left}, machine {right}"
            for name, left, right in zip(Outcome._fields, self.oracle, self.machine, strict=True)
            if left != right
        ]
        return "\n".join([f"tick {self.tick}:", *differ])


def random_case(rng: random.Random) -> Case:
    """A random program for a shipped robot (mostly the paper's) or a random one, with inputs for 30 to 200 ticks."""
    shipped = shipped_robots()
    draw = rng.random()
    if draw < 0.4:
        robot = shipped["mini-robot"]
    elif draw < 0.6:
        robot = shipped[rng.choice(sorted(shipped))]
    else:
        robot = random_robot(rng)
    shape = Shape(rng.choice((4, 8, 15, 25, 40, 40, 100)), rng.choice((3, 5, 8, 12)))
    return Case(random_program(rng, robot, shape), robot, random_script(rng, robot, rng.choice((30, 30, 60, 100, 200))))


def small_case(rng: random.Random) -> Case:
    """A small program for the paper's robot: what Hypothesis can draw fast and make smaller."""
    robot = shipped_robots()["mini-robot"]
    return Case(random_program(rng, robot, Shape(8, 4)), robot, random_script(rng, robot, 30))


def machine_for(case: Case) -> Machine | None:
    """The real machine with the compiled program, or None for a program that is refused for its size."""
    compiled = compile_lll(case.program, case.robot)
    if compiled.image is None:
        errors = [item for item in compiled.diagnostics if item.is_error]
        assert errors, "no image, and no error that says why"
        assert all(item.code == TOO_LARGE for item in errors), [(item.code, item.message) for item in errors]
        return None
    return Machine(compiled.image, case.robot)


def disagreement(case: Case) -> Disagreement | None:
    """The first difference between oracle and machine, or None."""
    machine = machine_for(case)
    return None if machine is None else first_difference(machine, case)


def first_difference(machine: Machine, case: Case) -> Disagreement | None:
    """Runs both side by side."""
    oracle = Oracle(case.program, case.robot)
    for tick, (inputs, done) in enumerate(case.script):
        expected = oracle.tick(inputs, done)
        for sensor, value in inputs.items():
            machine.set_input(sensor, value)
        for actuator, is_done in done.items():
            machine.set_done(actuator, is_done)
        commands = [(f"{command.actuator}.{command.procedure}", command.arguments) for command in machine.tick()]
        found = Outcome(commands, machine.variables(), machine.fault, machine.ended)
        if found != expected:
            return Disagreement(tick, expected, found)
    return None


def report(case: Case) -> str:
    """A small program that shows the disagreement of a larger one, with all that is needed to see it."""

    def disagrees(program: Seq) -> bool:
        try:
            return disagreement(case._replace(program=program)) is not None
        except AssertionError:
            return False

    program = shrink(case.program, disagrees)
    found = disagreement(case._replace(program=program))
    assert found is not None
    lines = [print_program(program), f"robot {case.robot.name}", str(found), "inputs:"]
    return "\n".join(lines + relevant(case.script[: found.tick + 1]))


def relevant(script: Sequence[TickInputs]) -> list[str]:
    """The ticks of a script in which something changes."""
    return [f"  {tick}: {inputs} {done}" for tick, (inputs, done) in enumerate(script) if inputs or done]
