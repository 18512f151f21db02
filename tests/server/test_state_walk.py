"""`POST /api/walk`: a state and its steps in the reader's language, a run that broke walked again, and refusals."""

from __future__ import annotations

from typing import Any

import pytest

from tests.verifier.check_fixtures import EXAMPLES

LOOP = (EXAMPLES / "passing-loop" / "passing-loop.krt").read_text(encoding="utf-8")


@pytest.fixture
def walking(page):
    """Asks for a walk through the mission of a text."""

    def walk(text: str = LOOP, *, language: str = "en", **more: Any):
        mission = page.post("/api/mission/read", content=text.encode()).json()["mission"]
        asked = {"mission": mission, "path": "", "seed": 1, "timing": "free", "places": [], **more}
        return page.post("/api/walk", json=asked, headers={"Accept-Language": language})

    return walk


def test_a_walk_says_what_happened_what_can_happen_and_where_everybody_is(walking) -> None:
    begun = walking().json()
    assert (begun["places"], begun["happened"], begun["situation"], begun["more"]) == ([], [], [], 0)
    assert begun["possible"][0]["sentences"] == ["`carrier-1` goes on in its program", "AskANorth = 1"]
    taken = walking(places=[0], failures=1).json()
    assert taken["happened"] == ["`carrier-1` goes on in its program", "AskANorth = 1"]
    assert taken["scene"]["step"] == 1
    assert taken["scene"]["robots"][0]["at"] == [["carrier-north", "v4"]]
    assert any(step["is_failure"] for step in taken["possible"])
    french = walking(places=[0], language="fr").json()
    assert french["happened"][0] != taken["happened"][0]


def test_a_walk_goes_on_while_there_is_one_way(walking) -> None:
    blink = (EXAMPLES / "blink" / "blink.krt").read_text(encoding="utf-8")
    ended = walking(blink, timing="lockstep", goes_on=True).json()
    assert len(ended["places"]) > 10
    assert (ended["possible"], ended["situation"]) == ([], ["The mission is done."])


@pytest.mark.parametrize(
    ("asked", "status", "words"),
    [
        ({"places": [9999]}, 422, "there is no step 10000 out of state 0"),
        ({"places": [-1]}, 422, ""),
        ({"places": [0] * 6000}, 422, ""),
        ({"failures": 9}, 422, ""),
        ({"timing": "slow"}, 422, ""),
        ({"kinds": []}, 422, ""),
    ],
)
def test_what_is_no_walk_is_refused(walking, asked: dict[str, Any], status: int, words: str) -> None:
    said = walking(**asked)
    assert said.status_code == status
    assert words.lower() in said.json()["message"].lower()


def test_a_mission_with_errors_says_why(walking) -> None:
    text = LOOP.replace('<agent name="gate" program="gate"/>', '<agent name="gate" program="nobody"/>')
    assert text != LOOP
    said = walking(text)
    assert said.status_code == 422
    assert said.json()["message"]
