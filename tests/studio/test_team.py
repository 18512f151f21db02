"""The team's tab: robots, goals, world and title, by mouse and by keys, and every change undone."""

from __future__ import annotations

import shutil
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import EXAMPLES, LOOKS, Studio
from tests.studio.looks import choose, find_nothing
from tests.studio.test_variables import save

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
TRANSPORT = "transport/transport.krt"
SQUARE = "square/square.krt"


def undo_all(studio: Studio) -> None:
    """Ctrl+Z until there is nothing to undo."""
    studio.page.evaluate("document.activeElement?.blur()")
    for _ in range(100):
        studio.at("menu-Edit").click()
        done = studio.at("menu-edit-undo").get_attribute("aria-disabled") == "true"
        studio.page.keyboard.press("Escape")
        if done:
            return
        studio.page.keyboard.press("Control+z")
    raise AssertionError("undo never ends")


@pytest.mark.thorough(
    "web/src/features/team/tab.test.tsx: robots are named, moved, added, copied and removed, each undone; a start "
    "of its own: web/src/session/add-starting.test.ts"
)
def test_robots_are_added_named_given_a_program_moved_copied_and_removed(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    file = "transport.krt"
    before = (studio.folder / file).read_text(encoding="utf-8")
    studio.at("tab-of-team").click()
    expect(studio.at("agent-name-6")).to_have_value("store-manager-B")
    studio.at("add-agent").click()
    name = studio.at("agent-name-7")
    expect(name).to_be_focused()
    # It stands on the road like the other carriers, at a start of its own, so nothing is wrong.
    expect(studio.at("agent-start-7")).to_have_value("carrier-4")
    expect(studio.at("problems")).to_contain_text("0")
    name.fill("carrier-1")
    expect(studio.page.get_by_role("alert").first).to_contain_text("There is a robot carrier-1 already.")
    name.fill("scout")
    studio.page.keyboard.press("Enter")
    studio.at("agent-program-7").select_option("loader")
    studio.at("agent-start-7").select_option("loader")
    saved = save(studio, file)
    assert '<agent name="scout" program="loader" start="loader"/>' in saved
    studio.at("agent-up-7").click()
    expect(studio.at("agent-name-6")).to_have_value("scout")
    expect(studio.at("agent-up-6")).to_be_focused()
    studio.at("agent-copy-6").click()
    expect(studio.at("agent-name-7")).to_have_value("scout-1")
    studio.at("agent-remove-7").click()
    studio.at("agent-remove-6").click()
    expect(studio.at("agent-name-6")).to_have_value("store-manager-B")
    assert '<agent name="scout' not in save(studio, file)
    undo_all(studio)
    assert save(studio, file) == before


def another_world_is_in_the_arena_at_once_and_undo_brings_the_old_one_back(studio: Studio) -> None:
    summary = studio.page.locator(".arena h2, .arena header").first
    expect(summary).to_contain_text("ring")
    studio.at("tab-of-team").click()
    find_nothing(studio, "the team", within=".team")
    studio.at("world-empty").locator("input").check()
    expect(summary).not_to_contain_text("ring")
    expect(studio.page.locator(".team [role=status]").first).to_contain_text("7 robots have no start in this world")
    find_nothing(studio, "a team in the wrong world", within=".team")
    expect(studio.at("problems")).to_contain_text("8")
    studio.page.keyboard.press("F8")
    expect(studio.at("agent-start-0")).to_be_focused()
    expect(studio.at("goal-house-0")).to_have_attribute("aria-invalid", "true")
    studio.page.evaluate("document.activeElement?.blur()")
    studio.page.keyboard.press("Control+z")
    expect(summary).to_contain_text("ring")
    studio.page.keyboard.press("Control+y")
    expect(summary).not_to_contain_text("ring")


def robots_without_a_start_are_put_on_free_ones_by_one_click(studio: Studio) -> None:
    studio.at("tab-of-team").click()
    studio.at("world-ring").locator("input").check()
    studio.at("place-agents").click()
    expect(studio.at("place-agents")).to_have_count(0)
    assert 'world href="ring.world.xml"' in save(studio, "square.krt")


@pytest.mark.thorough(
    "web/src/features/team/tab.test.tsx: title and help are written in the language of the page; in the file: "
    "tests/forms/test_pairs.py"
)
def test_the_title_is_written_in_the_language_of_the_page(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE)
    before = (studio.folder / "square.krt").read_text(encoding="utf-8")
    choose(studio, "ur")
    studio.at("tab-of-team").click()
    studio.at("team-title").fill("میرا مربع")
    studio.at("team-help").press_sequentially("چلتا ہے")
    studio.page.keyboard.press("Control+s")
    expect(studio.at("saved-state")).to_have_text("محفوظ")
    assert '<label xml:lang="ur">میرا مربع</label>' in (studio.folder / "square.krt").read_text(encoding="utf-8")
    undo_all(studio)
    studio.page.keyboard.press("Control+s")
    expect(studio.at("saved-state")).to_have_text("محفوظ")
    assert (studio.folder / "square.krt").read_text(encoding="utf-8") == before


def the_tabs_are_walked_by_arrows_to_the_team_and_back(studio: Studio) -> None:
    studio.at("tab-carrier").focus()
    studio.page.keyboard.press("End")
    expect(studio.at("tab-of-world")).to_be_focused()
    expect(studio.at("world")).to_be_visible()
    studio.page.keyboard.press("ArrowLeft")
    expect(studio.at("tab-of-team")).to_be_focused()
    expect(studio.at("team")).to_be_visible()
    expect(studio.at("world")).to_be_hidden()
    studio.page.keyboard.press("ArrowRight")
    studio.page.keyboard.press("ArrowRight")
    expect(studio.at("tab-carrier")).to_be_focused()
    expect(studio.at("team")).to_be_hidden()
    expect(studio.at("canvas")).to_be_visible()
    studio.page.keyboard.press("Alt+t")
    expect(studio.at("team")).to_be_visible()
    studio.at("tab-carrier").click()
    expect(studio.at("team")).to_be_hidden()


def test_tabs_are_walked_and_the_arena_shows_another_world_at_once(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    the_tabs_are_walked_by_arrows_to_the_team_and_back(studio)
    another_world_is_in_the_arena_at_once_and_undo_brings_the_old_one_back(studio)


@pytest.mark.thorough("web/src/features/arena/arena.test.ts: a mission that was edited since its run")
def test_after_a_run_the_arena_shows_what_was_edited_and_in_its_past_the_run(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    after_a_run_the_arena_shows_what_was_edited_and_in_its_past_the_run(studio)


def a_program_without_a_free_start_says_so_and_leads_to_the_team(studio: Studio) -> None:
    studio.at("add-program").click()
    studio.at("menu-add-carrier").click()
    expect(studio.at("banner")).to_contain_text("program-1 has no robot yet")
    studio.page.get_by_role("button", name="Open the team").click()
    studio.at("add-agent").click()
    expect(studio.at("agent-program-1")).to_have_value("program-1")


def a_world_of_the_folder_can_be_chosen(studio: Studio) -> None:
    shutil.copy(EXAMPLES / "stripes" / "stripes.world.xml", studio.folder / "yard.world.xml")
    studio.at("tab-of-team").click()
    expect(studio.at("world-yard")).to_contain_text("from this folder")
    studio.at("world-yard").locator("input").check()
    assert 'href="yard.world.xml"' in save(studio, "square.krt")


@pytest.mark.thorough(
    "web/src/features/team/worlds.test.tsx: starts by one click, worlds of the folder; session/actions.test.ts: a "
    "program without a place for its robot; server/test_parts.py: worlds that there are"
)
def test_robots_get_a_start_by_one_click_a_program_wants_one_and_a_world_of_the_folder_can_be_chosen(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(SQUARE)
    a_program_without_a_free_start_says_so_and_leads_to_the_team(studio)
    studio.take_back()
    robots_without_a_start_are_put_on_free_ones_by_one_click(studio)
    studio.take_back()
    a_world_of_the_folder_can_be_chosen(studio)


@pytest.mark.thorough("another_world_is_in_the_arena_at_once… looks at both with axe, in the light theme")
@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_axe_finds_nothing_in_the_team(open_studio: OpenStudio, look: tuple[str, ...]) -> None:
    studio = open_studio(TRANSPORT)
    choose(studio, *look)
    studio.page.keyboard.press("Alt+t")
    expect(studio.at("world-ring")).to_be_visible()
    find_nothing(studio, "the team", within=".team")
    studio.at("world-empty").locator("input").check()
    expect(studio.page.locator(".team [role=status]").first).to_be_visible()
    find_nothing(studio, "a team in the wrong world", within=".team")


def after_a_run_the_arena_shows_what_was_edited_and_in_its_past_the_run(studio: Studio) -> None:
    summary = studio.at("arena-summary")
    expect(summary).to_contain_text("0 of 12")
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    expect(summary).to_contain_text("12 of 12")
    studio.at("tab-of-team").click()
    studio.at("add-agent").click()
    expect(summary).to_contain_text("0 of 12")
    studio.at("undo").click()
    expect(summary).to_contain_text("12 of 12")
    studio.at("redo").click()
    expect(summary).to_contain_text("0 of 12")
    studio.at("step-back-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    expect(summary).to_contain_text("12 of 12")
