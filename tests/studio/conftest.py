"""The running studio in a real browser: a server of its own for each test, on loopback, ended by its process."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Locator, Page, expect, sync_playwright

from tools.chromium import FLAGS

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
WIDTH, HEIGHT = 1600, 1000
PATIENCE_MS = 30_000
"""How long a state is waited for: a busy machine is slow, and no test is about that."""
expect.set_options(timeout=PATIENCE_MS)


@pytest.fixture(scope="session")
def browser(chromium_path: str) -> Iterator[Browser]:
    """One Chromium for all tests of a worker; each test has a context of its own."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium_path, args=list(FLAGS))
        yield browser
        browser.close()


@dataclass
class Studio:
    """A page of the studio, and the folder it works in."""

    page: Page
    folder: Path
    faults: list[str]

    def at(self, testid: str) -> Locator:
        """The element of that test id."""
        return self.page.get_by_test_id(testid)

    def code(self) -> str:
        """The LLL beside the graph, a line break a line."""
        return "\n".join(self.page.locator('[data-testid="code"] .cm-line').all_inner_texts())

    def expect_code(self, text: str) -> None:
        """Waits until a stretch of text stands in the LLL."""
        expect(self.at("code")).to_contain_text(text)

    def drag(self, source: Locator, target: Locator) -> None:
        """Drags with the mouse as a hand does: press, move in steps, let go over the middle of the target."""
        source.scroll_into_view_if_needed()
        begin, end = source.bounding_box(), target.bounding_box()
        assert begin is not None
        assert end is not None
        mouse = self.page.mouse
        mouse.move(begin["x"] + begin["width"] / 2, begin["y"] + begin["height"] / 2)
        mouse.down()
        mouse.move(begin["x"] + begin["width"] / 2 + 12, begin["y"] + begin["height"] / 2 + 12, steps=3)
        mouse.move(end["x"] + end["width"] / 2, end["y"] + end["height"] / 2, steps=12)
        mouse.up()

    def drop(self, part: str, target: str) -> None:
        """Drags a part of the palette onto something of that test id."""
        self.drag(self.at(f"part-{part}"), self.at(target))

    def full_speed(self) -> None:
        """As fast as it goes: the last notch of the speed slider."""
        self.at("speed").focus()
        self.page.keyboard.press("End")

    def wait_until_done(self) -> None:
        """Waits until the run has ended as done."""
        expect(self.at("status")).to_contain_text("Done", timeout=60_000)


@pytest.fixture
def open_studio(browser: Browser, tmp_path: Path) -> Iterator[object]:
    """A function that opens the studio on a copy of an example, or on an empty folder with None.

    Words that follow say what device the page is on, as Playwright's contexts do: `viewport`, `has_touch`, …
    """
    servers: list[subprocess.Popen[str]] = []
    pages: list[Studio] = []

    def open_on(example: str | None, **device: Any) -> Studio:
        target = tmp_path / "missions"
        if example is not None:
            shutil.copytree((EXAMPLES / example).parent, target)
        else:
            target.mkdir()
        argument = str(target / Path(example).name) if example is not None else str(target)
        command = [sys.executable, "-m", "kitrobot", "studio", argument, "--no-browser", "--port", "0"]
        server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        servers.append(server)
        assert server.stdout is not None
        address = re.search(r"http://\S+", server.stdout.readline())
        assert address is not None, "the studio says its address on its first line"
        words = {"viewport": {"width": WIDTH, "height": HEIGHT}, "reduced_motion": "reduce", **device}
        context = browser.new_context(**words)
        page = context.new_page()
        faults: list[str] = []
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda message: faults.append(message.text) if message.type == "error" else None)
        page.goto(address.group(0))
        expect(page.get_by_test_id("run-button")).to_be_visible()
        expect(page.get_by_test_id("canvas")).to_be_visible()
        expect(page.locator('[data-testid="code"] .cm-line').first).not_to_be_empty()
        studio = Studio(page, target, faults)
        pages.append(studio)
        return studio

    yield open_on
    faults = [fault for studio in pages for fault in studio.faults]
    for studio in pages:
        studio.page.context.close()
    for server in servers:
        server.terminate()
        server.wait(10)
        assert server.stdout is not None
        server.stdout.close()
    assert faults == [], "the page reported errors of its own"
