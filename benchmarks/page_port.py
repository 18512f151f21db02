"""Deploying and stopping through a port of the page (Web Serial), beside `kitrobot deploy` and the studio's own port.

    python -m benchmarks.page_port

The board is the micro:bit's firmware in QEMU, with nothing on it each time; the page is in Chromium, the studio and the
bridge to the board's line are processes of their own. STOP is from the click until the page shows that the robot
stands.
"""

from __future__ import annotations

import multiprocessing
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection
from pathlib import Path

from playwright.sync_api import Browser, Locator, expect, sync_playwright

from tests.boards.qemu import running
from tests.studio.conftest import EXAMPLES, IS_OPEN
from tests.studio.serial_ports import MICROBIT, STAND_IN, Bridge
from tools import chromium

from . import browser as measured

TIMES, STOPS = 1, 5
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


def in_studio(chromium: Browser, through_page: bool) -> tuple[float, list[float]]:
    """The seconds from *Run on robot* until it runs, and the ms that STOPs took."""
    context = chromium.new_context(bypass_csp=True)
    context.set_default_timeout(PATIENCE_MS)
    with measured.studio(HEART) as address, running() as board, bridge(board.port) as line:
        page = context.new_page()
        page.goto(address)
        page.wait_for_function(IS_OPEN)
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
        command, own, page, stops = [], [], [], []
        for _ in range(TIMES):
            command.append(by_command())
            own.append(in_studio(found, False)[0])
            took, stopped = in_studio(found, True)
            page.append(took)
            stops += stopped
        found.close()
    for name, seconds in (("kitrobot deploy", command), ("studio, socket://", own), ("studio, page's port", page)):
        print(f"{name}: {statistics.median(seconds):.1f} s ({', '.join(f'{one:.1f}' for one in seconds)})")
    print(f"through the page / kitrobot deploy: {statistics.median(page) / statistics.median(command):.2f}")
    print(f"STOP through the page: {statistics.median(stops):.0f} ms, at most {max(stops):.0f} ms")


if __name__ == "__main__":
    main()
