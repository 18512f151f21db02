"""What stands on the page already stays where it is: nobody presses what has just moved under the pointer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Route, expect

from tests.effort import cases
from tests.studio.conftest import Studio
from tests.studio.test_tutorials import BLINK

pytestmark = pytest.mark.browser

TOOLS = ["pause-button", "step-back-button", "step-button", "stop-button", "run-on-robot"]


def test_nothing_moves_while_a_mission_comes_nor_when_a_run_is_paused(open_studio: Callable[[str], Studio]) -> None:
    studio = open_studio(BLINK)
    for fact in (no_tab_and_no_welcome_stands_where_the_mission_will, the_tools_of_the_run_stay_where_they_are):
        fact(studio)


def no_tab_and_no_welcome_stands_where_the_mission_will(studio: Studio) -> None:
    page = studio.page
    held: list[Route] = []
    page.route("**/api/mission?*", lambda route: held.append(route))
    with page.expect_request("**/api/mission?*"), page.expect_response("**/api/tutorials"):
        page.reload()
    expect(studio.at("run-button")).to_be_visible()
    expect(studio.at("tab-of-team")).to_have_count(0)
    expect(studio.at("welcome")).to_have_count(0)
    for route in held:
        route.continue_()
    expect(studio.at("tab-of-team")).to_be_visible()


def the_tools_of_the_run_stay_where_they_are(studio: Studio) -> None:
    def places() -> list[Any]:
        return [studio.at(tool).bounding_box() for tool in TOOLS]

    for language in cases(["ur"], ["en", "fr"]):
        studio.at("menu-View").click()
        studio.at(f"menu-view-{language}").click()
        expect(studio.page.locator("html")).to_have_attribute("lang", language)
        before = places()
        studio.at("run-button").click()
        studio.at("pause-button").click()
        expect(studio.at("step-button")).to_be_enabled()
        assert places() == before, language
        studio.at("stop-button").click()
        expect(studio.at("stop-button")).to_be_disabled()
