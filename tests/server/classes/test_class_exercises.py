"""Exercises of a class: those that come with KitRobot and those of the teacher's own; grading."""

from __future__ import annotations

from dataclasses import replace

from kitrobot.classroom.assignments import unpack
from tests.patience import PATIENCE_S
from tests.server.classes.conftest import KEY, SOCKET, SQUARE, hand_in, told


def put_own_exercise(school, name: str = "mine") -> None:
    """An exercise of the teacher's own in the folder of the class, with a world of its own beside it."""
    teacher = school.teacher()
    start = teacher.get("/api/mission", params={"path": "example:exercises/03-square.krt"}).json()["mission"]
    text = teacher.post("/api/mission/text", json={"mission": start}).json()["text"]
    (school.room.folder / f"{name}.krt").write_text(text)
    (school.room.folder / f"{name}.exercise.xml").write_text(
        f'<exercise version="1" start="{name}.krt"><label>My own</label><done><label>It ends</label></done></exercise>'
    )
    (school.room.folder / "yard.world.xml").write_text("<world/>")


def test_an_exercise_of_the_teachers_own_reaches_every_pupil_and_is_graded(school):
    put_own_exercise(school)
    teacher = school.teacher()
    ada, _ = school.join("Ada")
    ada.get("/api/exercises")  # The studio of one pupil is there before, of the other is not.
    assert teacher.post("/api/class/teacher/exercise", json={"exercise": "mine.exercise.xml"}).status_code == 200
    name = "Handed out/mine/mine.exercise.xml"
    assert school.room.record.exercise == name
    ben, _ = school.join("Ben")
    for pupil in (ada, ben):
        found = next(one for one in pupil.get("/api/exercises").json() if one["name"] == name)
        assert found["start"] == "Handed out/mine/mine.krt"
        opened = pupil.get("/api/mission", params={"path": found["start"]}).json()
        # It is begun with, and never written over.
        refused = pupil.put(
            "/api/mission",
            json={"path": found["start"], "revision": opened["revision"], "mission": opened["mission"]},
        )
        assert refused.status_code == 403, refused.text
        judged = pupil.post("/api/exercise/judge", json={"exercise": name, "mission": opened["mission"], "seed": 1})
        assert judged.status_code == 200, judged.text
    assert (school.room.folder / ".studios" / "Ben" / "Handed out" / "mine" / "yard.world.xml").is_file()
    # What the teacher writes on reaches pupils when it is chosen again; grading uses what they have.
    hand_in(ada, opened["mission"], "mine")
    assert teacher.post("/api/class/teacher/grade", json={}).json() == 1
    school.app.grading.wait(PATIENCE_S)
    assert (school.room.folder / "grades.csv").is_file()
    own = school.room.folder / "mine.exercise.xml"
    own.write_text(own.read_text().replace("My own", "My second"))
    teacher.post("/api/class/teacher/exercise", json={"exercise": "mine.exercise.xml"})
    labels = [list(one["label"].values()) for one in ada.get("/api/exercises").json() if one["name"] == name]
    assert labels == [["My second"]]


def test_a_wrong_exercise_of_the_teachers_own_is_a_sentence(school):
    teacher = school.teacher()
    put_own_exercise(school)
    school.join("Ada")

    def choose(name: str) -> tuple[int, str]:
        said = teacher.post("/api/class/teacher/exercise", json={"exercise": name})
        return said.status_code, said.json()["message"]

    folder = school.room.folder
    for path in ("mine.exercise.xml", "mine.krt"):
        (folder / "Ada" / path).write_bytes((folder / path).read_bytes())
    assert choose("Ada/mine.exercise.xml") == (422, "This exercise lies in the folder of a pupil.")
    for at in range(60):
        (folder / f"w{at}.world.xml").write_text("<world/>")
    status, message = choose("mine.exercise.xml")
    assert (status, "50 files" in message) == (422, True)
    (folder / "mine.krt").unlink()
    assert choose("mine.exercise.xml") == (422, "This exercise cannot be used any more.")
    assert school.room.record.exercise == ""
    assert not (folder / "Handed out" / "mine").exists()


def test_the_exercise_and_what_is_handed_out_must_be_usable(school):
    teacher = school.teacher()
    for name in ("example:exercises/nothing.exercise.xml", "../x.exercise.xml", "x"):
        assert teacher.post("/api/class/teacher/exercise", json={"exercise": name}).status_code in (403, 422)
    (school.room.folder / "broken.krt").write_text("<kitrobot")
    for path in ("broken.krt", "nothing.krt", "../x.krt", ".studios/x.krt"):
        assert teacher.post("/api/class/teacher/hand-out", json={"path": path}).status_code in (403, 404, 422)
    assert teacher.post("/api/class/teacher/grade", json={}).json()["message"] == "The class has no exercise."


def test_the_class_is_graded_with_its_exercise(school):
    teacher = school.teacher()
    start = teacher.get("/api/mission", params={"path": "example:exercises/03-square.krt"}).json()["mission"]
    ada, _ = school.join("Ada")
    hand_in(ada, start, "square")
    teacher.post("/api/class/teacher/exercise", json={"exercise": SQUARE})
    assert teacher.post("/api/class/teacher/grade", json={}).json() == 1
    with teacher.websocket_connect(f"{SOCKET}/api/class/teacher/watch?token={KEY}") as socket:
        school.app.grading.wait(PATIENCE_S)
        while not told(socket, "class")["grading"]["page"]:
            pass
    assert "Ada" in teacher.get("/api/class/teacher/grades").text
    assert (school.room.folder / "grades.csv").read_text("utf-8-sig").splitlines()[1].startswith("Ada,")
    marks_reach_the_gradebook(teacher, school)
    another_exercise_is_another_column(teacher, school)


