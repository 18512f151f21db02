"""`kitrobot class FOLDER --marks`: a file in the folder, and no class that opens."""

from __future__ import annotations

import pytest

from kitrobot.classroom.marks import Mark
from kitrobot.classroom.record import ClassRecord, PupilRecord, write_record


@pytest.fixture
def folder(here):
    made = here / "Class 5b"
    made.mkdir()
    pupils = [PupilRecord("آدا", "آدا", "WORD", marks=[Mark("x", "Square", 3, 5)]), PupilRecord("Ben", "Ben", "WORD")]
    write_record(made, ClassRecord("Class 5b", pupils=pupils))
    return made


def test_marks_are_written_for_a_gradebook(kitrobot, folder):
    (folder / "gradebook.csv").write_text("Student,ID,Section\nBen,4,5b\n")
    before = (folder / "class.toml").read_bytes()
    said = kitrobot("class", folder, "--marks", "canvas")
    assert (said.status, said.out) == (0, f"{folder / 'marks-canvas.csv'}\n")
    assert "is not in `gradebook.csv`" in said.err
    written = (folder / "marks-canvas.csv").read_bytes()
    assert written.startswith(b"\xef\xbb\xbfStudent,ID,")
    assert written.decode("utf-8-sig").splitlines()[2:] == ["آدا,,,,,3", "Ben,4,,,5b,"]
    assert (folder / "class.toml").read_bytes() == before


def test_a_gradebook_that_is_not_known_or_a_folder_without_a_class_is_a_sentence(kitrobot, folder, here):
    said = kitrobot("class", folder, "--marks", "=cmd")
    assert said.status != 0
    assert "moodle, canvas or sheet" in said.err
    for wrong in (here, here / "none"):
        said = kitrobot("class", wrong, "--marks", "moodle")
        assert said.status != 0
        assert "class.toml" in said.err
    assert not (here / "none").exists()
    (folder / "gradebook.csv").write_text("=1,2\n")
    said = kitrobot("class", folder, "--marks", "moodle")
    assert (said.status != 0, "gradebook.csv" in said.err) == (True, True)


def test_a_class_without_marks_says_how_to_get_them(kitrobot, here):
    write_record(here, ClassRecord("Empty"))
    said = kitrobot("class", here, "--marks", "sheet")
    assert said.status == 0
    assert "press Grade" in said.err
