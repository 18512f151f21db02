"""What is said about roles and groups that a MOVE can leave empty, alone or with a failure."""

from __future__ import annotations

import random

import pytest

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.compiler.program.team_check import check_program
from kitrobot.compiler.team.inlining import inlined
from kitrobot.compiler.team.moves import report_emptied
from kitrobot.compiler.team.names import Names, check_declarations
from kitrobot.compiler.team.sets import TeamSets
from kitrobot.compiler.team_compilation import compile_team
from kitrobot.diagnostics.model import Diagnostic, Rule
from kitrobot.image.debug import DebugMap
from kitrobot.lll.parse_results import parse_team
from kitrobot.lll.tree import Move, Node, Seq
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.crew import Crew, CrewProgram
from kitrobot.primitives.levels import Level
from kitrobot.text.sentences import Help, Sentence
from tests.compiler.crews import crew_declaring
from tests.effort import THOROUGH
from tests.lll.expectations import meets_expectations
from tests.team_programs.reference import Meaning

PARTS = load_catalogue()
CREW = Crew(
    (*((f"carrier-{n}", "carrier") for n in range(1, 7)), ("loader-1", "loader")),
    (CrewProgram("meet", "", Level.GROUP),),
)
NESTED = """\
role carriers: carrier 2;
role helpers: carrier 3;
role loaders: loader;
group movers = carriers;
group road = {movers, helpers};
group all = {road, loaders};
group rest = loaders on failure abort;
"""


MEET = "[any {road, rest} (Collision.IsPressed())]( SeqOfPar movers (); );"


def found_in(text: str, declared: str = NESTED, meet: str = MEET) -> list[Diagnostic]:
    crew = crew_declaring(CREW, declared)
    assert check_declarations(crew, PARTS.robots, lambda _: None) == []
    return found_for(crew, text, meet)


def found_for(crew: Crew, text: str, meet: str = MEET) -> list[Diagnostic]:
    """What is said of a program of a team; `meet` is the text of the one that it can name."""
    parsed = parse_team(text)
    assert parsed.diagnostics == []
    target = PARTS.extended([], [], crew).teams[Level.SOCIAL]
    found = check_program(parsed.program.seq, target, crew, parsed.source)

    def report(rule: Rule, message: Sentence, node: Node, help: Help = "") -> None:
        found.append(rule(message, parsed.source.place(node.start, node.end), help=help))

    whole = inlined(parsed.program.seq, "day", {"meet": parse_team(meet).program.seq}, report)
    report_emptied(whole, Names(crew), report)
    return found


def told(text: str, declared: str = NESTED, meet: str = MEET) -> None:
    """Compares what is said about a program with what its comments expect."""
    meets_expectations(text, found_in(text, declared, meet))


def emptied(text: str) -> dict[str, str]:
    """Of each role and group that is told, what is told of it."""
    found = found_in(text)
    assert {item.code for item in found} <= {"team-group-empty"}
    assert all(item.help and item.place for item in found)
    return {item.message.split("`")[1]: "failure" if "fails" in item.message else "move" for item in found}


MOVES = [
    # A role that robots move out of, and the group around it; the wider ones keep the helpers.
    ("MOVE 2 carriers -> rest;", {"carriers": "move", "movers": "move"}),
    # A group, and the ones in it.
    ("MOVE 5 road -> rest;", {"movers": "move", "road": "move"}),
    (
        "MOVE 2 all -> rest; MOVE 3 helpers -> rest;",
        {"movers": "move", "helpers": "move", "road": "move", "all": "failure"},
    ),
    # No more go than are there, and who is somewhere else is not taken.
    ("MOVE 9 movers -> rest;", {"movers": "move"}),
    # To a group in it: nobody leaves it.
    ("MOVE 5 road -> movers;", {}),
    ("MOVE 4 road -> movers;", {}),
    ("MOVE 2 carriers -> road;", {"carriers": "move", "movers": "move"}),
    # One is left of them, and no group says what comes of its failure.
    ("MOVE 1 carriers -> rest;", {"carriers": "failure", "movers": "failure"}),
    ("MOVE 1 movers -> rest;", {"movers": "failure"}),
    ("MOVE 4 road -> rest;", {"movers": "move", "road": "failure"}),
    ("MOVE 1 helpers -> rest;", {}),
    # The group that they come into is the only one that keeps them.
    ("*( MOVE 1 helpers -> rest; );", {"helpers": "move"}),
    ("*( MOVE 1 helpers -> rest; MOVE 1 rest -> helpers; );", {}),
]


