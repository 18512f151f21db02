"""What somebody sees of a gallery mission once it has run: sizes on the screen, what covers them, what the card says.

Where robots are and were is that of the same run in the simulator; where that is on the screen says the camera of the
arena. A mission that waits for a person has one who presses whatever can be pressed, one after another.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import expect

import kitrobot
from kitrobot.sim.setup.settings import length_of
from tests.studio.studio_page import Studio

SIZES = {"1440": (1440, 900), "390": (390, 844)}
"""A notebook and a phone, by their width in px."""

ENDED = ("done", "failed", "stuck", "time")
MOST_PRESSES = 60
STEP_MM = 10
BOARD_MM = 135
"""Of robots without a length of their own, as the arena draws them."""

FACTS = """() => {
    const canvas = document.querySelector('[data-testid="arena-canvas"]');
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const card = document.querySelector('[data-testid="ending"]');
    const words = [...(card?.querySelectorAll(".stage-ending-words p") ?? [])].map((one) => one.textContent);
    return { camera: canvas.dataset.camera.split(" ").map(Number), left, top, width, height,
        tone: card?.dataset.tone ?? "", words };
}"""
COVERED = """(points) => {
    const canvas = document.querySelector('[data-testid="arena-canvas"]');
    const found = {};
    for (const [x, y] of points) {
        const top = document.elementFromPoint(x, y);
        if (top === canvas) continue;
        const named = top?.closest("[data-testid]");
        const name = top === null ? "outside" : named?.dataset.testid ?? top.className;
        found[name] = (found[name] ?? 0) + 1;
    }
    return found;
}"""


@dataclass(frozen=True)
class SeenRun:
    """A run that ended, as it is seen.

    Attributes:
        robot: length of the smallest driving robot on the screen, in px.
        trail: width or height of all the places where robots were, whichever is larger, in px; 0 where nobody moved.
        covered: share of these places (0…1) that something else lies over, or that are not on the screen.
        by: the test ids of what lies over them.
        tone: that of the card.
        words: the paragraphs of the card.
    """

    robot: float
    trail: float
    covered: float
    by: tuple[str, ...]
    tone: str
    words: tuple[str, ...]


@dataclass(frozen=True)
class Ways:
    """Where robots were, in mm, and how long the smallest is."""

    length_mm: float
    points: tuple[tuple[float, float], ...]


def ways_of(path: Path) -> Ways:
    """The same run in the simulator, at most five minutes of it; what only a person would do is left out."""
    mission = kitrobot.open(path)
    run = mission.simulation(seed=1)
    last: dict[int, tuple[float, float]] = {}
    points: list[tuple[float, float]] = []
    while run.outcome is None and run.seconds < 300:
        for index, (x, y, *_) in enumerate(run.poses()):
            if index not in last or math.dist(last[index], (x, y)) >= STEP_MM:
                last[index] = (x, y)
                points.append((x, y))
        run.step()
    lengths = [length_of(agent.robot) for agent in run.members]
    return Ways(min((one for one in lengths if one), default=BOARD_MM), tuple(points))


def press_until_the_end(studio: Studio) -> None:
    """Presses all keys of the watched robot in turn until the run is over."""
    status = studio.at("status")
    keys = studio.page.locator(".arena-hands button")
    for press in range(MOST_PRESSES):
        if status.get_attribute("data-status") in ENDED:
            return
        count = keys.count()
        if count == 0:
            break
        key = keys.nth(press % count)
        key.dispatch_event("pointerdown", {"button": 0, "pointerId": 1, "isPrimary": True})
        key.dispatch_event("pointerup", {"button": 0, "pointerId": 1, "isPrimary": True})
    expect(status).to_have_attribute("data-status", "done")


def run_and_look(studio: Studio, ways: Ways) -> SeenRun:
    """Runs the open mission to its end as fast as it goes, and measures what is there then."""
    studio.at("menu-Run").click()
    studio.at("menu-run-as-fast").click()
    studio.at("run-button").click()
    press_until_the_end(studio)
    expect(studio.at("ending")).to_be_visible()
    studio.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    facts = studio.page.evaluate(FACTS)
    scale, x, y = facts["camera"]
    places = [(facts["left"] + x + mm_x * scale, facts["top"] + y - mm_y * scale) for mm_x, mm_y in ways.points]
    found: dict[str, int] = studio.page.evaluate(COVERED, places)
    xs, ys = [one for one, _ in places], [one for _, one in places]
    size = max(max(xs) - min(xs), max(ys) - min(ys))
    return SeenRun(
        robot=ways.length_mm * scale,
        trail=size if size > STEP_MM * scale else 0.0,
        covered=sum(found.values()) / len(places),
        by=tuple(sorted(found)),
        tone=facts["tone"],
        words=tuple(facts["words"]),
    )


def table(found: Mapping[tuple[str, str], SeenRun]) -> str:
    """The page of the documents: a row for each mission, with both sizes."""
    names = sorted({name for name, _ in found})
    rows = []
    for name in names:
        runs = [found.get((name, size)) for size in SIZES]
        numbers = " | ".join(
            "— | — | —" if one is None else f"{one.robot:.0f} | {one.trail:.0f} | {one.covered * 100:.0f} %"
            for one in runs
        )
        said = next((" ".join(one.words) for one in runs if one is not None), "")
        rows.append(f"| {name} | {numbers} | {said} |")
    return PAGE + "\n".join(rows) + "\n"


PAGE = """# Gallery runs

Each mission of the gallery as it stands on the screen once it has run to its end, as fast as it goes: how many px long
the smallest robot is, how many px wide or high all the places are where robots were (0: nobody moved), and how much of
them lies under something else or outside the screen; first at 1440×900, then at 390×844. A mission that waits for a
person has one who presses whatever can be pressed. `make gallery` writes this page.

| mission | robot | trail | covered | robot, 390 | trail, 390 | covered, 390 | the card |
|---|---|---|---|---|---|---|---|
"""
