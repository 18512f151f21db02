"""What a team declares in its mission: read with places, written in one layout, and printed before its programs."""

from __future__ import annotations

import random

from hypothesis import given
from hypothesis import strategies as st

from kitrobot.graph.model import empty_program
from kitrobot.lll.parse_results import parse_team
from kitrobot.lll.printer import print_team_program
from kitrobot.lll.tree import GroupDeclaration, Members, RoleDeclaration, WorkDeclaration
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.levels import Level
from kitrobot.workspace.mission_loader import open_mission
from tests.strategies import Shape, random_team_program, shipped_robots

TEAM = """\
  <team>
    <agent name="one" program="p"/>
    <role name="r" robot="carrier"><note>who</note></role>
    <role name="s" robot="mini-robot" least="2"/>
    <role name="t" robot="carrier" least="0" most="3"/>
    <group name="g" members="r one &quot;b c&quot;" failure="substitute"/>
    <work name="Boxes" units="12" lease="30"><note at="after">all</note></work>
    <work name="Bags" units="0"/>
  </team>
"""


def read(team: str, program: str = '<program name="p" robot="carrier"/>') -> tuple[Mission, list[tuple[str, int, str]]]:
    text = f'<kitrobot version="1">\n{program}\n{team}</kitrobot>'
    mission, found = read_mission(text.encode(), "m.krt")
    assert mission is not None
    return mission, [(item.code, item.place.line if item.place else 0, item.message) for item in found]


def test_declarations_are_read_and_written() -> None:
    mission, found = read(TEAM)
    assert found == []
    assert mission.team.roles == [
        RoleDeclaration("r", "carrier", above=["who"]),
        RoleDeclaration("s", "mini-robot", 2, 2),
        RoleDeclaration("t", "carrier", 0, 3),
    ]
    assert mission.team.groups == [GroupDeclaration("g", Members(["r", "one", "b c"]), "substitute")]
    assert mission.team.works == [WorkDeclaration("Boxes", 12, 30, after="all"), WorkDeclaration("Bags", 0)]
    assert TEAM in write_mission(mission).decode()


def test_what_is_wrong_with_a_declaration_has_its_line() -> None:
    wrong = """<team>
<role name="r"/>
<role name="s" robot="carrier" least="3" most="2"/>
<group name="g" members=""/>
<group name="h" members="a,b"/>
<group name="i" members="r" failure="wait"/>
<work name="a-b" units="1"/>
<work name="W" units="-1"/>
<role name="s" robot="carrier"/>
</team>"""
    mission, found = read(wrong)
    assert [(code, line) for code, line, _ in found] == [
        ("xml-missing", 4),
        ("xml-bad-value", 5),
        ("xml-missing", 6),
        ("xml-bad-value", 7),
        ("xml-bad-value", 8),
        ("xml-bad-value", 9),
        ("xml-bad-value", 10),
        ("xml-duplicate", 11),
    ]
    assert [one.name for one in mission.team.roles] == ["s"]


def test_a_program_of_a_team_has_a_level_and_no_robot() -> None:
    mission, found = read("", '<program name="p" level="group"/>')
    assert found == []
    assert (mission.programs[0].level, mission.programs[0].target) == (Level.GROUP, "")
    assert b'<program name="p" level="group">' in write_mission(mission)
    mission, found = read("", '<program name="p" level="social" robot="carrier"/>')
    assert [code for code, _, _ in found] == ["xml-unknown-attribute"]
    assert mission.programs[0].target == ""
    assert [code for code, _, _ in read("", '<program name="p"/>')[1]] == ["xml-missing"]
    assert [code for code, _, _ in read("", '<program name="p" level="crowd" robot="x"/>')[1]] == ["xml-bad-value"]


def test_a_mission_without_declarations_has_no_crew_and_is_written_as_ever() -> None:
    mission = Mission(programs=[empty_program("p", "carrier")], team=Team([Agent("a", "p")]))
    assert mission.crew is None
    text = write_mission(mission).decode()
    assert "level" not in text
    assert "role" not in text


HAUL = """<kitrobot version="1">
<program name="drive" robot="carrier">
<vertex id="start" element="Start"/><vertex id="v1" element="Wheel.Advance"/><vertex id="stop" element="Stop"/>
<arc from="start" to="v1"/><arc from="v1" to="stop"/>
</program>
<program name="haul" level="group">
<vertex id="start" element="Start"/>
<vertex id="v1" element="SeqOfPar"><set name="members">carriers</set></vertex>
<vertex id="v2" element="Program"><set name="name">NAME</set></vertex>
<vertex id="stop" element="Stop"/>
<arc from="start" to="v1"/><arc from="v1" out="body" to="v2"/><arc from="v2" to="v1" at="return"/>
<arc from="v1" to="stop"/>
</program>
<team>
<agent name="a" program="drive"/>
<role name="carriers" robot="carrier"/>
</team>
</kitrobot>"""


def problems(text: str, folder: object) -> list[tuple[str, int]]:
    path = folder / "haul.krt"  # type: ignore[operator]
    path.write_text(text)
    found = open_mission(path).before_setup
    told = [item for item in found if item.code.startswith("team-")]
    return [(item.code, item.place.line if item.place else 0) for item in told]


def test_a_mission_with_a_team_s_program_is_checked_as_a_whole(tmp_path: object) -> None:
    assert problems(HAUL.replace("NAME", "drive"), tmp_path) == []
    assert problems(HAUL.replace("NAME", "dive"), tmp_path) == [("team-unknown-program", 9)]
    assert problems(HAUL.replace("NAME", "haul"), tmp_path) == [("team-program-circle", 9)]
    wanted = HAUL.replace("NAME", "drive").replace('"carrier"/>\n</team>', '"carrier" least="2"/>\n</team>')
    assert problems(wanted, tmp_path) == [("team-role-unplayed", 16)]


def test_the_text_of_a_team_s_program_begins_with_what_the_mission_declares(tmp_path: object) -> None:
    problems(HAUL.replace("NAME", "drive"), tmp_path)
    opened = open_mission(tmp_path / "haul.krt")  # type: ignore[operator]
    text = opened.compiled["haul"].source.text
    assert text == "role carriers: carrier;\n\nSeqOfPar carriers ( PROGRAM drive; );\n"
    assert opened.compiled["haul"].image is None
    assert opened.compiled["drive"].image is not None


@given(st.randoms(use_true_random=True))
def test_declarations_of_a_text_come_back_from_the_mission(rng: random.Random) -> None:
    text = print_team_program(random_team_program(rng, shipped_robots()["mini-robot"], Shape(2, comments=True)))
    program = parse_team(text).program
    for what in ("roles", "groups", "works"):
        setattr(program, what, list({one.name: one for one in getattr(program, what)}.values()))
    for group in program.groups:
        group.members.braced = len(group.members.names) != 1
    mission = Mission(team=Team(roles=program.roles, groups=program.groups, works=program.works))
    again, found = read_mission(write_mission(mission), "m.krt")
    assert found == []
    assert again is not None
    assert again.team == mission.team
