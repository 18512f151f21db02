"""A class over HTTP: the pupil's and the teacher's paths."""

from __future__ import annotations

import io
import zipfile

import pytest
from starlette.websockets import WebSocketDisconnect

from kitrobot.server.classroom.app import create_class_app
from tests.server.classes.conftest import HOST, KEY, REACH, SOCKET, SQUARE, WORLD, hand_in, told
from tests.server.conftest import TestClient


def test_the_pages_say_whom_they_are_for(school):
    client = school.client()
    assert '<meta name="kitrobot-class" content="pupil">' in client.get("/").text
    assert '<meta name="kitrobot-class" content="teacher">' in client.get("/teacher").text
    assert "kitrobot-class" not in client.get("/studio").text
    answer = client.get("/assets/page.js")
    assert answer.status_code == 200
    assert "default-src 'self'" in client.get("/").headers["content-security-policy"]


def test_joining_says_what_is_wrong(school):
    client = school.client()
    assert client.get("/api/class").json() == {"name": "Class 5b", "joining": True}
    wrong = client.post("/api/class/join", json={"code": "AAAAAA", "name": "Ada"})
    assert wrong.status_code == 403
    assert wrong.json()["message"] == "That is not the code of this class."
    school.join("Ada")
    taken = client.post("/api/class/join", json={"code": school.room.record.code, "name": "ada"})
    assert taken.json()["state"] == "taken"
    french = client.post("/api/class/join", json={"code": "AAAAAA", "name": "B"}, headers={"Accept-Language": "fr"})
    assert french.json()["message"] != wrong.json()["message"]
    for body in (b"", b"{", b"[]", b"3", b'{"code": 1}', b"\xff" * 100, b"[" * 100_000):
        assert client.post("/api/class/join", content=body).status_code == 422


def test_work_is_on_the_disk_when_it_is_answered_and_nobody_elses(school, mission):
    ada, _ = school.join("Ada")
    ben, _ = school.join("Ben")
    kept = hand_in(ada, mission).json()
    assert kept["name"] == "blink.krt"
    assert (school.room.folder / "Ada" / "blink.krt").read_text().startswith("<kitrobot")
    again = hand_in(ada, mission | {"world": "empty.world.xml"}, "blink.krt", kept["revision"]).json()
    assert again["name"] == "blink.krt"
    file = ada.get("/api/class/work/file?name=blink.krt")
    assert file.headers["etag"] == f'"{again["revision"]}"'
    assert [one["name"] for one in ada.get("/api/class/work").json()] == ["blink.krt"]
    assert ben.get("/api/class/work").json() == []
    for name in ("../Ada/blink.krt", "blink.krt", "../class.toml"):
        assert ben.get("/api/class/work/file", params={"name": name}).status_code == 404


def test_a_pupils_studio_is_the_pupils_alone(school, mission):
    ada, key = school.join("Ada")
    ben, _ = school.join("Ben")
    saved = ada.put("/api/mission", json={"path": "mine.krt", "revision": "", "mission": mission})
    assert saved.status_code == 200, saved.text
    own = lambda client: [one["path"] for one in client.get("/api/missions").json() if not one["example"]]  # noqa: E731
    assert own(ada) == ["mine.krt"]
    assert own(ben) == []
    for path in ("mine.krt", "../Ada/mine.krt", "../../class.toml", "../../Ada/mine.krt"):
        assert ben.get("/api/mission", params={"path": path}).status_code in (403, 404)
    assert ada.post("/api/check", json={"path": "", "mission": mission}).status_code == 200
    with ada.websocket_connect(f"{SOCKET}/api/watch?token={key}") as socket:
        assert socket.receive_json()["type"] == "hello"


