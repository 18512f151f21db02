"""`kitrobot grade`: a row for each submission, whatever it is, and nothing that one does keeps another from its row."""

from __future__ import annotations

import csv
import io
import json
import multiprocessing
import os
from pathlib import Path

import pytest

from kitrobot.classroom import grader_process
from kitrobot.classroom.grade_tables import as_csv, as_html
from kitrobot.classroom.grades import Grade
from kitrobot.classroom.grading import MOST_BYTES, grade
from kitrobot.mission.writer import write_mission
from kitrobot.translation.languages import LANGUAGES
from tests.exercises.handing_in import exercise_file, handed_in_file, submission
from tests.exercises.solutions import SOLVED, WRONG

SQUARE = exercise_file("03-square")
FOR_EVER = {"a-square": "*[Flag.IsFalse()]( Wheel.Advance(50); WAIT(15); Wheel.Stop(); Motor.AbsoluteTurn(25, 50); );"}
DOCTYPE = '<!DOCTYPE k [<!ENTITY a SYSTEM "secret.txt">]><kitrobot version="1">&a;</kitrobot>'


def nested_calls(depth: int) -> str:
    """A mission for exercise 11 in which each program of the team calls the next one twice."""
    text = write_mission(submission("11-in-step", {})).decode()
    programs = ""
    for n in range(depth):
        calls = "".join(f'<vertex id="v{i}" element="Program"><set name="name">p{n + 1}</set></vertex>' for i in (1, 2))
        arcs = '<arc from="start" to="v1"/><arc from="v1" to="v2"/><arc from="v2" to="stop"/>'
        ends = f'<vertex id="start" element="Start"/>{calls}<vertex id="stop" element="Stop"/>{arcs}'
        name = "drive-in-step" if n == 0 else f"p{n}"
        programs += f'<program name="{name}" level="social">{ends}</program>'
    before, rest = text.split("<program", 1)
    return before + programs + rest.split("</program>", 1)[1]


@pytest.fixture
def classroom(tmp_path: Path) -> Path:
    handed_in_file("03-square", SOLVED["03-square"], tmp_path / "ada.krt")
    handed_in_file("03-square", WRONG["03-square"][0], tmp_path / "ben.krt")
    handed_in_file("03-square", FOR_EVER, tmp_path / "for-ever.krt")
    handed_in_file("12-no-jam", {}, tmp_path / "another.krt")
    handed_in_file("03-square", {}, tmp_path / "untouched.krt")
    (tmp_path / "secret.txt").write_text("the teacher's")
    (tmp_path / "hostile.krt").write_text(DOCTYPE)
    (tmp_path / "cut.krt").write_bytes((tmp_path / "ada.krt").read_bytes()[:300])
    (tmp_path / "empty.krt").write_bytes(b"")
    (tmp_path / "huge.krt").write_bytes(b" " * (MOST_BYTES + 1))
    (tmp_path / "folder.krt").mkdir()
    # A world beside it is no part of it.
    away = (
        (tmp_path / "ada.krt").read_text(encoding="utf-8").replace("</team>", '</team>\n  <world href="w.world.xml"/>')
    )
    (tmp_path / "own-world.krt").write_text(away, encoding="utf-8")
    return tmp_path


