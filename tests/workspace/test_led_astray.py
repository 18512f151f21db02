"""True mistakes whose sentence led astray: each is told where it is, with a way out, and nothing is said beside it."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

import pytest

from kitrobot.classroom.grade_tables import as_cell
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.files import listing
from kitrobot.files.folder import MissionFolder
from kitrobot.files.listing import MOST_LISTED
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import SaveError, save
from kitrobot.server.routes.mission_encoding import UnsavableError, mission_bytes
from kitrobot.text.forms import conflict_mark
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.wire.sentences import clause, spoken
from kitrobot.workspace.file_check import check_file
from kitrobot.workspace.mission_loader import new_mission, open_mission, with_mission
from kitrobot.workspace.search_path import SearchPath

PROGRAM = """  <program name="p" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="w" element="Wait"><set name="duration">5</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="w"/>
    <arc from="w" to="stop"/>
  </program>
"""
ONE = """  <team><agent name="a" program="p" start="robot-1"/></team>
"""
TWO = """  <team><agent name="a" program="p"/><agent name="b" program="p"/></team>
"""
WORLD = """  <world version="1" name="y" width="3000" height="2000">
    <start name="a" x="{x}" y="1000"/>
    <start name="b" x="1010" y="1000"/>{more}
    <wall x1="2990" y1="0" x2="2990" y2="2000"/>
  </world>
