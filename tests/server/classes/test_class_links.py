"""Links that open an exercise of a class, and which file is the work for which exercise."""

from __future__ import annotations

from urllib.parse import parse_qs, urlsplit

import pytest

from kitrobot.classroom.assignments import unpack
from kitrobot.classroom.overview import JoinAddress
from kitrobot.classroom.record import ClassRecord, read_record
from tests.patience import PATIENCE_S
from tests.server.classes.conftest import HOST, SQUARE, hand_in
from tests.server.classes.test_class_exercises import put_own_exercise

LINE = "example:exercises/08-follow-the-line.exercise.xml"
OWN = "Handed out/mine/mine.exercise.xml"


def link(school, exercise: str):
    return school.teacher().post("/api/class/teacher/link", json={"exercise": exercise})


def brought(address: str) -> dict[str, list[str]]:
    return parse_qs(urlsplit(address).fragment, strict_parsing=True)


def test_a_link_names_exercise_class_and_code_behind_the_sign_that_no_server_sees(school):
    made = link(school, SQUARE).json()
    assert made["address"].startswith(f"{HOST}/#exercise=example:exercises/03-square.exercise.xml&")
    found = {"exercise": [SQUARE], "class": ["Class 5b"], "code": [school.room.record.code]}
    assert brought(made["address"]) == found
    assert "%20" in made["address"], "a space as `+` is lost where a link is copied by hand"
    assert set("".join(made["qr"])) == {"0", "1"}
    assert {len(row) for row in made["qr"]} == {len(made["qr"])}
    # While nobody can join it opens for those who are in.
    school.teacher().post("/api/class/teacher/code", json={"on": False})
    assert brought(link(school, SQUARE).json()["address"]).keys() == {"exercise", "class"}


@pytest.mark.parametrize("name", ["5b & c#1?", "صف", "a=b+c", "100 %"])
def test_any_name_of_a_class_comes_back_from_a_link(name: str):
    reach = JoinAddress("http://192.168.4.20:8765/", (), "")
    address = reach.link(ClassRecord(name, "ABCDEF"), OWN)
    assert brought(address) == {"exercise": [OWN], "class": [name], "code": ["ABCDEF"]}
    assert address.isascii()


def test_a_link_to_an_own_exercise_hands_it_out_and_leaves_that_of_the_class(school):
    put_own_exercise(school)
    ada, _ = school.join("Ada")
    assert ada.get("/api/class/exercise", params={"name": OWN}).status_code == 204
    assert brought(link(school, "mine.exercise.xml").json()["address"])["exercise"] == [OWN]
    assert school.room.record.exercise == ""
    packed = ada.get("/api/class/exercise", params={"name": OWN})
    assert set(unpack(packed.content)) == {"mine.exercise.xml", "mine.krt", "yard.world.xml"}
    assert ada.get("/api/class/exercise").status_code == 204
    # A studio on the teacher's machine takes it as one in a page does.
    assert ada.put("/api/handed-out", params={"exercise": OWN}, content=packed.content).json() is True
    assert OWN in [one["name"] for one in ada.get("/api/exercises").json()]


@pytest.mark.parametrize("name", ["", "x", "../x.exercise.xml", "example:exercises/none.exercise.xml", "Handed out/x"])
def test_a_link_to_no_exercise_is_a_sentence(school, name: str):
    refused = link(school, name)
    assert refused.status_code in (403, 404, 422)
    assert refused.json()["message"]


def test_links_are_made_for_the_teacher_alone_and_files_only_of_what_was_handed_out(school):
    ada, _ = school.join("Ada")
    assert ada.post("/api/class/teacher/link", json={"exercise": SQUARE}).status_code == 403
    (school.room.folder / "Ada" / "secret.krt").write_text("x")
    for name in ("Handed out/../x", "Ada/x.exercise.xml", "../../x/y", "class.toml", "Handed out/a\0b/x", SQUARE):
        assert ada.get("/api/class/exercise", params={"name": name}).status_code == 204
    assert school.client().get("/api/class/exercise", params={"name": OWN}).status_code == 403


def for_exercise(pupil, mission, name: str, exercise: str, base: str = ""):
    wanted = {"name": name, "base": base, "mission": mission, "exercise": exercise}
    said = pupil.put("/api/class/work", json=wanted)
    assert said.status_code == 200, said.text
    return said.json()


def works(pupil) -> dict[str, str]:
    return {one["name"]: one["exercise"] for one in pupil.get("/api/class/work").json()}


def test_the_work_for_an_exercise_is_known_also_when_the_class_begins_anew(school, mission):
    ada, _ = school.join("Ada")
    kept = for_exercise(ada, mission, "square", SQUARE)
    for_exercise(ada, mission, "line", LINE)
    hand_in(ada, mission, "other")
    for_exercise(ada, mission, "wrong", "example:exercises/none.exercise.xml")
    for_exercise(ada, mission, "wrong", "../../etc/passwd")
    known = {"square.krt": SQUARE, "line.krt": LINE, "other.krt": "", "wrong.krt": ""}
    assert works(ada) == known
    # What goes on from it stays the work for it; another file for it takes its place, and neither overwrites.
    again = for_exercise(ada, {**mission, "world": "w.world.xml"}, "square", SQUARE, kept["revision"])
    assert again["name"] == "square.krt"
    assert for_exercise(ada, mission, "square", SQUARE)["name"] == "square 2.krt"
    assert works(ada) == {**known, "square.krt": "", "square 2.krt": SQUARE}
    record = read_record(school.room.folder)
    assert record is not None
    assert record.pupils[0].works == {LINE: "line.krt", SQUARE: "square 2.krt"}


@pytest.mark.parametrize("works", ['"x"', "[1]", "{ a = 1 }", '{ a = "../b.krt" }'])
def test_works_that_make_no_sense_leave_that_pupil_out(tmp_path, works: str):
    pupil = '[[pupil]]\nname = "{0}"\nfolder = "{0}"\nword = "ABCDEF"\n'
    text = 'name = "5b"\n' + pupil.format("Ada") + f"works = {works}\n" + pupil.format("Ben")
    (tmp_path / "class.toml").write_text(text)
    record = read_record(tmp_path)
    assert record is not None
    assert [one.name for one in record.pupils] == ["Ben"]
    assert "`works` makes no sense" in record.unread[0].reason


def test_the_class_grades_what_was_handed_in_for_its_exercise(school):
    teacher = school.teacher()
    start = teacher.get("/api/mission", params={"path": "example:exercises/03-square.krt"}).json()["mission"]
    ada, _ = school.join("Ada")
    for_exercise(ada, start, "square", SQUARE)
    for_exercise(ada, start, "line", LINE)
    ben, _ = school.join("Ben")
    for_exercise(ben, start, "line", LINE)
    cem, _ = school.join("Cem")
    hand_in(cem, start, "something")
    pupils = school.room.pupils
    assert [school.room.work_for(pupils[one], SQUARE) for one in ("Ada", "Ben", "Cem")] == [
        "square.krt",
        "",
        "something.krt",
    ]
    teacher.post("/api/class/teacher/exercise", json={"exercise": SQUARE})
    assert teacher.post("/api/class/teacher/grade", json={}).json() == 2
    school.app.grading.wait(PATIENCE_S)
    assert {one.record.name: len(one.record.marks) for one in pupils.values()} == {"Ada": 1, "Ben": 0, "Cem": 1}
