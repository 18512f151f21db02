"""Everything by the keyboard: one table of keys, and a way to every entry, tab, tree and tool."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
TRANSPORT = "transport/transport.krt"
MENUS = ("File", "Edit", "View", "Program", "Run", "Help")

ENTRIES = "() => [...document.querySelectorAll('[role=menu] [role^=menuitem]')].map(one => one.dataset.testid)"
KEYS = "() => [...document.querySelectorAll('[role=menu] .menu-keys')].map(one => one.textContent)"
FOCUSED = "() => document.activeElement?.dataset.testid ?? ''"


def vertex(studio: Studio, words: str) -> Locator:
    """The first vertex of the graph that says that."""
    return studio.page.locator(".vertex", has_text=words).first


def add(studio: Studio, words: str, key: str = "/") -> None:
    """Types to add a part: the key, some letters, Enter."""
    studio.page.keyboard.press(key)
    expect(studio.at("add-find")).to_be_focused()
    studio.page.keyboard.type(words)
    studio.page.keyboard.press("Enter")
    expect(studio.at("add-find")).to_have_count(0)


def walk_menu(studio: Studio) -> set[str]:
    """Goes once around an open menu with the arrow key; gives what had the focus."""
    seen: list[str] = []
    while (here := str(studio.page.evaluate(FOCUSED))) not in seen:
        seen.append(here)
        studio.page.keyboard.press("ArrowDown")
    return set(seen)


def listed(studio: Studio) -> tuple[set[str], str]:
    """Keys and words of the sheet that `?` opens."""
    studio.at("canvas").focus()
    studio.page.keyboard.press("?")
    sheet = studio.at("shortcuts-dialog")
    expect(sheet).to_be_visible()
    keys = set(sheet.locator(".keys:not(.keys-paths) kbd").all_inner_texts())
    words = sheet.inner_text()
    studio.page.keyboard.press("Escape")
    expect(sheet).to_have_count(0)
    return keys, words


def every_entry_of_every_menu_is_reached_and_its_key_is_in_the_list(studio: Studio) -> None:
    page = studio.page
    keys, words = listed(studio)
    for menu in MENUS:
        page.keyboard.press("Alt")
        expect(studio.at("menu-File")).to_be_focused()
        if menu != "File":
            page.keyboard.press(menu[0])
        else:
            page.keyboard.press("ArrowDown")
        expect(page.get_by_role("menu")).to_be_visible()
        entries = set(page.evaluate(ENTRIES))
        labels = page.locator("[role^=menuitem]:not(:has(.menu-keys)) .menu-label").all_inner_texts()
        used = page.evaluate(KEYS)
        assert walk_menu(studio) == entries, menu
        assert set(used) <= keys, menu
        assert [label for label in labels if label not in words] == [], menu
        page.keyboard.press("Escape")
        page.keyboard.press("Escape")
        expect(page.get_by_role("menu")).to_have_count(0)


def every_entry_of_the_context_menus_is_reached(studio: Studio) -> None:
    page = studio.page
    keys, _ = listed(studio)
    for choose in ("Escape", "ArrowDown", "a"):
        page.keyboard.press(choose)
        page.keyboard.press("Shift+F10")
        expect(studio.at("context-menu")).to_be_visible()
        entries = set(page.evaluate(ENTRIES))
        assert set(page.evaluate(KEYS)) <= keys, choose
        assert walk_menu(studio) == entries, choose
        page.keyboard.press("Escape")


NO_WAY = """() => {
    // Team and world belong to the list of tabs by `aria-owns`.
    const roving = '.tabs-last, [role=menubar], [role=tablist], [role=tree], [role=menu], [role=listbox], .cm-editor';
    const byKey = '.fold, .folded, .note-strip, .chip, .hole, .arc-spot, '
        + '[data-testid^=place-]';
    return [...document.querySelectorAll('button, a[href], input, select, textarea, [role=button], [role=treeitem]')]
        .filter(one => one.checkVisibility() && !one.disabled && one.tabIndex < 0)
        .filter(one => one.closest(roving) === null && one.closest(byKey) === null)
        .map(one => one.outerHTML.slice(0, 120));
}"""


def nothing_on_the_page_is_for_the_mouse_alone(studio: Studio) -> None:
    assert studio.page.evaluate(NO_WAY) == []
    vertex(studio, "Wheels Drive").click()
    assert studio.page.evaluate(NO_WAY) == []
    studio.at("problems").click()
    studio.page.keyboard.press("Control+f")
    assert studio.page.evaluate(NO_WAY) == []


def test_rooms_are_walked_by_keys_alt_leads_to_the_menus_and_nothing_is_for_the_mouse_alone(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio("square/square.krt")
    studio.at("canvas").focus()
    studio.page.keyboard.press("Alt")
    expect(studio.at("menu-File")).to_be_focused()
    studio.page.keyboard.press("h")
    expect(studio.page.get_by_role("menu")).to_be_visible()
    studio.page.keyboard.press("Escape")
    studio.page.keyboard.press("Escape")
    rooms_are_walked(studio)
    speed_follows_its_keys_but_not_while_one_types(studio)
    studio.page.locator(".vertex", has_text="Repeat").first.locator(".vertex-name").click()
    assert studio.page.evaluate(NO_WAY) == []


@pytest.mark.thorough(
    "web/src/app/reach.test.tsx: every entry of every menu is reached and in the list of keys, programs by keys; "
    "features/canvas/editing.test.tsx: menus of the graph, another script; "
    "test_rooms_are_walked_by_keys_alt_leads_to_the_menus_and_nothing_is_for_the_mouse_alone"
)
def test_every_menu_entry_and_room_is_reached_by_keys_which_are_listed_and_nothing_is_for_the_mouse_alone(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(TRANSPORT)
    programs_are_walked_moved_renamed_and_removed(studio)
    studio.page.keyboard.press("Escape")
    studio.take_back()
    every_entry_of_every_menu_is_reached_and_its_key_is_in_the_list(studio)
    every_entry_of_the_context_menus_is_reached(studio)
    studio.page.keyboard.press("Escape")
    f7_goes_through_the_rooms_and_the_arena_answers_keys(studio)
    speed_follows_its_keys_but_not_while_one_types(studio)
    studio.at("tab-carrier").click()
    keys_mean_the_same_on_a_keyboard_of_another_script(studio)
    studio.page.keyboard.press("Escape")
    nothing_on_the_page_is_for_the_mouse_alone(studio)


def programs_are_walked_moved_renamed_and_removed(studio: Studio) -> None:
    keys = studio.page.keyboard
    tabs = studio.page.locator("[role=tab][id^=tab-][data-program]:not([data-testid=tab-team])")
    names = tabs.locator(".tab-name").all_inner_texts()
    studio.at("canvas").focus()
    keys.press("Alt+PageDown")
    expect(studio.at(f"tab-{names[1]}")).to_have_attribute("aria-selected", "true")
    keys.press("Alt+PageUp")
    keys.press("Alt+PageUp")
    expect(studio.at(f"tab-{names[-1]}")).to_have_attribute("aria-selected", "true")
    keys.press("Alt+PageDown")
    keys.press("Alt+Shift+PageDown")
    expect(tabs.locator(".tab-name")).to_have_text([names[1], names[0], *names[2:]])
    keys.press("Control+z")
    expect(tabs.locator(".tab-name")).to_have_text(names)
    keys.press("F2")
    expect(studio.at("tab-name-field")).to_be_focused()
    keys.type("driver")
    keys.press("Enter")
    expect(studio.at("tab-driver")).to_be_visible()
    studio.at("tab-driver").focus()
    keys.press("Delete")
    expect(studio.at("tab-driver")).to_have_count(0)
    keys.press("Control+z")
    expect(studio.at("tab-driver")).to_be_visible()
    keys.press("Alt+n")
    expect(studio.at("add-program")).to_have_attribute("aria-expanded", "true")


@pytest.mark.thorough(
    "web/src/features/canvas/editing.test.tsx: by keys alone; features/new-mission/choice.test.ts: the pictures; "
    "test_first_minutes.py begins with keys"
)
def test_a_program_is_drawn_without_a_mouse(open_studio: OpenStudio) -> None:
    studio = open_studio(None)
    keys = studio.page.keyboard
    keys.press("Control+Alt+n")
    # Robot, place, then the first program: the one before the square is nothing.
    expect(studio.at("new-robots-mini-robot")).to_be_focused()
    keys.press("Tab")
    keys.press("Tab")
    keys.press("ArrowUp")
    expect(studio.at("new-starter-nothing")).to_be_checked()
    keys.press("Enter")
    studio.expect_opened()
    expect(studio.at("first-place")).to_be_visible()
    expect(studio.at("code")).to_contain_text("Your program appears here")
    studio.at("canvas").focus()
    add(studio, "repet")
    studio.expect_code("10*(")
    # Into the body, by its arc.
    keys.press("a")
    expect(studio.page.locator(".arc.is-selected .arc-spot")).to_have_count(1)
    add(studio, "wait")
    expect(studio.at("code")).to_contain_text(re.compile(r"10\*\(\s*WAIT\(10\);"))
    keys.press("Alt+ArrowDown")
    expect(studio.at("code")).to_contain_text(re.compile(r"10\*\(\s*\);\s*WAIT\(10\);"))
    keys.press("Alt+ArrowUp")
    expect(studio.at("code")).to_contain_text(re.compile(r"WAIT\(10\);\s*10\*\("))
    keys.press("Shift+ArrowDown")
    expect(studio.page.locator(".vertex.is-selected")).to_have_count(2)
    add(studio, "while", "w")
    expect(studio.at("code")).to_contain_text(re.compile(r"\*\[\s*\]\(\s*WAIT\(10\);\s*10\*\("))


@pytest.mark.thorough("web/src/features/palette/tree.test.ts and variables.test.tsx: walked by arrows, and Enter adds")
def test_the_parts_are_walked_and_enter_puts_one_at_the_selection(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    keys = studio.page.keyboard
    vertex(studio, "Wheels Stand still").click()
    for _ in range(8):
        if studio.page.evaluate("document.activeElement.closest('.parts') !== null"):
            break
        keys.press("F7")
    row = studio.page.locator(".palette [role=treeitem][tabindex='0']")
    expect(row).to_be_focused()
    first = row.get_attribute("data-row")
    keys.press("ArrowRight")
    expect(row).not_to_have_attribute("data-row", first or "")
    keys.press("ArrowLeft")
    expect(row).to_have_attribute("data-row", first or "")
    keys.press("/")
    expect(studio.at("part-find")).to_be_focused()
    keys.type("wait")
    keys.press("ArrowDown")
    keys.press("Enter")
    expect(studio.at("code")).to_contain_text(re.compile(r"Wheel\.Stop\(\);\s*WAIT\(10\);"))


def f7_goes_through_the_rooms_and_the_arena_answers_keys(studio: Studio) -> None:
    rooms_are_walked(studio)
    keys = studio.page.keyboard
    studio.at("arena-canvas").focus()
    for key in ("ArrowLeft", "+", "-", "0"):
        keys.press(key)
    keys.press("n")
    expect(studio.at("tab-carrier")).to_have_attribute("aria-selected", "true")
    keys.press("Shift+N")
    keys.press("Shift+N")
    expect(studio.at("tab-carrier")).to_have_attribute("aria-selected", "false")


def rooms_are_walked(studio: Studio) -> None:
    keys = studio.page.keyboard
    studio.at("canvas").focus()
    rooms: list[str] = []
    sides = ".side-inspector, .side-code, .side-arena"
    selectors = f"'.menubar, .toolbar, .parts, .tabs, .canvas, {sides}, footer.bottom-bar'"
    for _ in range(9):
        rooms.extend(studio.page.evaluate(f"[...(document.activeElement.closest({selectors})?.classList ?? [])]"))
        keys.press("F7")
        if rooms.count("canvas") == 2:
            break
    assert {"menubar", "toolbar", "parts", "tabs", "canvas", "side-code", "side-arena", "bottom-bar"} <= set(rooms)


def keys_mean_the_same_on_a_keyboard_of_another_script(studio: Studio) -> None:
    vertex(studio, "Wheels Stand still").click()
    studio.page.evaluate(
        "document.activeElement.dispatchEvent("
        "new KeyboardEvent('keydown', { key: 'ن', code: 'KeyN', bubbles: true, cancelable: true }))"
    )
    expect(studio.at("note-field")).to_be_focused()


def speed_follows_its_keys_but_not_while_one_types(studio: Studio) -> None:
    speed = studio.at("speed")
    studio.at("canvas").focus()
    studio.page.keyboard.press(".")
    expect(speed).to_have_attribute("aria-valuetext", "2×")
    studio.at("part-find").focus()
    studio.page.keyboard.press(",")
    expect(studio.at("part-find")).to_have_value(",")
    expect(speed).to_have_attribute("aria-valuetext", "2×")
