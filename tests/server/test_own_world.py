"""The world that a mission brings along, at the server's doors; and that the page draws it as the server does."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from kitrobot.server.routes.json_bodies import read_json
from kitrobot.wire.own_world import OwnWorldShape, own_world, own_world_shape
from kitrobot.wire.world import world_shape
from kitrobot.world.lookup import SHIPPED
from kitrobot.world.maze import make_maze
from kitrobot.world.xml_reader import read_world

HELD = Path(__file__).resolve().parents[2] / "web" / "src" / "model" / "testing" / "worlds.json"
"""Worlds as they travel, to be changed and to be drawn; `python -m tests.server.test_own_world` writes it anew."""


MIDDLE = {"x_mm": 0, "y_mm": 0, "radius_mm": 9, "width_mm": 0, "height_mm": 0, "value": 9, "falloff_mm": 0}


def _held() -> str:
    worlds = []
    for name in ("merge", "passing-loop", "ring"):
        world, _ = read_world((SHIPPED / f"{name}.world.xml").read_bytes(), name)
        assert world is not None
        drawn = json.loads(world_shape(world).model_dump_json(), parse_float=lambda text: round(float(text), 4))
        worlds.append({"own": json.loads(own_world_shape(world).model_dump_json()), "drawn": drawn})
    return json.dumps(worlds, separators=(",", ":")) + "\n"


def test_the_page_is_tested_against_the_worlds_as_the_server_draws_them() -> None:
    assert HELD.read_text() == _held(), "write it anew with `python -m tests.server.test_own_world`"


def plan(page: TestClient, href: str = "ring.world.xml", path: str = "transport.krt") -> dict[str, Any]:
    answer = page.get("/api/world/plan", params={"path": path, "href": href})
    assert answer.status_code == 200
    found = answer.json()
    assert isinstance(found, dict)
    return found


def test_a_worlds_file_can_be_had_to_be_changed(page: TestClient) -> None:
    found = plan(page)
    assert found["problems"] == []
    assert found["world"]["docks"][0] == {
        "name": "A",
        "road": "ring",
        "at_mm": 40.0,
        "reach_mm": 40.0,
        "storehouse": "A",
        "kind": "load",
        "side": "left",
    }
    assert found["world"]["roads"][0]["sections"][-1] == {"sign": 5, "from_mm": 1412.168, "to_mm": None}


@pytest.mark.parametrize("href", ["nowhere.world.xml", "../../etc/passwd", "/etc/passwd", "a\0b"])
def test_a_world_that_is_not_there_is_none(page: TestClient, href: str) -> None:
    assert plan(page, href) == {"world": None, "problems": []}


def test_its_text_is_the_text_of_its_file(page: TestClient) -> None:
    answer = page.post("/api/world/text", json=plan(page)["world"])
    assert answer.json()["text"] == (SHIPPED / "ring.world.xml").read_text()


def test_a_mission_with_it_is_saved_opened_and_checked(page: TestClient, transport: str) -> None:
    opened = page.get("/api/mission", params={"path": "transport.krt"}).json()
    world = plan(page)["world"]
    mission = {**opened["mission"], "world": "", "own_world": world}
    assert page.post("/api/check", json={"mission": mission, "path": "transport.krt"}).json()["problems"] == []
    world["docks"][0]["at_mm"] = 9000
    report = page.post("/api/check", json={"mission": mission, "path": "transport.krt"}).json()
    assert [(one["code"], one["thing"], one["line"]) for one in report["problems"]] == [("world-dock", "dock:0", 0)]
    saved = page.put("/api/mission", json={"path": "transport.krt", "revision": opened["revision"], "mission": mission})
    assert saved.status_code == 200
    again = page.get("/api/mission", params={"path": "transport.krt"}).json()
    assert again["mission"] == mission
    assert again["problems"] == []


@pytest.mark.parametrize(
    "wrong",
    [
        {"width_mm": 1e9},
        {"width_mm": -1},
        {"walls": [{"x1": 0, "y1": 0, "x2": "far", "y2": 0}]},
        {"walls": [{"x1": 0, "y1": 0, "x2": 0, "y2": 0}] * 20_001},
        {"lines": [{"colour": "pink", "width_mm": 1, "closed": False, "points": []}]},
        {"starts": [{"name": "a", "at": "moon"}]},
        {"zones": [{"kind": "wet", **MIDDLE}]},
        {"zones": [{"kind": "warm", **MIDDLE, "value": 101}]},
    ],
)
def test_what_no_world_can_be_is_refused(page: TestClient, wrong: dict[str, Any]) -> None:
    world = plan(page)["world"]
    assert page.post("/api/world/text", json={**world, **wrong}).status_code == 422


def test_templates_are_worlds_to_begin_with_and_a_seed_makes_its_maze(page: TestClient) -> None:
    def of(seed: int) -> dict[str, Any]:
        found = page.get("/api/world/templates", params={"seed": seed}).json()
        return {one["name"]: one["world"] for one in found}

    assert list(of(0)) == ["maze", "ring", "crossing", "football", "warehouse", "table"]
    assert own_world(OwnWorldShape.model_validate(of(7)["maze"])).walls == make_maze(7).walls
    assert of(7) == of(7)
    assert [name for name, world in of(1).items() if world != of(2)[name]] == ["maze"]
    for wrong in (-1, 2**32, "x"):
        assert page.get("/api/world/templates", params={"seed": wrong}).status_code == 422


def test_half_a_character_is_mended() -> None:
    world, _ = read_world((SHIPPED / "ring.world.xml").read_bytes(), "ring")
    assert world is not None
    shape = json.loads(own_world_shape(world).model_dump_json())
    body = json.dumps({**shape, "name": "\ud800"}).encode()
    assert own_world(OwnWorldShape.model_validate(read_json(body))).name == "\ufffd"


if __name__ == "__main__":
    HELD.write_text(_held())
