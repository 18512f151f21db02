"""Tutorials over the wire: those that come with KitRobot, those dropped into the folder, and what of one is done."""

from __future__ import annotations

import pytest

from kitrobot.translation.languages import TEXT_LANGUAGES
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


def test_eleven_tutorials_come_along_in_each_language_without_a_problem(page):
    tutorials = listed(page)
    assert len(tutorials) == 11
    for tutorial in tutorials.values():
        assert tutorial["problems"] == []
        assert set(TEXT_LANGUAGES) == set(tutorial["label"]) == set(tutorial["help"])
        for step in tutorial["steps"]:
            assert set(TEXT_LANGUAGES) == set(step["label"]) == set(step["help"])
            assert set(step["hint"]) in (set(TEXT_LANGUAGES), set())
            assert step["asks"] or step["events"]
            assert step["points"]


@pytest.mark.parametrize(
    "name",
    [
        *("first-steps", "dance", "draw", "sensing", "faster", "red-line", "bump", "together"),
        *("take-turns", "together-in-step", "when-one-fails"),
    ],
)
def test_a_tutorial_begins_with_a_mission_of_which_no_step_is_done(page, name):
    tutorial = listed(page)[f"example:tutorials/{name}/{name}.tutorial.xml"]
    mission = mission_of(page, tutorial["start"])
    fits = watch(page, tutorial["name"], mission).json()["fits"]
    # A step with events is done by one of them only.
    done = [fit and not step["events"] for fit, step in zip(fits, tutorial["steps"], strict=True)]
    assert done == [False] * len(tutorial["steps"])


def test_what_a_tutorial_begins_with_is_no_example(page):
    paths = [entry["path"] for entry in page.get("/api/missions").json()]
    assert not any("tutorials/" in path for path in paths)


def test_the_square_is_the_whole_first_tutorial_and_a_triangle_is_not(page):
    mission = mission_of(page, "example:draw-square/draw-square.krt")
    assert watch(page, FIRST, mission).json()["fits"] == [True] * 7
    loop = next(vertex for vertex in mission["programs"][0]["vertices"] if vertex["element"] == "Repetition")
    loop["settings"]["count"] = "3"
    assert watch(page, FIRST, mission).json()["fits"] == [True, True, True, True, False, True, False]
    # Nothing is drawn without a pen, and the rest is done all the same.
    mission = mission_of(page, "example:square/square.krt")
    assert watch(page, FIRST, mission).json()["fits"] == [False, False, False, True, True, True, False]


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


def test_a_team_s_program_is_held_against_a_tutorial_in_step_and_each_on_its_own(page):
    name = "example:tutorials/together-in-step/together-in-step.tutorial.xml"
    mission = mission_of(page, "example:tutorials/together-in-step/together-in-step.krt")
    program = mission["programs"][0]
    assert watch(page, name, mission).json()["fits"] == [True, False, False, False, False, True]
    lamp = {"id": "lamp", "element": "Light.LightOn", "settings": {}, "notes": []}
    program["vertices"].append(lamp)
    arc = next(arc for arc in program["arcs"] if (arc["source"], arc["target"]) == ("v2", "v1"))
    arc["target"], arc["at"] = "lamp", "in"
    program["arcs"].append({"source": "lamp", "out": "next", "target": "v1", "at": "return"})
    assert watch(page, name, mission).json()["fits"] == [True, True, True, False, False, True]
    next(vertex for vertex in program["vertices"] if vertex["id"] == "v1")["element"] = "ParOfSeq"
    assert watch(page, name, mission).json()["fits"] == [False, True, False, True, True, True]


def test_the_rule_of_a_group_and_the_spare_robots_are_held_against_a_tutorial(page):
    name = "example:tutorials/when-one-fails/when-one-fails.tutorial.xml"
    mission = mission_of(page, "example:tutorials/when-one-fails/when-one-fails.krt")
    # The rule is to drop at first: that step only waits for its event.
    assert watch(page, name, mission).json()["fits"] == [False, False, False, False, True, False]
    mission["groups"][0]["failure"] = "substitute"
    assert watch(page, name, mission).json()["fits"] == [True, False, False, True, False, False]
    mission["agents"].append({**mission["agents"][0], "name": "robot-4"})
    assert watch(page, name, mission).json()["fits"] == [True, True, True, True, False, False]
    # A robot that runs another program is not spare, nor one that a role takes.
    mission["agents"][3]["program"] = "other"
    assert watch(page, name, mission).json()["fits"][1] is False
    mission["agents"][3]["program"] = mission["agents"][0]["program"]
    mission["roles"][0]["most"] = 4
    assert watch(page, name, mission).json()["fits"][1] is False
    mission["groups"][0]["failure"] = "abort"
    assert watch(page, name, mission).json()["fits"][5] is True
