"""What is tried of a robot: its steps, the program that waits for them, and the notes that say what is to be seen."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from kitrobot.boards.bench import NoPartsError, bench_of, program_text
from kitrobot.boards.bench_loader import reason_of
from kitrobot.boards.bench_notes import notes_for, read_bench, shipped_notes
from kitrobot.boards.calibration import bench_robot
from kitrobot.compiler.compilation import compile_text
from kitrobot.image.machine import Machine
from kitrobot.primitives.automatic import number_variable
from kitrobot.primitives.catalogue import SHIPPED, load_catalogue
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.kit_xml import read_kit
from kitrobot.primitives.robot import Category
from kitrobot.text.sentences import Sentence
from kitrobot.translation.languages import TEXT_LANGUAGES

ROBOTS = load_catalogue().robots
KITS = sorted(SHIPPED.glob("*.board.xml"))


def kit_of(path: Path) -> Kit:
    kit, found = read_kit(path.read_bytes(), str(path))
    assert kit is not None, found
    return kit


@pytest.mark.parametrize("path", KITS, ids=lambda path: path.name.split(".")[0])
def test_all_that_a_kit_has_can_be_tried_and_each_part_says_what_is_to_be_seen(path: Path) -> None:
    kit = kit_of(path)
    for robot in (bench_robot(), *ROBOTS.values()):
        try:
            bench = bench_of(robot, kit)
        except NoPartsError:
            continue
        keys = {step.key for step in bench.steps}
        assert len(keys) + len(bench.left_out) == len(robot.actuators) + len(robot.sensors)
        assert all(step.seen.get("") for step in bench.steps), [step.part.name for step in bench.steps]
        there = bench.together(list(keys))
        assert bench.program(there).names.variables[bench.variable]
        for key in keys - set(there):
            assert key in bench.together(list(keys), key)


def test_a_step_calls_its_part_until_the_variable_says_another_one_and_then_ends_it() -> None:
    robot = ROBOTS["mini-robot"]
    bench = bench_of(robot, None)
    steps = {step.call: step for step in bench.steps if step.call}
    go, lamp = next(step for call, step in steps.items() if "Advance" in call), steps["Light.LightOn()"]
    with_variable = replace(robot, variables=(*robot.variables, number_variable(bench.variable, len(steps))))
    compiled = compile_text(program_text(bench.variable, bench.steps), with_variable)
    assert compiled.image is not None, compiled.diagnostics
    machine = Machine(compiled.image, with_variable)
    cell = machine.layout.variables[bench.variable]

    def told(value: int, ticks: int = 3) -> list[tuple[str, str]]:
        machine.cells[cell] = value
        return [(one.actuator, one.procedure) for _ in range(ticks) for one in machine.tick()]

    assert told(0) == []
    assert told(go.number) == [(go.part.name, "Advance")]
    assert told(lamp.number) == [(go.part.name, "Stop"), (lamp.part.name, "LightOn")]
    assert told(0) == [(lamp.part.name, "LightOff")]
    assert told(0, 20) == []


def test_a_part_of_a_device_that_no_note_names_is_tried_with_all_that_it_can_do_in_its_own_words() -> None:
    part = replace(next(part for part in ROBOTS["mini-robot"].actuators if part.name == "Door"), device="hatch")
    notes = notes_for(part)
    assert [note.procedure for note in notes] == ["Open", "Close"]
    assert all(note.seen[""] and not note.trouble for note in notes)


def test_a_name_that_the_robot_has_is_not_taken_for_the_variable_and_a_robot_of_nothing_is_refused() -> None:
    robot = ROBOTS["mini-robot"]
    crowded = replace(robot, variables=(*robot.variables, number_variable("Bench", 3)))
    assert bench_of(crowded, None).variable == "Bench_"
    with pytest.raises(NoPartsError):
        bench_of(replace(robot, actuators=(), sensors=()), None)


def test_every_note_is_said_in_each_language_and_what_is_measured_is_named_once() -> None:
    notes = shipped_notes()
    assert all(set(note.seen) == set(note.trouble) == set(TEXT_LANGUAGES) for note in notes)
    measures = [note.measures for note in notes if note.measures]
    assert sorted(measures) == sorted(set(measures)) == ["distance", "left", "right", "turn"]
    assert {note.category for note in notes} == {Category.ACTUATOR, Category.SENSOR}


@pytest.mark.parametrize(
    "text",
    [
        '<bench version="1"><actuator device="drive"/></bench>',
        '<bench version="1"><actuator device="drive" call="Advance"/></bench>',
        '<bench version="1"><actuator device="drive" call="Advance(50); Wheel.Stop()"/></bench>',
        '<bench version="1"><sensor/></bench>',
        '<bench version="1"><measure device="drive" call="Advance(50)" of="weight"/></bench>',
        '<bench version="1"><measure device="drive" call="Advance(50)" of="turn" lasts="101"/></bench>',
        '<bench version="2"/>',
        '<bench version="1"',
        "<!DOCTYPE bench []><bench/>",
    ],
)
def test_a_list_with_a_mistake_is_told_and_not_used(text: str) -> None:
    made, problems = read_bench(text.encode(), "bench.xml")
    assert made is None
    assert problems


@pytest.mark.parametrize(
    ("said", "reason"),
    [
        ("s2 OSError('no answer: not plugged in?',)", "it does not answer, and may be not plugged in"),
        ("s3 tcs34725 OSError(19,)", "it does not answer, and may be not plugged in"),
        ("a0 [Errno 5] EIO", "it does not answer, and may be not plugged in"),
        ("s3 OSError(28,)", "a driver failed (OSError(28,))"),
        ("a1 ValueError('pin')", "a driver failed (ValueError('pin'))"),
        ("s2", "a driver failed"),
        ("", "a driver failed"),
        ("no device at all", "a driver failed (no device at all)"),
    ],
)
def test_a_part_that_does_not_answer_is_told_in_plain_words(said: str, reason: str) -> None:
    assert reason_of(said, Sentence("a driver failed")) == reason