def test_every_submission_gets_a_row_and_the_file_that_was_named_is_all_that_is_read(kitrobot, classroom: Path) -> None:
    links = []
    if os.name == "posix":
        (classroom / "link.krt").symlink_to("ada.krt")
        os.mkfifo(classroom / "pipe.krt")
        links = ["link.krt", "pipe.krt"]
    names = ["ada", "ben", "for-ever", "another", "hostile", "cut", "empty", "huge", "folder", "own-world", "none"]
    names.append("untouched")
    files = [classroom / f"{name}.krt" for name in names] + [classroom / name for name in links]
    table, page = classroom / "table.csv", classroom / "table.html"
    said = kitrobot("grade", *files, "--exercise", SQUARE, "--json", "--csv", table, "--html", page)
    assert said.status == 1
    rows = {Path(row["submission"]).name: row for row in said.json}
    assert list(rows) == [path.name for path in files]
    assert (rows["ada.krt"]["points"], rows["ada.krt"]["of"], rows["ada.krt"]["problem"]) == (4, 4, None)
    assert [goal["reached"] for goal in rows["ben.krt"]["goals"]] == [True, False, True, True]
    assert (rows["ben.krt"]["goals"][1]["seed"], rows["ben.krt"]["goals"][1]["seconds"]) == (1, 8.36)
    # What the exercise begins with is no merit by itself.
    assert rows["for-ever.krt"]["points"] == rows["untouched.krt"]["points"] == 0
    assert [goal["condition"] for goal in rows["ada.krt"]["goals"]] == [True, False, False, True]
    assert [goal["earned"] for goal in rows["ben.krt"]["goals"]] == [1, 0, 1, 1]
    assert [goal["reached"] for goal in rows["untouched.krt"]["goals"]] == [True, False, False, True]
    assert rows["own-world.krt"]["points"] == 4
    problems = {name: row["problem"] for name, row in rows.items() if row["problem"]}
    assert problems["another.krt"] == "this is another mission: it has no program `a-square`"
    assert problems["hostile.krt"] == "expected no document type and no entities, found a <!DOCTYPE …>"
    assert problems["huge.krt"] == "it is larger than 1024 kB"
    assert problems["folder.krt"].endswith("it is a folder, not a file")
    assert problems["none.krt"] == "there is no such file"
    assert set(problems) == {*(f"{name}.krt" for name in names[3:9]), "none.krt", *links}
    for name in links:
        assert problems[name].startswith("it could not be read: it is a ")
    assert "teacher's" not in said.out
    told = list(csv.reader(io.StringIO(table.read_text(encoding="utf-8-sig"))))
    assert {len(line) for line in told} == {9}
    assert [line[4:6] for line in told if line[2] == "all"] == [
        ["4", "4"],
        ["3", "4"],
        ["0", "4"],
        ["4", "4"],
        ["0", "4"],
    ]
    html = page.read_text(encoding="utf-8")
    assert "Un carré" in html
    assert "چوکور" in html
    assert "<script" not in html
    assert "no program <code>a-square</code>" in html


def test_without_an_exercise_each_is_judged_by_the_one_whose_programs_it_has(kitrobot, tmp_path: Path) -> None:
    one = handed_in_file("01-first-drive", SOLVED["01-first-drive"], tmp_path / "one.krt")
    two = handed_in_file("02-round-the-corner", SOLVED["02-round-the-corner"], tmp_path / "two.krt")
    said = kitrobot("grade", one, two, "--jobs", "2")
    assert said.status == 0, said
    assert "First drive" in said.out
    assert "Round the corner" in said.out
    assert said.err.endswith("2 of 2 reached every goal\n")


def test_calls_that_double_again_and_again_end_within_the_bounds(tmp_path: Path) -> None:
    (tmp_path / "doubling.krt").write_text(nested_calls(40), encoding="utf-8")
    [row] = grade([tmp_path / "doubling.krt"], exercise_file("11-in-step"), 1)
    assert not row.full
    assert row.problem is not None or all(goal.why["en"] for goal in row.goals if not goal.reached)


def test_an_exercise_with_a_mistake_is_said_with_its_place_before_anything_is_graded(kitrobot, tmp_path: Path) -> None:
    bad = tmp_path / "bad.exercise.xml"
    bad.write_text('<exercise version="1" start="x.krt">\n  <done/>\n</exercise>\n')
    said = kitrobot("grade", tmp_path / "a.krt", "--exercise", bad, "--json")
    assert said.status == 1
    assert f"{bad}:2:3: error: expected a <label> in English in <done>, found none" in said.err
    assert json.loads(said.out)["error"]["diagnostics"]
    bad.write_text('<exercise version="1" start="x.krt"><label>E</label><done><label>D</label></done></exercise>')
    assert "there is no mission `x.krt` beside this exercise" in kitrobot("grade", "a.krt", "--exercise", bad).err


def test_what_comes_from_files_is_escaped_in_the_page_and_no_formula_in_the_spreadsheet() -> None:
    told = dict.fromkeys(LANGUAGES, "<b>&")
    rows = [Grade("=cmd()<script>.krt", {}, problem=told)]
    assert "<script>" not in as_html(rows)
    assert "&lt;b&gt;&amp;" in as_html(rows)
    assert "\n'=cmd()<script>.krt," in as_csv(rows).replace("\r\n", "\n")


def allocate(connection) -> None:
    grader_process.limit()
    try:
        size = len(bytearray((grader_process.MOST_MEMORY_MB + 1) * 1024 * 1024))
    except MemoryError:
        size = -1
    try:
        Path("written-by-a-submission").write_bytes(b"x")
        written = True
    except OSError:
        written = False
    connection.send((size, written))


@pytest.mark.skipif(not hasattr(os, "sched_getaffinity"), reason="only Linux bounds the memory of a process")
def test_the_process_of_a_submission_gets_no_more_memory_and_writes_no_file(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=allocate, args=(theirs,))
    process.start()
    theirs.close()
    assert ours.recv() == (-1, False)
    process.join()
    assert (tmp_path / "written-by-a-submission").stat().st_size == 0
