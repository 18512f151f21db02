"""A class under attack: every way in without, with wrong and with another's key; guesses, floods, bodies, names."""

from __future__ import annotations

import contextlib
import json
import os
import random
import shutil
from typing import Any

import pytest
from fastapi.routing import APIRoute, APIWebSocketRoute
from starlette.websockets import WebSocketDisconnect

from kitrobot.classroom.assignments import pack
from kitrobot.classroom.class_room import ClassRoom
from kitrobot.files.folder_quota import measured
from kitrobot.server.app import create_app
from kitrobot.server.classroom import gateway as class_gateway
from kitrobot.server.classroom import sockets as class_sockets
from kitrobot.server.classroom import studios as class_studios
from kitrobot.server.classroom.app import class_api
from tests.server.classes.conftest import KEY, SOCKET, SQUARE, WORLD, hand_in, told

ROBOT = b'<robot name="NAME" version="1"><!--' + b"x" * 600 + b'--><sensor name="Sign"/></robot>'

ROUTES = [route for route in class_api().routes if isinstance(route, APIRoute)]

TEACHERS = [(min(route.methods or ()), route.path) for route in ROUTES if "/teacher/" in route.path]

PUPILS = [
    ("PUT", "/api/class/work"),
    ("GET", "/api/class/work"),
    ("GET", "/api/class/work/file?name=a.krt"),
    ("GET", "/api/class/exercise"),
    ("GET", "/api/class/handed"),
]

OPEN = {"/api/class", "/api/class/join", "/api/class/ask", "/api/class/asked"}
"""What anybody may ask: with a code, or of what anybody may know."""

SOCKETS = [route.path for route in class_api().routes if isinstance(route, APIWebSocketRoute)]

STUDIO = ["/api/session", "/api/missions", "/api/mission?path=blink.krt", "/api/openapi.json", "/api/nothing", "/api"]


def test_every_path_of_a_class_is_somebodys_and_is_tried_below():
    tried = {path for _, path in TEACHERS} | {path.partition("?")[0] for _, path in PUPILS} | OPEN
    assert {route.path for route in ROUTES} == tried
    assert len(TEACHERS) >= 15
    assert sorted(SOCKETS) == ["/api/class/pupil", "/api/class/teacher/watch"]


def test_no_path_of_a_studio_answers_without_a_key_or_to_a_wrong_one(school):
    studio = create_app(school.room.folder, None, "x")
    paths = [
        (method, route.path)
        for route in studio.routes
        if isinstance(route, APIRoute) and route.path.startswith("/api")
        for method in route.methods or ()
    ]
    assert len(paths) > 40
    # No time passes and nobody floods: what is refused is refused for the key.
    school.app.app.app._allowances.clear()
    school.app.app.app._clock = iter(range(1, 10**9)).__next__
    answers = {school.client(given).request(*one).status_code for one in paths for given in ("", "wrong", KEY)}
    assert answers == {403}
    for route in studio.routes:
        if isinstance(route, APIWebSocketRoute):
            with (
                pytest.raises(WebSocketDisconnect),
                school.client().websocket_connect(f"{SOCKET}{route.path}?token=wrong"),
            ):
                pass


def test_a_gigabyte_is_refused_at_its_head_wherever_it_is_sent(school):
    _, key = school.join("Ada")
    school.app.app.app._clock = iter(range(1, 10**9)).__next__
    large = {"Content-Length": str(2**30)}
    writes = [("PUT", "/api/class/work"), *(("POST", path) for path in sorted(OPEN - {"/api/class"}))]
    writes += [("PUT", "/api/mission"), ("POST", "/api/mission/read"), ("POST", "/api/check"), ("POST", "/api/trace")]
    answers = {one: school.client(key).request(*one, headers=large, content=b"").status_code for one in writes}
    refused = answers.pop(("POST", "/api/trace"))
    assert refused == 403
    assert set(answers.values()) == {413}
    assert school.client().post("/api/class/join", headers=large, content=b"").status_code == 413


@pytest.mark.parametrize(
    "path",
    [
        "/..%2f..%2fClass%205b/class.toml",
        "/%2e%2e/%2e%2e/Class%205b/class.toml",
        "/assets/..%2f..%2f..%2fClass%205b%2fclass.toml",
        "/assets/%2e%2e/%2e%2e/%2e%2e/etc/passwd",
        "//etc/passwd",
        "/class.toml",
        "/Ada/a.krt",
        "/.studios/Ada/a.krt",
        "/..%5c..%5cclass.toml",
        "/assets/a%00.js",
    ],
)
def test_no_file_but_the_pages_own_is_served(school, path):
    school.join("Ada")
    answer = school.client().get(path)
    assert answer.status_code in (400, 404), answer.text[:200]
    assert school.room.record.code not in answer.text


