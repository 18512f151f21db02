"""Tutorials over the wire: those that come with KitRobot, those dropped into the folder, and what of one is done."""

from __future__ import annotations

import pytest

from tests.primitives.samples import TUTORIAL

FIRST = "example:tutorials/first-steps/first-steps.tutorial.xml"


def listed(page) -> dict[str, dict]:
    answer = page.get("/api/tutorials")
    assert answer.status_code == 200, answer.text
    return {entry["name"]: entry for entry in answer.json()}


def watch(page, tutorial: str, mission: dict, path: str = ""):
    return page.post("/api/tutorial/watch", json={"tutorial": tutorial, "mission": mission, "path": path})


def mission_of(page, path: str) -> dict:
    answer = page.get("/api/mission", params={"path": path})
    assert answer.status_code == 200, answer.text
    mission: dict = answer.json()["mission"]
    return mission


def test_three_tutorials_come_along_in_three_languages_without_a_problem(page):
    tutorials = listed(page)
    assert len(tutorials) == 3
    for tutorial in tutorials.values():
        assert tutorial["problems"] == []
        assert {"", "fr", "ur"} == set(tutorial["label"]) == set(tutorial["help"])
        for step in tutorial["steps"]:
            assert {"", "fr", "ur"} == set(step["label"]) == set(step["help"])
            assert set(step["hint"]) in ({"", "fr", "ur"}, set())
            assert step["asks"]
            assert step["points"]


@pytest.mark.parametrize("name", ["first-steps", "sensing", "together"])
def test_a_tutorial_begins_with_a_mission_of_which_no_step_is_done(page, name):
    tutorial = listed(page)[f"example:tutorials/{name}/{name}.tutorial.xml"]
    mission = mission_of(page, tutorial["start"])
    assert watch(page, tutorial["name"], mission).json() == {"fits": [False] * len(tutorial["steps"])}


def test_what_a_tutorial_begins_with_is_no_example(page):
    paths = [entry["path"] for entry in page.get("/api/missions").json()]
    assert not any("tutorials/" in path for path in paths)


def test_the_square_is_the_whole_first_tutorial_and_a_triangle_is_not(page):
    mission = mission_of(page, "example:square/square.krt")
    advance = next(vertex for vertex in mission["programs"][0]["vertices"] if vertex["element"] == "Wheel.Advance")
    assert watch(page, FIRST, mission).json()["fits"] == [True, False, *[True] * 7]
    advance["settings"]["speed"] = "60"
    assert watch(page, FIRST, mission).json()["fits"] == [True] * 9
    loop = next(vertex for vertex in mission["programs"][0]["vertices"] if vertex["element"] == "Repetition")
    loop["settings"]["count"] = "3"
    assert watch(page, FIRST, mission).json()["fits"] == [True] * 7 + [False, False]


def test_a_program_with_mistakes_is_watched_too(page):
    mission = mission_of(page, "example:tutorials/sensing/sensing.krt")
    program = mission["programs"][0]
    program["vertices"].append({"id": "v1", "element": "While", "settings": {}, "notes": []})
    program["arcs"] = [
        {"source": "start", "out": "next", "target": "v1", "at": "in"},
        {"source": "v1", "out": "body", "target": "v1", "at": "return"},
        {"source": "v1", "out": "next", "target": "stop", "at": "in"},
    ]
    fits = watch(page, "example:tutorials/sensing/sensing.tutorial.xml", mission).json()["fits"]
    assert fits == [True] + [False] * 7


def test_a_tutorial_dropped_into_the_folder_appears_and_a_mended_one_is_read_again(page, folder):
    (folder / "own").mkdir()
    file = folder / "own" / "mine.tutorial.xml"
    file.write_text(TUTORIAL.replace("</step>", "</stop>"))
    found = listed(page)["own/mine.tutorial.xml"]
    assert found["steps"] == []
    assert [(problem["file"], problem["line"]) for problem in found["problems"]] == [("own/mine.tutorial.xml", 9)]
    assert watch(page, "own/mine.tutorial.xml", mission_of(page, "blink.krt")).status_code == 422
    file.write_text(TUTORIAL)
    found = listed(page)["own/mine.tutorial.xml"]
    assert [problem["message"] for problem in found["problems"]] == ["there is no mission `x.krt` beside this tutorial"]
    (folder / "own" / "x.krt").write_bytes((folder / "blink.krt").read_bytes())
    found = listed(page)["own/mine.tutorial.xml"]
    assert (found["problems"], found["start"], len(found["steps"])) == ([], "own/x.krt", 1)
    assert "own/x.krt" in [entry["path"] for entry in page.get("/api/missions").json()]


@pytest.mark.parametrize(
    "name", ["../x.tutorial.xml", "/etc/x.tutorial.xml", "blink.krt", "", "example:../x.tutorial.xml"]
)
def test_no_name_leads_out_of_the_folder(page, name):
    assert watch(page, name, mission_of(page, "blink.krt")).status_code == 403


def test_a_tutorial_that_went_away_is_said_without_telling_where_it_was(page, folder):
    answer = watch(page, "gone.tutorial.xml", mission_of(page, "blink.krt"))
    assert answer.status_code == 422
    assert str(folder.parent) not in answer.text
    assert "gone.tutorial.xml" in answer.text
