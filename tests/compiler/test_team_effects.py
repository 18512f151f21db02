"""Lines that a substitute would do twice: where they are told, and where not."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import kitrobot
from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.compiler.team_compilation import compile_team
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.image.debug import DebugMap
from kitrobot.lll.parse_results import parse_team
from kitrobot.primitives.automatic import number_variable
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.crew import Crew, CrewProgram, declaring
from kitrobot.primitives.own_xml import OwnVariable
from kitrobot.sim.setup.settings import moves_boxes
from tests.lll.expectations import meets_expectations

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
AGENTS = tuple((f"loader-{n}", "loader") for n in (1, 2, 3))
PROGRAMS = (CrewProgram("count", "loader"),)
OWN = [OwnVariable("loader", number_variable("Own", 9))]
DECLARED = """\
role one: loader;
role other: loader;
group crew = {one, other} on failure substitute;
work Boxes = 12 lease 60;
"""


def found_in(text: str, declared: str = DECLARED, programs: dict[str, str] | None = None) -> list[Diagnostic]:
    """What is said about the program `team`, when every robot of it is a loader."""
    crew = declaring(Crew(AGENTS, PROGRAMS), parse_team(declared).program)
    catalogue = load_catalogue().extended([], OWN, crew)
    compiled = {}
    for name, one in {"team": text, **(programs or {})}.items():
        parsed = parse_team(one)
        assert parsed.ok, parsed.diagnostics
        compiled[name] = CompiledProgram(parsed.program.seq, parsed.source, None, DebugMap())
    made = compile_team("team", compiled, catalogue, ["loader"], moves_boxes)
    assert not any(item.is_error for item in made.diagnostics), made.diagnostics
    return made.diagnostics


def told(text: str, declared: str = DECLARED) -> None:
    """Compares what is said about a program with what its comments expect."""
    meets_expectations(text, found_in(text, declared))


TWICE = [
    "ParOfSeq one ( Loaded.Add(1); );  #! team-done-twice@16 `Loaded.Add` may be done twice: a substitute for `one`",
    "ParOfSeq one ( Loaded.Sub(2); WAIT(1); );  #! team-done-twice",
    "ParOfSeq crew ( Loaded.Add(1); );  #! team-done-twice@17 a substitute for `one`, `other` begins",
    "ParOfSeq one ( Counted.Set(Counted.IsFalse()); );  #! team-done-twice",
    "ParOfSeq one ( Arm.Load(); );  #! team-done-twice@16 `Arm.Load`",
    "ParOfSeq one ( //( °Arm.Load()°;, WAIT(50); ); );  #! team-done-twice",
    "SeqOfPar one ( WAIT(1); Loaded.Add(1); );  #! team-done-twice",
    "SeqOfPar crew ( ParOfSeq one ( Loaded.Add(1); ); );  #! team-done-twice",
    "3*( ParOfSeq one ( WAIT(1); Loaded.Add(1); ); );  #! team-done-twice",
    "*[any crew (Run.IsTrue())]( ParOfSeq one ( Loaded.Add(1); ); );  #! team-done-twice",
    # Passes that are counted begin at the first one again.
    "ParOfSeq one ( 3*( WAIT(1); Loaded.Add(1); ); );  #! team-done-twice",
    "ParOfSeq one ( 3*( <Presence.IsPressed()>(); Arm.Load(); ); );  #! team-done-twice",
    "ParOfSeq one ( *[Own.LessThan(3)]( Own.Add(1); Loaded.Add(1); ); );  #! team-done-twice",
    # A sensor does not say whether it was counted, nor does another variable.
    "ParOfSeq one ( <Presence.IsPressed()>( Loaded.Add(1); ); );  #! team-done-twice",
    "ParOfSeq one ( [Run.IsTrue()]( Loaded.Add(1); ); );  #! team-done-twice",
    "ParOfSeq one ( Loaded.Add(1); [Loaded.LessThan(9)]( WAIT(1); ); );  #! team-done-twice",
    # In the midst of a pass.
    "ParOfSeq one ( *[Run.IsTrue()]( Loaded.Add(1); WAIT(9); ); );  #! team-done-twice",
    # The answer of a team is told again.
    "SeqOfPar one ( [Counted.IsFalse()]( Loaded.Add(1); Counted.Set(1); ); );  #! team-done-twice",
    "SeqOfPar one ( *[Run.IsTrue()]( Loaded.Add(1); ); );  #! team-done-twice",
    # Outside of a unit.
    "ParOfSeq one ( Boxes.Take(); Boxes.Done(); Loaded.Add(1); );  #! team-done-twice",
    "ParOfSeq one ( Boxes.Take(); [!(Boxes.IsEmpty())]( WAIT(1); Boxes.Done(); ); Arm.Load(); );  #! team-done-twice",
    "ParOfSeq one ( [Run.IsTrue()]( Boxes.Take(); ); Arm.Load(); );  #! team-done-twice",
]


@pytest.mark.parametrize("text", TWICE)
def test_what_a_substitute_would_do_twice_is_told_where_it_stands(text: str) -> None:
    told(text)


ONCE = [
    # To set is to set; what is the robot's own begins anew, and so does its body.
    "ParOfSeq one ( Order.Set(5); Counted.Set(1); Loaded.Set(Order.Value()); Loaded.Add(0); );",
    "ParOfSeq one ( Own.Add(1); Own.Sub(1); );",
    "WAIT(5); SeqOfPar one ( WAIT(1); );",
    # A unit of work.
    "ParOfSeq one ( Boxes.Take(); Arm.Load(); Loaded.Add(1); Boxes.Done(); );",
    "SeqOfPar crew ( Boxes.Take(); Arm.Load(); Loaded.Add(1); Boxes.Done(); );",
    "ParOfSeq one ( *[!(Boxes.IsEmpty())]( Boxes.Take(); [!(Boxes.IsEmpty())]( Arm.Load(); Boxes.Done(); ); ); );",
    # What is asked first, and changed along with it.
    "ParOfSeq one ( [Counted.IsFalse()]( Loaded.Add(1); Counted.Set(1); ); );",
    "ParOfSeq one ( <Counted.IsFalse()>(); Loaded.Add(1); Counted.Set(1); );",
    "ParOfSeq one ( *[Loaded.LessThan(5)]( Loaded.Add(1); WAIT(1); ); );",
    "ParOfSeq one ( 5*( [Loaded.LessThan(5)]( Arm.Load(); Loaded.Add(1); ); ); );",
    "SeqOfPar one ( [Presence.IsPressed() & Counted.IsFalse()]( Loaded.Add(1); Counted.Set(1); ); );",
    "Where one [Counted.IsFalse()]( Loaded.Add(1); Counted.Set(1); );",
    # A box after a look.
    "ParOfSeq one ( <Presence.IsPressed()>(); Arm.Load(); );",
    "ParOfSeq one ( [Presence.IsPressed() & StockA.GreaterThan(0)]( Arm.Load(); ); );",
    "ParOfSeq one ( *[Run.IsTrue()]( [Presence.IsPressed()]( Arm.Load(); WAIT(3); ); ); );",
    "SeqOfPar one ( <Presence.IsPressed()>( Arm.Load(); ); );",
    # The end of a pass of a loop that goes by what stays.
    "ParOfSeq one ( *[Run.IsTrue()]( <Presence.IsPressed()>(); WAIT(9); Loaded.Add(1); ); );",
    "ParOfSeq one ( *( WAIT(9); [Presence.IsPressed()]( Loaded.Add(1); Own.Set(2); )!( Loaded.Sub(1); ); ); );",
    "SeqOfPar one ( *[Presence.IsReleased()]( WAIT(9); Loaded.Add(1); ); );",
]


@pytest.mark.parametrize("text", ONCE)
def test_nothing_is_said_where_doing_the_block_again_does_no_harm(text: str) -> None:
    told(text)


GROUPS = [
    ("group crew = {one, other};", False),
    ("group crew = {one, other} on failure drop;", False),
    ("group crew = {one, other} on failure abort;", False),
    ("group crew = {one, other} on failure substitute;", True),
    ("group crew = other on failure substitute;", False),
    ("group crew = one on failure substitute; group all = {crew, other} on failure abort;", False),
    ("group crew = one; group all = {crew, other} on failure substitute;", True),
    ("", False),
]


@pytest.mark.parametrize(("group", "is_told"), GROUPS)
def test_it_is_told_of_those_in_whose_place_a_substitute_comes(group: str, is_told: bool) -> None:
    declared = f"role one: loader; role other: loader; {group}"
    assert [item.code for item in found_in("ParOfSeq one ( Loaded.Add(1); );", declared)] == [
        "team-done-twice"
    ] * is_told


def test_who_moves_into_a_group_with_substitutes_is_replaced_too() -> None:
    declared = "role one: loader 2; role other: loader; group few = one; group crew = other on failure substitute;"
    assert found_in("ParOfSeq one ( Loaded.Add(1); );", declared) == []
    moving = found_in("MOVE 1 few -> crew; ParOfSeq one ( Loaded.Add(1); );", declared)
    assert [item.code for item in moving] == ["team-group-empty", "team-done-twice"]


def test_a_line_of_a_robot_s_program_is_told_once_and_there() -> None:
    program = "WAIT(1);\nLoaded.Add(1);"
    text = "ParOfSeq one ( PROGRAM count; ); 2*( ParOfSeq other ( PROGRAM count; ); );"
    (found,) = found_in(text, programs={"count": program})
    assert (found.program, found.place and found.place.line) == ("count", 2)
    assert not found.is_error
    assert found.help


def test_without_parts_that_move_boxes_only_variables_count() -> None:
    arm = next(part for part in load_catalogue().robots["loader"].actuators if part.name == "Arm")
    assert moves_boxes(arm)
    assert not moves_boxes(replace(arm, model="lamp"))
    assert not moves_boxes(replace(arm, model="of a board alone"))


@pytest.mark.parametrize("path", sorted(EXAMPLES.rglob("*.krt")), ids=lambda path: path.stem)
def test_no_example_has_a_line_that_a_substitute_would_do_twice(path: Path) -> None:
    opened = kitrobot.open(path)
    if not any(program.level.is_team for program in opened.mission.programs):
        return
    assert [item for item in opened.before_setup if item.code == "team-done-twice"] == []
