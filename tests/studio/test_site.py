"""The static site from a plain file server, under a path: nothing but files is asked for, and Python runs in the page.

One visit with two starts of Python, because a page with Python in it takes seconds to begin; the second start has no
server any more, and a mission in its address. When a mission is drawn before Python is there, and when not:
`web/src/site/first.test.ts`. More of it, and boards behind ports of the page, are tried in the thorough profile
(`test_site_whole`, `test_site_boards`). Building the folder has tests of its own (`tests/workspace/test_site.py`), the
same Python without a page (`tests/server/test_in_page_server.py`), and so have the sentences of each state, storage
and links (`web/src/site`).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.studio.conftest import Studio
from tests.studio.looks import choose
from tests.studio.sites import BLINK, MEMORY, FileServer, Visit, follow_link, link, wait_for_python

pytestmark = [pytest.mark.browser, pytest.mark.site]


TAKES_OVER_MS = 400_000
"""Chromium lets a service worker take over when the one before has nothing to do; after five minutes at the latest."""


def the_first_mission_is_edited_before_python_is_there_and_goes_on(page: Page, server: FileServer) -> Studio:
    studio = Studio(page, Path(), [])
    server.gate.clear()
    try:
        page.goto(server.address)
        nodes = page.locator(".canvas-node")
        expect(nodes).to_have_count(19)
        expect(studio.at("site")).to_contain_text("You can build already")
        studio.drop("Wait", "arc-start.next")
        expect(nodes).to_have_count(20)
        # The page is left before Python is there, and has it when it is opened again.
        page.reload()
        expect(nodes).to_have_count(20)
        studio.drop("Wait", "arc-start.next")
        expect(nodes).to_have_count(21)
        page.keyboard.press("Control+z")
        expect(nodes).to_have_count(20)
    finally:
        server.gate.set()
    wait_for_python(page)
    studio.expect_code("WAIT(10);")
    expect(studio.at("saved-state")).to_have_text("not saved")
    page.keyboard.press("Control+z")
    expect(nodes).to_have_count(19)
    expect(studio.at("saved-state")).to_have_text("example")
    return studio


def a_mission_runs_is_edited_and_saved_under_a_name_of_its_own(studio: Studio) -> None:
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    studio.drop("Wait", "arc-start.next")
    studio.expect_code("WAIT(10);")
    studio.page.keyboard.press("Control+s")
    studio.at("save-name").fill("mine")
    studio.at("save-name").press("Enter")
    expect(studio.at("saved-state")).to_have_text("saved")


def a_new_version_is_offered(studio: Studio, server: FileServer) -> None:
    studio.page.evaluate("navigator.serviceWorker.ready.then(() => null)")
    worker = server.folder / "service-worker.js"
    worker.write_text(worker.read_text().replace('const VERSION = "', 'const VERSION = "newer-'))
    studio.page.evaluate("navigator.serviceWorker.ready.then((found) => found.update()).then(() => null)")
    expect(studio.at("site")).to_contain_text("There is a new version")


def a_second_tab_waits_and_goes_on_once_the_first_goes_to_the_new_version(studio: Studio, address: str) -> Studio:
    first = studio.page
    second = first.context.new_page()
    second.goto(f"{address}#{link(BLINK, 'linked')}")
    expect(second.get_by_test_id("site")).to_contain_text("open in another tab")
    second.wait_for_load_state("networkidle")
    with first.expect_navigation(timeout=TAKES_OVER_MS):
        studio.at("site").get_by_role("button").click()
    wait_for_python(second)
    expect(first.get_by_test_id("site")).to_contain_text("open in another tab")
    assert "newer-" in second.evaluate("caches.keys().then((names) => names.join())")
    first.close()
    expect(second).to_have_title(re.compile("linked"))
    return Studio(second, Path(), [])


def python_speaks_the_language_that_is_chosen(studio: Studio) -> None:
    choose(studio, "es")
    studio.edit_code()
    studio.page.keyboard.press("Control+Home")
    studio.page.keyboard.type("Foo.Bar();")
    studio.at("problems").click()
    expect(studio.page.locator(".problem").first).to_contain_text("no tiene")


def an_exercise_comes_by_its_link_and_is_handed_in_as_a_file(studio: Studio) -> None:
    studio.page.evaluate("location.hash = 'exercise=example:exercises/03-square.exercise.xml'")
    expect(studio.at("exercise")).to_be_visible()
    with studio.page.expect_download() as handed:
        studio.at("exercise-hand-in").click()
    assert handed.value.suggested_filename == "03-square.krt"
    expect(studio.at("banner")).to_contain_text("03-square.krt")


def test_a_site_opens_a_link_keeps_what_is_saved_and_works_without_its_server(
    server: FileServer, visit: Callable[..., Visit]
) -> None:
    made = visit()
    studio = the_first_mission_is_edited_before_python_is_there_and_goes_on(made.context.new_page(), server)
    follow_link(studio, BLINK, "linked")
    studio.expect_code("WAIT(17);")
    a_mission_runs_is_edited_and_saved_under_a_name_of_its_own(studio)
    # Python's memory of this start is kept, and the next one goes on from it.
    studio.page.wait_for_function(f"async () => await {MEMORY} !== ''")
    a_new_version_is_offered(studio, server)
    server.end()
    studio = a_second_tab_waits_and_goes_on_once_the_first_goes_to_the_new_version(studio, server.address)
    studio.page.keyboard.press("Control+o")
    studio.at("open-dialog").locator('[data-path="mine.krt"]').click()
    expect(studio.page).to_have_title(re.compile("mine"))
    studio.expect_code("WAIT(10);")
    studio.page.evaluate("location.hash = 'mission=AAAA&name=x'")
    expect(studio.at("banner")).to_contain_text("The mission in this link is damaged.")
    an_exercise_comes_by_its_link_and_is_handed_in_as_a_file(studio)
    python_speaks_the_language_that_is_chosen(studio)
    assert made.warned == []
