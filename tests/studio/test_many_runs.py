"""Check, map of failures and experiment of one small mission: asked in the page, answered by a server, and played."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from kitrobot.server.routes import drawing_check as drawing_check_socket
from tests.patience import PATIENCE_S
from tests.studio.conftest import Studio
from tests.studio.looks import find_nothing
from tests.workspace.test_drawing_check import WAIT

pytestmark = pytest.mark.browser

PATIENCE_MS = 1000 * PATIENCE_S


@pytest.fixture
def stranded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, open_studio) -> str:
    """A carrier that waits for a sign which its road does not have."""
    path = tmp_path / "made" / "stranded" / "stranded.krt"
    path.parent.mkdir(parents=True)
    path.write_text(WAIT, encoding="utf-8")
    monkeypatch.setattr(drawing_check_socket, "EXPLORE_S", None)  # However busy the machine is.
    monkeypatch.setitem(open_studio.__globals__, "EXAMPLES", tmp_path / "made")
    return "stranded/stranded.krt"


def expect_status(studio: Studio, status: str) -> None:
    expect(studio.at("status")).to_have_attribute("data-status", status, timeout=PATIENCE_MS)


def after_an_edit_what_waits_for_ever_is_a_problem_that_a_run_shows(studio: Studio) -> None:
    studio.at("vertex-halt").click()
    studio.page.keyboard.press("Delete")
    expect(studio.at("problem-first")).to_have_attribute("data-severity", "warning", timeout=PATIENCE_MS)
    studio.at("problems").click()
    expect(studio.at("problem-1")).to_contain_text("carrier-1 can come to wait here for ever", ignore_case=True)
    studio.at("show-1").click()
    expect_status(studio, "paused")
    studio.page.keyboard.press("Control+z")
    expect(studio.at("problem-first")).to_have_count(0)


def a_property_is_written_and_what_breaks_it_is_played_up_to_its_moment(studio: Studio) -> None:
    keys = studio.page.keyboard
    keys.press("Alt+c")
    studio.at("property-add-never").click()
    studio.at("property-first-0").focus()
    # Completion takes "any ", then the robot, then a test of it.
    for letters in ("", "car", "Sign.Eq"):
        keys.type(letters)
        keys.press("Enter")
    keys.type(")")
    expect(studio.at("property-first-0")).to_have_value("any carrier-1 (Sign.EqualTo(1))")
    studio.at("check-begin").click()
    broken = studio.page.locator('.check-answer[data-shape="broken"]').first
    expect(broken).to_be_visible(timeout=PATIENCE_MS)
    expect(studio.at("check-begin")).to_be_visible(timeout=PATIENCE_MS)
    broken.click()
    expect(studio.page.locator(".guilty-cross").first).to_be_visible()
    find_nothing(studio, "the check with a run open", within="[data-testid=check]")
    studio.at("check-play").click()
    expect_status(studio, "paused")
    keys.press("Control+z")


def a_field_of_the_map_of_failures_is_played_and_ends_as_it_says(studio: Studio) -> None:
    studio.at("menu-Run").click()
    studio.at("menu-run-sweep").click()
    studio.at("sweep-moments").select_option("10")
    studio.at("sweep-seconds").fill("4")
    studio.at("sweep-begin").click()
    expect(studio.at("sweep-map")).to_be_visible(timeout=PATIENCE_MS)
    find_nothing(studio, "the map of failures", within="[data-testid=sweep]")
    studio.full_speed()
    field = studio.at("field-0-0")
    field.click()
    expect_status(studio, str(field.get_attribute("data-ending")))


def a_dot_of_an_experiment_is_a_run_that_plays(studio: Studio) -> None:
    studio.at("menu-Run").click()
    studio.at("menu-run-experiment").click()
    studio.at("experiment-address").fill("drive.go.speed")
    # By key: the panel may still find its width, and a click would meet what has come to its place.
    studio.at("experiment-address").press("Enter")
    studio.at("values-drive.go.speed").fill("20,30")
    studio.at("experiment-seeds").fill("1")
    studio.at("experiment-seconds").fill("4")
    expect(studio.at("experiment-begin")).to_have_text("Do 2 runs", timeout=PATIENCE_MS)
    studio.at("experiment-begin").click()
    expect(studio.at("experiment-done")).to_have_text("2 of 2 runs", timeout=PATIENCE_MS)
    find_nothing(studio, "the experiment", within="[data-testid=experiment]")
    studio.at("point-1").press("Enter")
    studio.at("run-1").press("Enter")
    expect(studio.page.locator('.experiment-run[data-played="true"]')).to_have_count(1)
    expect_status(studio, "time")


def test_a_mission_is_checked_its_failures_are_mapped_and_an_experiment_is_made_and_played(
    open_studio, stranded: str
) -> None:
    studio = open_studio(stranded)
    after_an_edit_what_waits_for_ever_is_a_problem_that_a_run_shows(studio)
    a_property_is_written_and_what_breaks_it_is_played_up_to_its_moment(studio)
    a_field_of_the_map_of_failures_is_played_and_ends_as_it_says(studio)
    a_dot_of_an_experiment_is_a_run_that_plays(studio)
