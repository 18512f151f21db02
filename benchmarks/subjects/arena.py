"""The arena of the studio with very many robots: frames a second while they drive, with and without their trails.

The real server and the real page in Chromium; the swarm of `swarm.py` runs at plain speed, all of it in view in a large
arena. What one picture costs is told besides, by the page: its main thread from the begin of a picture to its
end, without what the graphics process does afterwards. The stage of a new user follows (`benchmarks/stage.py`).
"""

from __future__ import annotations

import statistics
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import Browser, Page

from benchmarks import browser as web
from benchmarks import stage
from benchmarks.measurement import Rate, Row
from benchmarks.swarm import PROGRAM, ROBOT, arena, rover
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.lll.parse_results import parse
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.world.xml_writer import write_world

TITLE = "arena"

COUNT = """(ms) => new Promise((done) => {
  let [from, frames, work] = [0, 0, 0];
  const each = (now) => {
    if (from === 0) from = now;
    const begun = performance.now();
    // The page's own callbacks of this frame have run or run now; the next task begins when all have.
    setTimeout(() => { work += performance.now() - begun; }, 0);
    frames += 1;
    if (now - from < ms) requestAnimationFrame(each);
    else done([(1000 * (frames - 1)) / (now - from), work / frames]);
  };
  requestAnimationFrame(each);
})"""


@dataclass(frozen=True)
class Size:
    robots: int
    rounds: int
    ms: int
    drawing: int


FULL = Size(2000, 3, 4000, 20)
TINY = Size(20, 1, 300, 2)


def run(size: Size, *, peers: bool) -> list[Row]:
    with web.browser() as browser:
        if browser is None:
            print("benchmarks: arena was left out: there is no Chromium", file=sys.stderr)
            return []
        with _studio(size.robots) as address:
            found = _measured(browser, address, size)
        with stage.studio(size.drawing) as address:
            drawn = [stage.measure(browser, address) for _ in range(size.rounds)]
    rows = [_stage_row(f"{size.drawing} drawing: {name}", [one[name] for one in drawn]) for name in drawn[0]]
    for what, pairs in found.items():
        rates, works = [rate for rate, _ in pairs], [work for _, work in pairs]
        rows += [
            Row(f"{size.robots} robots, {what}", "frames/s", Rate(statistics.median(rates), min(rates), max(rates))),
            Row(
                f"{size.robots} robots, {what}: a picture",
                "ms",
                Rate(statistics.median(works), max(works), min(works)),
                lower_is_better=True,
            ),
        ]
    return rows


def _stage_row(what: str, values: list[float]) -> Row:
    low, high = min(values), max(values)
    if what.endswith("frames"):
        return Row(what, "frames/s", Rate(statistics.median(values), low, high))
    return Row(what, "ms", Rate(statistics.median(values), high, low), lower_is_better=True)


def _measured(browser: Browser, address: str, size: Size) -> dict[str, list[tuple[float, float]]]:
    with web.opened(browser, address, "document.querySelector('[data-testid=arena-canvas]')") as (page, _):
        page.locator("[data-testid=canvas]").focus()
        page.keyboard.press("f")
        page.locator("[data-testid=show-trails]").wait_for()
        page.locator("[data-testid=run-button]").click()
        page.locator("[data-testid=status][data-status=running]").wait_for()
        page.wait_for_timeout(2000)
        found: dict[str, list[tuple[float, float]]] = {"trails on": [], "trails off": []}
        for _ in range(size.rounds):
            for what in found:
                _switch(page, on=what == "trails on")
                rate, work = page.evaluate(COUNT, size.ms)
                found[what].append((float(rate), float(work)))
        return found


def _switch(page: Page, *, on: bool) -> None:
    switch = page.locator("[data-testid=show-trails]")
    if (switch.get_attribute("aria-pressed") == "true") is not on:
        switch.click()


@contextmanager
def _studio(robots: int) -> Iterator[str]:
    """A studio of its own on a mission with so many robots; gives its address."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "rover.robot.xml").write_text(ROBOT, encoding="utf-8")
        Path(folder, "swarm.world.xml").write_bytes(write_world(arena(robots)))
        tree = parse(PROGRAM).program
        mission = Mission(
            programs=[lll_to_graph(tree, rover(), load_catalogue(), "roam")], world_href="swarm.world.xml"
        )
        mission.team = Team([Agent(f"r{n}", "roam") for n in range(robots)])
        path = Path(folder, "swarm.krt")
        path.write_bytes(write_mission(mission))
        with web.studio(path) as address:
            yield address
