"""Missions with programs of teams over the wire: nothing of them is lost; the catalogue says what they are made of."""

from __future__ import annotations

from kitrobot.mission.reader import read_mission
from kitrobot.wire.mission import MissionShape, mission_from_shape, mission_shape
from tests.forms.test_written_opens import FULL


def test_a_mission_that_travelled_is_the_mission():
    mission, _ = read_mission(FULL.encode(), "full.krt")
    assert mission is not None
    text = mission_shape(mission).model_dump_json()
    assert mission_from_shape(MissionShape.model_validate_json(text)) == mission


def test_constructors_say_of_which_level_they_are(page):
    answer = page.get("/api/mission/new").json()["catalogue"]
    levels = {one["name"]: one["level"] for group in answer["groups"] for one in group["constructors"]}
    assert (levels["While"], levels["SeqOfPar"], levels["Move"]) == ("agent", "group", "social")


def test_a_team_s_program_is_reported_with_its_text(page):
    mission, _ = read_mission(FULL.encode(), "full.krt")
    assert mission is not None
    shape = mission_shape(mission).model_dump(mode="json")
    answer = page.post("/api/check", json={"mission": shape, "path": "blink.krt"})
    assert answer.status_code == 200, answer.text
    [report] = [one for one in answer.json()["programs"] if one["name"] == "haul"]
    assert report["lll"].endswith("PROGRAM p;\n")
    assert report["spans"][0]["vertex"] == "v1"


def test_slots_say_what_they_name(page):
    answer = page.get("/api/mission/new").json()["catalogue"]
    slots = {
        (one["name"], slot["name"]): slot["names"]
        for group in answer["groups"]
        for one in group["constructors"]
        for slot in one["slots"]
    }
    assert slots["SeqOfPar", "members"] == slots["Move", "source"] == slots["Move", "target"] == "set"
    assert (slots["Program", "name"], slots["Where", "condition"], slots["Move", "count"]) == ("program", "", "")


def test_a_first_program_of_a_team_is_made_and_projected(page):
    mission = page.get("/api/mission?path=blink.krt").json()["mission"]
    wanted = {"mission": mission, "path": "blink.krt", "name": "team"}
    after = page.post("/api/mission/team", json=wanted).json()
    assert [(one["name"], one["level"]) for one in after["programs"]][-1] == ("team", "social")
    report = page.post("/api/check", json={"mission": after, "path": "blink.krt"}).json()
    assert report["problems"] == []
    [projection] = report["projections"]
    assert projection["robot"] == mission["programs"][0]["robot"]
    assert {one["program"] for one in projection["spans"]} == {"team", mission["programs"][0]["name"]}
    again = page.post("/api/mission/team", json={**wanted, "mission": after})
    assert again.status_code == 422
    assert again.json()["message"] == "The mission has a program of the whole team already."
    assert page.post("/api/mission/team", json={**wanted, "name": ""}).status_code == 422
