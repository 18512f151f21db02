"""The static site from a plain file server, under a path: nothing but files is asked for, and Python runs in the page.

One visit with two starts of Python, because a page with Python in it takes seconds to begin; the second start has no
server any more, and a board behind a port of the page. More of it is tried in the thorough profile (`test_site_whole`,
`test_site_boards`). Building the folder has tests of its own (`tests/workspace/test_site.py`), the same Python without
a page (`tests/server/test_in_page_server.py`), and so have the sentences of each state, storage and links
(`web/src/site`).
"""

from __future__ import annotations

import base64
import re
import shutil
import threading
import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from tests.boards.modern import ModernBoard, onboard_files
from tests.patience import STATE_MS
from tests.sites import made_site
from tests.studio.conftest import EXAMPLES, HEIGHT, IS_OPEN, WIDTH, Studio
from tests.studio.serial_ports import PICO, Bridge
from tests.studio.test_robots import expect_robot

pytestmark = [pytest.mark.browser, pytest.mark.site]

PATH = "/school/kit/"


BLINK = """<kitrobot version="1">
  <program name="blink" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wait"><set name="duration">17</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="blink"/>
  </team>
</kitrobot>
"""


def link(text: str, name: str) -> str:
    """The part of a link behind its `#`, made without the page's own code."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    packed = packer.compress(text.encode()) + packer.flush()
    return f"mission={base64.urlsafe_b64encode(packed).decode().rstrip('=')}&name={name}"


class Files(SimpleHTTPRequestHandler):
    """A file server as Python brings it along: no header of ours, nothing compressed."""

    def __init__(self, *words: Any, gate: threading.Event, **named: Any) -> None:
        self._gate = gate
        super().__init__(*words, **named)

    def do_GET(self) -> None:
        if self.path.endswith(".packed"):
            assert self._gate.wait(STATE_MS / 1000)
        super().do_GET()

    def log_message(self, *_: object) -> None:
        """Says nothing."""


class FileServer:
    """Hands out a folder under PATH."""

    def __init__(self, root: Path) -> None:
        self.folder = root / PATH.strip("/")
        # Nothing of Python is handed out while it is closed.
        self.gate = threading.Event()
        self.gate.set()
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Files, directory=str(root), gate=self.gate))
        self.address = f"http://127.0.0.1:{self._server.server_port}{PATH}"
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)
        self._thread.start()

    def end(self) -> None:
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The root of a file server with the site in it."""
    root = tmp_path_factory.mktemp("web")
    shutil.copytree(made_site(tmp_path_factory.getbasetemp()), root / PATH.strip("/"))
    return root


@pytest.fixture
def server(site: Path) -> Iterator[FileServer]:
    server = FileServer(site)
    yield server
    server.end()


@dataclass
class Visit:
    """A browser that was never here; what its pages said, and what they asked for."""

    context: BrowserContext
    faults: list[str] = field(default_factory=list)
    warned: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.context.set_default_timeout(STATE_MS)
        self.context.on("request", lambda request: self.asked.append(request.url))
        self.context.on("weberror", lambda error: self.faults.append(str(error.error)))
        said = {"error": self.faults, "warning": self.warned}
        self.context.on("console", lambda message: said.get(message.type, []).append(message.text))


@pytest.fixture
def visit(browser: Browser, server: FileServer) -> Iterator[Callable[..., Visit]]:
    """A function that begins a visit to the site, which asks nobody else for anything and reports no errors."""
    visits: list[Visit] = []

    def begin(**device: Any) -> Visit:
        words = {"viewport": {"width": WIDTH, "height": HEIGHT}, "reduced_motion": "reduce", **device}
        visits.append(Visit(browser.new_context(**words)))
        return visits[-1]

    yield begin
    for one in visits:
        one.context.close()
    own = (server.address, "data:", "blob:")
    assert [address for one in visits for address in one.asked if not address.startswith(own)] == []
    assert [fault for one in visits for fault in one.faults] == [], "the page reported errors of its own"


MEMORY = "caches.keys().then((names) => names.filter((name) => name.startsWith('kitrobot memory')).join())"
"""Where the browser keeps Python's memory, or nothing."""

TAKES_OVER_MS = 400_000
"""Chromium lets a service worker take over when the one before has nothing to do; after five minutes at the latest."""


def opened(page: Page, address: str) -> Studio:
    page.goto(address)
    page.wait_for_function(IS_OPEN)
    return Studio(page, Path(), [])


def follow_link(studio: Studio, text: str, name: str) -> None:
    """Opens the mission of a link in a page that is there."""
    studio.page.evaluate("hash => location.hash = hash", link(text, name))
    expect(studio.page).to_have_title(re.compile(name))


def example(name: str) -> str:
    return (EXAMPLES / name / f"{name}.krt").read_text(encoding="utf-8")


def a_mission_runs_is_edited_and_saved_under_a_name_of_its_own(studio: Studio) -> None:
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    studio.drop("Wait", "arc-start.next")
    studio.expect_code("WAIT(10);")
    studio.page.keyboard.press("Control+s")
    studio.at("save-name").fill("mine")
    studio.at("save-name").press("Enter")
    expect(studio.at("saved-state")).to_have_text("saved")


