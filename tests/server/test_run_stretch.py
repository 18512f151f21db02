"""`POST /api/run-stretch`: a run between two steps, at every step while there is room, and refusals."""

from __future__ import annotations

from typing import Any

import pytest

from kitrobot.workspace import previews
from tests.server.conftest import SHORT


@pytest.fixture
def recording(page):
    """Asks for a stretch of a mission of twenty seconds."""
    text = SHORT.replace('"duration">2<', '"duration">200<')
    mission = page.post("/api/mission/read", content=text.encode()).json()["mission"]

    def ask(**more: Any):
        return page.post("/api/run-stretch", json={"mission": mission, "path": "", "seed": 1, **more})

    return ask


def test_a_stretch_has_a_frame_a_step_and_ends_with_the_run(recording) -> None:
    made = recording(first=10, last=40).json()
    assert (made["run"]["frames"], made["frame_s"]) == (31, 0.02)
    assert [agent["name"] for agent in made["run"]["agents"]] == ["robot-1"]
    assert made["ending"] == ""
    ended = recording(first=10, last=5000).json()
    assert ended["run"]["seconds"] < 25
    assert ended["ending"].endswith(".")
    assert ended["events"][-1]["seconds"] <= ended["run"]["seconds"]
    behind = recording(first=4000, last=5000).json()
    assert behind["run"]["frames"] == 1, "the run is over before"


def test_a_long_stretch_has_fewer_frames_than_steps(recording, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(previews, "MOST_STRETCH", 11)
    made = recording(first=0, last=40).json()
    assert made["frame_s"] == pytest.approx(0.08)
    assert made["run"]["frames"] == 11


@pytest.mark.parametrize(
    ("asked", "status", "words"),
    [
        ({"first": 5, "last": 5}, 422, "ends after step 5, not at step 5"),
        ({"first": -1, "last": 5}, 422, ""),
        ({"first": 0, "last": 10**9}, 422, ""),
        ({"first": 0}, 422, ""),
        ({"first": 0, "last": 5, "mission": {}}, 422, ""),
    ],
)
def test_what_is_no_stretch_is_refused(recording, asked: dict[str, Any], status: int, words: str) -> None:
    said = recording(**asked)
    assert said.status_code == status
    assert words in said.json()["message"]


def test_a_mission_that_cannot_run_says_why(page) -> None:
    text = SHORT.replace('program="blink"/>', 'program="missing"/>')
    mission = page.post("/api/mission/read", content=text.encode()).json()["mission"]
    said = page.post("/api/run-stretch", json={"mission": mission, "path": "", "seed": 1, "first": 0, "last": 9})
    assert said.status_code == 422
    assert any("missing" in problem["message"] for problem in said.json()["problems"])
