"""A current MicroPython runs programs as CPython does: same images, same inputs, same arrays after each tick."""

from __future__ import annotations

import os
import random
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import kitrobot
from kitrobot.compiler.compilation import compile_text
from kitrobot.image.machine import Machine
from kitrobot.image.model import LARGEST_VALUE
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot_xml import read_robot
from tests.boards.traces import Case, disagreements, on_cpython, on_micropython, rested, seeded
from tests.effort import THOROUGH, examples
from tests.oracle.agreement import machine_for, random_case, small_case
from tests.programs.test_programs import head
from tests.strategies import random_script

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("**/*.krt"))
RUNS = sorted((ROOT / "tests" / "programs" / "runs").glob("*.lll"))
BUDGET = int(os.environ.get("KITROBOT_BUDGET", "40"))
TICKS = 100 if THOROUGH else 40


def watched(machine: Machine, watch: bool) -> Machine:
    machine.seen = [0] * machine.image.instructions if watch else []
    return machine


def test_programs_of_the_examples() -> None:
    cases = []
    for path in EXAMPLES:
        opened = kitrobot.open(path)
        for program in opened.mission.programs:
            compiled = opened.compiled[program.name]
            if compiled.image is not None:
                robot = opened.catalogue.robots[program.target]
                name = f"{path.name} {program.name}"
                script = random_script(seeded(name), robot, TICKS)
                cases.append(Case(name, Machine(compiled.image, robot, watch=True), script))
    assert len(cases) > 20
    assert disagreements(cases) == []


def test_programs_of_the_tests() -> None:
    cases = []
    for path in RUNS:
        text = path.read_text(encoding="utf-8")
        robot = load_catalogue().robots[head(text, "robot")]
        image = compile_text(text, robot).image
        assert image is not None
        cases.append(Case(path.stem, Machine(image, robot), random_script(seeded(path.stem), robot, TICKS)))
    assert len(cases) == len(RUNS) > 3
    assert disagreements(cases) == []


def test_random_programs() -> None:
    cases = []
    for seed in range(BUDGET):
        case = random_case(random.Random(f"modern/{seed}"))
        machine = machine_for(case)
        if machine is not None:
            cases.append(Case(f"modern/{seed}", watched(machine, seed % 2 == 0), case.script))
    assert len(cases) > 0.8 * BUDGET
    assert disagreements(cases) == []


@settings(max_examples=examples(2, 8), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(rng=st.randoms(use_true_random=False))
def test_small_programs_that_hypothesis_finds(rng: random.Random) -> None:
    case = small_case(rng)
    machine = machine_for(case)
    if machine is not None:
        assert disagreements([Case("found", watched(machine, True), case.script)]) == []


def test_a_difference_would_be_found() -> None:
    robot = load_catalogue().robots["mini-robot"]
    image = compile_text("3*( Light.LightOn(); WAIT(1); Light.LightOff(); WAIT(1); );", robot).image
    assert image is not None
    inputs, trace = on_cpython(Case("blink", Machine(image, robot), rested(20)))
    assert on_micropython([(Machine(image, robot), inputs)]) == trace
    slower = replace(image, cells=tuple(value + (value == 5) for value in image.cells))
    assert slower != image
    assert on_micropython([(Machine(slower, robot), inputs)]) != trace


@pytest.mark.parametrize("sign", [1, -1])
def test_the_largest_numbers_are_no_different(sign: int) -> None:
    most = sign * LARGEST_VALUE
    xml = f"""<robot name="large" version="1">
      <help>Counts far.</help>
      <actuator name="Out" device="switch">
        <help>Takes a number.</help>
        <procedure name="Give">
          <help>Takes it.</help>
          <parameter name="x" min="{min(most, 0)}" max="{max(most, 0)}"><help>It.</help></parameter>
        </procedure>
      </actuator>
      <variable name="Big" min="{min(most, 0)}" max="{max(most, 0)}" initial="{most}"><help>It.</help></variable>
      <variable name="Step" min="{min(most, 0)}" max="{max(most, 0)}" initial="{most}"><help>It.</help></variable>
    </robot>"""
    robot, problems = read_robot(xml.encode(), "large.robot.xml")
    assert problems == []
    assert robot is not None
    text = "9*( Big.Add(Step.Value()); Out.Give(Big.Value()); Big.Sub(Step.Value()); Out.Give(Big.Value()); );"
    compiled = compile_text(text, robot)
    assert compiled.image is not None, compiled.diagnostics
    assert disagreements([Case("large", Machine(compiled.image, robot), rested(6))]) == []
