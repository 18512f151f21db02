"""Parts of one's own: saved from a selection, used, run, edited, renamed, deleted with a warning, and all undone."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.effort import cases
from tests.studio.conftest import LOOKS, Studio
from tests.studio.looks import choose as axe_look
from tests.studio.looks import find_nothing
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
TRANSPORT = "transport/transport.krt"


def select(studio: Studio, vertex: str) -> None:
    """Clicks a vertex where it has no chip."""
    studio.at(f"vertex-{vertex}").first.click(position={"x": 12, "y": 12})


def save_part(studio: Studio, name: str, *openings: str) -> None:
    """Fills the sheet that is open and saves the part."""
    expect(studio.at("own-lll")).to_be_visible()
    studio.at("own-name").fill(name)
    for opening in openings:
        studio.at(f"opening-{opening}").locator("input[type=checkbox]").check()
    expect(studio.at("own-save")).to_be_enabled()
    studio.at("own-save").click()
    expect(studio.at("own-dialog")).to_have_count(0)


def row(studio: Studio, name: str) -> Locator:
    """The part's row of the palette."""
    found = studio.at(f"part-{name}")
    found.scroll_into_view_if_needed()
    return found


def choose(studio: Studio, name: str, entry: str) -> None:
    """An entry of the menu that a right click on a part opens."""
    row(studio, name).click(button="right")
    studio.at("own-menu").get_by_role("menuitem", name=entry).click()


def saved_text(studio: Studio) -> str:
    """The mission as it would be saved."""
    with studio.page.expect_download() as download:
        studio.at("menu-File").click()
        studio.at("menu-file-download-krt").click()
    return download.value.path().read_text()


