"""Exercises over the wire: the list, and judging a mission piece by piece; nothing that is hidden is told."""

from __future__ import annotations

import shutil
from concurrent.futures import ThreadPoolExecutor

import pytest

from tests.exercises.handing_in import FOLDER
from tests.primitives.samples import EXERCISE

SQUARE = "example:exercises/03-square.exercise.xml"
JAM = "example:exercises/12-no-jam.exercise.xml"
START = "example:exercises/03-square.krt"


def mission_of(page, path: str) -> dict:
    answer = page.get("/api/mission", params={"path": path})
    assert answer.status_code == 200, answer.text
    mission: dict = answer.json()["mission"]
    return mission


def judge(page, exercise: str, mission: dict, seed: int | None):
    return page.post("/api/exercise/judge", json={"exercise": exercise, "mission": mission, "seed": seed})


def test_twelve_exercises_are_listed_and_what_they_begin_with_is_no_example(page) -> None:
    listed = {one["name"]: one for one in page.get("/api/exercises").json()}
    assert len(listed) == 12
    assert all(one["problems"] == [] and one["goals"] for one in listed.values())
    # Its third seed is hidden.
    assert listed[JAM]["seeds"] == [1, 2]
    assert [goal["kind"] for goal in listed[JAM]["goals"]] == ["run", "run", "run", "check", "check"]
    assert not any("exercises/" in entry["path"] for entry in page.get("/api/missions").json())


def test_a_run_of_one_seed_and_what_is_checked_are_judged_apart(page) -> None:
    mission = mission_of(page, START)
    made = judge(page, SQUARE, mission, 1).json()
    assert [goal["reached"] for goal in made["goals"]] == [True, False, False, True]
    assert made["goals"][1] == {"reached": False, "why": "The robot hardly moved.", "seed": 1, "seconds": 0.02}
    square = mission_of(page, "example:square/square.krt")["programs"][0]
    mission["programs"] = [{**square, "name": "a-square"}]
    made = judge(page, SQUARE, mission, 1).json()
    assert [goal["reached"] for goal in made["goals"]] == [True, True, True, True]
    jam = mission_of(page, "example:exercises/12-no-jam.krt")
    made = judge(page, JAM, jam, None).json()
    assert [goal["reached"] for goal in made["goals"]] == [None, None, None, False, False]
    assert made["goals"][3]["seed"] == 1


def test_a_check_that_is_on_is_stopped_and_what_was_found_is_kept(page, folder) -> None:
    """It has a million states; a check that was cut says of a goal that it is missed, or nothing."""
    for name in ("12-no-jam.krt", "short-ring.world.xml"):
        shutil.copy(FOLDER / name, folder / name)
    goals = "".join(
        f'<holds property="{name}" timing="{timing}" states="1000000"><label>{name}</label></holds>'
        for name, timing in (("deadlock", "lockstep"), ("empty-storehouse", "free"))
    )
    text = (
        f'<exercise version="1" start="12-no-jam.krt"><label>L</label><parts most="9"><label>P</label></parts>{goals}'
    )
    (folder / "long.exercise.xml").write_text(text + "</exercise>")
    asked = {"exercise": "long.exercise.xml", "mission": mission_of(page, "12-no-jam.krt"), "judging": "mine"}
    with ThreadPoolExecutor(1) as other:
        made = other.submit(page.post, "/api/exercise/judge", json=asked)
        told = page.post("/api/exercise/stop", json={"judging": "another"}).json()
        while not made.done():
            page.post("/api/exercise/stop", json={"judging": "mine"})
    assert told is False
    assert [goal["reached"] for goal in made.result().json()["goals"]] == [False, None, None]
    assert page.post("/api/exercise/stop", json={"judging": "mine"}).json() is False


def test_the_world_and_the_robots_are_those_of_the_exercise_whatever_is_sent(page) -> None:
    mission = mission_of(page, START)
    sent = {**mission, "world": "nowhere.world.xml", "agents": [*mission["agents"], *mission["agents"]]}
    made = judge(page, SQUARE, sent, 1)
    assert made.status_code == 200, made.text
    assert made.json()["mission"]["agents"] == mission["agents"]


def test_another_mission_and_an_exercise_with_a_mistake_are_said(page, folder) -> None:
    answer = judge(page, SQUARE, mission_of(page, "blink.krt"), 1)
    assert answer.status_code == 422
    assert "This is another mission: it has no program `a-square`" in answer.text
    (folder / "own.exercise.xml").write_text(EXERCISE.replace("</done>", "</don>"))
    found = {one["name"]: one for one in page.get("/api/exercises").json()}["own.exercise.xml"]
    assert (found["goals"], found["problems"][0]["line"]) == ([], 6)
    assert judge(page, "own.exercise.xml", mission_of(page, "blink.krt"), 1).status_code == 422


def test_what_is_hidden_is_not_told(page, folder) -> None:
    (folder / "own.exercise.xml").write_text(EXERCISE)
    (folder / "x.krt").write_bytes((folder / "blink.krt").read_bytes())
    found = {one["name"]: one for one in page.get("/api/exercises").json()}["own.exercise.xml"]
    assert found["seeds"] == [1]
    assert [goal["label"][""] for goal in found["goals"]] == ["It ends", "A square", "Never stuck"]


@pytest.mark.parametrize("name", ["../x.exercise.xml", "/etc/x.exercise.xml", "blink.krt", ""])
def test_no_name_leads_out_of_the_folder(page, name: str) -> None:
    assert judge(page, name, mission_of(page, "blink.krt"), 1).status_code == 403
