"""Work that is left without saving, saved elsewhere, or changed while it is saved."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import BrowserContext, Page, expect

from tests.studio.conftest import Studio, begin_new
from tests.studio.studio_processes import MISSION, Start, another_tab, expect_wait, wait_for
from tests.studio.test_variables import forgive_refusals

pytestmark = pytest.mark.browser


def open_file(page: Page, name: str, data: bytes) -> None:
    """File → Open, a file of this computer."""
    page.keyboard.press("Control+o")
    page.get_by_test_id("open-file").set_input_files({"name": name, "mimeType": "", "buffer": data})


@pytest.mark.thorough(
    "web/src/session/early-work.test.ts: work that is left is in the journal, and that is said; "
    "app/Banner.test.tsx: focus and Escape; features/gallery/OpenSheet.test.tsx: it is listed; "
    "tests/server/test_journal.py"
)
def test_work_that_is_left_without_saving_is_said_to_be_kept_and_is_there_under_open(
    studio: Studio, tmp_path: Path
) -> None:
    page = studio.page
    banner = page.get_by_test_id("banner")
    wait_for(page, 7)
    page.get_by_test_id("menu-File").click()
    page.get_by_test_id("menu-file-new").click()
    begin_new(page)
    expect(banner).to_contain_text("they are kept in the journal")
    # The question has the focus, and Escape is none of its answers.
    expect(banner.get_by_role("button").first).to_be_focused()
    page.keyboard.press("Escape")
    expect(banner).to_have_count(0)
    expect_wait(page, 7)
    page.get_by_test_id("menu-File").click()
    page.get_by_test_id("menu-file-new").click()
    begin_new(page)
    banner.get_by_role("button", name="Go on without saving").click()
    expect(banner).to_contain_text("Unsaved work on blink.krt is kept.")
    expect(page.get_by_test_id("title")).not_to_contain_text("blink")
    page.keyboard.press("Control+o")
    page.get_by_test_id("open-left").get_by_role("button", name="blink.krt").click()
    expect_wait(page, 7)
    expect(page.get_by_test_id("saved-state")).to_have_text("not saved")
    page.keyboard.press("Control+z")
    expect_wait(page, 2)
    page.keyboard.press("Control+o")
    expect(page.get_by_test_id("open-dialog")).to_contain_text("blink")
    expect(page.get_by_test_id("open-left")).to_have_count(0)

    # A later KitRobot's is told, and left alone until somebody throws it away.
    later = tmp_path / "missions" / ".kitrobot" / "journal" / "00000000000000aa.journal"
    later.write_bytes(b"kitrobot journal 9\nlater")
    page.evaluate("sessionStorage.clear()")
    page.reload()
    expect(banner).to_contain_text("This journal was written by a later KitRobot")
    page.keyboard.press("Control+o")
    expect(page.get_by_test_id("open-left").get_by_role("button")).to_be_disabled()
    expect(page.get_by_test_id("open-left")).to_contain_text("a later KitRobot")
    page.keyboard.press("Escape")
    assert later.exists()
    with page.expect_response(re.compile("/api/journal/forget$")):
        banner.get_by_role("button", name="Discard it").click()
    expect(banner).to_have_count(0)
    assert not later.exists()


@pytest.mark.thorough(
    "web/src/session/document.test.ts: unsaved changes go when the person says so, without a journal after a second "
    "question; journal.test.ts says when it cannot be written"
)
def test_work_that_the_journal_cannot_hold_is_not_left_without_a_word(studio: Studio) -> None:
    page = studio.page
    banner = page.get_by_test_id("banner")
    page.route("**/api/journal", lambda route: route.fulfill(status=422, json={"message": "Full.", "help": ""}))
    wait_for(page, 7)
    expect(banner).to_contain_text("Your changes are not kept safe at the moment")
    page.get_by_test_id("menu-File").click()
    page.get_by_test_id("menu-file-new").click()
    begin_new(page)
    banner.get_by_role("button", name="Go on without saving").click()
    expect(banner).to_contain_text("without saving they would be lost")
    expect_wait(page, 7)
    banner.get_by_role("button", name="Cancel").click()
    expect_wait(page, 7)
    forgive_refusals(studio)


NO_MISSIONS = [
    ("empty.krt", b'<kitrobot version="1"/>', "there is no program in it"),
    ("page.krt", b"<html><body>hello</body></html>", "page.krt"),
    ("holiday.jpg", b"\xff\xd8\xff\xe0\0\x10JFIF", "is a photo (JPEG)"),
]


@pytest.mark.thorough("web/src/session/document.test.ts, a damaged file leaves the open mission alone")
def test_a_file_that_gives_no_mission_is_refused_and_the_open_one_stays(studio: Studio) -> None:
    page = studio.page
    expect_wait(page, 2)
    for name, data, words in NO_MISSIONS:
        open_file(page, name, data)
        expect(page.get_by_test_id("banner")).to_contain_text(words)
        expect_wait(page, 2)
        expect(page.get_by_test_id("title")).to_contain_text("blink")
    forgive_refusals(studio)


@pytest.mark.thorough("web/src/app/Title.test.tsx; web/src/session/journal.test.ts goes on after a lost connection")
def test_without_its_server_a_page_claims_nothing_of_its_file(
    start: Start, mission: Path, context: BrowserContext
) -> None:
    server = start(mission)
    first, second = server.open(context), server.open(context)
    state = second.get_by_test_id("saved-state")
    expect(state).to_have_text("saved")
    server.kill()
    expect(state).to_have_text("no connection to the studio")
    second.locator(".vertex", has_text="Wait").first.click()
    second.keyboard.press("Delete")
    expect(state).to_have_text("not saved, not kept: no connection")
    expect(first.get_by_test_id("saved-state")).to_have_text("no connection to the studio")


def a_window_on_an_older_file_does_not_say_that_it_is_saved(studio: Studio) -> None:
    first, second = studio.page, another_tab(studio)
    expect(second.get_by_test_id("saved-state")).to_have_text("saved")
    wait_for(first, 5)
    first.keyboard.press("Control+s")
    expect(first.get_by_test_id("saved-state")).to_have_text("saved")
    expect(second.get_by_test_id("saved-state")).to_have_text("changed on disk")
    second.get_by_test_id("banner").get_by_role("button", name="Keep this one").click()
    expect(second.get_by_test_id("saved-state")).to_have_text("changed on disk")


def what_is_changed_while_it_is_saved_stays_unsaved_and_saves_next(studio: Studio) -> None:
    page, mission = studio.page, studio.folder / "blink.krt"
    held = []
    # Before the edit: a request that is made while the browser begins to hold requests is told to nobody.
    page.route("**/api/mission", lambda route: held.append(route), times=1)
    wait_for(page, 5)
    with page.expect_request("**/api/mission"):
        page.keyboard.press("Control+s")
    wait_for(page, 6)
    held[0].continue_()
    expect(page.get_by_test_id("saved-state")).to_have_text("not saved")
    page.keyboard.press("Control+s")
    expect(page.get_by_test_id("saved-state")).to_have_text("saved")
    expect(page.get_by_test_id("banner")).to_have_count(0)
    assert mission.read_text() == MISSION.format(6)


@pytest.mark.thorough(
    "web/src/session/document.test.ts: what is changed while it is saved stays unsaved; app/Title.test.tsx and "
    "disk.test.ts: another file on disk"
)
def test_what_is_changed_while_it_is_saved_stays_unsaved_and_a_window_on_an_older_file_says_so(studio: Studio) -> None:
    what_is_changed_while_it_is_saved_stays_unsaved_and_saves_next(studio)
    a_window_on_an_older_file_does_not_say_that_it_is_saved(studio)
