"""Devices of one's own in the arena: a slider that a person moves, and what indicators show beside the robot."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.gardener import gardener
from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]


@pytest.fixture
def studio(open_studio: OpenStudio, tmp_path: Path) -> Studio:
    folder = tmp_path / "garden"
    folder.mkdir()
    return open_studio(gardener(folder))


@pytest.mark.thorough(
    "web/src/features/arena/hands.test.tsx: a slider sets its sensor; components/scene/boards.test.ts: what "
    "indicators show; devices in a run: tests/sim"
)
def test_a_slider_is_moved_by_hand_and_the_pump_beside_the_robot_follows(studio: Studio) -> None:
    slider = studio.at("hand-Moisture")
    expect(slider).to_be_disabled()
    expect(slider).to_have_value("70")
    studio.full_speed()
    studio.at("run-button").click()
    expect(slider).to_be_enabled()
    studio.at("watch-button").click()
    slider.press("Home")
    expect(studio.at("watch-Moisture")).to_have_attribute("data-forced", "true")
    expect(studio.at("hands").locator("output")).to_have_text("0")
    # By day the dry bed is watered, until it is wet enough.
    expect(studio.at("arena-summary")).to_contain_text("Pump 80")
    slider.press("End")
    expect(studio.at("hands").locator("output")).to_have_text("100")
    expect(studio.at("arena-summary")).not_to_contain_text("Pump")
