"""What each kind of robot is given of a team's program, in examples."""

from __future__ import annotations

import pytest

from kitrobot.compiler.team.points import PointKind
from kitrobot.compiler.team.projection import Projection, project
from kitrobot.lll.parse_results import parse_team
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Call
from kitrobot.lll.walk import nodes
from kitrobot.primitives.crew import Crew, declaring

AGENTS = (("c-1", "carrier"), ("c-2", "carrier"), ("l", "loader"))
DECLARED = """role carrier: carrier 2;
role loader: loader;
group carriers = carrier;
"""


def projected(text: str, programs: dict[str, str] | None = None, more: str = "") -> Projection:
    parsed = parse_team(DECLARED + more + text, "team.lll")
    assert parsed.ok, parsed.diagnostics
    others = {name: parse_team(other).program.seq for name, other in (programs or {}).items()}
    crew = declaring(Crew(agents=AGENTS), parsed.program)
    return project(parsed.program.seq, crew, others, parsed.source, "team")


def program(made: Projection, kind: str) -> str:
    return print_program(made.programs[kind])


def test_lines_of_a_block_are_parted_by_meetings_for_its_members_only() -> None:
    made = projected("SeqOfPar carriers (Arm.Do(1); Arm.Do(2););")
    assert made.diagnostics == []
    assert (
        program(made, "carrier")
        == """\
Team.Join();
Team.Enter(0);
[Team.Answer()](
  Arm.Do(1);
  Team.Meet(1);
  Arm.Do(2);
  Team.Meet(2);
);
Team.Meet(3);
"""
    )
    assert program(made, "loader") == "Team.Join();\nTeam.Meet(3);\n"


def test_a_condition_around_blocks_is_asked_of_all_who_go_the_same_way() -> None:
    made = projected("[any carriers (Arm.IsUp()) & !(all loader (Arm.IsUp()))](SeqOfPar carriers (Arm.Do(1);););")
    assert (
        program(made, "carrier")
        == """\
Team.Join();
Team.Ask(0, Arm.IsUp());
[Team.Answer()]( Team.Ask(1, 0); );
[Team.Answer()](
  Team.Enter(2);
  [Team.Answer()](
    Arm.Do(1);
    Team.Meet(3);
  );
  Team.Meet(4);
);
"""
    )
    asked = made.plan.points[1]
    assert asked.kind is PointKind.ASK
    assert (asked.asked, asked.quantifier, asked.negated) == (frozenset(("loader",)), "all", True)
    assert [point.leads for point in made.plan.points[:3]] == [(1, 4), (2, 4), (3, 3)]


def test_passes_of_a_loop_around_blocks_are_counted_by_the_team() -> None:
    made = projected("3*(ParOfSeq loader (Arm.Do(1);););")
    assert (
        program(made, "loader")
        == """\
Team.Join();
Team.Ask(0, 0);
*[Team.Answer()](
  Team.Enter(1);
  [Team.Answer()]( Arm.Do(1); );
  Team.Meet(2);
  Team.Ask(0, 1);
);
"""
    )
    assert made.plan.points[0].times == 3


def test_a_robot_takes_the_branch_that_has_a_block_for_it() -> None:
    made = projected("//(ParOfSeq carriers (Arm.Do(1););, ParOfSeq loader (Arm.Do(2);););")
    assert (
        program(made, "loader")
        == """\
Team.Join();
Team.Enter(3);
[Team.Answer()](
  Team.Enter(4);
  [Team.Answer()]( Arm.Do(2); );
  Team.Meet(5);
);
Team.Meet(6);
"""
    )


def test_a_test_of_its_own_is_a_line_of_its_own() -> None:
    made = projected("SeqOfPar carriers ([Arm.IsUp()](Arm.Do(1);); Arm.Do(2););")
    assert "  [Arm.IsUp()]( Arm.Do(1); );\n  Team.Meet(1);\n" in program(made, "carrier")


