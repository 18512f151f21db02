"""What is said about a team's program in which those who are to meet cannot come."""

from __future__ import annotations

import sys
from collections.abc import Iterator

import pytest

from kitrobot.compiler.program.team_check import check_program, program_circles
from kitrobot.compiler.team.names import check_declarations
from kitrobot.lll.parse_results import parse_team
from kitrobot.lll.printer import print_team_program
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.crew import Crew, CrewProgram
from kitrobot.primitives.levels import Level
from tests.compiler.crews import crew_declaring
from tests.lll.expectations import meets_expectations

PARTS = load_catalogue()
ROBOTS = PARTS.robots
CREW = Crew(
    (*((f"carrier-{n}", "carrier") for n in (1, 2, 3)), ("loader", "loader"), ("somebody", "")),
    (
        CrewProgram("drive", "carrier"),
        CrewProgram("load", "loader"),
        CrewProgram("haul", "", Level.GROUP),
        CrewProgram("day", "", Level.SOCIAL),
    ),
)
DECLARED = """\
role carriers: carrier 2..3;
role loaders: loader;
group movers = carriers;
group all = {movers, loaders, loader};
work Boxes = 12;
"""


def told(text: str, level: Level = Level.SOCIAL) -> None:
    """Compares what is said about a program with what its comments expect."""
    crew = crew_declaring(CREW, DECLARED)
    parts = PARTS.extended([], [], crew)
    parsed = parse_team(text)
    assert parsed.diagnostics == []
    meets_expectations(text, check_program(parsed.program.seq, parts.teams[level], crew, parsed.source))


RIGHT = """\
SeqOfPar all (
  ParOfSeq carriers ( PROGRAM drive; );
  SeqOfPar {carrier-1, movers} ( Wheel.Stop(); );
  PROGRAM haul;
);
*[!(Boxes.IsEmpty()) & any carriers (Collision.IsPressed())](
  SeqOfPar carriers ( Boxes.Take(); WAIT(1); Boxes.Done(); );
  [Collision.IsPressed()]( WAIT(1); );
);
ParOfSeq carriers (
  *[Collision.IsPressed()]( WAIT(1); );
);
//( SeqOfPar carriers ( WAIT(1); );, SeqOfPar loaders ( WAIT(1); ); );
Where all [Boxes.Left.IsEmpty()]( WAIT(1); )!( WAIT(2); );
MOVE 1 movers -> loaders;
""".replace("Boxes.Left.IsEmpty()", "Boxes.IsEmpty()")


def test_a_program_in_which_all_can_meet_is_said_nothing_about() -> None:
    told(RIGHT)


WRONG = [
    "SeqOfPar cariers ();  #! team-unknown-member@10 the team has no role, no group and no agent `cariers`",
    "ParOfSeq {carriers, Boxes} ();  #! team-unknown-member@10 `Boxes` is work",
    "[any nobody (Collision.IsPressed())]();  #! team-unknown-member",
    "PROGRAM dive;  #! team-unknown-program@1 there is no program `dive`",
    "SeqOfPar loaders ( PROGRAM drive; );  #! team-program-kind@20 and `loaders` are others",
    "SeqOfPar {carrier-1, loader} ( PROGRAM load; );  #! team-program-kind",
    "MOVE 1 carrier-1 -> loaders;  #! team-unknown-member `carrier-1` is an agent",
    "MOVE 1 carriers -> crowd;  #! team-unknown-member",
    "*[Collision.IsPressed()]( SeqOfPar carriers ( WAIT(1); ); );  #! team-bare-test@3 can be true for one member",
    "[all carriers (Collision.IsPressed()) | Collision.IsPressed()]( PROGRAM haul; );  #! team-bare-test@41",
    "<!(Collision.IsPressed())>( MOVE 1 movers -> loaders; );  #! team-bare-test@4",
    "SeqOfPar carriers ( SeqOfPar loaders ( WAIT(1); ); );  #! team-not-within@30 `loaders` are not among those",
    "SeqOfPar carriers ( [all all (Collision.IsPressed())]( WAIT(1); ); );  #! team-not-within",
    "SeqOfPar carrier-1 ( SeqOfPar carriers (); );  #! team-not-within",
    "SeqOfPar carriers ( SeqOfPar somebody (); );",
    "Where carriers [Collision.IsPressed()]( SeqOfPar carriers (); );  #! team-not-within@41 a block stands on a side",
    "//( SeqOfPar movers ();, ParOfSeq {carriers} (); );  #! team-two-places@35 `carriers` are in another branch",
    "//( SeqOfPar movers (); SeqOfPar carriers ();, WAIT(1); );",
]


@pytest.mark.parametrize("text", WRONG)
def test_what_is_wrong_is_said_where_it_stands(text: str) -> None:
    told(text)