"""


def mission(*parts: str) -> bytes:
    return ('<kitrobot version="1">\n' + "".join(parts) + "</kitrobot>\n").encode()


def found_in(tmp_path: Path, data: bytes, name: str = "m.krt") -> list[Diagnostic]:
    path = tmp_path / name
    path.write_bytes(data)
    return list(check_file(path).diagnostics)


def only(found: list[Diagnostic]) -> tuple[str, str, int]:
    assert len(found) == 1, [one.message for one in found]
    place = found[0].place
    return found[0].message, found[0].help, place.line if place is not None else 0


@pytest.mark.parametrize("name", ["m.krt", "m.lll", "m.kra", "m.xml", "m.world.xml"])
@pytest.mark.parametrize("count", [1, 2, 512, 2000])
def test_a_file_of_zero_bytes_has_no_text_and_its_copy_is_named(tmp_path: Path, name: str, count: int) -> None:
    message, help, _ = only(found_in(tmp_path, b"\0" * count, name))
    assert f"only {count} bytes that are zero" in message
    assert f"{name}~" in help


def test_a_file_whose_end_is_zero_was_not_written_to_its_end(tmp_path: Path) -> None:
    _, help, _ = only(found_in(tmp_path, mission(PROGRAM)[:-30] + b"\0" * 30))
    assert "~" in help


def test_an_empty_file_points_to_its_copy(tmp_path: Path) -> None:
    message, help, _ = only(found_in(tmp_path, b""))
    assert "empty" in message
    assert "~" in help


MARKS = "<<<<<<< ours\n{}=======\n{}>>>>>>> theirs\n"


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_a_merge_that_was_not_finished_is_called_that(tmp_path: Path, end: str) -> None:
    text = mission(PROGRAM, MARKS.format(TWO, TWO)).decode()
    message, help, line = only(found_in(tmp_path, text.replace("\n", end).encode()))
    assert "a merge was not finished here" in message
    assert "kitrobot merge" in help
    assert text.split("\n")[line - 1].startswith("<<<<<<<")


def test_a_merge_that_was_not_finished_in_a_text(tmp_path: Path) -> None:
    text = "WAIT(1);\n" + MARKS.format("WAIT(2);\n", "WAIT(3);\n")
    message, _, line = only(found_in(tmp_path, text.encode(), "m.lll"))
    assert ("a merge was not finished here" in message, line) == (True, 2)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("a;\n<<<<<<< HEAD\nb;\n", 2),
        ("a;\n=======\nb;\n>>>>>>> theirs\n", 2),
        ("a;\n>>>>>>> said somebody\n", None),
        ("a;\n=======\n", None),
        ("a <<<<<<< b\n<<<<<<<<<<\n", None),
    ],
)
def test_marks_of_a_merge_are_those_that_git_leaves(text: str, line: int | None) -> None:
    mark = conflict_mark(text)
    assert (None if mark is None else text.count("\n", 0, mark) + 1) == line


@pytest.mark.parametrize("number", ["2.5", "abc", "-1", ""])
def test_a_number_that_is_none_has_no_remark_on_another_one(tmp_path: Path, number: str) -> None:
    looped = PROGRAM.replace("Wait", "Repetition").replace("duration", "count").replace(">5<", f">{number}<")
    looped = looped.replace(
        '    <arc from="w" to="stop"/>',
        '    <vertex id="b" element="Wheel.Stop"/>\n    <arc from="w" out="body" to="b"/>\n'
        '    <arc from="b" to="w" at="return"/>\n    <arc from="w" to="stop"/>',
    )
    message, _, _ = only(found_in(tmp_path, mission(looped, ONE)))
    assert "expected a whole number" in message


def test_starts_that_are_too_near_are_told_there(tmp_path: Path) -> None:
    message, help, line = only(found_in(tmp_path, mission(PROGRAM, TWO, WORLD.format(x=1000, more=""))))
    assert message == "a and b start in the same place"
    assert help == "move one of the two: their starts are a and b"
    assert line == 12
    message, _, line = only(found_in(tmp_path, mission(PROGRAM, TWO, WORLD.format(x=2989, more=""))))
    assert (message, line) == ("a starts in a wall", 11)


def test_a_world_that_fell_out_is_not_the_empty_one(tmp_path: Path) -> None:
    data = mission(PROGRAM, TWO, WORLD.format(x=100, more='\n    <start name="c" x="1" y="1" heading="-450"/>'))
    message, _, line = only(found_in(tmp_path, data))
    assert "heading" in message
    assert line == 13
    # What the page has of it is no mission in the empty world either.
    made, _ = read_mission(data, "m.krt")
    assert made is not None
    report = with_mission(made, "m.krt", SearchPath(tmp_path)).check()
    assert [one.message for one in report.problems] == ["the mission's own world has a mistake"]


@pytest.mark.parametrize(
    ("breakpoint", "says"),
    [
        ('program="gone" vertex="w"', "the program `gone`, which is not in this mission"),
        ('program="p" vertex="gone"', "at `gone`, which is not in the program `p`"),
    ],
)
def test_a_breakpoint_that_no_run_comes_to_is_told(tmp_path: Path, breakpoint: str, says: str) -> None:
    found = found_in(tmp_path, mission(PROGRAM, ONE, f"  <breakpoint {breakpoint}/>\n"))
    message, _, line = only(found)
    assert says in message
    assert line == 10
    assert not found[0].is_error
    assert found_in(tmp_path, mission(PROGRAM, ONE, '  <breakpoint program="p" vertex="w"/>\n')) == []


def test_a_breakpoint_that_watches_nobody_is_told(tmp_path: Path) -> None:
    watched = '<breakpoint program="p" vertex="w"><agent name="c"/></breakpoint>\n'
    message, _, _ = only(found_in(tmp_path, mission(PROGRAM, ONE, watched)))
    assert "`c`, which is not in the team" in message


def test_a_name_keeps_its_first_letter_in_the_page() -> None:
    assert spoken(Sentence("{path} cannot be saved", "new.krt")) == "`new.krt` cannot be saved."
    assert spoken(Sentence("the file {path} cannot be saved", "new.krt")) == "The file new.krt cannot be saved."
    assert clause(Sentence("{agent} waits", "ada")) == "`ada` waits"
    assert clause(Sentence("{agent} waits", "Ada")) == "Ada waits"
    assert clause(Sentence("{names} wait", Series(COMMA, ["ada", "ben"]))) == "`ada`, ben wait"
    assert clause(Sentence("{what} makes no sense", Sentence("the list"))) == "the list makes no sense"
    assert clause("a plain text") == "a plain text"
    assert spoken("a plain text") == "A plain text."


def test_a_folder_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(SaveError, match=r"`new\.krt` cannot be saved: there is no folder `sub`") as raised:
        save(tmp_path / "sub" / "new.krt", Mission())
    assert raised.value.help == "make the folder first"


@pytest.mark.parametrize("letters", ["x", "é", "آ", "😀"])
def test_a_name_of_255_bytes_is_saved_as_often_as_one_likes(tmp_path: Path, letters: str) -> None:
    stem = letters * (251 // len(letters.encode()))
    path = tmp_path / f"{stem}{'x' * (251 - len(stem.encode()))}.krt"
    assert len(os.fsencode(path.name)) == 255
    save(path, Mission())
    save(path, Mission(label={"": "again"}))
    assert b"again" in path.read_bytes()
    assert os.listdir(tmp_path) == [path.name]
    short = tmp_path / f"{'x' * 250}.krt"
    save(short, Mission())
    save(short, Mission())
    assert len(os.listdir(tmp_path)) == 3, "one that is shorter by a letter has its copy"


@pytest.mark.parametrize("href", ["x" * 5000, "x" * 300 + ".world.xml", "a/" * 3000 + "b", "é" * 200])
def test_a_world_whose_name_no_system_has_is_not_there_and_the_mission_opens(tmp_path: Path, href: str) -> None:
    made = new_mission()
    made.world_href = href
    path = tmp_path / "m.krt"
    save(path, made)
    opened = open_mission(path)
    assert opened.mission.world_href == href
    assert [one.code for one in opened.diagnostics] == ["mission-no-world"]


def test_the_file_of_a_world_is_found_in_whatever_form_its_name_is(tmp_path: Path) -> None:
    composed, apart = "\u00e9.world.xml", "e\u0301.world.xml"
    empty = '<world version="1" name="y" width="100" height="100"/>'
    for file, href in ((composed, apart), (apart, composed), (apart, apart)):
        folder = tmp_path / f"{len(file)}{len(href)}"
        folder.mkdir()
        (folder / file).write_text(empty)
        made = new_mission()
        made.world_href = href
        save(folder / "m.krt", made)
        assert open_mission(folder / "m.krt").world is not None


def test_what_would_not_open_is_not_made_a_file() -> None:
    assert mission_bytes(new_mission(), "m.krt")
    with pytest.raises(UnsavableError):
        mission_bytes(Mission(), "m.krt")
    for unknown in ("<a", "</kitrobot>", "<a></b>", "&b;"):
        with contextlib.suppress(UnsavableError):
            data = mission_bytes(Mission(programs=new_mission().programs, unknown=[unknown]), "m.krt")
            found, _ = read_mission(data, "m.krt")
            assert found is not None
            assert found.programs == new_mission().programs


@pytest.mark.parametrize(
    ("cell", "safe"),
    [
        ("=1+1", "'=1+1"),
        ("Ada;=HYPERLINK(1)", "Ada;'=HYPERLINK(1)"),
        ("Ada; +1", "Ada; '+1"),
        ("Ada\t@x", "Ada\t'@x"),
        ('Ada;"=1"', 'Ada;"\'=1"'),
        ("a,-1", "a,'-1"),
        ("a\n=1", "a\n'=1"),
        ("＝1", "'＝1"),
        ("Ada-Marie = 1", "Ada-Marie = 1"),
        (-5, -5),
    ],
)
def test_no_cell_becomes_a_formula_wherever_a_spreadsheet_parts_it(cell: object, safe: object) -> None:
    assert as_cell(cell) == safe


@pytest.mark.parametrize("seconds", [10**12, -(10**12), 253402300800, 0])
def test_a_file_of_any_moment_is_listed(tmp_path: Path, seconds: int) -> None:
    path = tmp_path / "m.krt"
    path.write_bytes(mission(PROGRAM))
    try:
        os.utime(path, (seconds, seconds))
    except (OSError, OverflowError):
        return  # this file system has no such moment
    [entry] = [one for one in MissionFolder(tmp_path).missions() if not one.example]
    assert entry.path == "m.krt"
    assert len(entry.modified) == len("2026-01-01T00:00:00+00:00")


def test_of_very_many_files_it_is_said_how_many_are_not_listed(tmp_path: Path) -> None:
    for number in range(MOST_LISTED + 3):
        (tmp_path / f"{number:04}.krt").touch()
        if number == MOST_LISTED - 1:
            assert all(one.path for one in MissionFolder(tmp_path).missions())
    own = [one for one in MissionFolder(tmp_path).missions() if not one.example]
    assert len(own) == MOST_LISTED + 1
    assert (own[-1].path, own[-2].path) == ("", f"{MOST_LISTED - 1:04}.krt")
    assert own[-1].problem.startswith("3 more files are not listed")


def test_of_a_folder_with_very_much_it_is_said_from_where_on_nothing_was_looked_at(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in "abc":
        (tmp_path / name / "inner").mkdir(parents=True)
        (tmp_path / name / "inner" / "m.krt").touch()
    monkeypatch.setattr(listing, "MOST_LOOKED_AT", 6)
    own = [one for one in MissionFolder(tmp_path).missions() if not one.example]
    assert [one.path for one in own] == ["a/inner/m.krt", "b/inner/m.krt", ""]
    assert "folders from `c/inner` on were not looked through" in own[-1].problem
