"""Who has no board at hand yet says which kit it will be: the parts follow the kit, and so does the robot."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio
from tests.studio.looks import find_nothing

pytestmark = pytest.mark.browser


@pytest.mark.thorough(
    "web/src/features/robots/RobotPanel.test.tsx: a kit and its robot; palette/Palette.test.tsx: parts follow the "
    "kit; web/src/session/kit.test.ts: it is remembered"
)
def test_the_parts_and_the_robot_follow_the_kit_that_was_chosen_without_a_board(
    open_studio: Callable[..., Studio], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("KITROBOT_BOARDS", "")
    studio = open_studio("square/square.krt")
    expect(studio.at("part-Wheel.DriveBy")).to_be_visible()
    studio.page.keyboard.press("Alt+r")
    studio.at("kit-pick").click()
    studio.built_of("microbit")
    chosen = studio.at("kit-at-hand")
    expect(chosen).to_have_attribute("data-kit", "microbit")
    expect(chosen).to_contain_text("This kit has no")
    find_nothing(studio, "a kit without a board")
    expect(studio.at("part-Wheel.DriveBy")).to_have_count(0)
    expect(studio.at("palette-kit")).to_contain_text("micro:bit")
    # The robot that the kit can be is one press away; what the program has and the new robot lacks is a problem.
    studio.at("kit-take-robot").click()
    expect(studio.at("part-Display.Image")).to_be_attached()
    expect(studio.at("kit-take-robot")).to_have_count(0)
    # Remembered, until all parts are wanted again.
    studio.page.keyboard.press("Control+z")
    studio.page.reload()
    expect(studio.at("palette-kit")).to_be_visible()
    expect(studio.at("part-Wheel.DriveBy")).to_have_count(0)
    studio.at("palette-all-parts").click()
    expect(studio.at("part-Wheel.DriveBy")).to_be_visible()
    expect(studio.at("palette-kit")).to_have_count(0)