def test_a_pupils_page_is_told_what_the_teacher_does(school, mission):
    ada, key = school.join("Ada")
    teacher = school.teacher()
    with ada.websocket_connect(f"{SOCKET}/api/class/pupil?token={key}") as socket:
        first = socket.receive_json()
        assert (first["name"], first["frozen"], first["word"]) == ("Ada", False, school.room.pupils["Ada"].record.word)
        teacher.post("/api/class/teacher/freeze", json={"on": True})
        assert socket.receive_json()["frozen"]
        teacher.post("/api/class/teacher/exercise", json={"exercise": SQUARE})
        assert socket.receive_json()["exercise"] == SQUARE
        sent = teacher.post("/api/class/teacher/hand-out", json={"path": "example:blink/blink.krt"}).json()
        assert sent == {"name": "blink", "pupils": 1}
        assert socket.receive_json()["handed"] == 1
        assert b"<kitrobot" in ada.get("/api/class/handed").content
        teacher.post("/api/class/teacher/note", json={"folder": "Ada", "text": "Well done"})
        assert socket.receive_json()["note_text"] == "Well done"
        socket.send_json({"type": "hand", "up": True})
        assert socket.receive_json()["hand"]
        teacher.post("/api/class/teacher/hand-down", json={"folder": "Ada"})
        assert not socket.receive_json()["hand"]
        teacher.post("/api/class/teacher/remove", json={"folder": "Ada"})
        with pytest.raises(WebSocketDisconnect):
            socket.receive_json()
    assert ada.get("/api/class/work").status_code == 403


def test_some_pupils_are_frozen_asked_to_let_edit_and_seen_in_their_arena(school, mission):
    ada, key = school.join("Ada")
    school.join("Ben")
    hand_in(ada, mission)
    teacher = school.teacher()
    arena = {"running": True, "seconds": 1.5, "world": WORLD, "poses": [[10, 20, 0.5]], "way": [[0, 20], [10, 20]]}
    with (
        ada.websocket_connect(f"{SOCKET}/api/class/pupil?token={key}") as socket,
        teacher.websocket_connect(f"{SOCKET}/api/class/teacher/watch?token={KEY}") as watch,
    ):

        def until(**wanted) -> None:
            while any(socket.receive_json()[name] != value for name, value in wanted.items()):
                pass

        teacher.post("/api/class/teacher/freeze", json={"on": True, "folders": ["Ada"]})
        until(frozen=True)
        cards = {card["name"]: card for card in told(watch, "pupils")["changed"]}
        while not cards["Ada"]["frozen"]:
            cards |= {card["name"]: card for card in told(watch, "pupils")["changed"]}
        assert not cards["Ben"]["frozen"]
        teacher.post("/api/class/teacher/freeze", json={"on": False, "folders": ["Ada"]})
        until(frozen=False)
        # Ben is not here; Ada is, and says yes.
        assert teacher.post("/api/class/teacher/turn", json={"folder": "Ben", "ask": True}).status_code == 422
        teacher.post("/api/class/teacher/turn", json={"folder": "Ada", "ask": True})
        until(turn="asked")
        socket.send_json({"type": "turn", "yes": True})
        until(turn="teacher")
        teacher.post("/api/class/teacher/turn", json={"folder": "Ada", "ask": False})
        until(turn="pupil")
        # What the page shows is told on only while the teacher looks on.
        watch.send_json({"type": "look", "folder": "Ada"})
        until(looked=True)
        socket.send_json({"type": "arena", "arena": arena})
        while (shown := told(watch, "arena"))["arena"] is None:
            pass
        assert shown["folder"] == "Ada"
        assert shown["arena"]["poses"] == [[10, 20, 0.5]]
        assert shown["arena"]["world"]["width_mm"] == 1000
        watch.send_json({"type": "look", "folder": ""})
        assert told(watch, "arena") == {"type": "arena", "folder": "", "arena": None}


