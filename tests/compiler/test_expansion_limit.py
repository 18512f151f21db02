"""A small mission that becomes a large program is refused before anything of it is made."""

from __future__ import annotations

import sys
from itertools import pairwise
from pathlib import Path
from xml.sax.saxutils import escape

import pytest

from kitrobot.compiler.graph import expansion_limit
from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.graph.model import IN, NEXT, RETURN, START, STOP, Arc, Program, Vertex
from kitrobot.image.model import MOST_INSTRUCTIONS
from kitrobot.workspace.mission_loader import OpenMission, read_mission_data
from kitrobot.workspace.search_path import SearchPath

LIMIT = 100
PART = """<constructor name="{name}" icon="repeat" colour="action"><label>{name}</label><help>h</help>
{slots}<code>{code}</code></constructor>"""


@pytest.fixture(autouse=True)
def limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """Limits that are reached soon."""
    monkeypatch.setattr(expansion_limit, "MOST_INSTRUCTIONS", LIMIT)
    monkeypatch.setattr(expansion_limit, "MOST_OF_MISSION", 2 * LIMIT)


def mission_of(
    *uses: int, code: str = "WAIT(1);" * 11, level: str = 'robot="mini-robot"', team: str = ""
) -> OpenMission:
    """A mission of programs that use a part of eleven instructions so often."""
    programs = ""
    for number, count in enumerate(uses):
        chain = ["start", *(f"v{at}" for at in range(count)), "stop"]
        programs += f'<program name="p{number}" {level}><vertex id="start" element="Start"/>'
        programs += "".join(f'<vertex id="{one}" element="Big"/>' for one in chain[1:-1])
        programs += '<vertex id="stop" element="Stop"/>'
        programs += "".join(f'<arc from="{one}" to="{other}"/>' for one, other in pairwise(chain))
        programs += "</program>"
    part = PART.format(name="Big", slots="", code=escape(code))
    text = f'<kitrobot version="1">{part}{programs}<team>{team}</team></kitrobot>'
    return read_mission_data(text.encode(), "big.krt", SearchPath(Path()))


def too_large(opened: OpenMission) -> list[tuple[str, str, tuple[str, ...]]]:
    found = [one for one in opened.report.problems if one.code == "too-large"]
    return [(one.program or "", str(one.message), one.vertices) for one in found]


def test_a_program_is_refused_one_beyond_the_limit_with_its_largest_part() -> None:
    assert too_large(mission_of(10)) == []
    ((program, message, vertices),) = too_large(mission_of(11))
    assert (program, vertices) == ("p0", ("v10",))
    assert message == "with all parts in their places this program has more than 100 instructions"


def test_nothing_of_it_is_expanded(monkeypatch: pytest.MonkeyPatch) -> None:
    def fill(*given: object) -> None:
        raise AssertionError("a part was put in its place")

    monkeypatch.setattr(sys.modules["kitrobot.compiler.graph.graph_to_lll"], "fill", fill)
    opened = mission_of(11)
    assert opened.report.programs[0].lll == ""
    assert opened.compiled["p0"].image is None


@pytest.mark.parametrize(
    "code",
    [
        "*[" + " & ".join(["Captor.IsPressed()"] * 10) + "](WAIT(1););",
        "//(" + ",".join(["WAIT(1);"] * 10) + ");",
        "Wheel.Advance(" + ",".join(["Captor.Value()"] * 88) + ");",
    ],
)
def test_tests_branches_and_parameters_count(code: str) -> None:
    assert too_large(mission_of(10, code=code)) == []
    assert len(too_large(mission_of(12, code=code))) == 1


def test_parts_inside_of_parts_count() -> None:
    outer = PART.format(name="Outer", slots='<flow name="body"/>', code="WAIT(1);" * 10 + "2*({body};);")
    text = f'<kitrobot version="1">{outer}<program name="p" robot="mini-robot"/></kitrobot>'
    catalogue = read_mission_data(text.encode(), "p.krt", SearchPath(Path())).catalogue

    def nested(depth: int) -> Program:
        made = Program("p", "mini-robot")
        made.vertices = [
            Vertex("start", START),
            *(Vertex(f"v{at}", "Outer") for at in range(depth)),
            Vertex("stop", STOP),
        ]
        made.arcs = [Arc("start", "v0", NEXT, IN), Arc("v0", "stop", NEXT, IN)]
        for at in range(depth - 1):
            made.arcs += [Arc(f"v{at}", f"v{at + 1}", "body", IN), Arc(f"v{at + 1}", f"v{at}", NEXT, RETURN)]
        made.arcs.append(Arc(f"v{depth - 1}", f"v{depth - 1}", "body", RETURN))
        return made

    assert graph_to_lll(nested(9), catalogue).ok
    made = graph_to_lll(nested(11), catalogue)
    assert [one.code for one in made.diagnostics] == ["too-large"]
    assert made.program.items == []


def test_parts_as_small_as_what_is_drawn_are_no_reason_to_refuse_a_program() -> None:
    assert too_large(mission_of(300, code="WAIT(1);")) == []


def test_the_programs_of_a_mission_have_a_limit_together() -> None:
    opened = mission_of(10, 10, 10, 10)
    message = "with all parts in their places the programs of this mission have more than 200 instructions"
    assert too_large(opened) == [("p2", message, ()), ("p3", message, ())]
    assert [bool(one.lll) for one in opened.report.programs] == [True, True, False, False]
    # One that is too large by itself takes no room from the others.
    assert [one for one, *_ in too_large(mission_of(11, 10, 10))] == ["p0"]


def test_a_team_program_is_refused_where_it_is_too_large_for_its_kinds(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(expansion_limit, "MOST_FOR_KINDS", 25)
    robots = ("mini-robot", "carrier", "loader")
    team = "".join(f'<agent name="a{at}" program="p0" robot="{robot}"/>' for at, robot in enumerate(robots))
    for kinds in (2, 3):
        opened = mission_of(1, level='level="social"', team=team if kinds == 3 else team.rpartition("<")[0])
        assert opened.team is not None
        found = [str(one.message) for one in opened.team.diagnostics if one.code == "too-large"]
        expected = ["11 instructions for each of 3 kinds of robots are more than 25"]
        assert found == (expected if kinds == 3 else [])


def test_the_limit_is_what_an_image_holds() -> None:
    assert MOST_INSTRUCTIONS == 65536
