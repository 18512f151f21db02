"""No output of a command takes the place of a file that the command read, by whatever name; nothing is done before."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import get_type_hints

import pytest

import kitrobot as library
from kitrobot.boards.monitor import record_robots
from kitrobot.cli.app import app
from kitrobot.diagnostics.read_files import OutputPlaceError, expect_outputs, note_read, recording_reads
from kitrobot.files.disk import read_bytes, write_atomic

MISSION = """<kitrobot version="1">
  <program name="p" robot="rover">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wait"><set name="duration">1</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
  <team><agent name="robot-1" program="p" start="west"/></team>
  <world href="yard.world.xml"/>
</kitrobot>
"""
WORLD = """<world version="1" name="yard" width="2000" height="2000">
  <start name="west" x="900" y="900"/>
</world>
"""
EXERCISE = """<exercise version="1" start="begin.krt" seconds="10">
  <label>Wait</label>
  <help>Wait a moment.</help>
  <uses part="Wait" least="1"><label>A wait</label></uses>
</exercise>
"""
CONSTRUCTORS = """<constructors version="1"><group name="Mine" colour="action">
  <constructor name="Nap"><code>WAIT(9)</code></constructor>
</group></constructors>
"""
KIT = '<board name="mine" version="1"><tried how="documents"/><missing device="arm"/></board>\n'


@pytest.fixture
def project(here: Path) -> Path:
    """A mission with everything that it reads beside it."""
    shipped = Path(library.__file__).parent / "primitives" / "shipped" / "mini-robot.robot.xml"
    robot = shipped.read_text().replace('name="mini-robot"', 'name="rover"', 1)
    files = {
        "m.krt": MISSION,
        "base.krt": MISSION.replace(">1<", ">2<"),
        "other.krt": MISSION.replace("robot-1", "robot-2"),
        "begin.krt": MISSION,
        "handed-in.krt": MISSION,
        "yard.world.xml": WORLD,
        "rover.robot.xml": robot,
        "parts.xml": CONSTRUCTORS,
        "wait.exercise.xml": EXERCISE,
        "mine.board.xml": KIT,
        "scrap.board.xml": KIT.replace("mine", "scrap"),
        "p.lll": "WAIT(1);\n",
        "key.txt": "a long random text that nobody guesses, 8201736451\n",
    }
    for name, text in files.items():
        (here / name).write_text(text, encoding="utf-8")
    return here


BESIDE = ("yard.world.xml", "rover.robot.xml", "parts.xml")
RUN = ("run", "m.krt")
GRADE = ("grade", "handed-in.krt", "--exercise", "wait.exercise.xml")
OUTPUTS: dict[tuple[str, str], tuple[tuple[str, ...], tuple[str, ...]]] = {
    # Command and output → the arguments before the output's name, and the files that are read.
    ("run", "trace"): ((*RUN, "--trace"), ("m.krt", *BESIDE)),
    ("run", "drawing"): ((*RUN, "--board", "mine.board.xml", "--drawing"), ("m.krt", "mine.board.xml", *BESIDE)),
    ("run", "picture"): ((*RUN, "--fail-sweep", "2", "--output"), ("m.krt", *BESIDE)),
    ("grade", "csv"): ((*GRADE, "--csv"), ("handed-in.krt", "wait.exercise.xml", "begin.krt", *BESIDE)),
    ("grade", "html"): ((*GRADE, "--html"), ("handed-in.krt", "wait.exercise.xml", "begin.krt", *BESIDE)),
    ("convert", "target"): (
        ("convert", "m.krt"),
        ("m.krt", *BESIDE),
    ),
    ("merge", "output"): (
        ("merge", "base.krt", "m.krt", "other.krt", "--output"),
        ("base.krt", "other.krt", *BESIDE),
    ),
    ("team", "trace"): (("team", "m.krt", "--key", "key.txt", "--trace"), ("m.krt", "key.txt", *BESIDE)),
    ("calibrate", "output"): (
        ("calibrate", "--board", "cutebot", "--output"),
        ("scrap.board.xml",),
    ),
}
NO_BOARD = ("watch", "trace")
"""Asks a robot first; tried below without one."""
ONLY_READ = {
    "after",
    "base",
    "before",
    "drive",
    "exercise",
    "file",
    "files",
    "firmware",
    "inputs",
    "key",
    "mission",
    "ours",
    "parts",
    "points",
    "program",
    "site",
    "source",
    "submissions",
    "theirs",
    "tls",
}
FOLDERS = {("sweep", "output"), ("site", "folder"), ("desktop", "folder"), ("class", "folder"), ("studio", "folder")}
WAYS: dict[str, Callable[[Path], str]] = {
    "its name": lambda path: path.name,
    "through a folder": lambda path: f"sub/../{path.name}",
    "its whole path": lambda path: str(path),
    "a symbolic link": lambda path: linked(path, Path.symlink_to),
    "a hard link": lambda path: linked(path, Path.hardlink_to),
}


def linked(path: Path, link: Callable[[Path, Path], None]) -> str:
    made = path.with_name("link.lll")
    link(made, path)
    return made.name


def test_every_output_of_every_command_is_tried_here():
    found = set()
    for command in app.registered_commands:
        assert command.callback is not None
        for name, annotation in get_type_hints(command.callback, include_extras=True).items():
            if "Path" in str(annotation) and name not in ONLY_READ:
                found.add((command.name, name))
    assert found - FOLDERS <= {*OUTPUTS, NO_BOARD}
    assert {*OUTPUTS, NO_BOARD} <= found


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(("which", "read"), [(which, read) for which, (_, files) in OUTPUTS.items() for read in files])
def test_an_output_over_a_file_that_is_read_is_refused(kitrobot, project, which, read, way):
    (project / "sub").mkdir()
    before = {path: path.read_bytes() for path in project.iterdir() if path.is_file()}
    if which == ("convert", "target") and "link" not in way:
        return  # the ending of the name says which form it is
    words, _ = OUTPUTS[which]
    said = kitrobot(*words, WAYS[way](project / read))
    assert said.status == (2 if which[0] == "merge" else 1), said.err
    assert "it is a file that is read" in said.err
    assert "help: give the output a name of its own" in said.err
    assert {path: path.read_bytes() for path in before} == before
    assert not list(project.glob("*~"))


def test_a_copy_of_what_was_there_takes_no_input_s_place_either(kitrobot, project):
    (project / "m.krt~").write_text(MISSION.replace(">1<", ">7<"))
    before = {path: path.read_bytes() for path in project.iterdir()}
    said = kitrobot("merge", "base.krt", "m.krt", "m.krt~")
    assert said.status == 2
    assert "m.krt~` would be written over, and it is a file that is read" in said.err
    assert {path: path.read_bytes() for path in before} == before


def test_a_name_of_its_own_is_written(kitrobot, project):
    assert kitrobot(*RUN, "--trace", "t.krtrace", "--drawing", "d.svg").status == 0
    assert kitrobot(*GRADE, "--csv", "c.csv", "--html", "h.html").err.startswith("1 of 1")
    # And once more: what was written is no input.
    assert kitrobot(*RUN, "--trace", "t.krtrace", "--drawing", "d.svg").status == 0
    assert kitrobot("merge", "base.krt", "m.krt", "other.krt").status == 0
    assert kitrobot("convert", "p.lll", "p.kri", "--robot", "rover.robot.xml").status == 0
    assert kitrobot("convert", "p.lll", "p.kri", "--robot", "rover.robot.xml").status == 0
    assert kitrobot("format", "p.lll", "--write").status == 0


@pytest.mark.parametrize("words", [(*RUN, "--trace", "a.svg", "--drawing"), (*GRADE, "--csv", "a.svg", "--html")])
def test_two_outputs_are_two_files(kitrobot, project, words):
    said = kitrobot(*words, "./a.svg")
    assert said.status == 1
    assert "two outputs would be written to `a.svg`" in said.err
    assert not (project / "a.svg").exists()


def test_shipped_exercises_are_read_when_none_is_named(kitrobot, project, monkeypatch):
    folder = project / "exercises"
    folder.mkdir()
    for name in ("wait.exercise.xml", "begin.krt"):
        (folder / name).write_bytes((project / name).read_bytes())
    monkeypatch.setattr("kitrobot.classroom.grader_process.examples_folder", lambda: project)
    for name in ("wait.exercise.xml", "begin.krt"):
        said = kitrobot("grade", "handed-in.krt", "--csv", folder / name)
        assert "it is a file that is read" in said.err


def test_a_recording_of_robots_is_not_written_over_their_mission(project):
    with pytest.raises(OutputPlaceError):
        record_robots(project / "m.krt", [], project / "m.krt")


def test_python_does_not_record_over_a_mission_or_what_lies_beside_it(project):
    for name in ("m.krt", "yard.world.xml", "rover.robot.xml"):
        with pytest.raises(OutputPlaceError):
            library.open(project / "m.krt").run(trace=project / name)
    assert (project / "yard.world.xml").read_text() == WORLD


def test_a_file_that_was_replaced_after_it_was_read_is_still_one_that_was_read(here):
    path = here / "a.txt"
    path.write_text("a")
    with recording_reads():
        read_bytes(path)
        other = here / "b.txt"
        other.write_text("b")
        os.replace(other, path)
        with pytest.raises(OutputPlaceError):
            write_atomic(path, b"c")
        write_atomic(path, b"c", before=b"b")
    write_atomic(path, b"d")
    assert path.read_text() == "d"


def test_files_that_are_not_there_are_neither_read_nor_in_the_way(here):
    with recording_reads():
        note_read(here / "none")
        note_read(Path("\0"))
        expect_outputs(here / "none", None, here / "other")