def test_a_program_stands_in_its_place_and_its_lines_say_where_they_are_from() -> None:
    made = projected("ParOfSeq loader (PROGRAM lift; Arm.Do(9););", {"lift": "2*(Arm.Do(1););"})
    assert "  2*( Arm.Do(1); );\n  Arm.Do(9);\n" in program(made, "loader")
    inside = [node for node in nodes(made.programs["loader"]) if isinstance(node, Call) and node.object == "Arm"]
    assert [node.program for node in inside] == ["lift", "team"]


def test_who_can_move_into_a_group_has_its_blocks() -> None:
    made = projected("MOVE 1 carriers -> loaders; ParOfSeq loaders (Arm.Do(1););", more="group loaders = loader;\n")
    assert "Arm.Do(1)" in program(made, "carrier")
    assert made.plan.points[0].moves == ("carriers", "loaders")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Arm.Do(1);", "team-no-block"),
        ("//(WAIT(1);, ParOfSeq loader (Arm.Do(1);););", "team-no-block"),
        ("//(ParOfSeq c-1 (Arm.Do(1););, ParOfSeq {c-1, loader} (Arm.Do(1);););", "team-two-places"),
        ("ParOfSeq carriers (SeqOfPar carriers (Arm.Do(1);););", "team-not-within"),
        ("*(ParOfSeq carriers (BREAK;););", "team-break"),
        ("SeqOfPar carriers (3*([Arm.IsUp()](BREAK;); Arm.Do(1);););", "team-break"),
    ],
)
def test_what_cannot_be_shared_out_is_told_with_its_place(text: str, code: str) -> None:
    made = projected(text)
    assert [item.code for item in made.diagnostics] == [code]
    place = made.diagnostics[0].place
    assert place is not None
    assert (place.file, place.line) == ("team.lll", 4)


@pytest.mark.parametrize(
    ("text", "loop"),
    [
        ("*(ParOfSeq carriers (BREAK;););", True),
        ("2*(SeqOfPar carriers ([Arm.IsUp()](BREAK;););); ", True),
        ("ParOfSeq carriers (Arm.Do(1); BREAK;);", False),
        ("2*(Arm.Do(1);); ParOfSeq carriers (BREAK;);", False),
        ("*(//(ParOfSeq carriers (BREAK;);, ParOfSeq loader (Arm.Do(1););););", False),
    ],
)
def test_a_break_of_one_robot_is_said_to_leave_a_loop_only_where_there_is_one(text: str, loop: bool) -> None:
    told = [item.message for item in projected(text).diagnostics if item.code == "team-break"]
    assert [("out of a loop" in one, "in no loop" in one) for one in told] == [(loop, not loop)]


def test_programs_that_double_each_other_or_nest_without_end_are_refused_soon() -> None:
    doubling = {f"p{n}": f"PROGRAM p{n + 1}; PROGRAM p{n + 1};" for n in range(60)} | {"p60": "Arm.Do(1);"}
    made = projected("ParOfSeq loader (PROGRAM p0;);", doubling)
    assert [item.code for item in made.diagnostics] == ["too-large"]
    nested = {f"p{n}": f"2*(PROGRAM p{n + 1};);" for n in range(300)} | {"p300": "Arm.Do(1);"}
    made = projected("ParOfSeq loader (PROGRAM p0;);", nested)
    assert [item.code for item in made.diagnostics] == ["graph-too-deep"]
    circle = {"a": "Arm.Do(1); PROGRAM b;", "b": "PROGRAM a;"}
    assert projected("ParOfSeq loader (PROGRAM a;);", circle).diagnostics == []


def test_a_role_that_robots_move_to_is_a_group_that_begins_with_its_players() -> None:
    made = projected("MOVE 1 carrier -> loader; ParOfSeq loader (Arm.Do(1););")
    assert {name: made.plan.groups[name] for name in ("carrier", "loader")} == {
        "carrier": frozenset(("carrier",)),
        "loader": frozenset(("loader",)),
    }
    assert "Arm.Do(1)" in program(made, "carrier")
