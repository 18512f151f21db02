"""Every route reads and writes the same through orjson and the standard library, which is all that a page has.

The mission has whatever a mission can have: notes, XML that nobody knows, a part, a variable, a world and a team's
program of its own. A route that is new has to be added to `ASKED`.
"""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import orjson
import pytest

from kitrobot.files.examples import examples_folder
from kitrobot.server.app import create_app
from kitrobot.text import json_text
from tests.server.conftest import HOST, SOCKET, TOKEN, TestClient

RICH = """<kitrobot version="1" xmlns:o="urn:other">
  <o:thing>kept</o:thing>
  <constructor name="Twice" icon="repeat" colour="action">
    <label>Twice</label>
    <help>Blinks</help>
    <number name="pause" min="0" max="9" default="1"><label>pause</label></number>
    <code>Light.LightOn(); WAIT({pause}); Light.LightOff();</code>
  </constructor>
  <variable robot="mini-robot" name="Tally" min="0" max="9" initial="1"><help>How often</help></variable>
  <program name="blink" robot="mini-robot">
    <vertex id="start" element="Start"><note>first</note></vertex>
    <vertex id="v1" element="Light.LightOn"><note>on\nand on</note><note at="after">behind</note>
      <o:more a="1"/></vertex>
    <vertex id="v2" element="Wait"><set name="duration">2</set></vertex>
    <vertex id="v3" element="Twice"><set name="pause">1</set></vertex>
    <vertex id="stop" element="Stop"><note>last</note></vertex>
    <arc from="start" to="v1"/>
    <arc from="v1" to="v2"/>
    <arc from="v2" to="v3"/>
    <arc from="v3" to="stop"/>
  </program>
  <team><agent name="robot-1" program="blink"/></team>
  <world version="1" name="yard" width="3000" height="3000">
    <start name="robot-1" x="500" y="500" heading="0"/>
  </world>
</kitrobot>
"""

Asking = Callable[["Both"], Any]
NO_STUDY = {"path": "rich.krt", "study": "none"}


class Both:
    """A studio, and what its page has of it."""

    def __init__(self, place: Path) -> None:
        self.place = place
        folder, static = place / "missions", place / "static"
        folder.mkdir(parents=True)
        static.mkdir()
        (static / "index.html").write_text("<!doctype html><title>the page</title>")
        (folder / "rich.krt").write_text(RICH)
        examples = examples_folder()
        assert examples is not None
        (folder / "team.krt").write_bytes((examples / "transport-team" / "transport-team.krt").read_bytes())
        self.app = create_app(folder, folder / "rich.krt", TOKEN, static=static, secret="s" * 64)
        here = ("127.0.0.1", 5000)
        self.page = TestClient(self.app, base_url=HOST, headers={"X-KitRobot-Token": TOKEN}, client=here)

    def get(self, path: str, /, **params: Any) -> Any:
        return self.page.get(f"/api/{path}", params=params)

    def post(self, path: str, /, **value: Any) -> Any:
        return self.page.post(f"/api/{path}", json=value)

    def send(self, path: str, data: bytes, /, **params: Any) -> Any:
        return self.page.post(f"/api/{path}", content=data, params=params)

    def mission(self, path: str = "rich.krt") -> dict[str, Any]:
        found: dict[str, Any] = self.get("mission", path=path).json()["mission"]
        return found

    def typed(self, path: str, program: str, change: Callable[[str], str]) -> Any:
        """A text that is typed over a program."""
        mission = self.mission(path)
        report = self.post("check", mission=mission, path=path).json()
        text = next(one["lll"] for one in report["programs"] if one["name"] == program)
        return self.post("text", mission=mission, path=path, program=program, text=change(text))

    def run(self) -> str:
        """A run of its mission that stands at its end."""
        with self.page.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}") as socket:
            start = {"type": "start", "mission": self.mission(), "path": "rich.krt", "seed": 1, "speed": 0}
            socket.send_text(json.dumps(start))
            said: list[Any] = []
            while not said or said[-1].get("status") != "done":
                message = socket.receive()
                if message.get("text") is not None:
                    said.append(json.loads(message["text"]))
                    assert said[-1]["type"] in ("started", "tick", "state"), said[-1]
            run = next(one["run"] for one in said if one["type"] == "started")
            self.answer = self.get("run/trace", run=run)
            self.judged = self.get("run/judgements", run=run)
        return json.dumps(said)


def own_world(both: Both) -> dict[str, Any]:
    found: dict[str, Any] = both.get("world/templates").json()[0]["world"]
    return found


def text_of_a_run(both: Both) -> Any:
    both.run()
    return both.answer


def judgements_of_a_run(both: Both) -> Any:
    both.run()
    return both.judged


