"""What the studio keeps between two questions never shows in an answer: each is what a studio that just began says."""

from __future__ import annotations

import copy
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kitrobot.server.app import create_app
from kitrobot.workspace.compile_cache import MOST_STATES
from tests.effort import examples
from tests.server.conftest import HOST, TOKEN, TestClient

ROBOT = """<robot name="rover" version="1">
  <actuator name="Lamp"><procedure name="{word}"/></actuator>
</robot>
"""
Mission = dict[str, Any]


@pytest.fixture(autouse=True)
def _folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    monkeypatch.setenv("KITROBOT_CONFIG", str(tmp_path / "config"))


@pytest.fixture
def mission(page: TestClient, transport: str) -> Mission:
    found: Mission = page.get("/api/mission", params={"path": transport}).json()["mission"]
    return found


class Studio:
    """A studio that goes on, beside one that begins anew for each question."""

    def __init__(self, page: TestClient, folder: Path) -> None:
        self.page = page
        self.folder = folder

    def _both(self, address: str, wanted: Mission) -> Mission:
        fresh = TestClient(create_app(self.folder, None, TOKEN), base_url=HOST, headers={"X-KitRobot-Token": TOKEN})
        answer, expected = self.page.post(address, json=wanted), fresh.post(address, json=wanted)
        found: Mission = answer.json()
        assert (answer.status_code, found) == (expected.status_code, expected.json())
        return found

    def check(self, mission: Mission) -> Mission:
        return self._both("/api/check", {"mission": mission, "path": "transport.krt"})

    def typed(self, mission: Mission, text: str) -> Mission:
        name = mission["programs"][0]["name"]
        wanted = {"mission": mission, "path": "transport.krt", "program": name, "text": text}
        return self._both("/api/text", wanted)


@pytest.fixture
def studio(page: TestClient, folder: Path) -> Studio:
    return Studio(page, folder)


def _program(mission: Mission, at: int = 0) -> Mission:
    found: Mission = mission["programs"][at]
    return found


def _numbered(mission: Mission) -> Mission:
    found: Mission = next(one for one in _program(mission)["vertices"] if one["settings"])
    return found


def _set_number(mission: Mission) -> None:
    settings = _numbered(mission)["settings"]
    settings[next(iter(settings))] = "77"


def _break_number(mission: Mission) -> None:
    settings = _numbered(mission)["settings"]
    settings[next(iter(settings))] = "much"


def _cut_arc(mission: Mission) -> None:
    _program(mission)["arcs"].pop()


def _note(mission: Mission) -> None:
    _program(mission)["vertices"][1]["notes"].append({"text": "so", "at": ""})


def _other_program(mission: Mission) -> None:
    _program(mission, 1)["vertices"].pop()


def _other_robot(mission: Mission) -> None:
    _program(mission)["robot"] = "mini-robot"


def _rename(mission: Mission) -> None:
    _program(mission)["name"] = "anew"


CHANGES: list[Callable[[Mission], None]] = [
    _set_number,
    _break_number,
    _cut_arc,
    _note,
    _other_program,
    _other_robot,
    _rename,
]


@pytest.mark.parametrize("change", CHANGES)
def test_each_edit_is_answered_anew_and_so_is_its_undo(
    studio: Studio, mission: Mission, change: Callable[[Mission], None]
) -> None:
    first = studio.check(mission)
    after = copy.deepcopy(mission)
    change(after)
    assert studio.check(after) != first
    assert studio.check(mission) == first


def test_a_text_is_followed_beside_the_graph_that_was_sent_with_it(studio: Studio, mission: Mission) -> None:
    lll = studio.check(mission)["programs"][0]["lll"]
    first = studio.typed(mission, lll + "WAIT(5);")
    assert first["program"] is not None
    after = copy.deepcopy(mission)
    _note(after)
    noted = studio.typed(after, studio.check(after)["programs"][0]["lll"] + "WAIT(5);")
    assert noted["program"] != first["program"]
    after["programs"][0] = noted["program"]
    assert studio.check(after) == noted["report"]
    assert studio.typed(mission, lll + "WAIT(5);") == first
    assert studio.typed(mission, lll + "WAIT(5")["program"] is None


