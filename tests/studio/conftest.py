"""The running studio in a real browser: for each worker one server thread, one browser and a few tabs."""

from __future__ import annotations

import asyncio
import secrets
import shutil
import socket
import threading
from collections.abc import Generator, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import uvicorn
from fastapi import FastAPI
from playwright.sync_api import Browser, Locator, Page, expect, sync_playwright
from playwright.sync_api import Error as PlaywrightError
from starlette.types import Receive, Scope, Send

from kitrobot.server.app import create_app
from kitrobot.server.web_server import server_config
from tests.effort import THOROUGH
from tests.patience import PATIENCE_S, STATE_MS
from tests.studio.tabs import HANDS_MS, NOTHING, Tab, Tabs
from tools.chromium import FLAGS

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
WIDTH, HEIGHT = 1600, 1000
expect.set_options(timeout=STATE_MS)

IS_OPEN = """() => {
    const at = (id) => document.querySelector(`[data-testid="${id}"]`);
    return at("run-button")?.checkVisibility() && at("canvas")?.checkVisibility()
        && at("code")?.querySelector(".cm-line")?.textContent;
}"""
"""Looked at in each frame: Playwright's `expect` waits up to half a second between two looks, and each look at what is
not there yet makes a description of the whole page."""


LOOKS = [("light",), *([("dark", "ur"), ("contrast", "fr")] if THOROUGH else [])]
"""Theme and language that axe looks at whole; it holds the contrast of each screen in one of the themes, by turns."""


ENGINE = "--js-flags=--no-opt"
"""Optimising the page takes a tenth of the browser's time, and no test is long enough to get it back."""


WHAT_A_PAGE_SHOWS = """() => {
    const at = document.activeElement;
    const places = ["banner", "said", "saved-state", "site", "status"].map((id) => `[data-testid="${id}"]`);
    const said = [...document.querySelectorAll([...places, '[role="dialog"]'].join())];
    return [location.href, document.hasFocus() ? "has the focus" : "has no focus", at?.cloneNode(false).outerHTML ?? "",
        ...said.map((one) => `${one.dataset.testid ?? "dialog"}: ${one.textContent}`)];
}"""


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Of a test that failed, what its pages show goes into the report: it may not fail a second time."""
    report = yield
    browser = getattr(item, "funcargs", {}).get("browser")
    if call.when == "call" and call.excinfo is not None and browser is not None:
        pages = [page for context in browser.contexts for page in context.pages]
        for page in [page for page in pages if not page.url.endswith(NOTHING)]:
            with suppress(PlaywrightError):
                report.sections.append(("a page shows", "\n".join(page.evaluate(WHAT_A_PAGE_SHOWS))))
    return report


@pytest.fixture(scope="session")
def browser(chromium_path: str) -> Iterator[Browser]:
    """One Chromium for all tests of a worker."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium_path, args=[*FLAGS, ENGINE], slow_mo=HANDS_MS)
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def tabs(browser: Browser) -> Iterator[Tabs]:
    """The tabs that the tests of a worker use one after another."""
    tabs = Tabs(browser)
    yield tabs
    tabs.close()


async def answer_nothing(send: Send) -> None:
    """An empty page."""
    headers = [(b"content-type", b"text/html"), (b"cache-control", b"no-store")]
    await send({"type": "http.response.start", "status": 200, "headers": headers})
    await send({"type": "http.response.body", "body": b'<link rel="icon" href="data:,">'})


class Slot:
    """One address, at which the studios of a worker's tests are served one after another.

    The same address lets the browser keep what it has compiled of the page.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        self.app: FastAPI | None = None
        listening = socket.create_server(("127.0.0.1", 0))
        self.address = f"http://127.0.0.1:{listening.getsockname()[1]}"
        self._server = uvicorn.Server(server_config(self))
        self._ended = asyncio.run_coroutine_threadsafe(self._server.serve([listening]), loop)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope.get("path") == NOTHING:
            await answer_nothing(send)
            return
        assert self.app is not None, "a request to a studio whose test has ended"
        await self.app(scope, receive, send)

    def close(self) -> None:
        self._server.should_exit = True
        self._ended.result(PATIENCE_S)


class ServerThread:
    """One event loop on a thread, which serves the studios of a worker's tests.

    What only a process shows (a kill, a restart, its first line) has tests with processes: test_journal.py.
    """

    def __init__(self) -> None:
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="studios", daemon=True)
        self._thread.start()
        self._slots: list[Slot] = []

    def serve(self, target: Path) -> ServedStudio:
        """Serves the studio on a mission's file or a folder, as `kitrobot studio` does."""
        token = secrets.token_urlsafe(24)
        folder, mission = (target, None) if target.is_dir() else (target.parent, target)
        slot = next((slot for slot in self._slots if slot.app is None), None)
        if slot is None:
            slot = Slot(self._loop)
            self._slots.append(slot)
        slot.app = create_app(folder, mission, token)
        return ServedStudio(f"{slot.address}/?token={token}", slot)

    def close(self) -> None:
        for slot in self._slots:
            slot.close()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join(PATIENCE_S)


@dataclass(frozen=True)
class ServedStudio:
    """A studio that is being served."""

    address: str
    slot: Slot

    def close(self) -> None:
        self.slot.app = None


@pytest.fixture(scope="session")
def servers() -> Iterator[ServerThread]:
    """The thread that serves the studios of a worker's tests."""
    thread = ServerThread()
    yield thread
    thread.close()


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
        """Gives the LLL the focus, once it can be edited."""
        expect(self.at("code-editor")).to_have_attribute("data-writable", "true")
        self.at("code").locator(".cm-content").focus()

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
        """Waits until the run has ended as done."""
        expect(self.at("status")).to_contain_text("Done")


@pytest.fixture
def open_studio(tabs: Tabs, servers: ServerThread, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[object]:
    """A function that opens the studio on a copy of an example, or on an empty folder with None.

    Words that follow say what device the page is on, as Playwright's contexts do: `viewport`, `has_touch`, …; with
    `first_visit` the browser has nothing of the studio yet.
    """
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    opened: list[tuple[Studio, ServedStudio, Tab]] = []

    def open_on(example: str | None, *, first_visit: bool = False, **device: Any) -> Studio:
        target = tmp_path / "missions"
        if example is not None:
            # Without what a studio that somebody opened on the example has kept beside it.
            shutil.copytree((EXAMPLES / example).parent, target, ignore=shutil.ignore_patterns(".kitrobot"))
        else:
            target.mkdir()
        running = servers.serve(target if example is None else target / Path(example).name)
        words = {"viewport": {"width": WIDTH, "height": HEIGHT}, "reduced_motion": "reduce", **device}
        tab = tabs.make(words) if first_visit else tabs.take(words)
        page = tab.page
        faults: list[str] = []
        tab.hear("pageerror", lambda error: faults.append(str(error)))
        tab.hear("console", lambda message: faults.append(message.text) if message.type == "error" else None)
        studio = Studio(page, target, faults, running.address)
        opened.append((studio, running, tab))
        page.goto(running.address)
        page.wait_for_function(IS_OPEN)
        if example is None:
            # The pictures of a new mission, which an empty folder begins with.
            page.get_by_test_id("new-name").press("Escape")
        return studio

    yield open_on
    faults = [fault for studio, _, _ in opened for fault in studio.faults]
    for _, running, tab in opened:
        tabs.give_back(tab, running.slot.address)
        running.close()
    assert faults == [], "the page reported errors of its own"
