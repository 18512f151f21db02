"""More of the static site (thorough profile): features of the studio in it, damaged storage, no locks."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.studio.conftest import Studio
from tests.studio.sites import MEMORY, FileServer, Visit, follow_link, opened, wait_for_python
from tests.studio.test_check import greedy_text
from tests.studio.test_exercises import JAM
from tests.studio.test_files_out import keep
from tests.studio.test_recordings import drop, expect_tick, value
from tests.studio.test_tutorials import at_step, begin, first_steps_until_run

pytestmark = [
    pytest.mark.browser,
    pytest.mark.site,
    pytest.mark.thorough(
        "studio/test_site.py on the main path, web/src/site/*.test.ts for locks, memory and storage; features run the "
        "same code as in the installed studio, without threads in server/test_in_page_server.py"
    ),
]

NO_LOCKS = "delete Navigator.prototype.locks"
DAMAGE = """async ([name, address, table]) => {
    const headers = { "X-Table": table, "X-Length": "64" };
    await (await caches.open(name)).put(address, new Response(new Uint8Array(64), { headers }));
}"""
ENTRY = """async (name) => {
    const cache = await caches.open(name);
    const [asked] = await cache.keys();
    return [name, asked.url, (await cache.match(asked)).headers.get("X-Table")];
}"""


LATER = """async () => {
    const name = (await indexedDB.databases()).find(({ name }) => name.startsWith("/home")).name;
    const done = (asked) => new Promise((yes, no) => {
        asked.onsuccess = () => yes(asked.result);
        asked.onerror = asked.onblocked = () => no(asked.error);
    });
    (await done(indexedDB.open(name, 99))).close();
}"""
"""As a later browser or KitRobot would leave it: this one cannot read it."""
ENTRIES = """async () => {
    const name = (await indexedDB.databases()).find(({ name }) => name.startsWith("/home")).name;
    const db = await new Promise((yes) => (indexedDB.open(name).onsuccess = (event) => yes(event.target.result)));
    const keys = db.transaction("FILE_DATA").objectStore("FILE_DATA").getAllKeys();
    await new Promise((yes) => (keys.onsuccess = yes));
    db.close();
    return keys.result;
}"""


def a_run_is_stepped_back_in_saved_and_opened_again(studio: Studio, folder: Path) -> None:
    end = value(studio, "aria-valuenow")
    studio.at("step-back-button").click()
    expect_tick(studio, end - 1)
    studio.page.get_by_role("menuitem", name="Run", exact=True).click()
    with studio.page.expect_download() as saved:
        studio.page.get_by_role("menuitem", name="Save this run").click()
    path = folder / "kept.krtrace"
    saved.value.save_as(path)
    drop(studio, path.name, path.read_bytes())
    expect(studio.at("recording-bar")).to_contain_text("kept.krt, seed 1")
    studio.at("event-strip").focus()
    studio.page.keyboard.press("End")
    expect_tick(studio, end)


def a_mission_goes_out_as_a_picture_and_comes_back(studio: Studio, folder: Path) -> None:
    path = keep(studio, "export-png", folder)
    studio.new_mission()
    expect(studio.at("first-place")).to_be_visible()
    studio.page.keyboard.press("Control+o")
    studio.at("open-file").set_input_files(path)
    expect(studio.at("tab-store-manager-A")).to_be_visible()


def an_exercise_is_judged(studio: Studio) -> None:
    studio.page.keyboard.press("Control+o")
    studio.at(JAM).click()
    studio.at("exercise-judge").click()
    expect(studio.at("exercise-basis")).to_have_text("Judged in 2 runs.")
    expect(studio.at("exercise-goal-2")).to_have_attribute("data-state", "missed")
    studio.at("exercise-leave").click()


def a_check_tells_what_breaks_and_plays_it(studio: Studio) -> None:
    follow_link(studio, greedy_text(), "greedy")
    studio.page.keyboard.press("Alt+c")
    # A quarter of the time is for looking in the simulator: a busy machine needs more than usual.
    studio.at("check-seconds").select_option("1800")
    studio.at("check-begin").click()
    broken = studio.at("answer-empty-storehouse-lockstep-0")
    expect(broken).to_have_attribute("data-shape", "broken")
    studio.at("check-stop").click()
    expect(studio.at("check-begin")).to_be_visible()
    broken.click()
    expect(studio.at("check-seen")).to_have_attribute("data-confirmed", "true")
    studio.at("check-play").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    expect(studio.at("status")).to_contain_text("01:05.6")


def a_tutorial_follows_what_is_drawn(studio: Studio) -> None:
    begin(studio, "first-steps")
    first_steps_until_run(studio)
    studio.at("run-button").click()
    at_step(studio, 4)


def with_each_tab_alone_where_there_are_no_locks(page: Page, address: str) -> Page:
    """So it is at an address to which the browser gives no locks, such as that of another machine without `https`."""
    page.add_init_script(NO_LOCKS)
    page.reload()
    wait_for_python(page)
    other = page.context.new_page()
    other.add_init_script(NO_LOCKS)
    other.goto(address)
    expect(other.get_by_test_id("site")).to_contain_text("open in another tab")
    page.close()
    wait_for_python(other)
    return other


def test_all_of_the_studio_runs_in_a_site_and_what_is_damaged_loses_nothing(
    server: FileServer,
    visit: Callable[..., Visit],
    tmp_path: Path,
) -> None:
    made = visit()
    studio = opened(made.context.new_page(), server.address)
    # The example runs to its end.
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    expect(studio.at("arena-summary")).to_contain_text("12 of 12 delivered")
    a_run_is_stepped_back_in_saved_and_opened_again(studio, tmp_path)
    a_mission_goes_out_as_a_picture_and_comes_back(studio, tmp_path)
    an_exercise_is_judged(studio)
    a_check_tells_what_breaks_and_plays_it(studio)
    a_tutorial_follows_what_is_drawn(studio)
    studio.page.wait_for_function(f"async () => await {MEMORY} !== ''")
    page = with_each_tab_alone_where_there_are_no_locks(studio.page, server.address)
    assert made.warned == []
    # A memory that is damaged is not used.
    page.evaluate(DAMAGE, page.evaluate(ENTRY, page.evaluate(MEMORY)))
    studio = opened(page, server.address)
    assert ["memory cannot be used" in line for line in made.warned] == [True]
    what_was_kept_and_cannot_be_read_is_told_and_not_written_over(studio, server)


def what_was_kept_and_cannot_be_read_is_told_and_not_written_over(studio: Studio, server: FileServer) -> None:
    page = studio.page
    page.goto(f"{server.address}site.json")
    page.evaluate(LATER)
    entries = page.evaluate(ENTRIES)
    opened(page, server.address)
    expect(studio.at("site")).to_contain_text("nothing is written over it")
    studio.drop("Wait", "arc-start.next")
    expect(studio.at("saved-state")).to_have_text("only in this page")
    page.goto(f"{server.address}site.json")
    assert entries
    assert page.evaluate(ENTRIES) == entries
