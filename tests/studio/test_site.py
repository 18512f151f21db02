"""The static site from a plain file server, under a path: nothing but files is asked for, and Python runs in the page.

One test, because a page with Python in it takes seconds to begin. Building the folder has tests of its own
(`tests/workspace/test_site.py`), and so have what is said in each state and links (`web/src/site`).
"""

from __future__ import annotations

import base64
import re
import shutil
import threading
import zlib
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from tests.patience import STATE_MS
from tests.sites import made_site
from tests.studio.conftest import HEIGHT, IS_OPEN, WIDTH, Studio
from tests.studio.test_check import greedy_text
from tests.studio.test_exercises import JAM
from tests.studio.test_files_out import keep
from tests.studio.test_recordings import drop, expect_tick, value
from tests.studio.test_tutorials import at_step, begin, first_steps_until_run

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

    def log_message(self, *_: object) -> None:
        """Says nothing."""


class FileServer:
    """Hands out a folder under PATH."""

    def __init__(self, root: Path) -> None:
        self.folder = root / PATH.strip("/")
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Files, directory=str(root)))
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


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    context = browser.new_context(viewport={"width": WIDTH, "height": HEIGHT}, reduced_motion="reduce")
    context.set_default_timeout(STATE_MS)
    yield context
    context.close()


NO_LOCKS = "delete Navigator.prototype.locks"
MEMORY = "caches.keys().then((names) => names.filter((name) => name.startsWith('kitrobot memory')).join())"
"""Where the browser keeps Python's memory, or nothing."""
DAMAGE = """async ([name, address, table]) => {
    const headers = { "X-Table": table, "X-Length": "64" };
    await (await caches.open(name)).put(address, new Response(new Uint8Array(64), { headers }));
}"""
ENTRY = """async (name) => {
    const cache = await caches.open(name);
    const [asked] = await cache.keys();
    return [name, asked.url, (await cache.match(asked)).headers.get("X-Table")];
}"""


LATER = """async () => {
    const name = (await indexedDB.databases()).find(({ name }) => name.startsWith("/home")).name;
    const done = (asked) => new Promise((yes, no) => {
        asked.onsuccess = () => yes(asked.result);
        asked.onerror = asked.onblocked = () => no(asked.error);
    });
    (await done(indexedDB.open(name, 99))).close();
}"""
"""As a later browser or KitRobot would leave it: this one cannot read it."""
ENTRIES = """async () => {
    const name = (await indexedDB.databases()).find(({ name }) => name.startsWith("/home")).name;
    const db = await new Promise((yes) => (indexedDB.open(name).onsuccess = (event) => yes(event.target.result)));
    const keys = db.transaction("FILE_DATA").objectStore("FILE_DATA").getAllKeys();
    await new Promise((yes) => (keys.onsuccess = yes));
    db.close();
    return keys.result;
}"""


def opened(page: Page, address: str) -> Studio:
    page.goto(address)
    page.wait_for_function(IS_OPEN)
    return Studio(page, Path(), [])


def a_run_is_stepped_back_in_saved_and_opened_again(studio: Studio, folder: Path) -> None:
    end = value(studio, "aria-valuenow")
    studio.at("step-back-button").click()
    expect_tick(studio, end - 1)
    studio.page.get_by_role("menuitem", name="Run", exact=True).click()
    with studio.page.expect_download() as saved:
        studio.page.get_by_role("menuitem", name="Save this run").click()
    path = folder / "kept.krtrace"
    saved.value.save_as(path)
    drop(studio, path.name, path.read_bytes())
    expect(studio.at("recording-bar")).to_contain_text("kept.krt, seed 1")
    studio.at("event-strip").focus()
    studio.page.keyboard.press("End")
    expect_tick(studio, end)


def a_mission_goes_out_as_a_picture_and_comes_back(studio: Studio, folder: Path) -> None:
    path = keep(studio, "export-png", folder)
    studio.new_mission()
    expect(studio.at("first-place")).to_be_visible()
    studio.page.keyboard.press("Control+o")
    studio.at("open-file").set_input_files(path)
    expect(studio.at("tab-store-manager-A")).to_be_visible()


def an_exercise_is_judged(studio: Studio) -> None:
    studio.page.keyboard.press("Control+o")
    studio.at(JAM).click()
    studio.at("exercise-judge").click()
    expect(studio.at("exercise-basis")).to_have_text("Judged in 2 runs.")
    expect(studio.at("exercise-goal-2")).to_have_attribute("data-state", "missed")
    studio.at("exercise-leave").click()


def a_check_tells_what_breaks_and_plays_it(studio: Studio) -> None:
    studio.page.evaluate("hash => location.hash = hash", link(greedy_text(), "greedy"))
    expect(studio.page).to_have_title(re.compile("greedy"))
    studio.page.keyboard.press("Alt+c")
    studio.at("check-begin").click()
    broken = studio.at("answer-empty-storehouse-lockstep-0")
    expect(broken).to_have_attribute("data-shape", "broken")
    studio.at("check-stop").click()
    expect(studio.at("check-begin")).to_be_visible()
    broken.click()
    expect(studio.at("check-seen")).to_have_attribute("data-confirmed", "true")
    studio.at("check-play").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    expect(studio.at("status")).to_contain_text("01:05.6")


