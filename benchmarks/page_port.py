"""Deploying and stopping through a port of the page (Web Serial), beside `kitrobot deploy` and the studio's own port.

    python -m benchmarks.page_port

The page is a studio's, or one of the static site, where Python runs in the page and the mission is in a link. The board
is the micro:bit's firmware in QEMU, with nothing on it each time; the page is in Chromium, the studio and the bridge to
the board's line are processes of their own. STOP is from the click until the page shows that the robot stands.
"""

from __future__ import annotations

import multiprocessing
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from multiprocessing.connection import Connection
from pathlib import Path

from playwright.sync_api import Browser, Locator, expect, sync_playwright

from kitrobot.packaging.site import make_site
from kitrobot.server.first_missions import first_missions
from tests.boards.qemu import running
from tests.studio.conftest import EXAMPLES, IS_OPEN
from tests.studio.serial_ports import MICROBIT, STAND_IN, Bridge
from tests.studio.sites import MEMORY, PATH, FileServer, link
from tools import chromium
from tools.site_parts import PARTS, ROOT

from . import browser as measured

TIMES, STOPS = 3, 10
PATIENCE_MS = 120_000
HEART = EXAMPLES / "heart" / "heart.krt"
_STOP = """() => new Promise((stopped) => {
    const at = (name) => document.querySelector(`[data-testid="${name}"]`);
    const begun = performance.now();
    new MutationObserver((_, looking) => {
        if (at("robot-state").dataset.state !== "ready") return;
        looking.disconnect();
        stopped(performance.now() - begun);
    }).observe(at("robot-state"), { attributes: true });
    at("robot-stop").click();
})"""


def _serve(port: int, told: Connection) -> None:
    with Bridge(port) as bridge:
        told.send(bridge.address)
        told.recv()


@contextmanager
def bridge(port: int) -> Iterator[str]:
    """A bridge to a board's line in a process of its own; its address."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_serve, args=(port, theirs))
    process.start()
    try:
        yield ours.recv()
    finally:
        ours.send("end")
        process.join()


def by_command() -> float:
    """The seconds of `kitrobot deploy`."""
    with running() as board:
        begun = time.perf_counter()
        command = [sys.executable, "-m", "kitrobot", "deploy", str(HEART), "--to", board.address]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return time.perf_counter() - begun


def in_page(chromium: Browser, address: str, through_page: bool = True) -> tuple[float, list[float]]:
    """The seconds from *Run on robot* until it runs, and the ms that STOPs took; `address`: of a page with *heart*."""
    context = chromium.new_context(bypass_csp=True)
    context.set_default_timeout(PATIENCE_MS)
    with running() as board, bridge(board.port) as line:
        page = context.new_page()
        page.goto(address)
        page.wait_for_function(IS_OPEN)
        expect(page).to_have_title(re.compile("heart", re.IGNORECASE))
        if "#" in address:
            # What the browser keeps at a first visit is kept by then.
            page.wait_for_function(f"async () => await {MEMORY} !== ''")
            page.evaluate("navigator.serviceWorker.ready.then(() => null)")
        page.evaluate(STAND_IN, [line, MICROBIT])
        page.keyboard.press("Alt+r")
        if through_page:
            page.get_by_test_id("find-board").click()
        else:
            page.get_by_test_id("robots-address").fill(board.address)
            page.keyboard.press("Enter")
        robot = page.get_by_test_id("robot")
        robot.get_by_test_id("robot-run").wait_for()
        took = _run(robot)
        stops = []
        for _ in range(STOPS):
            stops.append(float(page.evaluate(_STOP)))
            _run(robot)
        context.close()
    return took, stops


def _run(robot: Locator) -> float:
    begun = time.perf_counter()
    robot.get_by_test_id("robot-run").click()
    expect(robot.get_by_test_id("robot-state")).to_have_attribute("data-state", "running", timeout=PATIENCE_MS)
    return time.perf_counter() - begun


def main() -> None:
    """Prints the medians."""
    path = chromium.find()
    assert path is not None, "no Chromium here"
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        os.environ |= {"KITROBOT_STATE": str(Path(folder) / "state"), "KITROBOT_CONFIG": str(Path(folder) / "none")}
        found = playwright.chromium.launch(executable_path=path, args=list(chromium.FLAGS))
        (web := Path(folder) / "web").mkdir()
        make_site(web / PATH.strip("/"), [ROOT / "web", PARTS], first=first_missions())
        server = FileServer(web)
        site = f"{server.address}#{link(HEART.read_text(encoding='utf-8'), 'heart')}"
        command, own = [], []
        ways: dict[str, tuple[list[float], list[float]]] = {"studio": ([], []), "site": ([], [])}
        for _ in range(TIMES):
            command.append(by_command())
            with measured.studio(HEART) as address:
                own.append(in_page(found, address, False)[0])
            for name, (seconds, stops) in ways.items():
                with measured.studio(HEART) if name == "studio" else nullcontext(site) as address:
                    took, stopped = in_page(found, address)
                seconds.append(took)
                stops += stopped
        found.close()
        server.end()
    _tell("kitrobot deploy", command)
    _tell("studio, socket://", own)
    for name, (seconds, stops) in ways.items():
        _tell(f"{name}, page's port", seconds)
        print(f"  / kitrobot deploy: {statistics.median(seconds) / statistics.median(command):.2f}")
        print(f"  STOP: {statistics.median(stops):.0f} ms, at most {max(stops):.0f} ms")


def _tell(name: str, seconds: list[float]) -> None:
    print(f"{name}: {statistics.median(seconds):.1f} s ({', '.join(f'{one:.1f}' for one in seconds)})")


if __name__ == "__main__":
    main()
