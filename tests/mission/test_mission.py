"""Missions: the round trip, damage, older and newer versions, and saving without ever losing anything."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.graph.model import empty_program
from kitrobot.mission.model import Agent, Goal, Mission, Team
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import SaveError, save, write_mission

GOOD = """\
<kitrobot version="1">
  <program name="carrier" robot="carrier">
    <vertex id="start" element="Start"/>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="stop"/>
  </program>
  <team>
    <agent name="carrier-1" program="carrier"/>
    <agent name="carrier-2" program="carrier" start="carrier-1"/>
    <goal storehouse="B" stock="all"/>
    <goal storehouse="A" stock="0"/>
  </team>
  <world href="ring.world.xml"/>
</kitrobot>
"""
FIXTURES = Path(__file__).parent / "fixtures"
EXAMPLE = Path(__file__).parents[2] / "examples" / "transport" / "transport.krt"


def mission(data: bytes = GOOD.encode()) -> Mission:
    found, problems = read_mission(data, "test.krt")
    assert problems == []
    assert found is not None
    return found


def test_a_mission_is_read_as_it_is_written() -> None:
    assert mission() == Mission(
        1,
        [empty_program("carrier", "carrier")],
        Team(
            [Agent("carrier-1", "carrier"), Agent("carrier-2", "carrier", "carrier-1")],
            [Goal("B", "all"), Goal("A", "0")],
        ),
        "ring.world.xml",
    )
    assert write_mission(mission()).decode() == GOOD


def test_an_agent_starts_at_the_start_of_its_name_unless_it_says_another() -> None:
    assert [agent.start_name for agent in mission().team.agents] == ["carrier-1", "carrier-1"]


def test_the_example_is_in_the_true_layout() -> None:
    assert write_mission(mission(EXAMPLE.read_bytes())) == EXAMPLE.read_bytes()


@pytest.mark.parametrize("path", sorted(FIXTURES.glob("*.krt")), ids=lambda path: path.name)
def test_a_mission_of_every_version_ever_written_opens_as_the_newest(path: Path) -> None:
    assert mission(path.read_bytes()).version == 1


def test_a_smallest_mission_is_enough() -> None:
    assert mission(b'<kitrobot version="1"/>') == Mission()
    assert write_mission(Mission()) == b'<kitrobot version="1">\n</kitrobot>\n'


def test_a_newer_version_is_refused_in_a_sentence_and_nothing_is_touched() -> None:
    found, problems = read_mission(GOOD.replace('version="1"', 'version="2"').encode(), "test.krt")
    assert found is None
    assert [problem.code for problem in problems] == ["xml-newer-version"]
    assert "newer KitRobot" in problems[0].help


@pytest.mark.parametrize(
    ("old", "new", "code", "line", "marked", "words"),
    [
        (
            '"carrier-1" program="carrier"',
            '"carrier-1" program="carier"',
            "mission-no-program",
            8,
            "carier",
            "not in this",
        ),
        ('name="carrier-2"', 'name="carrier-1"', "xml-duplicate", 9, "carrier-1", "there already"),
        ('stock="0"', 'stock="-1"', "mission-goal", 11, "-1", "whole number"),
        ('stock="0"', 'stock="65536"', "mission-goal", 11, "65536", "65535"),
        ('stock="0"', 'stock="٣"', "mission-goal", 11, "٣", "whole number"),
        (' storehouse="A"', "", "xml-missing", 11, "<goal", "storehouse"),
        (' program="carrier" start', " start", "xml-missing", 9, "<agent", "program"),
        ('<world href="ring.world.xml"/>', "<world/>", "xml-missing", 13, "<world", "href"),
        ('<goal storehouse="B" stock="all"/>', "<gaol/>", "xml-unknown-element", 10, "<gaol", "gaol"),
    ],
)
def test_a_mistake_is_said_at_its_place(old: str, new: str, code: str, line: int, marked: str, words: str) -> None:
    assert old in GOOD
    text = GOOD.replace(old, new, 1)
    found, problems = read_mission(text.encode(), "test.krt")
    assert found is not None
    assert [problem.code for problem in problems] == [code]
    place = problems[0].place
    assert place is not None
    assert place.line == line
    assert text.split("\n")[line - 1][place.column - 1 : place.end_column - 1] == marked
    assert words in problems[0].message


def test_a_goal_of_the_largest_number_is_right() -> None:
    assert mission(GOOD.replace('stock="0"', 'stock="65535"').encode()).team.goals[1].stock == "65535"


def test_xml_that_we_do_not_know_is_kept_word_for_word() -> None:
    extra = '  <breakpoints><on vertex="v1"/> </breakpoints>\n'
    text = GOOD.replace("</kitrobot>", extra + "</kitrobot>")
    found, problems = read_mission(text.encode(), "test.krt")
    assert [problem.code for problem in problems] == ["xml-unknown-element"]
    assert found is not None
    assert write_mission(found).decode() == text


@given(st.data())
def test_a_damaged_mission_never_escapes_as_an_exception(data: st.DataObject) -> None:
    text = EXAMPLE.read_bytes()
    at = data.draw(st.integers(0, len(text) - 1))
    length = data.draw(st.integers(0, 200))
    found, problems = read_mission(text[:at] + data.draw(st.binary(max_size=4)) + text[at + length :], "w")
    assert found is not None or problems


NAMES = st.text(
    st.characters(codec="utf-8", exclude_categories=["Cc", "Cs"], exclude_characters="\ufffe\uffff"), min_size=1
)


@given(st.lists(st.builds(Agent, NAMES, NAMES, st.one_of(st.just(""), NAMES)), unique_by=lambda agent: agent.name))
def test_any_names_survive_the_file(agents: list[Agent]) -> None:
    made = Mission(team=Team(agents))
    found, _ = read_mission(write_mission(made), "test.krt")
    assert found == made


# ---- saving


def test_saving_keeps_what_was_there_before(tmp_path: Path) -> None:
    path = tmp_path / "a.krt"
    save(path, Mission())
    assert not (tmp_path / "a.krt~").exists()
    assert save(path, mission()) == path.read_bytes() == GOOD.encode()
    assert (tmp_path / "a.krt~").read_bytes() == write_mission(Mission())
    assert sorted(os.listdir(tmp_path)) == ["a.krt", "a.krt~"]


def test_a_save_that_fails_leaves_the_old_file_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.krt"
    save(path, mission())

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(SaveError, match="No space left"):
        save(path, Mission())
    assert path.read_bytes() == GOOD.encode()
    assert os.listdir(tmp_path) == ["a.krt"]


def test_a_folder_that_is_not_there_is_an_error_in_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(SaveError, match="cannot be saved"):
        save(tmp_path / "no" / "a.krt", Mission())


@pytest.mark.skipif(os.name != "posix", reason="links and modes of POSIX")
def test_saving_through_a_link_writes_the_file_it_leads_to_with_its_mode(tmp_path: Path) -> None:
    real = tmp_path / "real.krt"
    save(real, Mission())
    real.chmod(0o640)
    (tmp_path / "link.krt").symlink_to(real)
    save(tmp_path / "link.krt", mission())
    assert (tmp_path / "link.krt").is_symlink()
    assert real.read_bytes() == GOOD.encode()
    assert real.stat().st_mode & 0o777 == 0o640


def test_title_and_what_happens_come_first_one_line_a_language_and_come_back() -> None:
    first = Mission(label={"ur": "چوکور", "": "A <square>"}, help={"fr": "Quatre côtés"})
    data = write_mission(first)
    assert data.decode().splitlines()[1:4] == [
        "  <label>A &lt;square&gt;</label>",
        '  <label xml:lang="ur">چوکور</label>',
        '  <help xml:lang="fr">Quatre côtés</help>',
    ]
    again = mission(data)
    assert (again.label, again.help) == (first.label, first.help)
    assert write_mission(again) == data


def test_a_title_given_twice_in_one_language_is_said_and_the_first_is_kept() -> None:
    data = b'<kitrobot version="1"><label>One</label><label xml:lang="en">Two</label></kitrobot>'
    found, problems = read_mission(data, "test.krt")
    assert found is not None
    assert found.label == {"": "One"}
    assert "already" in problems[0].message
