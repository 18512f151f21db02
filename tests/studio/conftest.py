"""The running studio in a real browser: for each worker one server thread, one browser and a few tabs."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Generator, Iterator
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, expect, sync_playwright
from playwright.sync_api import Error as PlaywrightError

from tests.boards.host import SEEN_PACE, HostBoard, host_board
from tests.patience import STATE_MS
from tests.sites import made_site
from tests.studio.robot_rows import write_quick_pulse
from tests.studio.servers import ServedStudio, ServerThread
from tests.studio.sites import PATH, FileServer, Visit
from tests.studio.studio_page import EXAMPLES, HEIGHT, IS_OPEN, LOOKS, WIDTH, Studio, begin_new
from tests.studio.studio_processes import MISSION, Server, Start
from tests.studio.tabs import HANDS_MS, KEEP_TEXT, NOTHING, Tab, Tabs
from tools.chromium import FLAGS

__all__ = ["EXAMPLES", "HEIGHT", "IS_OPEN", "LOOKS", "WIDTH", "ServerThread", "Studio", "begin_new"]

expect.set_options(timeout=STATE_MS)


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


@pytest.fixture(scope="session")
def servers() -> Iterator[ServerThread]:
    """The thread that serves the studios of a worker's tests."""
    thread = ServerThread()
    yield thread
    thread.close()


@pytest.fixture
def open_studio(tabs: Tabs, servers: ServerThread, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[object]:
    """A function that opens the studio on a copy of an example, or on an empty folder with None.

    Words that follow say what device the page is on, as Playwright's contexts do: `viewport`, `has_touch`, …; with
    `first_visit` the browser keeps nothing of the studio yet. An empty folder begins with the pictures of a new
    mission; with `pictures` they stay.
    """
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    opened: list[tuple[Studio, ServedStudio, Tab]] = []

    def open_on(example: str | None, *, first_visit: bool = False, pictures: bool = False, **device: Any) -> Studio:
        target = tmp_path / "missions"
        if example is not None:
            # Without what a studio that somebody opened on the example has kept beside it.
            shutil.copytree((EXAMPLES / example).parent, target, ignore=shutil.ignore_patterns(".kitrobot"))
        else:
            target.mkdir()
        running = servers.serve(target if example is None else target / Path(example).name)
        words = {"viewport": {"width": WIDTH, "height": HEIGHT}, "reduced_motion": "reduce", **device}
        tab = tabs.take(words, first_visit=first_visit)
        page = tab.page
        faults: list[str] = []
        tab.hear("pageerror", lambda error: faults.append(str(error)))
        tab.hear("console", lambda message: faults.append(message.text) if message.type == "error" else None)
        studio = Studio(page, target, faults, running.address)
        opened.append((studio, running, tab))
        page.goto(running.address)
        page.wait_for_function(IS_OPEN)
        if example is None and not pictures:
            page.get_by_test_id("new-name").press("Escape")
        return studio

    yield open_on
    faults = [fault for studio, _, _ in opened for fault in studio.faults]
    for _, running, tab in opened:
        tabs.give_back(tab, running.slot.address)
        running.close()
    assert faults == [], "the page reported errors of its own"


@pytest.fixture
def pulse(open_studio: Callable[..., Studio], tmp_path: Path) -> Callable[..., Studio]:
    """Opens the studio on the mission `pulse`, with its robot; `broken` as in `write_pulse`."""

    def opened(broken: bool = False, **device: object) -> Studio:
        source = tmp_path / "source"
        source.mkdir()
        # An absolute path stays what it is when it is joined to the folder of the examples.
        return open_studio(str(write_quick_pulse(source, broken)), **device)

    return opened


@pytest.fixture
def robots(tmp_path: Path) -> Iterator[Callable[..., HostBoard]]:
    """Starts robots on the network that have `pulse`."""
    with ExitStack() as stack:

        def robot(broken: bool = False) -> HostBoard:
            folder = tmp_path / "robots"
            folder.mkdir(exist_ok=True)
            return stack.enter_context(host_board(write_quick_pulse(folder, broken), "pulse", SEEN_PACE))

        yield robot


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The root of a file server with the site in it."""
    root = tmp_path_factory.mktemp("web")
    shutil.copytree(made_site(tmp_path_factory.getbasetemp()), root / PATH.strip("/"))
    return root


@pytest.fixture
def server(site: Path) -> Iterator[FileServer]:
    """Hands out the site."""
    server = FileServer(site)
    yield server
    server.end()


@pytest.fixture
def visit(browser: Browser, server: FileServer) -> Iterator[Callable[..., Visit]]:
    """A function that begins a visit to the site, which asks nobody else for anything and reports no errors."""
    visits: list[Visit] = []

    def begin(**device: Any) -> Visit:
        words = {"viewport": {"width": WIDTH, "height": HEIGHT}, "reduced_motion": "reduce", **device}
        context = browser.new_context(**words)
        context.add_init_script(KEEP_TEXT)
        visits.append(Visit(context))
        return visits[-1]

    yield begin
    for one in visits:
        one.context.close()
    own = (server.address, "data:", "blob:")
    assert [address for one in visits for address in one.asked if not address.startswith(own)] == []
    assert [fault for one in visits for fault in one.faults] == [], "the page reported errors of its own"


@pytest.fixture
def mission(tmp_path: Path) -> Path:
    """A mission of one Wait, in a folder of its own."""
    path = tmp_path / "missions" / "blink.krt"
    path.parent.mkdir()
    path.write_text(MISSION.format(2))
    return path


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Start]:
    """Starts the studio on a mission or a folder, in a process of its own."""
    servers: list[Server] = []

    def run(target: Path) -> Server:
        servers.append(Server(target, tmp_path / "state"))
        return servers[-1]

    yield run
    for server in servers:
        if server.process.returncode is None:
            server.kill()


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    """A window of the browser in which nothing was opened before."""
    context = browser.new_context(viewport={"width": WIDTH, "height": HEIGHT})
    context.add_init_script(KEEP_TEXT)
    context.set_default_timeout(STATE_MS)
    yield context
    context.close()


@pytest.fixture
def studio(open_studio: Callable[..., Studio], tmp_path: Path) -> Studio:
    """The studio on a copy of that mission, without a process of its own."""
    source = tmp_path / "source"
    source.mkdir()
    (source / "blink.krt").write_text(MISSION.format(2))
    return open_studio(str(source / "blink.krt"))