def journal(both: Both, method: str, path: str) -> Any:
    """A page that is open claims a journal, and writes it."""
    with both.page.websocket_connect(f"{SOCKET}/api/watch?token={TOKEN}") as socket:
        tab = socket.receive_json()["tab"]
        claimed = both.post("journal/claim", tab=tab, path="rich.krt", journal="")
        if path == "journal/claim":
            return claimed
        made = {"tab": tab, "path": "rich.krt", "name": "rich", "records": ["a", "b"], "unsaved": True}
        put = both.page.put("/api/journal", json=made)
        if method == "PUT":
            return put
        return both.post("journal", tab=tab, first=2, records=["c"], unsaved=True)


def walk(both: Both, *places: int) -> Any:
    path = "example:transport/transport.krt"
    return both.post("walk", mission=both.mission(path), path=path, seed=1, timing="free", places=places)


def again(both: Both, path: str) -> Any:
    asked = both.post("again", asked="0" * 64)
    if path == "again":
        return asked
    return both.post(path, asked="0" * 64, answered=asked.json()["answered"], proof="1" * 64)


ASKED: dict[tuple[str, str], tuple[Asking, ...]] = {
    ("GET", "/api/openapi.json"): (lambda both: both.get("openapi.json"),),
    ("GET", "/api/session"): (lambda both: both.get("session"),),
    ("GET", "/api/missions"): (lambda both: both.get("missions"),),
    ("GET", "/api/missions/preview"): (lambda both: both.get("missions/preview", path="example:square/square.krt"),),
    ("GET", "/api/mission"): (
        lambda both: both.get("mission", path="rich.krt"),
        lambda both: both.get("mission", path="team.krt"),
        lambda both: both.get("mission", path="nowhere.krt"),
    ),
    ("GET", "/api/mission/new"): (lambda both: both.get("mission/new"),),
    ("POST", "/api/mission/read"): (
        lambda both: both.send("mission/read", RICH.encode()),
        lambda both: both.send("mission/read", b"<kitrobot>"),
    ),
    ("PUT", "/api/mission"): (
        lambda both: both.page.put("/api/mission", json={"path": "b.krt", "revision": "", "mission": both.mission()}),
        lambda both: both.page.put(
            "/api/mission", json={"path": "rich.krt", "revision": "x", "mission": both.mission()}
        ),
    ),
    ("POST", "/api/mission/text"): (lambda both: both.post("mission/text", mission=both.mission()),),
    ("POST", "/api/check"): (
        lambda both: both.post("check", mission=both.mission(), path="rich.krt"),
        lambda both: both.post("check", mission=both.mission("team.krt"), path="team.krt"),
        lambda both: both.post("check", mission={**both.mission(), "agents": []}, path="rich.krt"),
    ),
    ("POST", "/api/mission/team"): (
        lambda both: both.post(
            "mission/team",
            mission=both.mission("example:transport/transport.krt"),
            path="example:transport/transport.krt",
            name="all",
        ),
    ),
    ("POST", "/api/walk"): (
        lambda both: walk(both, 0),
        lambda both: walk(both, 9999),
    ),
    ("POST", "/api/again"): (lambda both: again(both, "again"),),
    ("POST", "/api/again/token"): (lambda both: again(both, "again/token"),),
    ("POST", "/api/fragment"): (
        lambda both: both.post("fragment", text="# why\nLight.LightOn();", robot="mini-robot", path=""),
    ),
    ("GET", "/api/board/trace"): (lambda both: both.get("board/trace", address="nobody"),),
    ("GET", "/api/firmware"): (lambda both: both.get("firmware"),),
    ("POST", "/api/firmware"): (lambda both: both.send("firmware", b"UF2", file="a.uf2", drive="/nowhere"),),
    ("POST", "/api/journal/claim"): (lambda both: journal(both, "POST", "journal/claim"),),
    ("PUT", "/api/journal"): (lambda both: journal(both, "PUT", "journal"),),
    ("POST", "/api/journal"): (lambda both: journal(both, "POST", "journal"),),
    ("GET", "/api/journal/left"): (lambda both: both.get("journal/left"),),
    ("POST", "/api/journal/forget"): (lambda both: both.post("journal/forget", journal="none"),),
    ("POST", "/api/mission/difference"): (
        lambda both: both.post("mission/difference", mission={**both.mission(), "agents": []}, path="rich.krt"),
    ),
    ("POST", "/api/mission/merge"): (
        lambda both: both.post(
            "mission/merge",
            base=both.mission(),
            mission={**both.mission(), "agents": []},
            path="rich.krt",
            taken=[],
        ),
    ),
    ("POST", "/api/text"): (
        lambda both: both.typed("rich.krt", "blink", lambda text: text),
        lambda both: both.typed("rich.krt", "blink", lambda text: text.replace("WAIT(2)", "WAIT(3)")),
        lambda both: both.typed("rich.krt", "blink", lambda text: text.replace("first", "another")),
        lambda both: both.typed("rich.krt", "blink", lambda text: text.replace("on\n", "on and off\n")),
        lambda both: both.typed("rich.krt", "blink", lambda text: text + "("),
        lambda both: both.typed("team.krt", both.mission("team.krt")["programs"][0]["name"], lambda text: text),
    ),
    ("POST", "/api/part/offer"): (
        lambda both: both.post(
            "part/offer", mission=both.mission(), path="rich.krt", program="blink", vertices=["v1", "v2"]
        ),
    ),
    ("POST", "/api/part"): (
        lambda both: both.post(
            "part",
            mission=both.mission(),
            path="rich.krt",
            program="blink",
            vertices=["v1", "v2"],
            name="Mine",
            icon="repeat",
            colour="action",
            label={"": "Mine"},
            help={},
            chosen=[],
        ),
    ),
    ("POST", "/api/part/read"): (
        lambda both: both.post(
            "part/read",
            mission=both.mission(),
            path="rich.krt",
            robot="mini-robot",
            constructor=both.mission()["constructors"][0],
        ),
    ),
    ("POST", "/api/part/file"): (lambda both: both.post("part/file", constructors=both.mission()["constructors"]),),
    ("GET", "/api/catalogue"): (lambda both: both.get("catalogue", path="rich.krt"),),
    ("GET", "/api/world"): (lambda both: both.get("world", path="rich.krt", href="ring.world.xml"),),
    ("GET", "/api/world/plan"): (lambda both: both.get("world/plan", path="rich.krt", href="ring.world.xml"),),
    ("GET", "/api/world/templates"): (lambda both: both.get("world/templates", seed=7),),
    ("POST", "/api/world/text"): (lambda both: both.post("world/text", **own_world(both)),),
    ("GET", "/api/worlds"): (lambda both: both.get("worlds", path="rich.krt"),),
    ("GET", "/api/kits"): (lambda both: both.get("kits", path="rich.krt"),),
    ("POST", "/api/kits/fit"): (
        lambda both: both.post("kits/fit", path="rich.krt", mission=both.mission(), program="blink"),
    ),
    ("POST", "/api/parts"): (
        lambda both: both.send("parts", b"<world/>", path="rich.krt", file="a.world.xml"),
        lambda both: both.send("parts", b"no XML", path="rich.krt", file="a.txt"),
    ),
    ("POST", "/api/parts/difference"): (
        lambda both: both.send("parts/difference", b"<board/>", path="rich.krt", file="a.board.xml"),
    ),
    ("POST", "/api/variable"): (
        lambda both: both.post(
            "variable",
            path="rich.krt",
            variables=both.mission()["variables"],
            robot="mini-robot",
            name="Other",
            type="integer",
            min=0,
            max=5,
            initial=0,
            shared=False,
        ),
    ),
    ("POST", "/api/image"): (
        lambda both: both.post("image", mission=both.mission(), path="rich.krt", program="blink"),
    ),
    ("POST", "/api/tree"): (lambda both: both.post("tree", mission=both.mission(), path="rich.krt", program="blink"),),
    ("POST", "/api/board-file"): (
        lambda both: both.post(
            "board-file",
            mission=both.mission("example:heart/heart.krt"),
            path="",
            program="heart",
            kit="",
            firmware="",
            firmware_name="",
        ),
    ),
    ("POST", "/api/experiment/choices"): (
        lambda both: both.post("experiment/choices", mission=both.mission(), path="rich.krt"),
    ),
    ("POST", "/api/experiment/plan"): (
        lambda both: both.post("experiment/plan", **experiment(both)),
        lambda both: both.post("experiment/plan", **{**experiment(both), "seeds": "none"}),
    ),
    ("GET", "/api/experiment/study"): (lambda both: both.get("experiment/study", **NO_STUDY),),
    ("GET", "/api/experiment/runs"): (lambda both: both.get("experiment/runs", **NO_STUDY, first=0, count=9),),
    ("GET", "/api/experiment/table"): (lambda both: both.get("experiment/table", **NO_STUDY),),
    ("POST", "/api/experiment/replay"): (
        lambda both: both.page.post("/api/experiment/replay", params={**NO_STUDY, "row": 0}),
    ),
    ("GET", "/api/tutorials"): (lambda both: both.get("tutorials"),),
    ("POST", "/api/tutorial/watch"): (
        lambda both: both.post(
            "tutorial/watch",
            tutorial=both.get("tutorials").json()[0]["name"],
            mission=both.mission(),
            path="rich.krt",
        ),
    ),
    ("GET", "/api/exercises"): (lambda both: both.get("exercises"),),
    ("POST", "/api/exercise/judge"): (
        lambda both: both.post(
            "exercise/judge",
            exercise="example:exercises/03-square.exercise.xml",
            mission=both.mission("example:exercises/03-square.krt"),
            seed=1,
        ),
    ),
    ("POST", "/api/exercise/stop"): (lambda both: both.post("exercise/stop", judging="none"),),
    ("PUT", "/api/handed-out"): (
        lambda both: both.page.put("/api/handed-out", content=b"", params={"exercise": "a.exercise.xml"}),
    ),
    ("POST", "/api/run-stretch"): (
        lambda both: both.post("run-stretch", mission=both.mission(), path="rich.krt", seed=1, first=0, last=9),
        lambda both: both.post("run-stretch", mission=both.mission(), path="rich.krt", seed=1, first=9, last=9),
    ),
    ("GET", "/api/beginnings"): (lambda both: both.get("beginnings"),),
    ("GET", "/api/beginnings/previews"): (
        lambda both: both.get("beginnings/previews", **first_beginning(both, starter=False)),
    ),
    ("GET", "/api/mission/begin"): (lambda both: both.get("mission/begin", **first_beginning(both)),),
    ("GET", "/api/traces"): (lambda both: both.get("traces"),),
    ("GET", "/api/trace"): (lambda both: both.get("trace", path="none.krtrace"),),
    ("POST", "/api/trace"): (lambda both: both.send("trace", text_of_a_run(both).content, name="a.krtrace"),),
    ("GET", "/api/run/trace"): (text_of_a_run,),
    ("GET", "/api/run/judgements"): (judgements_of_a_run, lambda both: both.get("run/judgements", run="none")),
    ("GET", "/"): (lambda both: both.page.get("/"),),
}
"""What is asked of each route, with an answer and, where there is one, a refusal that is said by hand."""
REFUSED = {
    *(("POST", f"/api/{path}") for path in ("again/token", "firmware", "journal/forget", "experiment/replay")),
    *(("GET", f"/api/{path}") for path in ("board/trace", "trace")),
    *(("GET", f"/api/experiment/{path}") for path in ("study", "runs", "table")),
    ("PUT", "/api/handed-out"),
}
"""Those of which no answer is to be had here."""


