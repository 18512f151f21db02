"""A team of processes in the studio: given bodies, started, shown as a run, stopped; by keys and on a phone."""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import EXAMPLES, Studio
from tests.studio.looks import find_nothing
from tests.studio.test_watching import another_window, status_is

pytestmark = pytest.mark.browser

ACTIVE = ".vertex.is-active"


def open_pair(open_studio: Callable[..., Studio], tmp_path: Path) -> Studio:
    """The studio on two robots that drive there and back until they are stopped, with its panel of robots."""
    mission = shutil.copytree(EXAMPLES / "pair", tmp_path / "source") / "pair.krt"
    text = mission.read_text(encoding="utf-8")
    mission.write_text(text.replace('<set name="count">2</set>', '<set name="count">200</set>'), encoding="utf-8")
    studio = open_studio(str(mission))
    studio.page.keyboard.press("Alt+r")
    expect(studio.at("crew").get_by_role("combobox")).to_have_count(2)
    return studio


def start(studio: Studio) -> None:
    """Starts the team with the keyboard."""
    studio.at("crew-start").focus()
    studio.page.keyboard.press("Enter")
    expect(studio.at("crew-status")).to_have_attribute("data-phase", "running")
    status_is(studio.page, "running")


@pytest.mark.slow
def test_a_team_is_started_glows_and_is_stopped(open_studio: Callable[..., Studio], tmp_path: Path) -> None:
    studio = open_pair(open_studio, tmp_path)
    start(studio)
    expect(studio.at("crew")).to_contain_text("Takes part")
    find_nothing(studio, "a team that runs")
    studio.at("crew-watch").click()
    expect(studio.page.locator(ACTIVE).first).to_be_visible()
    # What is watched takes the place of the panel.
    studio.page.keyboard.press("Alt+r")
    studio.at("crew-stop").click()
    expect(studio.at("crew-status")).to_contain_text(re.compile("stood still within [0-9]+ ms"))
    status_is(studio.page, "stopped")


@pytest.mark.slow
@pytest.mark.thorough(
    "the test above; tests/server/test_fleet_runs.py: stopped from every window, what cannot be started is told; "
    "web/src/features/robots/boards.test.ts: bodies of a mission; features/run/bars.test.tsx: the past of robots"
)
def test_a_team_is_given_bodies_paused_in_what_is_shown_and_stopped_from_a_phone(
    open_studio: Callable[..., Studio], tmp_path: Path
) -> None:
    studio = open_pair(open_studio, tmp_path)
    page, crew = studio.page, studio.at("crew")
    expect(studio.at("crew-send")).to_be_disabled()
    # A board that is not plugged in can be chosen by its address, for one agent at a time.
    studio.at("robots-address").fill("127.0.0.1:1")
    page.keyboard.press("Enter")
    one, two = (crew.get_by_label(f"Body of robot-{n}") for n in (1, 2))
    one.select_option("socket://127.0.0.1:1")
    two.select_option("socket://127.0.0.1:1")
    expect(one).to_have_value("")
    studio.at("crew-send").click()
    expect(studio.at("crew-trouble")).to_have_count(1)
    expect(studio.at("crew-refused")).to_contain_text("robot-2")
    find_nothing(studio, "a team that could not be sent to")
    two.select_option("")
    expect(studio.at("crew-send")).to_be_disabled()
    other = another_window(studio)
    other.set_viewport_size({"width": 390, "height": 844})
    other.keyboard.press("Alt+r")
    start(studio)
    studio.at("pause-button").click()
    expect(studio.at("behind-bar")).to_contain_text("does not pause them")
    studio.at("follow").click()
    expect(studio.at("behind-bar")).to_have_count(0)
    expect(other.get_by_test_id("crew-status")).to_contain_text("The team runs")
    assert other.evaluate("document.documentElement.scrollWidth") <= 390
    other.get_by_test_id("crew-stop").click()
    expect(other.get_by_test_id("crew-status")).to_contain_text(re.compile("stood still within [0-9]+ ms"))
    status_is(page, "stopped")