def test_guessing_codes_and_words_is_held_back(school):
    school.room.clock = lambda: 0.0
    school.join("Ada")
    code = school.room.record.code
    eve = school.client(address="192.168.4.66")
    # Half of them guess the code, half the word of another.
    for at in range(20):
        guess = {"code": "AAAAAA", "name": "Eve"} if at % 2 else {"code": code, "name": "Ada", "word": "AAAAAA"}
        assert eve.post("/api/class/join", json=guess).status_code == 403
    right = eve.post("/api/class/join", json={"code": code, "name": "Eve"})
    assert right.status_code == 403
    assert "too many" in right.json()["message"].lower()
    assert eve.post("/api/class/ask", json={"code": code, "name": "Ada"}).status_code == 403
    # A header that names another address is somebody's invention.
    forged = {"X-Forwarded-For": "192.168.4.1", "Forwarded": "for=192.168.4.1"}
    assert eve.post("/api/class/join", json={"code": code, "name": "Eve"}, headers=forged).status_code == 403
    school.join("Ben")
    assert any("192.168.4.66" in line for line in school.room.log.last())


def test_one_pupil_opens_so_many_sockets(school):
    ada, key = school.join("Ada")
    with contextlib.ExitStack() as stack:
        for _ in range(class_sockets.MOST_PAGES):
            stack.enter_context(ada.websocket_connect(f"{SOCKET}/api/class/pupil?token={key}"))
        with pytest.raises(WebSocketDisconnect), ada.websocket_connect(f"{SOCKET}/api/class/pupil?token={key}"):
            pass
    assert school.room.pupils["Ada"].pages == 0


def test_a_pupil_does_not_end_the_teachers_socket(school):
    ada, key = school.join("Ada")
    arena = {"running": True, "seconds": 1, "world": WORLD, "poses": [], "way": []}
    hostile = json.dumps({"type": "arena", "arena": arena}).replace('"width_mm": 1000', '"width_mm": 1e999')
    with school.teacher().websocket_connect(f"{SOCKET}/api/class/teacher/watch?token={KEY}") as watch:
        watch.send_json({"type": "look", "folder": "Ada"})
        assert told(watch, "arena")["folder"] == "Ada"
        with ada.websocket_connect(f"{SOCKET}/api/class/pupil?token={key}") as socket:
            socket.receive_json()
            socket.send_text(hostile)
            with pytest.raises(WebSocketDisconnect):
                list(iter(socket.receive_json, None))
        # The teacher's page hears on.
        school.join("Ben")
        while "Ben" not in [card["name"] for card in told(watch, "pupils")["changed"]]:
            pass


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


def test_a_flood_is_held_and_only_of_who_floods(school, monkeypatch):
    # Fewer than are allowed otherwise: what is held is how they are counted.
    monkeypatch.setattr(class_gateway, "AT_ONCE", 30.0)
    monkeypatch.setattr(class_gateway, "STRANGERS_AT_ONCE", 20.0)
    # No time passes.
    school.app.app.app._clock = lambda: 0.0
    ada, _ = school.join("Ada")
    ben, _ = school.join("Ben")
    answers = [ada.get("/api/class/work").status_code for _ in range(40)]
    assert answers.count(429) == 10
    assert ben.get("/api/class/work").status_code == 200
    strangers = [school.client(address="192.168.4.99").get("/api/class").status_code for _ in range(30)]
    assert strangers.count(429) == 10
    assert school.client(address="192.168.4.98").get("/api/class").status_code == 200