def experiment(both: Both) -> dict[str, Any]:
    asked = {"axes": [], "seeds": "1-3", "measures": ["seconds"], "seconds": 5}
    return {"mission": both.mission(), "path": "rich.krt", **asked}


def first_beginning(both: Both, starter: bool = True) -> dict[str, str]:
    found = both.get("beginnings").json()
    chosen = {"robot_set": found["robot_sets"][0]["name"], "place": found["places"][0]["name"]}
    return {**chosen, "starter": found["starters"][0]["name"]} if starter else chosen


class Compared:
    """orjson, whose answers are held against those of the standard library; `differences` says where they are two."""

    def __init__(self) -> None:
        self.differences: list[str] = []
        self.written = self.read = 0

    def dumps(self, value: Any, option: int) -> bytes:
        made = orjson.dumps(value, option=option)
        self.written += 1
        self._compare(json.loads(made), lambda: json.loads(json_text.plain_to_json(value)))
        return made

    def loads(self, text: bytes | str) -> Any:
        value = orjson.loads(text)
        self.read += 1
        self._compare(value, lambda: json_text.plain_from_json(text))
        return value

    def _compare(self, value: Any, plain: Callable[[], Any]) -> None:
        try:
            same = plain() == value
        except (TypeError, ValueError) as error:
            self.differences.append(f"{error!r}: {value!r:.200}")
        else:
            if not same:
                self.differences.append(f"{value!r:.200}")