def test_the_teacher_sees_each_pupil(school, mission):
    ada, key = school.join("Ada")
    teacher = school.teacher()
    teacher.post("/api/class/teacher/exercise", json={"exercise": SQUARE})
    hand_in(ada, mission)
    with ada.websocket_connect(f"{SOCKET}/api/class/pupil?token={key}") as pupil:
        pupil.receive_json()
        goals = [{"reached": True, "why": ""}, {"reached": False, "why": "three sides"}]
        pupil.send_json(
            {
                "type": "report",
                "running": True,
                "edits": 3,
                "runs": 1,
                "file": "blink",
                "exercise": SQUARE,
                "goals": goals,
            }
        )
        with teacher.websocket_connect(f"{SOCKET}/api/class/teacher/watch?token={KEY}") as socket:
            whole = told(socket, "class")
            assert (whole["name"], whole["code"], whole["address"]) == ("Class 5b", school.room.record.code, HOST)
            assert len(whole["goals"]) >= 2
            card = told(socket, "pupils")["changed"][0]
            while card["state"] != "running":
                card = told(socket, "pupils")["changed"][0]
            assert card["name"] == "Ada"
            assert [goal["reached"] for goal in card["goals"]] == [True, False]
            assert (card["file"], card["version"]) == ("blink.krt", 1)
            socket.send_json({"type": "look", "folder": "Ada"})
            while not pupil.receive_json()["looked"]:
                pass
    picture = teacher.get("/api/class/teacher/picture", params={"folder": "Ada"}).json()
    assert picture["program"]["name"] == "blink"
    assert teacher.get("/api/class/teacher/picture", params={"folder": "Eve"}).status_code == 422
    # Also of a class that was started anew.
    again = create_class_app(school.room, KEY, REACH)
    client = TestClient(again.app, base_url=HOST, headers={"X-KitRobot-Token": KEY}, client=("127.0.0.1", 1))
    assert client.get("/api/class/teacher/picture", params={"folder": "Ada"}).json() == picture
    again.close()


def test_the_teacher_opens_a_copy_in_a_studio_on_the_folder(school, mission):
    ada, _ = school.join("Ada")
    hand_in(ada, mission)
    assert school.teacher().get("/api/mission", params={"path": "Ada/blink.krt"}).json()["mission"] == mission


def test_a_pupil_who_asks_from_another_computer_comes_in_with_the_teachers_yes(school):
    school.join("Ada")
    other = school.client(address="192.168.4.78")
    asked = other.post("/api/class/ask", json={"code": school.room.record.code, "name": "Ada"}).json()
    assert other.post("/api/class/asked", json=asked).json() == {"state": "waiting", "key": ""}
    with school.teacher().websocket_connect(f"{SOCKET}/api/class/teacher/watch?token={KEY}") as socket:
        assert told(socket, "class")["asking"][0]["name"] == "Ada"
    school.teacher().post("/api/class/teacher/answer", json=asked | {"yes": True})
    said = other.post("/api/class/asked", json=asked).json()
    assert said["state"] == "in"
    assert school.client(said["key"]).get("/api/class/work").status_code == 200


def test_all_work_is_collected_with_a_table_that_no_spreadsheet_takes_for_formulas(school, mission):
    ada, _ = school.join("=Ada()")
    school.join("فاطمہ")
    hand_in(ada, mission)
    hand_in(ada, mission | {"world": "x.world.xml"})
    answer = school.teacher().get("/api/class/teacher/collect")
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        names = archive.namelist()
        table = archive.read("class.csv").decode("utf-8-sig")
    assert sorted(names) == ["=Ada()/blink 2.krt", "=Ada()/blink.krt", "class.csv"]
    assert table.splitlines()[1].startswith("'=Ada(),'=Ada(),blink")
    assert "فاطمہ" in table
    some = school.teacher().get("/api/class/teacher/collect", params={"folder": ["فاطمہ"]})
    with zipfile.ZipFile(io.BytesIO(some.content)) as archive:
        assert archive.namelist() == ["class.csv"]
