"""A class over HTTP: every way in without, with wrong and with another's key; the pupil's and the teacher's paths."""

from __future__ import annotations

import io
import zipfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from fastapi.routing import APIRoute
from starlette.websockets import WebSocketDisconnect

from kitrobot.classroom import ClassRoom
from kitrobot.server import class_door, class_studios
from kitrobot.server.class_app import ClassApp, class_api, create_class_app
from kitrobot.server.class_overview import Reach
from tests.patience import PATIENCE_S
from tests.server.conftest import SHORT, TestClient

KEY = "the-teachers-key"
HOST = "http://192.168.4.20:8765"
SOCKET = "ws://192.168.4.20:8765"
SQUARE = "example:exercises/03-square.exercise.xml"
REACH = Reach(HOST, ("101",), "Only this machine can reach the class")


@dataclass
class Class:
    room: ClassRoom
    app: ClassApp

    def client(self, key: str = "", address: str = "192.168.4.77") -> TestClient:
        headers = {"X-KitRobot-Token": key} if key else {}
        return TestClient(self.app.app, base_url=HOST, headers=headers, client=(address, 5000))

    def teacher(self) -> TestClient:
        return self.client(KEY, "127.0.0.1")

    def join(self, name: str) -> tuple[TestClient, str]:
        said = self.client().post("/api/class/join", json={"code": self.room.record.code, "name": name})
        assert said.status_code == 200, said.text
        return self.client(said.json()["key"]), said.json()["key"]


@pytest.fixture
def school(tmp_path: Path):
    static = tmp_path / "static"
    (static / "assets").mkdir(parents=True)
    (static / "index.html").write_text("<!doctype html><html><head><title>the page</title></head></html>")
    (static / "assets" / "page.js").write_text("export {};")
    room = ClassRoom(tmp_path / "Class 5b")
    app = create_class_app(room, KEY, REACH, static=static)
    yield Class(room, app)
    app.close()
    room.close()


@pytest.fixture
def mission(school: Class) -> dict[str, Any]:
    said = school.teacher().post("/api/mission/read?name=a.krt", content=SHORT.encode())
    found: dict[str, Any] = said.json()["mission"]
    return found


def hand_in(pupil: TestClient, mission: dict[str, Any], name: str = "blink", base: str = ""):
    return pupil.put("/api/class/work", json={"name": name, "base": base, "mission": mission})


ROUTES = [route for route in class_api().routes if isinstance(route, APIRoute)]
TEACHERS = [(min(route.methods or ()), route.path) for route in ROUTES if "/teacher/" in route.path]
PUPILS = [
    ("PUT", "/api/class/work"),
    ("GET", "/api/class/work"),
    ("GET", "/api/class/work/file?name=a.krt"),
    ("GET", "/api/class/handed"),
]
STUDIO = ["/api/session", "/api/missions", "/api/mission?path=blink.krt", "/api/openapi.json", "/api/nothing", "/api"]


def test_there_are_paths_of_the_teacher_to_look_at():
    assert len(TEACHERS) >= 14


@pytest.mark.parametrize(("method", "path"), TEACHERS)
def test_what_is_the_teachers_is_given_to_nobody_else(school, method, path):
    _, key = school.join("Ada")
    for given in ("", "wrong", key, KEY[:-1], KEY + "x"):
        for address in ("192.168.4.77", "127.0.0.1"):
            assert school.client(given, address).request(method, path).status_code == 403
    # Not even the right key from another machine.
    assert school.client(KEY).request(method, path).status_code == 403
    assert school.client(KEY).request(method, path, headers={"X-Forwarded-For": "127.0.0.1"}).status_code == 403


@pytest.mark.parametrize(("method", "path"), PUPILS)
def test_what_is_a_pupils_is_given_with_the_key_alone(school, mission, method, path):
    _, key = school.join("Ada")
    json = {"name": "a", "mission": mission} if method == "PUT" else None
    for given in ("", "wrong", key[:-1], key + "x", "\u00e9"):
        client = school.client()
        headers = {"X-KitRobot-Token": given.encode()} if given else {}
        assert client.request(method, path, json=json, headers=headers).status_code == 403
    # Two keys are none.
    assert (
        school.client(key).request(method, f"{path}{'&' if '?' in path else '?'}token=other", json=json).status_code
        == 403
    )
    assert school.client(KEY, "127.0.0.1").request(method, path, json=json).status_code == 403


@pytest.mark.parametrize("path", STUDIO)
def test_a_studio_is_given_with_a_key_alone(school, path):
    for given in ("", "wrong"):
        assert school.client(given).get(path).status_code == 403


@pytest.mark.parametrize("path", ["class/pupil", "class/teacher/watch", "run", "watch"])
def test_no_socket_opens_without_the_key(school, path):
    _, key = school.join("Ada")
    tries = ["", "wrong", KEY] if path != "class/teacher/watch" else ["", "wrong", KEY, key]
    for given in tries:
        with (
            pytest.raises(WebSocketDisconnect) as raised,
            school.client().websocket_connect(f"{SOCKET}/api/{path}?token={given}"),
        ):
            pass
        assert raised.value.code == 1008


@pytest.mark.parametrize("host", ["evil.example", "evil.example:8765", "127.0.0.1.evil.example", "", "a:b"])
def test_a_foreign_name_for_this_machine_is_refused(school, host):
    assert school.teacher().get("/api/class", headers={"Host": host}).status_code == 403


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", "https://192.168.4.20:8765", "http://192.168.4.20:1"]
)
def test_another_page_is_refused(school, origin):
    assert school.teacher().get("/api/class", headers={"Origin": origin}).status_code == 403
    with (
        pytest.raises(WebSocketDisconnect),
        school.teacher().websocket_connect(f"{SOCKET}/api/class/teacher/watch", headers={"Origin": origin}),
    ):
        pass


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


