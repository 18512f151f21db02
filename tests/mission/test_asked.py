"""Properties of a mission: in the file, compared, merged, on the wire; a wrong one is told with its place."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.mission.model import Mission
from kitrobot.mission.property_forms import TIMED, AskedProperty, Form, VisitOrder
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.versions.comparison import differences
from kitrobot.versions.mission_merge import merge_missions
from kitrobot.wire.mission import MissionShape, mission_from_shape, mission_shape
from kitrobot.workspace.mission_loader import open_mission
from tests.verifier.check_fixtures import EXAMPLES

HEAD = """<kitrobot version="1"><program name="p" robot="mini-robot"><vertex id="start" element="Start"/>
<vertex id="stop" element="Stop"/><arc from="start" to="stop"/></program>
<team><agent name="robot-1" program="p"/></team>"""
LINES = (
    '<property name="n" never="any p (Button.IsPressed())"/>',
    '<property name="a" after="any p (Button.IsPressed())" eventually="all robot-1 (Button.IsReleased())"/>',
    '<property name="e" eventually="any robot-1 (Button.IsPressed())"/>',
    '<property name="s" stays="any p (Button.IsPressed())" until="any p (Button.IsReleased())"/>',
    '<property name="w" never="any p (Button.IsPressed())" while="any p (Button.IsReleased())"/>',
    '<property name="h" holds="any p (Button.IsPressed())" for="1.5"/>',
    '<property name="m" at-most="any p (Button.IsPressed())" times="3"/>',
    '<property name="f" first="any p (Button.IsPressed())" before="any p (Button.IsReleased())"/>',
    '<property name="g" again="any p (Button.IsPressed()); any p (Button.IsReleased())" within="20"/>',
    '<property name="v" visit="any p (Button.IsPressed()); any p (Button.IsReleased())" order="turn"/>',
    '<property name="d" after="any p (Button.IsPressed())" eventually="any p (Button.IsReleased())" within="0.5"/>',
)
TEXTS = st.text(st.characters(codec="utf-8", exclude_categories=("Cc", "Cs", "Co", "Cn")), max_size=30).map(str.strip)


def read(*parts: str) -> tuple[Mission, list[str]]:
    mission, problems = read_mission("\n".join((HEAD, *parts, "</kitrobot>")).encode(), "m.krt")
    assert mission is not None
    return mission, [item.message for item in problems]


def test_the_forms_are_read_written_and_sent_the_same() -> None:
    mission, problems = read(*LINES)
    assert problems == []
    assert {one.form for one in mission.properties} == set(Form)
    written = write_mission(mission)
    assert read_mission(written, "m.krt") == (mission, [])
    assert [line.strip() for line in written.decode().splitlines() if "<property" in line] == list(LINES)
    shape = MissionShape.model_validate_json(mission_shape(mission).model_dump_json())
    assert mission_from_shape(shape) == mission


@given(
    TEXTS.filter(bool),
    st.sampled_from(Form),
    TEXTS,
    TEXTS,
    st.floats(0, 1e6),
    st.integers(0, 100),
    st.sampled_from(VisitOrder),
)
def test_whatever_it_says_comes_back(
    name: str, form: Form, first: str, second: str, seconds: float, times: int, order: VisitOrder
) -> None:
    one = AskedProperty(
        name,
        form,
        first,
        second if form in (Form.NEVER, Form.AFTER, Form.STAYS, Form.BEFORE) else "",
        seconds if form in TIMED else 0.0,
        times if form is Form.AT_MOST else 0,
        order if form is Form.VISIT else VisitOrder.ANY,
    )
    mission, _ = read_mission(write_mission(Mission(properties=[one])), "m.krt")
    assert mission is not None
    assert mission.properties == [one]


@pytest.mark.parametrize(
    "wrong",
    [
        '<property never="any p (Button.IsPressed())"/>',
        '<property name="n"/>',
        '<property name="n" after="x"/>',
        '<property name="n" never="x" eventually="y"/>',
        '<property name="n" never="x" within="4"/>',
        '<property name="n" holds="x"/>',
        '<property name="n" holds="x" for="soon"/>',
        '<property name="n" eventually="x" within="0"/>',
        '<property name="n" at-most="x"/>',
        '<property name="n" at-most="x" times="101"/>',
        '<property name="n" visit="x" order="some"/>',
        '<property name="n" first="x"/>',
        '<property name="n" stays="x" until="y" never="z"/>',
        f'<property name="n" never="{"x" * 2000}"/>',
        f'<property name="{"n" * 200}" never="x"/>',
    ],
)
def test_one_that_is_wrong_is_kept_word_for_word(wrong: str) -> None:
    mission, problems = read(wrong)
    assert len(problems) == 1
    assert mission.unknown == [wrong]
    assert mission.properties == []


def test_differences_and_merging() -> None:
    base, _ = read(LINES[0])
    ours, _ = read(LINES[0].replace("Pressed", "Released"))
    theirs, _ = read(LINES[0], LINES[2])
    assert [one.sentence for one in differences(base, ours)] == ["the property n: first changed"]
    assert [one.sentence for one in differences(base, theirs)] == ["the property e added"]
    merged = merge_missions(base, ours, theirs)
    assert merged.conflicts == ()
    assert merged.mission.properties == [ours.properties[0], theirs.properties[1]]


@pytest.mark.parametrize(
    ("line", "message", "help", "at"),
    [
        ('name="n" never="any p (Buton.IsPressed())"', "Buton", "Button", "never="),
        (
            'name="n" after="any p (Button.IsPressed())" eventually="any q (Button.IsPressed())"',
            "`q`",
            "",
            "eventually=",
        ),
        ('name="n" never="Button.IsPressed()"', "does not say whose it is", "any carrier-1", "never="),
        ('name="n" never=""', "expected a condition", "", "never="),
        ('name="contact" never="any p (Button.IsPressed())"', "checked unasked", "another name", "name="),
    ],
)
def test_one_about_nothing_is_told_with_its_place_and_the_mission_runs(
    tmp_path: Path, line: str, message: str, help: str, at: str
) -> None:
    path = tmp_path / "m.krt"
    path.write_text("\n".join((HEAD, f"  <property {line}/>", "</kitrobot>")), encoding="utf-8")
    report = open_mission(path).check()
    assert report.ok
    [problem] = [one for one in report.problems if one.code == "mission-property"]
    assert message in problem.message
    assert help in problem.help
    assert problem.place is not None
    row = path.read_text(encoding="utf-8").splitlines()[problem.place.line - 1]
    assert row[problem.place.column - 1 :].startswith(at)


def test_one_may_speak_of_roles_groups_and_works_of_the_team(tmp_path: Path) -> None:
    example = EXAMPLES / "shared-search" / "shared-search.krt"
    text = example.read_text(encoding="utf-8")
    world = example.with_suffix("").with_suffix(".world.xml")
    (tmp_path / world.name).write_text(world.read_text(encoding="utf-8"), encoding="utf-8")
    path = tmp_path / "m.krt"

    def said(condition: str) -> list[str]:
        line = f'  <property name="n" never="{condition}"/>\n</kitrobot>'
        path.write_text(text.replace("</kitrobot>", line), encoding="utf-8")
        return [one.message for one in open_mission(path).check().problems if one.code == "mission-property"]

    mission = open_mission(example).mission
    [role, *_], [group, *_], [work, *_] = mission.team.roles, mission.team.groups, mission.team.works
    assert said(f"any {role.name} (Count.EqualTo(3)) &amp; all {group.name} ({work.name}.IsEmpty())") == []
    assert said(f"any {role.name} (Nothing.IsEmpty())") != []