def test_a_group_s_program_does_not_name_a_wider_one() -> None:
    told("PROGRAM day;")
    told("PROGRAM day;  #! team-unknown-program", Level.GROUP)


DECLARATIONS = [
    (DECLARED, []),
    ("role a: carier;", ["team-role-unplayed"]),
    ("role a: carrier 4;", []),
    ("role a: carrier 5;", ["team-role-unplayed"]),
    ("role a: store-manager 2;", ["team-role-unplayed"]),
    ("role a: carrier; group a = a;", ["team-same-name", "team-group-circle"]),
    ("work a = 1; group a = loader on failure abort;", ["team-same-name"]),
    ("group a = {b, loader}; group b = a;", ["team-group-circle", "team-group-circle"]),
    ("group a = {b, loader};", ["team-unknown-member"]),
    ("role r: carrier 0..3; group a = r;", ["team-group-empty"]),
    ("work w = 1; group a = {w};", ["team-unknown-member"]),
    ("role r: carrier 1..1; group a = r;", ["team-group-empty"]),
    ("role r: carrier 1..1; group a = r on failure substitute;", []),
    ("role r: carrier 1..1; group a = r on failure abort;", []),
    ("role r: carrier 1..2; group a = r;", []),
    ("role r: carrier 1..1; role s: carrier 3; group a = r on failure substitute;", ["team-group-empty"]),
    ("role r: carrier 1..1; group a = r; group b = {a, loader} on failure abort;", []),
    ("role r: carrier 1..1; group a = {r, loader};", []),
]


@pytest.mark.parametrize(("text", "codes"), DECLARATIONS, ids=[row[0] for row in DECLARATIONS])
def test_what_is_wrong_with_a_declaration_is_said(text: str, codes: list[str]) -> None:
    found = check_declarations(crew_declaring(CREW, text), ROBOTS, lambda _: None)
    assert [item.code for item in found] == codes
    assert all(item.help for item in found)


@pytest.fixture
def few_calls() -> Iterator[int]:
    """How many calls may stand in one another: few, so that little text is deeper."""
    usual = sys.getrecursionlimit()
    sys.setrecursionlimit(300)
    yield 300
    sys.setrecursionlimit(usual)


def test_groups_may_hold_each_other_deeper_than_calls_may(few_calls: int) -> None:
    rows = [f"group g{n} = g{n + 1};" for n in range(few_calls)]
    crew = crew_declaring(CREW, "\n".join([*rows, f"group g{few_calls} = loader on failure abort;"]))
    assert check_declarations(crew, ROBOTS, lambda _: None) == []


def test_a_program_in_its_own_place_is_told_with_the_way_to_it() -> None:
    programs = {
        "a": parse_team("PROGRAM drive; PROGRAM b;").program.seq,
        "b": parse_team("*( PROGRAM c; )").program.seq,
        "c": parse_team("PROGRAM b; PROGRAM e;").program.seq,
        "e": parse_team("PROGRAM e;").program.seq,
    }
    assert [(item.program, item.message) for item in program_circles(programs)] == [
        ("b", "`b` would stand in its own place: b → c → b"),
        ("c", "`c` would stand in its own place: c → b → c"),
        ("e", "`e` would stand in its own place: e → e"),
    ]


def test_lines_of_a_block_follow_a_meeting_so_none_of_them_takes_the_place_of_another() -> None:
    told("SeqOfPar carriers ( Wheel.Advance(50); Wheel.Stop(); );")
    told("SeqOfPar carriers ( 2*( Wheel.Advance(50); Wheel.Stop(); ); );")
    told("SeqOfPar carriers ( [any carriers (Cargo.IsPressed())]( 2*( Wheel.Advance(50); Wheel.Stop(); ); ); );")
    told("SeqOfPar carriers ( *( Wheel.Advance(50); Wheel.Stop(); WAIT(1); ); );")
    told("ParOfSeq carriers ( Wheel.Advance(50); Wheel.Stop(); );  #! overwritten")
    told("SeqOfPar carriers ( [Cargo.IsPressed()]( Wheel.Advance(50); Wheel.Stop(); ); );  #! overwritten")
    told("//( SeqOfPar carriers ( Wheel.Stop(); );, SeqOfPar loaders ( Wheel.Stop(); ); );")


def test_an_object_that_no_robot_of_the_team_has_is_told() -> None:
    told("SeqOfPar carriers ( Weel.Stop(); );  #! unknown-object the team has no `Weel`")
    told("Boxes.Give();  #! unknown-method `Boxes` of the team has no `Give`")


def test_the_text_of_the_right_program_is_laid_out_as_it_is_read() -> None:
    assert parse_team(print_team_program(parse_team(RIGHT).program)).program == parse_team(RIGHT).program
