"""The stage of a new user: twenty robots draw squares, the camera frames them, and the card comes.

It measures what a person waits for and sees: the time from the press on *Run* to the first picture that moves, frames
a second until the end, and the longest time between two frames, in the run and in the second after its end.
"""

from __future__ import annotations

import itertools
import math
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from playwright.sync_api import Browser

from benchmarks import browser as web
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.lll.parse_results import parse
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.world.geometry import Pose
from kitrobot.world.model import Start, World

PROGRAM = "Pen.PenDown();\n4*(\n  Wheel.DriveBy(30);\n  Motor.LeftBy(90);\n);\n"
APART_MM = 700
AFTER_MS = 1000

WATCH = """(after) => {
    const at = (name) => document.querySelector(`[data-testid="${name}"]`);
    const seen = { frames: [], pressed: 0, moved: 0, ended: 0 };
    at('run-button').addEventListener('click', () => { seen.pressed = performance.now(); },
        { capture: true, once: true });
    window.stageSeen = new Promise((done) => {
        const each = (now) => {
            if (seen.pressed > 0) {
                seen.frames.push(now);
                const moves = Number(at('event-strip')?.getAttribute('aria-valuenow')) > 0;
                if (seen.moved === 0 && moves) seen.moved = now;
                if (seen.ended === 0 && at('status')?.dataset.status === 'done') seen.ended = now;
            }
            if (seen.ended > 0 && now - seen.ended > after) done(seen);
            else requestAnimationFrame(each);
        };
        requestAnimationFrame(each);
    });
}"""


def measure(browser: Browser, address: str) -> dict[str, float]:
    """One run: the figures by name, in ms and in frames a second."""
    with web.opened(browser, address, "document.querySelector('[data-testid=arena-canvas]')") as (page, _):
        page.locator("[data-testid=saved-state]").filter(has_text="saved").wait_for()
        page.evaluate(WATCH, AFTER_MS)
        page.locator("[data-testid=run-button]").click()
        seen = page.evaluate("stageSeen")
    frames, moved, ended = seen["frames"], seen["moved"], seen["ended"]
    gaps = [(now, now - before) for before, now in itertools.pairwise(frames)]
    running = [gap for now, gap in gaps if moved <= now <= ended]
    return {
        "Run to a picture that moves": moved - seen["pressed"],
        "frames": 1000 * len(running) / (ended - moved),
        "longest frame of the run": max(running),
        "longest frame with the card": max(gap for now, gap in gaps if now > ended),
    }


@contextmanager
def studio(robots: int) -> Iterator[str]:
    """A studio of its own on a mission in which so many robots draw; gives its address."""
    columns = math.ceil(math.sqrt(robots))
    places = [(1 + n % columns, 1 + n // columns) for n in range(robots)]
    starts = tuple(Start(f"r{n}", pose=Pose(x * APART_MM, y * APART_MM, 0.0)) for n, (x, y) in enumerate(places))
    side = (columns + 1) * APART_MM
    catalogue = load_catalogue()
    program = lll_to_graph(parse(PROGRAM).program, catalogue.robots["mini-robot"], catalogue, "draw")
    mission = Mission(programs=[program], own_world=World("yard", side, side, starts=starts))
    mission.team = Team([Agent(f"r{n}", "draw") for n in range(robots)])
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "draw.krt")
        path.write_bytes(write_mission(mission))
        with web.studio(path) as address:
            yield address
