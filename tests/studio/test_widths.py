"""Whatever the width of the window: nothing of the head, the tools and the tabs lies over another, none is cut off."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.effort import THOROUGH, cases
from tests.studio.conftest import Studio
from tests.studio.looks import choose, find_nothing
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
SQUARE = "square/square.krt"
LONG_TITLE = "an-adventurous-mission-" * 3 + "end-of-the-road"
"""80 characters and more with ".krt", no space anywhere."""
WIDTHS = [320, 360, 390, 420, 480, 540, 560, 561, 600, 640, 719, 720, 721, 768, 800, 853, 900, 901, 960, 961, 1000]
WIDTHS += [1024, 1100, 1101, 1200, 1280, 1281, 1366, 1440, 1600, 1920, 2560]

# Rows of controls. What is cut where it is longer than its place ends in "…", and a title says it all.
AMISS = """() => {
    const rows = '.head, .tabs, .side-tabs, .side-head, .robots-head, .bottom-bar, .narrow-tabs';
    const pressed = 'button, a[href], input, select, [role=tab], [role^=menuitem], [role=slider], h1, h2, '
        + '[data-testid=saved-state], .run-status-words, .side-note';
    const there = (one) => one.checkVisibility({ opacityProperty: true, visibilityProperty: true })
        && one.closest('[hidden]') === null;
    const name = (one) => one.dataset.testid ?? `${one.tagName} ${one.className} ${one.textContent}`.slice(0, 60);
    const place = (one) => {
        const { left, right, top, bottom } = one.getBoundingClientRect();
        return { one, left, right, top, bottom };
    };
    const controls = [...document.querySelectorAll(rows)].filter(there)
        .flatMap((row) => [...row.querySelectorAll(pressed)]).filter(there)
        .filter((one) => one.getBoundingClientRect().width > 1)
        .map(place);
    const found = [];
    for (const { one, left, right, top, bottom } of controls) {
        if (left < -0.5 || right > innerWidth + 0.5 || top < -0.5 || bottom > innerHeight + 0.5)
            found.push(`${name(one)} is out of the window: ${[left, right, top, bottom].map(Math.round)}`);
    }
    for (let a = 0; a < controls.length; a++) for (let b = a + 1; b < controls.length; b++) {
        const [p, q] = [controls[a], controls[b]];
        if (p.one.contains(q.one) || q.one.contains(p.one)) continue;
        const wide = Math.min(p.right, q.right) - Math.max(p.left, q.left);
        const high = Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top);
        if (wide > 1 && high > 1) found.push(`${name(p.one)} lies over ${name(q.one)} by ${wide.toFixed(1)}`);
    }
    const parts = new Set(controls.flatMap(({ one }) => [one, ...one.querySelectorAll('span, strong, small')]));
    for (const one of parts) {
        const style = getComputedStyle(one);
        if (!there(one) || style.display === 'inline' || style.clipPath !== 'none' || one.tagName === 'INPUT') continue;
        const wide = one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0;
        const high = one.scrollHeight > one.clientHeight + 1 && style.overflowY === 'hidden';
        if (!wide && !high) continue;
        const told = one.closest('[title]') !== null || document.querySelector('[data-testid=status-more]') !== null;
        if (style.textOverflow === 'ellipsis' && wide && told) continue;
        if (style.webkitLineClamp !== 'none' && told) continue;
        // What holds it may cut nothing itself.
        if (wide && style.overflowX === 'visible' && [...one.children].some((child) => parts.has(child))) continue;
        found.push(`${name(one)} is cut: ${one.scrollWidth} in ${one.clientWidth}`);
    }
    const page = document.documentElement;
    if (page.scrollWidth > page.clientWidth) found.push('the page is wider than the window');
    return found;
}"""
SETTLED = "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))"


def mission(studio: Studio, programs: int, word: str = "a-program-with-a-long-name") -> str:
    """A mission of that many programs with long names under a long title, opened in the page."""
    text = (studio.folder / "square.krt").read_text(encoding="utf-8")
    first, end = text.index("<program "), text.index("</program>") + len("</program>")
    program = text[first:end]
    each = (program.replace('name="square"', f'name="{word}-{number}"') for number in range(1, programs + 1))
    team = f'<team><agent name="a-robot-with-a-long-name" program="{word}-1" start="robot-1"/></team>'
    text = text[:first] + "\n".join(each) + team + "</kitrobot>"
    name = f"{LONG_TITLE}.krt"
    (studio.folder / name).write_text(text, encoding="utf-8")
    studio.page.keyboard.press("Control+o")
    studio.at("open-dialog").locator(f'[data-path="{name}"]').click()
    expect(studio.at("title")).to_contain_text(name)
    expect(studio.at(f"tab-{word}-1")).to_be_visible()
    return name


def amiss(studio: Studio, turn: int, height: int = 900) -> list[str]:
    """Everything that is amiss, each with its width: at some widths, others at each turn; thoroughly at all of them."""
    found = []
    for width in WIDTHS if THOROUGH else WIDTHS[2 * turn :: 6]:
        studio.page.set_viewport_size({"width": width, "height": height})
        studio.page.evaluate(SETTLED)
        found += [f"{width} px: {one}" for one in studio.page.evaluate(AMISS)]
    return found


# Words of the other languages are longer than English ones.
@pytest.mark.parametrize("look", cases([("contrast", "ur")], [("dark", "fr"), ("light", "en")]), ids=str)
def test_nothing_overlaps_or_is_cut_at_any_width_and_what_has_no_room_is_in_a_menu(
    open_studio: OpenStudio, look: tuple[str, ...]
) -> None:
    studio = open_studio(SQUARE)
    a_menu_without_room_is_in_the_last_one(studio)
    studio.page.set_viewport_size({"width": 1600, "height": 1000})
    choose(studio, *look)
    assert "\n".join(amiss(studio, 0)) == "", "a usual mission"
    studio.page.set_viewport_size({"width": 1600, "height": 1000})
    mission(studio, 40)
    every_program_is_reached(studio, 320)
    studio.page.set_viewport_size({"width": 1600, "height": 1000})
    studio.drop("Wait", "arc-start.next")
    assert "\n".join(amiss(studio, 1)) == "", "long names"
    studio.page.set_viewport_size({"width": 1600, "height": 1000})
    studio.at("run-button").click()
    studio.at("pause-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    assert "\n".join(amiss(studio, 2, 450)) == "", "paused, in a low window"
    studio.at("stop-button").click()
    a_tool_without_room_is_behind_the_three_dots(studio)


IN_VIEW = """(tab) => {
    const [box, row] = [tab.getBoundingClientRect(), tab.closest('.tabs-scroll').getBoundingClientRect()];
    return box.left >= row.left - 1 && box.right <= row.right + 1 && !tab.hasAttribute('data-cut');
}"""


def every_program_is_reached(studio: Studio, width: int) -> None:
    studio.page.set_viewport_size({"width": width, "height": 900})
    for tab in ("tab-of-team", "tab-of-world", "more-programs"):
        expect(studio.at(tab)).to_be_in_viewport(ratio=1)
    studio.at("more-programs").click()
    expect(studio.at("program-find")).to_be_focused()
    box = place_of(studio.at("program-list"))
    assert box["x"] >= 0
    assert box["x"] + box["width"] <= width
    find_nothing(studio, "the list of programs", within=".program-list")
    studio.at("program-option-a-program-with-a-long-name-40").click()
    last = studio.at("tab-a-program-with-a-long-name-40")
    expect(last).to_have_attribute("aria-selected", "true")
    assert last.evaluate(IN_VIEW)
    expect(studio.at("more-programs")).to_be_focused()
    last.focus()
    studio.page.keyboard.press("Home")
    first = studio.at("tab-a-program-with-a-long-name-1")
    expect(first).to_be_focused()
    assert first.evaluate(IN_VIEW)


@pytest.mark.thorough(
    "web/src/app/ProgramList.test.tsx: by letters, arrows and Enter; at 320 px: every_program_is_reached"
)
@pytest.mark.parametrize("look", cases([("contrast", "ur")], [("light", "en")]), ids=str)
def test_every_program_is_reached_where_its_tab_has_no_room(open_studio: OpenStudio, look: tuple[str, ...]) -> None:
    studio = open_studio(SQUARE)
    choose(studio, *look)
    keys = studio.page.keyboard
    expect(studio.at("more-programs")).to_be_hidden()
    mission(studio, 40, "program-of-many")
    for width in cases([320], [1440, 1024, 600]):
        studio.page.set_viewport_size({"width": width, "height": 900})
        for tab in ("tab-of-team", "tab-of-world", "more-programs"):
            expect(studio.at(tab)).to_be_in_viewport(ratio=1)
        # By mouse: through the list, and what is chosen comes into view.
        studio.at("more-programs").click()
        expect(studio.at("program-find")).to_be_focused()
        expect(studio.at("program-list").locator("li")).to_have_count(40)
        box = place_of(studio.at("program-list"))
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width
        find_nothing(studio, "the list of programs")
        studio.at("program-option-program-of-many-40").click()
        last = studio.at("tab-program-of-many-40")
        expect(last).to_have_attribute("aria-selected", "true")
        assert last.evaluate(IN_VIEW)
        expect(studio.at("more-programs")).to_be_focused()
        # By keys: letters, arrows, Enter.
        keys.press("Enter")
        keys.type("many-2")
        expect(studio.at("program-list").locator("li")).to_have_count(11)
        keys.press("ArrowDown")
        keys.press("Enter")
        found = studio.at("tab-program-of-many-20")
        expect(found).to_have_attribute("aria-selected", "true")
        assert found.evaluate(IN_VIEW)
        keys.press("Enter")
        keys.type("nothing like it")
        expect(studio.at("program-list").locator("li")).to_have_count(0)
        keys.press("Escape")
        expect(studio.at("program-list")).to_have_count(0)
        expect(studio.at("more-programs")).to_be_focused()
        # By the arrows in the row itself, round over team and world.
        found.focus()
        keys.press("End")
        expect(studio.at("tab-of-world")).to_be_focused()
        keys.press("ArrowLeft" if look[1] == "ur" else "ArrowRight")
        first = studio.at("tab-program-of-many-1")
        expect(first).to_be_focused()
        assert first.evaluate(IN_VIEW)


def a_menu_without_room_is_in_the_last_one(studio: Studio) -> None:
    expect(studio.at("menu-more")).to_be_hidden()
    studio.page.set_viewport_size({"width": 320, "height": 640})
    expect(studio.at("menu-Help")).to_be_hidden()
    keys = studio.page.keyboard
    studio.at("menu-File").focus()
    keys.press("ArrowLeft")
    expect(studio.at("menu-more")).to_be_focused()
    keys.press("Enter")
    find_nothing(studio, "menus in common")
    studio.at("menu-help-shortcuts").click()
    expect(studio.at("shortcuts-dialog")).to_be_visible()
    keys.press("Escape")
    # One that has the focus hands it on when it gives way.
    studio.page.set_viewport_size({"width": 1440, "height": 900})
    studio.at("menu-Help").focus()
    studio.page.set_viewport_size({"width": 320, "height": 640})
    expect(studio.at("menu-more")).to_be_focused()


def a_tool_without_room_is_behind_the_three_dots(studio: Studio) -> None:
    studio.page.set_viewport_size({"width": 390, "height": 844})
    expect(studio.at("step-button")).to_be_hidden()
    expect(studio.at("run-button")).to_be_in_viewport(ratio=1)
    studio.at("run-button").click()
    studio.at("pause-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    studio.at("more-tools").click()
    find_nothing(studio, "more tools")
    before = studio.at("status").inner_text()
    studio.at("menu-run-step").click()
    expect(studio.at("status")).not_to_have_text(before)
    expect(studio.at("more-tools")).to_be_focused()
    studio.page.keyboard.press("Enter")
    studio.page.keyboard.press("Escape")
    expect(studio.at("more-tools")).to_be_focused()
