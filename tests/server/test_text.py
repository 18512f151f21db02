"""Typing: the text of a program becomes its graph, or says why not."""

from __future__ import annotations

import json
from typing import Any

import pytest

from kitrobot.server.routes.text import LONGEST_TEXT
from kitrobot.wire.report import ReportShape
from kitrobot.wire.text import FollowedShape
from tests.server.conftest import TestClient


@pytest.fixture
def mission(page: TestClient) -> dict[str, Any]:
    """The mission of the workspace: `Light.LightOn(); WAIT(2);`."""
    opened: dict[str, Any] = page.get("/api/mission", params={"path": "blink.krt"}).json()["mission"]
    return opened


def typed(page: TestClient, mission: dict[str, Any], text: str, program: str = "blink") -> dict[str, Any]:
    wanted = {"mission": mission, "path": "blink.krt", "program": program, "text": text}
    answer = page.post("/api/text", json=wanted)
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def test_the_same_text_gives_the_same_program(page: TestClient, mission: dict[str, Any]) -> None:
    found = typed(page, mission, "Light.LightOn();WAIT( 2 )")
    assert found["program"] == mission["programs"][0]
    assert [span["vertex"] for span in found["spans"]] == ["v1", "v2"]
    assert found["spans"][1] | {"line": 1} == {"vertex": "v2", "start": 16, "end": 25, "line": 1}


def test_a_new_instruction_gets_a_vertex_and_the_others_keep_theirs(page: TestClient, mission: dict[str, Any]) -> None:
    found = typed(page, mission, "Light.LightOn();\nWheel.Stop();\nWAIT(2);")
    assert [vertex["id"] for vertex in found["program"]["vertices"]] == ["start", "v1", "v3", "v2", "stop"]
    assert found["problems"] == []


@pytest.mark.parametrize(
    ("text", "code", "column"),
    [
        ("Light.LightOn(); WAIT(2", "not-closed", 22),
        ("Light.Lighton(); WAIT(2);", "unknown-method", 7),
        ("*[(]><", "syntax", 4),
        ("1*(" * 10_000, "too-deep", 303),
    ],
)
def test_a_mistake_gives_no_program_and_its_place(
    page: TestClient, mission: dict[str, Any], text: str, code: str, column: int
) -> None:
    found = typed(page, mission, text)
    assert (found["program"], found["spans"]) == (None, [])
    assert code in [problem["code"] for problem in found["problems"]]
    first = found["problems"][0]
    assert (first["line"], first["column"], first["program"]) == (1, column, "blink")


def test_a_mistake_names_the_vertex_it_is_at(page: TestClient, mission: dict[str, Any]) -> None:
    found = typed(page, mission, "Light.Lighton(); WAIT(2);")
    assert found["problems"][0]["vertices"] == ["v1"]


def test_a_mistake_that_the_graph_has_already_holds_nothing_back(page: TestClient, mission: dict[str, Any]) -> None:
    mission["programs"][0]["vertices"][1]["element"] = "Lamp.Glow"
    found = typed(page, mission, "Lamp.Glow(); WAIT(3);")
    assert [vertex["element"] for vertex in found["program"]["vertices"]] == ["Start", "Lamp.Glow", "Wait", "Stop"]
    assert typed(page, mission, "Lamp.Glow(); Lamp.Shine();")["program"] is None


def test_many_mistakes_are_told_in_part(page: TestClient, mission: dict[str, Any]) -> None:
    found = typed(page, mission, ")\n" * 500)
    assert len(found["problems"]) == 100


def test_a_text_at_the_limit_is_read_and_one_over_it_refused(page: TestClient, mission: dict[str, Any]) -> None:
    assert typed(page, mission, ";" * LONGEST_TEXT)["program"] is not None
    wanted = {"mission": mission, "path": "", "program": "blink", "text": ";" * (LONGEST_TEXT + 1)}
    answer = page.post("/api/text", json=wanted)
    assert answer.status_code == 422
    assert "at most 1000000" in answer.json()["message"]


def test_a_program_that_is_not_there_and_a_robot_that_is_not_there_are_said(
    page: TestClient, mission: dict[str, Any]
) -> None:
    for change, word in (({"program": "x"}, "no program"), ({}, "no robot")):
        mission["programs"][0]["robot"] = "nobody"
        wanted = {"mission": mission, "path": "", "program": "blink", "text": ""} | change
        answer = page.post("/api/text", json=wanted)
        assert answer.status_code == 422
        assert word in answer.json()["message"]


def test_the_answer_has_the_fields_of_its_shape_and_no_others(page: TestClient, mission: dict[str, Any]) -> None:
    found = typed(page, mission, "# now\nLight.LightOn(); WAIT(3);")
    assert found["program"]["vertices"]
    assert FollowedShape.model_validate(found).model_dump(mode="json") == found
    wrong = typed(page, mission, "Light.Lighton();")
    assert wrong["problems"]
    assert wrong["report"] is None
    assert FollowedShape.model_validate(wrong).model_dump(mode="json") == wrong


def test_the_report_is_what_a_check_of_the_new_mission_says(page: TestClient, mission: dict[str, Any]) -> None:
    found = typed(page, mission, "Light.LightOn(); WAIT(3); Light.LightOn(); Light.LightOff();")
    mission["programs"][0] = found["program"]
    checked = page.post("/api/check", json={"mission": mission, "path": "blink.krt"}).json()
    assert found["report"] == checked
    assert checked["programs"][0]["instructions"]
    assert ReportShape.model_validate(checked).model_dump(mode="json") == checked


def test_half_a_character_in_a_text_is_no_failure(page: TestClient, mission: dict[str, Any]) -> None:
    body = {"mission": mission, "path": "blink.krt", "program": "blink", "text": "# \ud800\nWAIT(2);"}
    answer = page.post("/api/text", content=json.dumps(body), headers={"content-type": "application/json"})
    assert answer.status_code == 200
    assert "\ufffd" in answer.text