def marks_reach_the_gradebook(teacher, school) -> None:
    (mark,) = school.room.pupils["Ada"].record.marks
    assert (mark.exercise, mark.points) == (SQUARE, 0)
    ben, _ = school.join("Ben")
    wanted = {"folder": "Ada", "exercise": SQUARE, "text": "=Well\n\tdone"}
    assert ben.post("/api/class/teacher/comment", json=wanted).status_code == 403
    for wrong in ({"text": "x" * 501}, {"folder": "../Ada"}, {"exercise": "none"}):
        assert teacher.post("/api/class/teacher/comment", json={**wanted, **wrong}).status_code == 422
    assert teacher.post("/api/class/teacher/comment", json=wanted).json() is True
    assert school.room.pupils["Ada"].record.marks == [replace(mark, comment="=Well done")]
    (school.room.folder / "gradebook.csv").write_text("First name,Last name,Email address\nAda,King,ada@x\n")
    found = teacher.get("/api/class/teacher/marks", params={"gradebook": "moodle"}).json()
    assert (found["name"], found["exercises"], found["listed"], found["unlisted"]) == (
        *("marks-moodle.csv", 1, True),
        ["Ben"],
    )
    assert found["text"].splitlines()[1:] == ["ada@x,Ada King,0,'=Well done", "? Ben,Ben,-,"]
    assert teacher.get("/api/class/teacher/marks", params={"gradebook": "../x"}).status_code == 422
    the_list_of_a_gradebook_comes_in(teacher, ben, school.room.folder / "gradebook.csv")
    (school.room.folder / "gradebook.csv").write_text("1,2\n")
    refused = teacher.get("/api/class/teacher/marks", params={"gradebook": "canvas"})
    assert refused.status_code == 422
    assert "gradebook.csv" in refused.json()["message"]
    (school.room.folder / "gradebook.csv").unlink()


def the_list_of_a_gradebook_comes_in(teacher, ben, path) -> None:
    address = "/api/class/teacher/gradebook"
    before = path.read_bytes()
    for wrong, why in (
        (b"1,2\n", "names no column"),
        (b"", "names no column"),
        (b"Name\n", "no pupils"),
        (b"PK\x03\x04" + bytes(100), "spreadsheet"),
        (bytes(range(256)), "cannot be used"),
    ):
        refused = teacher.put(address, content=wrong)
        assert refused.status_code == 422
        assert why in refused.json()["message"]
        assert path.read_bytes() == before
    assert teacher.put(address, content=b"Name\n" + b"x" * 4_200_000).status_code == 413
    assert path.read_bytes() == before
    assert ben.put(address, content=b"Name\nAda\n").status_code == 403
    wanted = "\ufeffStudent;Email\nKing, Ada;a@x\nBen;b@x\n".encode()
    assert teacher.put(address, content=wanted).json() == {"pupils": 2, "unlisted": []}
    assert path.read_bytes() == wanted
    assert teacher.put(address, content=b"Name\nAda\n").json() == {"pupils": 1, "unlisted": ["Ben"]}
    path.unlink()
    assert teacher.put(address, content=wanted).status_code == 200
    assert path.stat().st_mode & 0o077 == 0


def another_exercise_is_another_column(teacher, school) -> None:
    put_own_exercise(school)
    teacher.post("/api/class/teacher/exercise", json={"exercise": "mine.exercise.xml"})
    teacher.post("/api/class/teacher/grade", json={})
    school.app.grading.wait(PATIENCE_S)
    head, *lines = teacher.get("/api/class/teacher/marks", params={"gradebook": "sheet"}).json()["text"].splitlines()
    assert head.startswith("\ufeffName,")
    assert "My own (max " in head
    assert [len(line.split(",")) for line in lines] == [5, 5]


def test_pupils_get_nothing_of_an_exercise_that_is_hidden(school):
    """Neither a page with Python in it, nor the studio of a pupil on the teacher's computer; grading has it all."""
    put_own_exercise(school)
    own = school.room.folder / "mine.exercise.xml"
    hidden = '<!-- a secret --><seed value="1"/><seed value="4711" hidden="yes"/>'
    hidden += '<uses part="Repetition" hidden="yes"><label>A secret repetition</label></uses></exercise>'
    own.write_text(own.read_text().replace("</exercise>", hidden))
    teacher = school.teacher()
    ada, _ = school.join("Ada")
    assert teacher.post("/api/class/teacher/exercise", json={"exercise": "mine.exercise.xml"}).status_code == 200
    files = unpack(ada.get("/api/class/exercise").content)
    assert set(files) == {"mine.exercise.xml", "mine.krt", "yard.world.xml"}
    ada.get("/api/exercises")
    beside = school.room.folder / ".studios" / "Ada" / "Handed out" / "mine" / "mine.exercise.xml"
    for text in (files["mine.exercise.xml"], beside.read_bytes()):
        assert b"It ends" in text
        for word in (b"secret", b"4711", b"hidden", b"Repetition"):
            assert word not in text
    judged = ada.post(
        "/api/exercise/judge",
        json={
            "exercise": "Handed out/mine/mine.exercise.xml",
            "mission": ada.get("/api/mission", params={"path": "Handed out/mine/mine.krt"}).json()["mission"],
            "seed": 1,
        },
    )
    assert len(judged.json()["goals"]) == 1
    hand_in(ada, judged.json()["mission"], "mine")
    teacher.post("/api/class/teacher/grade", json={})
    school.app.grading.wait(PATIENCE_S)
    assert "A secret repetition" in (school.room.folder / "grades.csv").read_text("utf-8-sig")