@pytest.mark.parametrize(("text", "expected"), MOVES, ids=[row[0] for row in MOVES])
def test_each_role_and_group_that_a_move_can_leave_empty_is_told(text: str, expected: dict[str, str]) -> None:
    assert emptied(text) == expected


PLAIN = "role carriers: carrier 2..3; role loaders: loader; group movers = carriers; group all = {movers, loaders};"


@pytest.mark.parametrize(
    "text",
    [
        "MOVE 2 movers -> loaders;  #! team-group-empty@1 it may have no more than 2",
        "2*( MOVE 1 movers -> loaders; );  #! team-group-empty",
        "*( WAIT(1); MOVE 1 movers -> loaders; );  #! team-group-empty",
        "*( WAIT(1); MOVE 1 movers -> loaders; MOVE 1 loaders -> movers; );",
    ],
)
def test_a_group_that_can_lose_all_its_members_is_told_with_how_many_it_may_have(text: str) -> None:
    told(text, PLAIN)


LOOKED_FOR = [
    "MOVE 2 movers -> rest;  MOVE 2 rest -> movers;",
    "MOVE 2 movers -> rest; SeqOfPar loaders (); MOVE 2 rest -> movers;",
    "MOVE 2 movers -> rest; SeqOfPar movers (); MOVE 2 rest -> movers;  #! team-group-empty@1",
    "MOVE 2 movers -> rest; [any road (Collision.IsPressed())](); MOVE 2 rest -> movers;  #! team-group-empty@1",
    "2*( MOVE 1 movers -> rest; SeqOfPar movers (); ); MOVE 2 rest -> movers;  #! team-group-empty@5",
    "//( MOVE 1 movers -> rest; SeqOfPar loaders ();, MOVE 1 movers -> rest; );  #! team-group-empty@50",
]


@pytest.mark.parametrize("text", LOOKED_FOR)
def test_a_group_that_is_filled_again_is_told_where_somebody_looks_for_its_robots_before(text: str) -> None:
    told(text)


@pytest.mark.parametrize(
    ("meet", "text"),
    [
        (MEET, "MOVE 2 movers -> rest; PROGRAM meet; MOVE 2 rest -> movers;  #! team-group-empty@1"),
        ("SeqOfPar loaders ();", "MOVE 2 movers -> rest; PROGRAM meet; MOVE 2 rest -> movers;"),
        ("MOVE 2 rest -> movers;", "MOVE 2 movers -> rest; PROGRAM meet;"),
        ("MOVE 1 movers -> rest;", "MOVE 1 movers -> rest; PROGRAM meet;  #! team-group-empty@1"),
        ("MOVE 1 movers -> rest;", "2*( PROGRAM meet; );  #! team-group-empty@1"),
        ("MOVE 1 movers -> rest;", "PROGRAM meet; SeqOfPar movers (); MOVE 1 rest -> movers;  #! team-group-empty@1"),
    ],
)
def test_moves_and_blocks_of_a_program_that_is_named_count_where_it_stands(meet: str, text: str) -> None:
    told(text, meet=meet)


def test_it_is_told_of_the_program_in_which_the_move_stands() -> None:
    crew = crew_declaring(CREW, NESTED)
    texts = {"day": "WAIT(1);\nPROGRAM meet;\n", "meet": "WAIT(1);\n\nMOVE 2 movers -> rest;\n"}
    parsed = {name: parse_team(text) for name, text in texts.items()}
    programs = {name: CompiledProgram(one.program.seq, one.source, None, DebugMap()) for name, one in parsed.items()}
    made = compile_team("day", programs, PARTS.extended([], [], crew), ["carrier", "loader"])
    assert {item.code for item in made.diagnostics} == {"team-group-empty"}
    assert {(item.program, item.place.line) for item in made.diagnostics if item.place} == {("meet", 3)}


