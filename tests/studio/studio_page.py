"""A page of the studio, as tests use it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import FloatRect, Locator, Page, expect

from tests.effort import THOROUGH

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
WIDTH, HEIGHT = 1600, 1000

IS_OPEN = """() => {
    const at = (id) => document.querySelector(`[data-testid="${id}"]`);
    return at("run-button")?.checkVisibility() && at("canvas")?.checkVisibility()
        && at("code")?.querySelector(".cm-line")?.textContent;
}"""
"""Looked at in each frame: Playwright's `expect` waits up to half a second between two looks, and each look at what is
not there yet makes a description of the whole page."""

LOOKS = [("light",), *([("dark", "ur"), ("contrast", "fr")] if THOROUGH else [])]
"""Theme and language that axe looks at whole; it holds the contrast of each screen in one of the themes, by turns."""


def place_of(locator: Locator) -> FloatRect:
    """Where an element is, in CSS px of the window, once it stands still."""
    element = locator.element_handle()
    element.wait_for_element_state("stable")
    place = element.bounding_box()
    assert place is not None
    return place


def begin_new(page: Page) -> None:
    """A new mission without parts, chosen from the pictures that are shown."""
    page.locator("label", has=page.get_by_test_id("new-starter-nothing")).click()
    page.get_by_test_id("new-name").fill("mission")
    page.get_by_test_id("new-begin").click()


@dataclass
class Studio:
    """A page of the studio, and the folder it works in."""

    page: Page
    folder: Path
    faults: list[str]
    address: str = ""

    def at(self, testid: str) -> Locator:
        """The element of that test id."""
        return self.page.get_by_test_id(testid)

    def code(self) -> str:
        """The LLL beside the graph, a line break a line."""
        return "\n".join(self.page.locator('[data-testid="code"] .cm-line').all_inner_texts())

    def expect_whole_code(self, text: str) -> None:
        """Waits until the LLL is this: lines that come into view are drawn in the frame after."""
        lines = self.page.locator('[data-testid="code"] .cm-line')
        expect(lines).to_have_text(text.split("\n"), use_inner_text=True)
        assert self.code() == text

    def edit_code(self) -> None:
        """Gives the LLL the focus, with which it can be edited."""
        self.at("code").locator(".cm-content").focus()
        expect(self.at("code-editor")).to_have_attribute("data-writable", "true")

    def expect_code(self, text: str) -> None:
        """Waits until a stretch of text stands in the LLL."""
        expect(self.at("code")).to_contain_text(text)

    def drag(self, source: Locator, target: Locator) -> None:
        """Drags with the mouse as a hand does: press, move in steps, let go over the middle of the target."""
        source.scroll_into_view_if_needed()
        begin, end = place_of(source), place_of(target)
        mouse = self.page.mouse
        mouse.move(begin["x"] + begin["width"] / 2, begin["y"] + begin["height"] / 2)
        mouse.down()
        mouse.move(begin["x"] + begin["width"] / 2 + 12, begin["y"] + begin["height"] / 2 + 12, steps=2)
        mouse.move(end["x"] + end["width"] / 2, end["y"] + end["height"] / 2, steps=5)
        mouse.up()

    def drop(self, part: str, target: str) -> None:
        """Drags a part of the palette onto something of that test id."""
        self.drag(self.at(f"part-{part}"), self.at(target))

    def new_mission(self) -> None:
        """File, New, and a program from nothing."""
        self.at("menu-File").click()
        self.at("menu-file-new").click()
        begin_new(self.page)
        self.expect_opened()

    def expect_opened(self) -> None:
        """Waits until the mission that was asked for is there."""
        expect(self.page.locator(".studio")).to_have_attribute("aria-busy", "false")

    def take_back(self) -> None:
        """Undoes all that was edited, for the next fact of the same test."""
        undo = self.at("undo")
        while undo.is_enabled():
            undo.click()

    def built_of(self, kit: str) -> None:
        """Answers the question what a robot is built of; "" as its own file says."""
        self.page.locator(f'[data-testid="kit-card"][data-kit="{kit}"]').click()

    def full_speed(self) -> None:
        """As fast as it goes: the last notch of the speed slider."""
        self.at("speed").press("End")

    def wait_until_done(self) -> None:
        """Waits until the run has ended as done; each look of `expect` would describe the whole page."""
        self.at("status").filter(has_text="Done").wait_for()