def test_a_mission_that_is_too_large_is_refused_before_it_is_read(school, mission):
    ada, _ = school.join("Ada")
    large = ada.put("/api/class/work", content=b"x" * (2 * 1024 * 1024 + 1))
    assert large.status_code == 413
    # A gigabyte that only says it is small.

    def endless():
        for _ in range(40):
            yield b"x" * 100_000

    assert ada.put("/api/class/work", content=endless()).status_code in (400, 413)
    assert ada.put("/api/class/work", headers={"Content-Length": str(2**30)}, content=b"").status_code == 413
    assert ada.get("/api/class/work").json() == []


def test_a_flood_is_held_and_only_of_who_floods(school):
    # No time passes.
    school.app.app.app._clock = lambda: 0.0
    ada, _ = school.join("Ada")
    ben, _ = school.join("Ben")
    answers = [ada.get("/api/class/work").status_code for _ in range(int(class_door.AT_ONCE) + 100)]
    assert answers.count(429) == 100
    assert ben.get("/api/class/work").status_code == 200
    strangers = [school.client(address="192.168.4.99").get("/api/class").status_code for _ in range(500)]
    assert 429 in strangers
    assert school.client(address="192.168.4.98").get("/api/class").status_code == 200


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


@pytest.mark.parametrize(
    "path", ["/api/board/trace", "/api/trace", "/api/traces/../trace", "/api/run/trace", "/api/sweep", "/api/verify"]
)
def test_a_pupils_studio_does_not_use_the_teachers_machine(school, path):
    ada, key = school.join("Ada")
    assert ada.get(path).status_code in (403, 404)
    with pytest.raises(WebSocketDisconnect), ada.websocket_connect(f"{SOCKET}/api/boards?token={key}"):
        pass


@pytest.mark.parametrize("kind", ["robots", "fleet"])
def test_a_pupil_on_the_teachers_machine_gets_neither_ports_nor_processes(school, mission, kind):
    _, key = school.join("Ada")
    client = school.client(key, "127.0.0.1")
    request: dict[str, Any] = {
        "type": kind,
        "mission": mission,
        "path": "",
        "holder": "x",
        "speed": 1,
        "breakpoints": [],
    }
    request |= {"addresses": ["/dev/ttyACM0"]} if kind == "robots" else {"seed": 1, "boards": []}
    with client.websocket_connect(f"{SOCKET}/api/run?token={key}") as socket:
        socket.send_json(request)
        answer = socket.receive_json()
    assert answer["type"] == "error", answer
    assert "another machine" in answer["message"], answer


def test_a_full_studio_takes_no_more(school, mission, monkeypatch):
    ada, _ = school.join("Ada")
    monkeypatch.setattr(class_studios, "MOST_FILES", 0)
    (school.room.folder / ".studios" / "Ada").mkdir(parents=True)
    (school.room.folder / ".studios" / "Ada" / "a").write_text("")
    answer = ada.put("/api/mission", json={"path": "mine.krt", "revision": "", "mission": mission})
    assert answer.status_code == 413
    assert ada.post("/api/mission/text", json={"mission": mission}).status_code == 200


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


WORLD = {
    "name": "w",
    "width_mm": 1000,
    "height_mm": 500,
    **{kind: [] for kind in ("walls", "floors", "lines", "roads", "docks", "storehouses", "starts")},
}


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


@pytest.mark.parametrize(
    "arena",
    [
        {},
        {"poses": [[1e300, 0, 0]]},
        {"poses": [[0, 0]]},
        {"poses": [[0, 0, 0]] * 51},
        {"world": None},
        {"seconds": "x"},
    ],
)
def test_an_arena_that_makes_no_sense_closes_the_socket(school, arena):
    ada, key = school.join("Ada")
    whole = {"running": True, "seconds": 1, "world": WORLD, "poses": [], "way": []} | arena if arena else {}
    with ada.websocket_connect(f"{SOCKET}/api/class/pupil?token={key}") as socket:
        socket.receive_json()
        socket.send_json({"type": "arena", "arena": whole})
        with pytest.raises(WebSocketDisconnect):
            socket.receive_json()


@pytest.mark.parametrize("said", ["", "{", "3", '{"type":"report"}', '{"type":"look","folder":"Ben"}', "x" * 70_000])
def test_a_pupils_socket_that_makes_no_sense_is_closed(school, said):
    ada, key = school.join("Ada")
    with ada.websocket_connect(f"{SOCKET}/api/class/pupil?token={key}") as socket:
        socket.receive_json()
        socket.send_text(said)
        with pytest.raises(WebSocketDisconnect):
            socket.receive_json()
    assert school.room.looked == ""


def test_a_socket_that_floods_is_closed(school):
    ada, key = school.join("Ada")
    with ada.websocket_connect(f"{SOCKET}/api/class/pupil?token={key}") as socket:
        socket.receive_json()
        report = {"type": "report", "running": False, "edits": 0, "runs": 0, "file": "", "exercise": "", "goals": []}
        for _ in range(200):
            socket.send_json(report)
        with pytest.raises(WebSocketDisconnect):
            socket.receive_json()


def told(socket, kind: str) -> dict[str, Any]:
    """The next message of that kind."""
    while True:
        message: dict[str, Any] = socket.receive_json()
        if message["type"] == kind:
            return message


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