def test_every_route_reads_and_writes_the_same_with_and_without_orjson(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert json_text.HAS_ORJSON
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    compared = Compared()
    monkeypatch.setattr(json_text, "fast", compared)
    both = Both(tmp_path / "both")
    routes = {
        (method, getattr(route, "path", ""))
        for route in both.app.router.routes
        for method in getattr(route, "methods", None) or ()
        if method != "HEAD"
    }
    assert routes == set(ASKED)
    for (method, path), every in ASKED.items():
        for asking in every:
            status = asking(copy.copy(both)).status_code
            assert compared.differences == [], f"{method} {path}"
            assert status < 500, f"{method} {path}"
            assert status == 200 or asking is not every[0] or (method, path) in REFUSED, (method, path, status)
    assert min(compared.written, compared.read) > 20


def test_what_only_orjson_could_write_is_written_by_neither() -> None:
    from dataclasses import dataclass
    from datetime import datetime

    @dataclass
    class Note:
        text: str

    for odd in (Note("a"), datetime(2000, 1, 1), {1, 2}, b"a"):
        for write in (json_text.to_json, json_text.plain_to_json):
            with pytest.raises(TypeError):
                write({"a": odd})


def test_the_news_of_a_run_are_written_without_orjson(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(json_text, "HAS_ORJSON", False)
    assert '"done"' in Both(tmp_path).run()