@pytest.mark.thorough(
    "web/src/features/custom-blocks/sheets.test.tsx: saved, used, changed, deleted, undone; "
    "server/test_own_parts.py: offered, made and read; that it runs: mission and compiler tests of constructors; "
    "with a server: test_palette.py"
)
def test_a_selection_is_saved_used_run_edited_and_deleted_and_all_of_it_is_undone(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    keys = studio.page.keyboard
    first = saved_text(studio)
    before = studio.code()
    select(studio, "v11")
    keys.press("p")
    save_part(studio, "Wait till free", "v11-condition")
    expect(studio.page.locator(".vertex", has_text="Wait till free")).to_have_count(1)
    expect(row(studio, "Wait till free")).to_be_visible()
    expect(studio.at("code")).to_contain_text("Collision.IsPressed()")
    assert studio.code() == before, "it means the same"

    # Used by a click in the palette, after the one that is selected.
    row(studio, "Wait till free").click()
    expect(studio.page.locator(".vertex", has_text="Wait till free")).to_have_count(2)
    keys.press("Control+z")
    expect(studio.page.locator(".vertex", has_text="Wait till free")).to_have_count(1)

    # It runs, and glows while it does.
    studio.at("run-button").click()
    expect(studio.page.locator(".vertex.is-active", has_text="Wait till free")).to_be_visible()
    keys.press("Shift+F5")

    row(studio, "Wait till free").focus()
    keys.press("F2")
    dialog = studio.at("own-dialog")
    expect(studio.at("slot-condition")).to_be_visible()
    studio.at("own-name").fill("Road free")
    code = dialog.locator(".cm-content")
    code.click()
    keys.press("Control+a")
    keys.insert_text("*[{condition}]( WAIT({pause}); <Collision.IsPressed(")
    expect(studio.at("own-failure")).not_to_be_empty()
    expect(studio.at("own-save")).to_be_disabled()
    keys.press("Control+a")
    keys.insert_text("*[{condition}]( WAIT({pause}); Wheel.Stop(); )")
    expect(studio.at("slot-pause")).to_be_visible()
    studio.at("slot-pause").get_by_label("at first").fill("7")
    expect(studio.at("own-save")).to_be_enabled()
    studio.at("own-save").click()
    expect(dialog).to_have_count(0)
    expect(studio.page.locator(".vertex", has_text="Road free")).to_have_count(1)
    studio.expect_code("WAIT(7)")
    expect(studio.at("part-Wait till free")).to_have_count(0)

    choose(studio, "Road free", "Delete this part")
    expect(studio.at("own-delete")).to_contain_text("It is used 1 time.")
    studio.at("own-use-carrier").click()
    expect(studio.page.locator(".vertex", has_text="Road free")).to_be_in_viewport()
    row(studio, "Road free").focus()
    keys.press("Delete")
    studio.at("own-dissolve").click()
    expect(studio.at("part-Road free")).to_have_count(0)
    expect(studio.page.locator(".vertex", has_text="Road free")).to_have_count(0)
    studio.expect_code("WAIT(7)")

    studio.at("canvas").focus()
    for _ in range(3):
        keys.press("Control+z")
    expect(studio.at("part-Wait till free")).to_have_count(0)
    assert saved_text(studio) == first


@pytest.mark.thorough("web/src/features/custom-blocks/sheets.test.tsx: P, F2, Delete and undo")
def test_it_all_goes_by_keys(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    keys = studio.page.keyboard
    select(studio, "v11")
    keys.press("p")
    expect(studio.at("own-name")).to_be_focused()
    expect(studio.at("own-lll")).to_be_visible()
    keys.type("Loop of mine")
    expect(studio.at("own-save")).to_be_enabled()
    keys.press("Enter")
    expect(studio.at("own-dialog")).to_have_count(0)
    expect(studio.page.locator(".vertex", has_text="Loop of mine")).to_have_count(1)
    studio.at("canvas").focus()
    keys.press("/")
    keys.type("loop of mine")
    keys.press("Enter")
    expect(studio.page.locator(".vertex", has_text="Loop of mine")).to_have_count(2)
    row(studio, "Loop of mine").focus()
    keys.press("F2")
    expect(studio.at("own-name")).to_be_focused()
    keys.press("Escape")
    expect(studio.at("own-dialog")).to_have_count(0)
    row(studio, "Loop of mine").focus()
    keys.press("Delete")
    expect(studio.at("own-delete")).to_contain_text("It is used 2 times.")
    expect(studio.page.locator(".vertex", has_text="Loop of mine")).to_have_count(2)
    studio.at("own-leave").click()
    expect(studio.at("problems")).to_have_attribute("title", re.compile("^2 problems"))
    studio.at("canvas").focus()
    keys.press("Control+z")
    expect(row(studio, "Loop of mine")).to_be_visible()


def a_name_that_cannot_be_is_told_at_once(studio: Studio) -> None:
    select(studio, "v11")
    studio.page.keyboard.press("p")
    for name in cases(["While"], ["a.b", "Start", "   "]):
        studio.at("own-name").fill("Fitting")
        expect(studio.at("own-save")).to_be_enabled()
        find_nothing(studio, "saving a part")
        studio.at("own-name").fill(name)
        expect(studio.page.locator(".own-wrong")).not_to_be_empty()
        expect(studio.at("own-save")).to_be_disabled()


def what_cannot_be_a_part_is_told(studio: Studio) -> None:
    studio.at("vertex-v11").locator(".chip").first.click()
    studio.page.keyboard.press("p")
    expect(studio.at("own-failure")).to_contain_text("alone cannot be a part")
    expect(studio.at("own-save")).to_be_disabled()


def parts_are_shared_as_a_file(studio: Studio) -> None:
    select(studio, "v11")
    studio.page.keyboard.press("p")
    save_part(studio, "Mine")
    with studio.page.expect_download() as download:
        choose(studio, "Mine", "Download my parts")
    assert download.value.suggested_filename == "transport.constructors.xml"
    assert '<constructor name="Mine"' in download.value.path().read_text()


@pytest.mark.thorough(
    "web/src/features/custom-blocks/sheets.test.tsx: names and selections that cannot be; axe on the sheet: "
    "test_clipping.py, a part of one's own; shared as a file: test_palette.py"
)
def test_what_cannot_be_a_part_or_its_name_is_told_and_parts_are_shared_as_a_file(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    a_name_that_cannot_be_is_told_at_once(studio)
    studio.page.keyboard.press("Escape")
    expect(studio.at("own-dialog")).to_have_count(0)
    what_cannot_be_a_part_is_told(studio)
    studio.page.keyboard.press("Escape")
    expect(studio.at("own-dialog")).to_have_count(0)
    parts_are_shared_as_a_file(studio)


@pytest.mark.thorough("tests/studio/test_reach.py: Urdu mirrors the page, its menus and arrow keys")
def test_in_urdu_the_sheet_is_mirrored(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT, locale="ur-PK")
    select(studio, "v11")
    studio.page.keyboard.press("p")
    expect(studio.at("own-lll")).to_be_visible()
    name, lll = place_of(studio.at("own-name")), place_of(studio.at("own-lll"))
    assert name["x"] > lll["x"] + lll["width"]
    expect(studio.at("own-name")).to_have_value(re.compile("میرا پرزہ"))


@pytest.mark.thorough("test_clipping.py, the screen a part of one's own: axe looks at the sheet")
@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_axe_finds_nothing_on_the_sheets(open_studio: OpenStudio, look: tuple[str, ...]) -> None:
    studio = open_studio(TRANSPORT)
    axe_look(studio, *look)
    select(studio, "v11")
    studio.page.keyboard.press("p")
    expect(studio.at("own-lll")).to_be_visible()
    studio.at("opening-v11-condition").locator("input[type=checkbox]").check()
    expect(studio.at("own-lll")).to_contain_text("{condition}")
    find_nothing(studio, "saving a part")
    save_part(studio, "Mine")
    row(studio, "Mine").hover()
    find_nothing(studio, "a part of one's own in the palette")
    row(studio, "Mine").click(button="right")
    expect(studio.at("own-menu")).to_be_visible()
    find_nothing(studio, "its menu")
    studio.page.keyboard.press("Escape")
    row(studio, "Mine").focus()
    studio.page.keyboard.press("F2")
    expect(studio.at("slot-condition")).to_be_visible()
    find_nothing(studio, "editing a part")
    studio.page.keyboard.press("Escape")
    row(studio, "Mine").focus()
    studio.page.keyboard.press("Delete")
    expect(studio.at("own-delete")).to_be_visible()
    find_nothing(studio, "deleting a part")


@pytest.mark.thorough("web/src/session/journal.test.ts, web/src/model/everything.test.ts; tests/studio/test_journal.py")
def test_a_part_is_still_there_after_a_reload_with_its_undo(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    select(studio, "v11")
    studio.page.keyboard.press("p")
    with studio.page.expect_response(re.compile("/api/journal$")):
        save_part(studio, "Mine", "v11-condition")
    studio.page.reload()
    expect(row(studio, "Mine")).to_be_visible()
    expect(studio.page.locator(".vertex", has_text="Mine")).to_have_count(1)
    studio.at("canvas").focus()
    studio.page.keyboard.press("Control+z")
    expect(studio.at("part-Mine")).to_have_count(0)
    expect(studio.page.locator(".vertex", has_text="Mine")).to_have_count(0)


@pytest.mark.thorough(
    "web/src/features/palette/variables.test.tsx: a finger that rests, on the same rows of the palette"
)
def test_a_finger_that_rests_on_a_part_opens_its_menu(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT, has_touch=True)
    select(studio, "v11")
    studio.page.keyboard.press("p")
    save_part(studio, "Mine")
    at = place_of(row(studio, "Mine"))
    down = {
        "pointerType": "touch",
        "isPrimary": True,
        "bubbles": True,
        "clientX": at["x"] + 40,
        "clientY": at["y"] + 10,
    }
    row(studio, "Mine").dispatch_event("pointerdown", down)
    expect(studio.at("own-menu")).to_be_visible()
    row(studio, "Mine").dispatch_event("pointerup", down)
    studio.at("own-menu").get_by_role("menuitem", name="Delete this part").click()
    expect(studio.at("own-delete")).to_contain_text("It is used 1 time.")