@pytest.mark.parametrize(
    "path",
    [
        *("/api/board/trace", "/api/trace", "/api/traces/../trace", "/api/run/trace", "/api/sweep", "/api/verify"),
        *("/api/experiment", "/api/experiment/study", "/api/experiment/table"),
    ],
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


def quota_left(school, monkeypatch, size: int, files: int = 1000):
    """A pupil whose studio takes so much."""
    monkeypatch.setattr(class_studios, "MOST_BYTES", size)
    monkeypatch.setattr(class_studios, "MOST_FILES", files)
    return school.join("Ada")[0]


def handed_out(pupil, name: str, files: dict[str, bytes]):
    return pupil.put(f"/api/handed-out?exercise=Handed out/{name}/a.exercise.xml", content=pack(files))


def test_every_way_to_write_is_counted_before_it_is_written(school, mission, monkeypatch):
    ada = quota_left(school, monkeypatch, 20_000)
    studio = school.room.folder / ".studios" / "Ada"
    saves = [
        lambda at: ada.put("/api/mission", json={"path": f"a{at}.krt", "revision": "", "mission": mission}),
        lambda at: ada.post(f"/api/parts?path=&file=r{at}.robot.xml", content=ROBOT.replace(b"NAME", b"r%d" % at)),
        lambda at: handed_out(ada, str(at), {"a.exercise.xml": random.Random(at).randbytes(6_000)}),
    ]
    for save in saves:
        answers: list[int] = []
        for at in range(90):
            answers.append(save(at).status_code)
            if answers.count(413) == 3:
                break
        assert answers[0] == 200, save(1000).text
        assert set(answers) == {200, 413}
        assert measured(studio)[0] <= 20_000
        shutil.rmtree(studio)
        studio.mkdir()


def test_a_journal_is_counted_with_each_record(school, mission, monkeypatch):
    ada = quota_left(school, monkeypatch, 50_000)
    key = ada.headers["X-KitRobot-Token"]
    with ada.websocket_connect(f"{SOCKET}/api/watch?token={key}") as socket:
        tab = told(socket, "hello")["tab"]
        assert ada.post("/api/journal/claim", json={"tab": tab, "path": "a.krt", "journal": ""}).status_code == 200
        whole = {"tab": tab, "path": "a.krt", "name": "a", "records": ["a"], "unsaved": True}
        assert ada.put("/api/journal", json=whole).status_code == 200
        answers = set()
        for at in range(100):
            record = random.Random(at).randbytes(1000).hex()
            more = {"tab": tab, "first": at + 1, "records": [record], "unsaved": True}
            answers.add(ada.post("/api/journal", json=more).status_code)
            if 413 in answers:
                break
    assert answers == {200, 413}
    assert measured(school.room.folder / ".studios" / "Ada")[0] <= 50_000


def test_folders_and_files_are_counted_and_what_becomes_smaller_is_written(school, mission, monkeypatch):
    ada = quota_left(school, monkeypatch, 100_000, 20)
    answers = [handed_out(ada, str(at), {}).status_code for at in range(40)]
    assert set(answers) == {200, 413}
    assert measured(school.room.folder / ".studios" / "Ada")[1] <= 20
    # Who has no room left can still save what is not larger.
    shutil.rmtree(school.room.folder / ".studios" / "Ada" / "Handed out")
    saved = {"revision": ""}
    for _ in range(2):
        saved = ada.put("/api/mission", json={"path": "a.krt", **saved, "mission": mission}).json()
        saved = {"revision": saved["revision"]}
    for at in range(40):
        handed_out(ada, str(at), {})
    smaller = {**mission, "agents": []}
    assert ada.put("/api/mission", json={"path": "a.krt", **saved, "mission": smaller}).is_success


def test_one_pupil_has_so_many_sockets_of_every_kind(school, monkeypatch):
    monkeypatch.setattr(class_gateway, "MOST_SOCKETS", 3)
    ada, key = school.join("Ada")
    with contextlib.ExitStack() as stack:
        for path in ("class/pupil", "watch", "run"):
            stack.enter_context(ada.websocket_connect(f"{SOCKET}/api/{path}?token={key}"))
        with pytest.raises(WebSocketDisconnect), ada.websocket_connect(f"{SOCKET}/api/watch?token={key}"):
            pass
    with ada.websocket_connect(f"{SOCKET}/api/watch?token={key}"):
        pass


def test_joining_and_everything_else_do_not_hold_up_each_other(school, monkeypatch):
    for name in ("STRANGERS_A_SECOND", "JOINS_A_SECOND"):
        monkeypatch.setattr(class_gateway, name, 0.0)
    for name in ("STRANGERS_AT_ONCE", "JOINS_AT_ONCE"):
        monkeypatch.setattr(class_gateway, name, 5.0)
    stranger = school.client()
    answers = [stranger.get("/api/class").status_code for _ in range(6)]
    assert answers == [200] * 5 + [429]
    school.join("Ada")
    tries = {"code": "AAAAAA", "name": "Eve"}
    other = school.client(address="192.168.4.78")
    answers = [other.post("/api/class/join", json=tries).status_code for _ in range(6)]
    assert answers == [403] * 5 + [429]
    assert other.get("/api/class").status_code == 200


def test_the_teacher_makes_room_and_removes_those_who_did_nothing(school):
    teacher = school.teacher()
    for at in range(5):
        school.join(f"Invented {at}")
    assert teacher.post("/api/class/teacher/places", json={"places": 5}).json() == 5
    full = school.client().post("/api/class/join", json={"code": school.room.record.code, "name": "Ada"})
    assert full.status_code == 422
    assert full.json()["message"] == "This class has 5 pupils already."
    assert teacher.post("/api/class/teacher/remove-idle").json() == 5
    school.join("Ada")
    for places in (0, 1001, "x"):
        assert teacher.post("/api/class/teacher/places", json={"places": places}).status_code == 422
    ada, _ = school.join("Ben")
    for path in ("places", "remove-idle"):
        assert ada.post(f"/api/class/teacher/{path}", json={"places": 9}).status_code == 403


def test_a_full_studio_takes_no_more(school, mission, monkeypatch):
    ada, _ = school.join("Ada")
    monkeypatch.setattr(class_studios, "MOST_FILES", 0)
    (school.room.folder / ".studios" / "Ada").mkdir(parents=True)
    (school.room.folder / ".studios" / "Ada" / "a").write_text("")
    answer = ada.put("/api/mission", json={"path": "mine.krt", "revision": "", "mission": mission})
    assert answer.status_code == 413
    assert ada.post("/api/mission/text", json={"mission": mission}).status_code == 200


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


@pytest.mark.parametrize("unknown", ["<broken", "</kitrobot>", "<a></b>", "&b;"])
def test_what_is_handed_in_opens_or_is_refused(school, mission, unknown):
    ada, _ = school.join("Ada")
    said = hand_in(ada, mission | {"unknown": [unknown]})
    files = ada.get("/api/class/work").json()
    if said.status_code == 200:
        data = ada.get("/api/class/work/file", params={"name": said.json()["name"]}).content
        read = school.teacher().post("/api/mission/read?name=a.krt", content=data)
        assert read.status_code == 200
        assert read.json()["mission"]["programs"] == mission["programs"]
    else:
        assert "would not open" in said.json()["message"]
        assert files == []


def test_a_hand_in_that_would_not_open_is_refused_with_a_sentence_and_nothing_is_written(school, mission):
    ada, _ = school.join("Ada")
    said = hand_in(ada, mission | {"programs": []})
    assert said.status_code == 422
    assert "would not open" in said.json()["message"]
    assert ada.get("/api/class/work").json() == []
    assert hand_in(ada, mission).status_code == 200


@pytest.mark.parametrize("name", ["grades.html", "GRADES.csv", "class.csv", "log.txt", "Site", "Handed out", "a.krt"])
def test_no_name_of_a_pupil_takes_the_place_of_what_the_class_writes(school, mission, name):
    pupil, _ = school.join(name)
    assert hand_in(pupil, mission).status_code == 200
    teacher = school.teacher()
    assert teacher.post("/api/class/teacher/exercise", json={"exercise": SQUARE}).status_code == 200
    assert teacher.post("/api/class/teacher/grade", json={}).json() == 1
    school.app.grading.wait(60)
    assert school.app.grading.state is not None
    assert school.app.grading.state.page == "grades.html"
    assert (school.room.folder / "grades.html").is_file()
    assert (school.room.folder / "grades.csv").is_file()


def test_a_file_of_a_moment_beyond_calendars_stops_no_class(school, mission):
    ada, _ = school.join("Ada")
    assert hand_in(ada, mission).status_code == 200
    work = school.room.folder / "Ada" / "blink.krt"
    plan = school.room.folder / "plan.krt"
    plan.write_bytes(work.read_bytes())
    for path in (work, plan):
        os.utime(path, (10**12, 10**12))
    assert ada.get("/api/class/work").json()[0]["name"] == "blink.krt"
    teacher = school.teacher()
    assert "plan.krt" in [one["path"] for one in teacher.get("/api/missions").json()]
    assert teacher.get("/api/class/teacher/collect").status_code == 200
    school.app.close()
    school.room.close()
    again = ClassRoom(school.room.folder)
    assert again.pupils["Ada"].work == "blink.krt"
    again.close()
