"""How large a program may be: each limit from both sides, and what it costs the machine."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.compiler.compilation import CompiledProgram, compile_lll, compile_program, compile_text
from kitrobot.image.listing import disassemble
from kitrobot.image.machine import Machine
from kitrobot.image.model import MOST_CELLS, MOST_COMMANDS, MOST_INSTRUCTIONS, MOST_SLOTS, MOST_STOPS, Image
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import Call, Seq
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from tests.compiler.graphs import graph, shipped

_SHIPPED = shipped().robots["mini-robot"]
MINI = replace(
    _SHIPPED,
    actuators=tuple(
        replace(one, methods=tuple(method for method in one.methods if not method.name.endswith("By")))
        for one in _SHIPPED.actuators
    ),
)
"""The robot of the paper, whose images have the fewest cells: without distances and degrees."""
MARKED = ("Motor.Turn(1)", "Wheel.Advance(1)", "Light.LightOn()", "Switch.SwitchOn()")


def robot(xml: str) -> Robot:
    made, problems = read_robot(f'<robot name="wide" version="1">{xml}</robot>'.encode(), "wide.robot.xml")
    assert made is not None, problems
    return made


def waits(count: int) -> str:
    return "".join(f"WAIT({n});" for n in range(1, count + 1))


def branches(count: int) -> str:
    return f"//({','.join(['WAIT(1)'] * count)});"


def marks(count: int) -> str:
    actions = [f"°{MARKED[n % 4]}°;" for n in range(count)]
    return "//(" + ",".join("".join(actions[n : n + 4]) for n in range(0, count, 4)) + ");"


def procedures(count: int) -> Robot:
    inside = "".join(f'<procedure name="Do{n}"/>' for n in range(count))
    return robot(f'<actuator name="A" device="drive">{inside}</actuator>')


def parameters(count: int) -> Robot:
    inside = "".join(f'<parameter name="p{n}" min="0" max="9" default="0"/>' for n in range(count))
    procedure = f'<procedure name="Do">{inside}</procedure><procedure name="Stop"/>'
    return robot(f'<actuator name="A" device="drive">{procedure}</actuator>')


def variables(count: int) -> Robot:
    inside = "".join(f'<variable name="V{n}" type="integer" min="0" max="9" initial="0"/>' for n in range(count))
    return robot(f'<actuator name="A" device="drive"><procedure name="Do"/></actuator>{inside}')


def only(compiled: CompiledProgram, message: str) -> None:
    assert compiled.image is None
    assert [(item.code, item.is_error) for item in compiled.diagnostics if item.is_error] == [("too-large", True)]
    (told,) = [item for item in compiled.diagnostics if item.is_error]
    assert told.message == message
    assert told.help == "split it, or use fewer of them"


def runs(compiled: CompiledProgram, on: Robot) -> Image:
    assert compiled.image is not None, compiled.diagnostics
    machine = Machine(Image.from_bytes(compiled.image.to_bytes()), on)
    for _ in range(3):
        machine.tick()
    return compiled.image


STATE = 1 + 3 + 3 + 4  # the fault flag, sensors, done flags, variables of mini-robot


def test_a_program_with_as_many_cells_as_there_are_runs() -> None:
    image = runs(compile_text(waits(MOST_CELLS - STATE), MINI), MINI)
    assert len(image.cells) == MOST_CELLS


def test_a_program_with_a_cell_too_many_is_told() -> None:
    message = "the program needs 257 cells (inputs, variables, counters and constants), and an image holds 256"
    only(compile_text(waits(MOST_CELLS - STATE + 1), MINI), message)


def test_a_program_with_as_many_slots_as_there_are_runs() -> None:
    image = runs(compile_text(branches(MOST_SLOTS - 1), MINI), MINI)
    assert len(image.slots) == MOST_SLOTS


def test_a_program_with_a_slot_too_many_is_told() -> None:
    message = "the program needs 257 slots (the program and its branches), and an image holds 256"
    only(compile_text(branches(MOST_SLOTS), MINI), message)


def test_a_program_with_as_many_stops_as_there_are_runs() -> None:
    image = runs(compile_text(marks(MOST_STOPS), MINI), MINI)
    assert len(image.stops) == MOST_STOPS


def test_a_program_with_a_stop_too_many_is_told() -> None:
    message = "the program needs 257 marked actions with a stop, and an image holds 256"
    only(compile_text(marks(MOST_STOPS + 1), MINI), message)


def test_an_action_marked_again_in_its_slot_needs_no_stop_of_its_own() -> None:
    image = runs(compile_text("//(" + "°Wheel.Advance(1)°;" * 300 + ");", MINI), MINI)
    assert len(image.stops) == 1


ADDED = parse("Count.Add(1);").program.items * (MOST_INSTRUCTIONS // 2)
"""Two instructions each, ADD and CLAMP; the END of a program is one too many."""


def test_a_program_with_as_many_instructions_as_there_are_runs() -> None:
    image = runs(compile_lll(Seq([*ADDED[1:], Call("Wheel", "Stop")]), MINI), MINI)
    assert image.instructions == MOST_INSTRUCTIONS


def test_a_program_with_an_instruction_too_many_is_told() -> None:
    only(compile_lll(Seq(ADDED), MINI), "the program needs 65537 instructions, and an image holds 65536")


def test_a_robot_with_as_many_procedures_as_there_are_can_be_programmed() -> None:
    wide = procedures(MOST_COMMANDS)
    runs(compile_text("A.Do255();", wide), wide)


def test_a_robot_with_a_procedure_too_many_is_told() -> None:
    message = "the program needs 257 procedures of the robot, and an image holds 256"
    only(compile_text("A.Do0();", procedures(MOST_COMMANDS + 1)), message)


def test_a_robot_with_as_many_parameters_as_fit_can_be_programmed() -> None:
    wide = parameters(200)
    call = f"A.Do({','.join(['1'] * 200)});"
    image = runs(compile_text(call, wide), wide)
    assert image.most_arguments == 200
    machine = Machine(image, wide)
    assert machine.tick()[0].arguments == [1] * 200


def test_a_robot_whose_procedure_has_more_parameters_than_an_image_counts_is_told() -> None:
    wide = parameters(255)
    runs(compile_text("A.Stop();", wide), wide)
    message = "the program needs 256 parameters of a procedure, and an image holds 255"
    only(compile_text("A.Stop();", parameters(256)), message)


def test_a_robot_with_more_variables_than_cells_is_told() -> None:
    wide = variables(255)
    runs(compile_text("A.Do();", wide), wide)
    message = "the program needs 257 cells (inputs, variables, counters and constants), and an image holds 256"
    only(compile_text("A.Do();", variables(256)), message)


def test_everything_that_is_too_large_is_told() -> None:
    compiled = compile_text(waits(300) + branches(300) + marks(300), MINI)
    assert [item.code for item in compiled.diagnostics if item.is_error] == ["too-large"] * 3


# ---- what is shared and what is not -------------------------------------------------------------------------

SIZES = [
    ("equal numbers share a constant", "WAIT(1); WAIT(1); Count.Set(5);", "constants", 1),
    ("loops one after another share a counter", "2*(WAIT(1);); 3*(WAIT(1););", "counters", 1),
    ("a loop in a loop has its own counter", "2*(3*(WAIT(1);););", "counters", 2),
    ("loops of two branches have their own counters", "//(2*(WAIT(1););, 2*(WAIT(1);););", "counters", 2),
    ("a loop around a parallel and one in it have their own", "2*(//(2*(WAIT(1);););)", "counters", 2),
    ("a while has no counter", "*[Run.IsTrue()](WAIT(1););", "counters", 0),
    ("a loop of no times has no counter", "0*(2*(WAIT(1);););", "counters", 0),
    ("instructions share temporaries", "[Captor.LessThan(1)](); [Captor.LessThan(2)]();", "temporaries", 1),
    ("joined tests share temporaries", "[Captor.LessThan(1) & Captor.LessThan(2)]();", "temporaries", 1),
    ("a test against nothing needs no temporary", "[Button.IsPressed() & Run.IsTrue()]();", "temporaries", 0),
    ("parameters that are computed stand in a row", "Motor.AbsoluteTurn(Captor.Value(), 3);", "temporaries", 2),
]


@pytest.mark.parametrize(("text", "size", "count"), [row[1:] for row in SIZES], ids=[row[0] for row in SIZES])
def test_cells_are_shared_where_they_can_be(text: str, size: str, count: int) -> None:
    image = runs(compile_text(text, MINI), MINI)
    assert getattr(image, size) == count


LISTINGS = [
    ("an empty program", "", ["END"]),
    ("an action", "Wheel.Stop();", ["ACT 5 0 0", "END"]),
    ("a later action looks at its flag from the next tick on", "Door.Open();", ["ACT 6 0 0", "YIELD", "JZ 5 1", "END"]),
    ("Set to a number in range needs no clamp", "Count.Set(3);", ["MOV 7 11", "END"]),
    ("Set to a value of a narrower range needs no clamp", "Count.Set(Level.Value());", ["MOV 7 8", "END"]),
    ("a sum is clamped", "Count.Add(1);", ["ADD 7 7 11", "CLAMP 7 12 13", "END"]),
    ("a test of a flag is a jump", "[Run.IsTrue()](Wheel.Stop(););", ["JZ 9 2", "ACT 5 0 0", "END"]),
    ("the test turned round", "[Run.IsFalse()](Wheel.Stop(););", ["JNZ 9 2", "ACT 5 0 0", "END"]),
    ("WAIT(0) is one tick", "WAIT(0);", ["WAIT 11", "END"]),
    ("a free back edge is a jump", "*[Run.IsTrue()](WAIT(1););", ["JZ 9 3", "WAIT 11", "JMP 0", "END"]),
    ("any other gives up the tick", "*[Run.IsTrue()]();", ["JZ 9 2", "LOOP 0", "END"]),
    ("a parallel", "//(Wheel.Stop(););", ["FORK 0", "JOIN 0", "END", "ACT 5 0 0", "END"]),
    ("a parallel of nothing is a tick", "//();", ["WAIT 11", "END"]),
    ("a mark outside a parallel does nothing", "°Wheel.Advance(1)°;", ["ACT 3 11 1", "END"]),
    ("a mark arms its stop", "//(°Wheel.Advance(1)°;);", ["FORK 0", "JOIN 0", "END", "ARM 0", "ACT 3 11 1", "END"]),
    ("a loop of no times is nothing", "0*(Wheel.Stop(););", ["END"]),
    ("a value as an instruction is nothing", "Captor.Value();", ["END"]),
]


@pytest.mark.parametrize(("text", "code"), [row[1:] for row in LISTINGS], ids=[row[0] for row in LISTINGS])
def test_a_construct_becomes_this_code(text: str, code: list[str]) -> None:
    image = runs(compile_text(text, MINI), MINI)
    listing = disassemble(image).split(".code\n")[1].splitlines()
    assert [" ".join(line.partition(";")[0].split()) for line in listing] == code


def test_the_debug_map_leads_each_instruction_to_its_text() -> None:
    text = "2*(Wheel.Stop();); [Captor.LessThan(5)](WAIT(1););"
    compiled = compile_text(text, MINI)
    assert compiled.image is not None
    assert len(compiled.debug.origins) == compiled.image.instructions
    shown = [text[origin.start : origin.end] for origin in compiled.debug.origins]
    assert shown[0] == "2*(Wheel.Stop();)"
    assert "Wheel.Stop()" in shown
    assert "WAIT(1)" in shown
    assert {compiled.debug.vertex(n) for n in range(-1, 99)} == {None}
    assert {origin.program for origin in compiled.debug.origins} == {""}


def test_the_debug_map_names_the_program_and_the_vertex_of_each_instruction() -> None:
    program = graph("start > v:Wheel.Stop > w:Wheel.Stop > stop")
    compiled = compile_program(program, shipped())
    assert compiled.image is not None
    made_by = [(origin.program, origin.vertex) for origin in compiled.debug.origins]
    assert list(dict.fromkeys(made_by)) == [("p", "v"), ("p", "w")]
    assert len(made_by) == compiled.image.instructions