def a_tutorial_follows_what_is_drawn(studio: Studio) -> None:
    begin(studio, "first-steps")
    first_steps_until_run(studio)
    studio.at("run-button").click()
    at_step(studio, 6)


def test_a_site_runs_keeps_what_is_saved_and_works_without_its_server(
    server: FileServer, context: BrowserContext, tmp_path: Path
) -> None:
    asked: list[str] = []
    faults: list[str] = []
    context.on("request", lambda request: asked.append(request.url))
    context.on("weberror", lambda error: faults.append(str(error.error)))
    warned: list[str] = []
    said = {"error": faults, "warning": warned}
    context.on("console", lambda message: said.get(message.type, []).append(message.text))
    page = context.new_page()
    studio = opened(page, server.address)

    # The example runs to its end.
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    expect(studio.at("arena-summary")).to_contain_text("12 of 12 delivered")
    a_run_is_stepped_back_in_saved_and_opened_again(studio, tmp_path)
    a_mission_goes_out_as_a_picture_and_comes_back(studio, tmp_path)
    an_exercise_is_judged(studio)
    a_check_tells_what_breaks_and_plays_it(studio)
    a_tutorial_follows_what_is_drawn(studio)
    page.goto("about:blank")
    studio = opened(page, server.address)

    # An edit is saved under a name of its own, and is there after a reload.
    studio.drop("Wait", "arc-start.next")
    studio.expect_code("WAIT(10);")
    page.keyboard.press("Control+s")
    page.get_by_test_id("save-name").fill("mine")
    page.get_by_test_id("save-name").press("Enter")
    expect(studio.at("saved-state")).to_have_text("saved")
    # Answered after the journal was told of the new name.
    page.keyboard.press("Control+o")
    expect(studio.at("open-dialog")).to_contain_text("mine")
    page.keyboard.press("Escape")
    # Python's memory of this start is kept, and the next starts go on from it.
    page.wait_for_function(f"async () => await {MEMORY} !== ''")
    page.reload()
    page.wait_for_function(IS_OPEN)
    studio.expect_code("WAIT(10);")
    expect(page).to_have_title(re.compile("mine"))

    # A second tab waits for the first, and goes on when that is closed.
    page.evaluate("navigator.serviceWorker.ready.then(() => null)")
    other = context.new_page()
    other.goto(server.address)
    expect(other.get_by_test_id("site")).to_contain_text("open in another tab")
    page.close()
    other.wait_for_function(IS_OPEN)

    # So it is at an address to which the browser gives no locks, such as that of another machine without `https`.
    page = other
    page.add_init_script(NO_LOCKS)
    page.reload()
    page.wait_for_function(IS_OPEN)
    other = context.new_page()
    other.add_init_script(NO_LOCKS)
    other.goto(server.address)
    expect(other.get_by_test_id("site")).to_contain_text("open in another tab")
    page.close()
    other.wait_for_function(IS_OPEN)
    studio = Studio(other, Path(), [])

    # A mission in a link is opened, a damaged one is told; where robots are looked for it is said what is not there.
    other.evaluate("location.hash = 'mission=AAAA&name=x'")
    expect(studio.at("banner")).to_contain_text("The mission in this link is damaged.")
    other.evaluate("hash => location.hash = hash", link(BLINK, "linked"))
    expect(other).to_have_title(re.compile("linked"))
    studio.expect_code("WAIT(17);")
    studio.at("run-on-robot").click()
    expect(studio.at("robots-in-page")).to_contain_text("teams of several boards, need KitRobot installed")
    studio.at("robots-close").click()

    # A new version is offered, and comes when somebody wants it.
    worker = server.folder / "service-worker.js"
    worker.write_text(worker.read_text().replace('const VERSION = "', 'const VERSION = "newer-'))
    other.evaluate("navigator.serviceWorker.ready.then((found) => found.update()).then(() => null)")
    expect(studio.at("site")).to_contain_text("There is a new version")
    with other.expect_navigation():
        studio.at("site").get_by_role("button").click()
    studio.expect_code("WAIT(17);")
    assert "newer-" in other.evaluate("caches.keys().then((names) => names.join())")

    # The server is gone, and a memory is damaged: the page is there, with what was saved, and without that memory.
    assert warned == []
    other.evaluate(DAMAGE, other.evaluate(ENTRY, other.evaluate(MEMORY)))
    server.end()
    other.reload()
    other.wait_for_function(IS_OPEN)
    studio.expect_code("WAIT(17);")
    assert ["memory cannot be used" in line for line in warned] == [True]

    # What was kept and cannot be read is told, and nothing is written over it.
    other.goto(f"{server.address}site.json")
    other.evaluate(LATER)
    entries = other.evaluate(ENTRIES)
    other.goto(server.address)
    other.wait_for_function(IS_OPEN)
    expect(studio.at("site")).to_contain_text("nothing is written over it")
    studio.drop("Wait", "arc-start.next")
    expect(studio.at("saved-state")).to_have_text("only in this page")
    other.goto(f"{server.address}site.json")
    assert entries
    assert other.evaluate(ENTRIES) == entries

    assert [address for address in asked if not address.startswith((server.address, "data:", "blob:"))] == []
    assert faults == []
