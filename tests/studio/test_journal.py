"""Nothing is ever lost: a killed server, a closed tab, a file that somebody else changed, a mission open twice."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from playwright.sync_api import BrowserContext, Response, expect

from tests.patience import PATIENCE_S
from tests.studio.conftest import Studio, begin_new
from tests.studio.studio_processes import MISSION, Start, another_tab, edit_and_keep, expect_wait, wait_for
from tests.studio.test_variables import forgive_refusals

pytestmark = pytest.mark.browser


def saved_journal(answer: Response) -> bool:
    """Whether it is that of a journal in which nothing is unsaved."""
    request = answer.request
    sent = request.post_data_json or {}
    return request.method == "PUT" and request.url.endswith("/api/journal") and not sent.get("unsaved", True)


def test_after_a_kill_a_page_goes_on_with_the_next_studio_and_its_work_is_there_for_another_page_with_its_undo(
    start: Start, mission: Path, context: BrowserContext
) -> None:
    server = start(mission)
    page = server.open(context)
    edit_and_keep(page, 7)
    server.kill()
    page.locator(".vertex", has_text="Wait").first.click()
    page.keyboard.press("Delete")
    with page.expect_response(re.compile("/api/journal$")) as kept:
        again = start(mission)
    assert kept.value.ok
    assert again.address.partition("?")[0] == server.address.partition("?")[0]
    expect(page.get_by_test_id("banner")).to_contain_text("The studio started anew")
    page.close(run_before_unload=False)
    page = again.open(context)
    expect(page.get_by_test_id("banner")).to_contain_text("Your unsaved work on blink.krt is back")
    expect(page.get_by_test_id("code")).not_to_contain_text("WAIT")
    page.keyboard.press("Control+z")
    expect_wait(page, 7)
    page.keyboard.press("Control+s")
    expect(page.get_by_test_id("saved-state")).to_have_text("saved")
    assert mission.read_text() == MISSION.format(7)


@pytest.mark.thorough(
    "the test above; a request with the token of the studio that is gone: web/src/api/reconnect.test.ts; what is said: "
    "web/src/app/Title.test.tsx and Banner.test.tsx"
)
def test_a_page_goes_on_with_the_studio_that_started_after_a_kill(
    start: Start, mission: Path, context: BrowserContext
) -> None:
    server = start(mission)
    page = server.open(context)
    edit_and_keep(page, 7)
    server.kill()
    page.locator(".vertex", has_text="Wait").first.click()
    page.keyboard.press("Delete")
    with page.expect_response(re.compile("/api/journal$")) as kept:
        again = start(mission)
    assert kept.value.ok
    assert again.address != server.address
    assert again.address.partition("?")[0] == server.address.partition("?")[0]
    banner = page.get_by_test_id("banner")
    expect(banner).to_contain_text("The studio started anew")
    expect(banner).to_contain_text("Your changes are kept.")
    expect(page.get_by_test_id("code")).not_to_contain_text("WAIT")
    # It has the new studio's token: what it does is kept and saved, and it can be loaded again.
    page.keyboard.press("Control+z")
    with page.expect_response(re.compile("/api/journal$")):
        wait_for(page, 9)
    again.kill()
    start(mission)
    expect_wait(page, 9)
    # Saved with the token of the studio that is gone: the page finds the next one by itself.
    with (
        page.expect_response(saved_journal),
        page.expect_response(lambda one: one.url.endswith("/api/mission") and one.ok),
    ):
        page.keyboard.press("Control+s")
    page.reload()
    expect_wait(page, 9)
    assert '<set name="duration">9</set>' in mission.read_text()


@pytest.mark.thorough("web/src/api/reconnect.test.ts; tests/server/test_journal.py, nobody watches without the token")
def test_another_studio_at_the_address_gets_nothing_of_a_page(
    start: Start, mission: Path, context: BrowserContext, tmp_path: Path
) -> None:
    server = start(mission)
    page = server.open(context)
    server.kill()
    port = int(server.address.rpartition(":")[2].partition("/")[0])
    shutil.rmtree(tmp_path / "state")  # it knows nothing of the first one
    command = [sys.executable, "-m", "kitrobot", "studio", str(mission), "--no-browser", "--port", str(port)]
    env = {**os.environ, "KITROBOT_STATE": str(tmp_path / "state")}
    other = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=env)
    try:
        expect(page.get_by_test_id("banner")).to_contain_text("Somebody else is where this page's studio was")
        expect(page.get_by_test_id("banner")).to_contain_text("Your changes are still in this page")
    finally:
        other.kill()
        other.wait(PATIENCE_S)


@pytest.mark.thorough(
    "the first test of this file; web/src/session/journal.test.ts: brings a mission back with its undo and redo"
)
def test_after_a_kill_the_work_is_there_with_its_undo(start: Start, mission: Path, context: BrowserContext) -> None:
    server = start(mission)
    page = server.open(context)
    edit_and_keep(page, 7)
    page.locator(".vertex", has_text="Wait").first.click()
    with page.expect_response(re.compile("/api/journal$")):
        page.keyboard.press("Delete")
    expect(page.get_by_test_id("code")).not_to_contain_text("WAIT")
    server.kill()
    page.close(run_before_unload=False)
    page = start(mission).open(context)
    expect(page.get_by_test_id("banner")).to_contain_text("Your unsaved work on blink.krt is back")
    expect(page.get_by_test_id("code")).not_to_contain_text("WAIT")
    expect(page.get_by_test_id("saved-state")).to_have_text("not saved")
    page.keyboard.press("Control+z")
    expect_wait(page, 7)
    page.keyboard.press("Control+z")
    expect_wait(page, 2)
    expect(page.get_by_test_id("saved-state")).to_have_text("saved")
    page.keyboard.press("Control+y")
    expect_wait(page, 7)
    page.keyboard.press("Control+s")
    expect(page.get_by_test_id("saved-state")).to_have_text("saved")
    assert mission.read_text() == MISSION.format(7)


@pytest.mark.thorough("web/src/session/early-work.test.ts: what came back can be discarded")
def test_work_that_is_discarded_is_gone_for_good(studio: Studio) -> None:
    page = studio.page
    edit_and_keep(page, 7)
    page.close()
    page = another_tab(studio)
    expect_wait(page, 7)
    with page.expect_response(re.compile("/api/journal$")):
        page.get_by_test_id("banner").get_by_role("button", name="Discard it").click()
    expect_wait(page, 2)
    expect(page.get_by_test_id("saved-state")).to_have_text("saved")
    page.close()
    page = another_tab(studio)
    expect_wait(page, 2)
    expect(page.get_by_test_id("banner")).to_have_count(0)


@pytest.mark.thorough(
    "web/src/session/journal.test.ts: a mission is brought back with its undo; in another page: the first test above"
)
def test_a_page_that_is_loaded_again_goes_on(studio: Studio) -> None:
    page = studio.page
    edit_and_keep(page, 9)
    page.reload()
    expect_wait(page, 9)
    page.keyboard.press("Control+z")
    expect_wait(page, 2)


@pytest.mark.thorough(
    "web/src/session/journal.test.ts, a mission is brought back with its undo; tests/files/test_recovery.py"
)
def test_a_new_mission_that_was_never_saved_comes_back(start: Start, mission: Path, context: BrowserContext) -> None:
    server = start(mission.parent)
    page = server.open(context)
    page.get_by_test_id("menu-File").click()
    page.get_by_test_id("menu-file-new").click()
    begin_new(page)
    expect(page.get_by_test_id("first-place")).to_be_visible()
    with page.expect_response(re.compile("/api/journal$")):
        source, target = page.get_by_test_id("part-Wait"), page.get_by_test_id("first-place")
        source.drag_to(target)
    expect(page.get_by_test_id("code")).to_contain_text("WAIT")
    server.kill()
    page.close()
    page = start(mission.parent).open(context)
    expect(page.get_by_test_id("code")).to_contain_text("WAIT")
    expect(page.get_by_test_id("title")).to_contain_text("not saved")


@pytest.mark.thorough(
    "web/src/session/disk.test.ts asks; document.test.ts takes the one on disk; tests/server/test_journal.py: a "
    "page hears that its file changed"
)
def test_a_file_changed_on_disk_is_offered_when_nothing_is_unsaved(studio: Studio) -> None:
    page, mission = studio.page, studio.folder / "blink.krt"
    expect_wait(page, 2)
    mission.write_text(MISSION.format(33))
    banner = page.get_by_test_id("banner")
    expect(banner).to_contain_text("changed on disk")
    banner.get_by_role("button", name="Load it").click()
    expect_wait(page, 33)
    expect(banner).to_have_count(0)


def a_save_over_a_changed_file_asks_and_shows_the_difference(studio: Studio) -> None:
    page, mission = studio.page, studio.folder / "blink.krt"
    wait_for(page, 5)
    mission.write_text(MISSION.format(44))
    page.keyboard.press("Control+s")
    banner = page.get_by_test_id("banner")
    expect(banner).to_contain_text("changed on disk")
    banner.get_by_role("button", name="Show the difference").click()
    expect(page.get_by_test_id("differences")).to_contain_text("the duration of Wait (v1): 44 → 5")
    page.keyboard.press("Escape")
    assert mission.read_text() == MISSION.format(44)
    banner.get_by_role("button", name="Save mine over it").click()
    expect(page.get_by_test_id("saved-state")).to_have_text("saved")
    assert mission.read_text() == MISSION.format(5)
    assert mission.with_name("blink.krt~").read_text() == MISSION.format(44)
    forgive_refusals(studio)


def the_file_is_merged_into_what_was_changed_here_and_undo_takes_it_back(studio: Studio) -> None:
    page, mission = studio.page, studio.folder / "blink.krt"
    wait_for(page, 6)
    mission.write_text(MISSION.format(44))
    page.keyboard.press("Control+s")
    banner = page.get_by_test_id("banner")
    banner.get_by_role("button", name="Show the difference").click()
    page.get_by_test_id("merge").click()
    conflicts = page.get_by_test_id("conflicts")
    expect(conflicts).to_contain_text("the duration of Wait (v1)")
    conflicts.get_by_label("The one on disk: 44").check()
    page.get_by_test_id("merge-apply").click()
    expect_wait(page, 44)
    expect(banner).to_contain_text("are merged")
    page.keyboard.press("Control+z")
    expect_wait(page, 6)
    # What was taken back is asked about again, what is merged is saved without a question.
    page.keyboard.press("Control+s")
    expect(banner).to_contain_text("changed on disk")
    page.keyboard.press("Control+y")
    page.keyboard.press("Control+s")
    expect(page.get_by_test_id("saved-state")).to_have_text("saved")
    assert mission.read_text() == MISSION.format(44)
    forgive_refusals(studio)


@pytest.mark.thorough(
    "web/src/session/document.test.ts: the person chooses when the file was changed meanwhile; "
    "app/DifferenceSheet.test.tsx and session/merges.test.ts; tests/server/test_journal.py: differences and "
    "merges"
)
def test_a_file_that_changed_is_saved_over_after_a_question_or_merged_and_undo_takes_that_back(studio: Studio) -> None:
    a_save_over_a_changed_file_asks_and_shows_the_difference(studio)
    the_file_is_merged_into_what_was_changed_here_and_undo_takes_it_back(studio)


@pytest.mark.thorough(
    "tests/server/test_journal.py: two pages know of each other; web/src/app/Title.test.tsx says so; "
    "document.test.ts asks before it saves over a changed file"
)
def test_two_windows_know_of_each_other_and_overwrite_nothing_silently(studio: Studio) -> None:
    first, second = studio.page, another_tab(studio)
    mission = studio.folder / "blink.krt"
    for page in (first, second):
        expect(page.get_by_test_id("also-open")).to_be_visible()
    edit_and_keep(first, 5)
    edit_and_keep(second, 6)
    first.keyboard.press("Control+s")
    expect(first.get_by_test_id("saved-state")).to_have_text("saved")
    second.keyboard.press("Control+s")
    expect(second.get_by_test_id("banner")).to_contain_text("changed on disk")
    assert mission.read_text() == MISSION.format(5)
    expect_wait(second, 6)
    second.close()
    expect(first.get_by_test_id("also-open")).to_have_count(0)
    assert first.get_by_test_id("banner").count() == 0


@pytest.mark.thorough(
    "tests/files/test_recovery.py: a damaged journal gives what is whole and is kept aside; "
    "web/src/session/journal.test.ts: what is missing is said"
)
def test_a_damaged_journal_opens_what_is_whole_of_it(start: Start, mission: Path, context: BrowserContext) -> None:
    server = start(mission)
    page = server.open(context)
    edit_and_keep(page, 7)
    page.close()
    server.kill()
    journal = next(mission.parent.rglob("*.journal"))
    data = bytearray(journal.read_bytes())
    data[-3] ^= 0xFF
    journal.write_bytes(data)
    page = start(mission).open(context)
    expect_wait(page, 7)
    expect(page.get_by_test_id("banner")).to_contain_text("The journal was damaged")
    assert next(mission.parent.rglob("*.damaged")).read_bytes() == data