ONE_LEFT = """\
role carriers: carrier {count};
role loaders: loader;
group movers = carriers{failure};
group rest = loaders on failure abort;
{more}
"""
FAILURES = [
    (5, "", "", "`on failure abort`, or `on failure substitute` with a spare robot"),
    (5, " on failure drop", "", "`on failure abort`, or `on failure substitute` with a spare robot"),
    (5, " on failure abort", "", None),
    (5, " on failure substitute", "", None),
    (6, " on failure substitute", "", "add a spare robot of its kind"),
    # A group around it, and one that holds the same robots whoever moves.
    (5, "", "group both = {movers, loaders} on failure abort;", None),
    (5, "", "group same = carriers on failure abort;", None),
]


@pytest.mark.parametrize(("count", "failure", "more", "way_out"), FAILURES)
def test_the_one_robot_that_a_move_leaves_is_told_where_its_failure_leaves_nobody(
    count: int, failure: str, more: str, way_out: str | None
) -> None:
    found = found_in(f"MOVE {count - 1} movers -> rest;", ONE_LEFT.format(count=count, failure=failure, more=more))
    if way_out is None:
        assert found == []
    else:
        (one,) = found
        assert one.message == "`movers` may have one robot left after this MOVE, and none when that one fails"
        assert way_out in one.help


def test_a_group_that_robots_move_out_of_too_does_not_stand_by_the_one_that_is_left() -> None:
    declared = ONE_LEFT.format(count=5, failure="", more="group same = carriers on failure abort;")
    told("MOVE 4 movers -> rest;", declared)
    told("MOVE 1 same -> rest; MOVE 4 movers -> rest;  #! team-group-empty@22", declared)


@pytest.mark.parametrize("seed", range(600 if THOROUGH else 60))
def test_what_the_moves_of_a_random_team_leave_empty_is_told(seed: int) -> None:
    """Held against the meaning of programs of teams (`reference`); who moves is in one place only."""
    chance = random.Random(seed)
    roles = {f"r{n}": chance.randint(1, 3) for n in range(4)}
    agents = [f"a-{n}" for n in range(sum(roles.values()))]
    playing = dict(zip(agents, [name for name, count in roles.items() for _ in range(count)], strict=True))
    inside: dict[str, list[str]] = {f"g{n}": [f"r{n}"] for n in range(3)}
    inside["g3"] = ["r3", *chance.sample(["g0", "g1", "g2"], chance.randint(1, 2))]
    inside["g4"] = chance.sample(["g0", "g1", "g2", "g3"], 2)
    declared = [f"role {name}: carrier {count};" for name, count in roles.items()]
    declared += [f"group {name} = {{{', '.join(names)}}};" for name, names in inside.items()]
    crew = crew_declaring(Crew(tuple((name, "carrier") for name in agents), ()), "\n".join(declared))
    pairs = [chance.sample([*inside, *roles], 2) for _ in range(chance.randint(1, 4))]
    sets = TeamSets(crew, Seq([Move(1, source, target) for source, target in pairs]))
    meaning = Meaning(playing, {name: sorted(names) for name, names in sets.groups.items()}, {})

    def members(group: str) -> int:
        return sum(meaning.is_in(name, group) for name in agents)

    lines, emptied = [], set[str]()
    for source, target in pairs:
        count = min(chance.randint(1, 4), members(source))
        meaning.instruction(Move(count, source, target), agents, False)
        lines.append(f"MOVE {count} {source} -> {target}; SeqOfPar {{{', '.join(sets.groups)}}} ();")
        emptied |= {group for group in sets.groups if not members(group)}
    found = found_for(crew, "\n".join(lines))
    assert not any(item.is_error for item in found)
    assert emptied <= {item.message.split("`")[1] for item in found if "can lose" in item.message}


@pytest.mark.parametrize(("groups", "moves", "told"), [(99, 300, 99), (99, 301, 0), (3000, 1, 0)])
def test_of_more_groups_and_moves_than_can_be_held_against_each_other_nothing_is_told(
    groups: int, moves: int, told: int
) -> None:
    rows = [f"group g{n} = g{n + 1};" for n in range(groups - 1)]
    declared = ["role r: carrier;", *rows, f"group g{groups - 1} = r; group other = loader-1;"]
    crew = crew_declaring(CREW, "\n".join(declared))
    program = parse_team("MOVE 1 g0 -> other;" * moves).program.seq
    found: list[str] = []
    report_emptied(program, Names(crew), lambda rule, message, node, help="": found.append(message))
    assert len(found) == told
