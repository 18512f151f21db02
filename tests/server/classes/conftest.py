"""A class over HTTP: its room and application, and clients of its teacher and its pupils."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from kitrobot.classroom.class_room import ClassRoom
from kitrobot.classroom.overview import JoinAddress
from kitrobot.server.classroom.app import ClassApp, create_class_app
from tests.server.conftest import SHORT, TestClient

KEY = "the-teachers-key"

HOST = "http://192.168.4.20:8765"

SOCKET = "ws://192.168.4.20:8765"

SQUARE = "example:exercises/03-square.exercise.xml"

REACH = JoinAddress(HOST, ("101",), "Only this machine can reach the class")


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


WORLD = {
    "name": "w",
    "width_mm": 1000,
    "height_mm": 500,
    **{kind: [] for kind in ("walls", "floors", "lines", "roads", "docks", "storehouses", "starts")},
}


def told(socket, kind: str) -> dict[str, Any]:
    """The next message of that kind."""
    while True:
        message: dict[str, Any] = socket.receive_json()
        if message["type"] == kind:
            return message