def test_a_robot_whose_file_changes_is_read_by_the_next_check(studio: Studio, mission: Mission, folder: Path) -> None:
    program = _program(mission)
    program["robot"] = "rover"
    program["vertices"] = [program["vertices"][0], program["vertices"][-1]]
    ends = [vertex["id"] for vertex in program["vertices"]]
    shine = {"id": "s", "element": "Lamp.Shine", "settings": {}, "notes": [], "unknown": ""}
    program["vertices"].insert(1, shine)
    program["arcs"] = [
        {"source": ends[0], "target": "s", "out": "next", "at": "in"},
        {"source": "s", "target": ends[1], "out": "next", "at": "in"},
    ]
    codes = []
    for word in (None, "Shine", "Glow", "Shine"):
        if word is not None:
            (folder / "rover.robot.xml").write_text(ROBOT.format(word=word))
        report = studio.check(mission)
        codes.append([one["code"] for one in report["problems"] if "s" in one["vertices"]])
    assert codes[1] == codes[3] == []
    assert codes[2] == ["unknown-element"]
    (folder / "rover.robot.xml").unlink()
    assert studio.check(mission)["programs"][0]["lll"] == ""


def test_parts_of_the_mission_s_own_that_change_change_what_they_are_in(
    studio: Studio, page: TestClient, mission: Mission
) -> None:
    name = _program(mission)["name"]
    flow = [one["id"] for one in _program(mission)["vertices"] if one["element"] in ("Forever", "While", "Repetition")]
    wanted = {"mission": mission, "path": "transport.krt", "program": name, "vertices": flow[:1]}
    made = page.post("/api/part", json={**wanted, "name": "Trip", "colour": "loop", "chosen": []}).json()["part"]
    own = copy.deepcopy(mission)
    own["programs"][0], own["constructors"] = made["program"], [made["constructor"]]
    first = studio.check(own)
    assert not [one for one in first["problems"] if one["code"] == "unknown-element"]
    other = copy.deepcopy(own)
    other["constructors"][0]["code"] = "WAIT(3);"
    other["constructors"][0]["slots"] = []
    assert studio.check(other)["programs"][0]["lll"] != first["programs"][0]["lll"]
    other["constructors"] = []
    assert [one for one in studio.check(other)["problems"] if one["code"] == "unknown-element"]
    assert studio.check(own) == first


def test_two_windows_that_edit_the_same_program_are_each_answered_for_their_own(
    studio: Studio, mission: Mission
) -> None:
    windows = [copy.deepcopy(mission), copy.deepcopy(mission)]
    for turn in range(2 * MOST_STATES):
        for at, window in enumerate(windows):
            typed = _numbered(window)["settings"]
            typed[next(iter(typed))] = number = str(10 * turn + at)
            assert f"({number})" in studio.check(window)["programs"][0]["lll"]


@settings(max_examples=examples(8), deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.randoms(use_true_random=True))
def test_each_key_is_answered_as_by_a_studio_that_begins_anew(
    studio: Studio, mission: Mission, rng: random.Random
) -> None:
    mission, text = copy.deepcopy(mission), studio.check(mission)["programs"][0]["lll"]
    for _ in range(6):
        lines = text.splitlines(keepends=True)
        at = rng.randrange(len(lines) + 1)
        lines[at : at + rng.randrange(2)] = rng.choice(
            [["WAIT(7);\n"], ["2*(\n", "  WAIT(1);\n", "  BREAK;\n", ");\n"], ["# é🙂\n", "BREAK;\n"], []]
        )
        found = studio.typed(mission, "".join(lines))
        if found["program"] is not None:
            mission["programs"][0] = found["program"]
            text = found["report"]["programs"][0]["lll"]
            assert studio.check(mission) == found["report"]