def a_new_version_is_offered(studio: Studio, server: FileServer) -> None:
    studio.page.evaluate("navigator.serviceWorker.ready.then(() => null)")
    worker = server.folder / "service-worker.js"
    worker.write_text(worker.read_text().replace('const VERSION = "', 'const VERSION = "newer-'))
    studio.page.evaluate("navigator.serviceWorker.ready.then((found) => found.update()).then(() => null)")
    expect(studio.at("site")).to_contain_text("There is a new version")


def a_second_tab_waits_and_goes_on_once_the_first_goes_to_the_new_version(studio: Studio, address: str) -> Studio:
    first = studio.page
    second = first.context.new_page()
    # Only here: in the first tab Python began under the policy of the site. A board's stand-in is at another address.
    first.context.new_cdp_session(second).send("Page.setBypassCSP", {"enabled": True})
    second.goto(address)
    expect(second.get_by_test_id("site")).to_contain_text("open in another tab")
    second.wait_for_load_state("networkidle")
    with first.expect_navigation(timeout=TAKES_OVER_MS):
        studio.at("site").get_by_role("button").click()
    second.wait_for_function(IS_OPEN)
    expect(first.get_by_test_id("site")).to_contain_text("open in another tab")
    assert "newer-" in second.evaluate("caches.keys().then((names) => names.join())")
    first.close()
    return Studio(second, Path(), [])


def a_board_is_chosen_sent_to_glows_and_is_stopped(studio: Studio, bridge: Bridge) -> None:
    bridge.give(studio.page)
    studio.page.keyboard.press("Alt+r")
    expect(studio.at("robots-empty")).to_contain_text("Press Find a board, and choose it.")
    expect(studio.at("robots-in-page")).to_contain_text("teams of several boards, need KitRobot installed")
    expect(studio.at("robots-address")).to_have_count(0)
    studio.at("find-board").click()
    robot = studio.at("robot")
    expect(robot.get_by_role("heading")).to_have_text("Raspberry Pi Pico")
    robot.get_by_test_id("robot-run").click()
    studio.built_of("pico")
    expect_robot(robot, state="running")
    # Held, it would stop where Python in the page is busy for longer than 0.8 s.
    robot.get_by_test_id("robot-free").click()
    expect(studio.page.locator(".vertex.is-active").first).to_be_visible()
    studio.at("team-stop").click()
    expect_robot(robot, state="ready")
    bridge.pull()
    expect_robot(robot, phase="lost")


def test_the_first_mission_is_drawn_before_python_is_there_and_nothing_is_done_to_it(
    server: FileServer, visit: Callable[..., Visit]
) -> None:
    """Later the same one is open; once something was done, a page that is loaded again waits for what that was."""
    server.gate.clear()
    page = visit().context.new_page()
    try:
        page.goto(server.address)
        nodes = page.locator(".canvas-node")
        expect(nodes).to_have_count(19)
        expect(page.get_by_test_id("site")).to_contain_text("KitRobot is coming")
        expect(page.locator(".studio")).to_have_attribute("aria-busy", "true")
        # No key and no click reaches it.
        page.keyboard.press("Control+a")
        page.keyboard.press("Delete")
        assert page.locator(".middle").get_attribute("inert") is not None
        server.gate.set()
        page.wait_for_function(IS_OPEN)
        studio = Studio(page, Path(), [])
        expect(page.locator(".studio")).to_have_attribute("aria-busy", "false")
        expect(nodes).to_have_count(19)
        studio.drop("Wait", "arc-start.next")
        expect(nodes).to_have_count(20)
        server.gate.clear()
        page.evaluate("caches.keys().then((names) => Promise.all(names.map((name) => caches.delete(name))))")
        page.goto(server.address)
        expect(page.get_by_test_id("site")).to_contain_text("KitRobot is coming")
        expect(nodes).to_have_count(0)
    finally:
        server.gate.set()


def test_a_site_opens_a_link_keeps_what_is_saved_works_without_its_server_and_sends_to_a_board(
    server: FileServer, visit: Callable[..., Visit]
) -> None:
    made = visit()
    studio = opened(made.context.new_page(), f"{server.address}#{link(BLINK, 'linked')}")
    expect(studio.page).to_have_title(re.compile("linked"))
    studio.expect_code("WAIT(17);")
    a_mission_runs_is_edited_and_saved_under_a_name_of_its_own(studio)
    # Python's memory of this start is kept, and the next one goes on from it.
    studio.page.wait_for_function(f"async () => await {MEMORY} !== ''")
    a_new_version_is_offered(studio, server)
    server.end()
    studio = a_second_tab_waits_and_goes_on_once_the_first_goes_to_the_new_version(studio, server.address)
    studio.page.keyboard.press("Control+o")
    studio.at("open-dialog").locator('[data-path="mine.krt"]').click()
    expect(studio.page).to_have_title(re.compile("mine"))
    studio.expect_code("WAIT(10);")
    studio.page.evaluate("location.hash = 'mission=AAAA&name=x'")
    expect(studio.at("banner")).to_contain_text("The mission in this link is damaged.")
    follow_link(studio, example("blink"), "blink")
    with (
        ModernBoard({"lib/machine.py": onboard_files()["machine.py"]}) as board,
        Bridge(int(board.address.rsplit(":", 1)[1]), PICO) as bridge,
    ):
        a_board_is_chosen_sent_to_glows_and_is_stopped(studio, bridge)
    assert made.warned == []
