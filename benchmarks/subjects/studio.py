"""The studio as its user waits for it, in Chromium, against Blockly on a page of its own with the same program.

Ours is the real server and the real page: every change of the graph goes to the server, which prints the LLL and looks
for problems; a change of the text becomes a graph there first. Blockly does what a page with Blockly does: it draws all
blocks, and writes its JavaScript anew after a change, without looking for problems. Its changes are calls in the page
and not keys, so it does not pay for their handling. Both run in the same browser, one after another, a fresh
page for each round. Seconds are those of the clock: here it is the waiting that counts.
"""

from __future__ import annotations

import json
import shutil
import statistics
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import Browser, Page

from benchmarks import browser as web
from benchmarks.measurement import Rate, Row
from benchmarks.peers import blockly, node
from benchmarks.random_programs import ROBOT, catalogue, graph_of, tree_of_vertices
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.mission.writer import write_mission

TITLE = "studio"
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
FRAMES = "frames/s"
WORKING = "document.querySelector('[data-testid=problems]').getAttribute('aria-busy') !== 'false'"

CAMERA = "document.querySelector('.canvas-graph')"


@dataclass(frozen=True)
class Size:
    vertices: tuple[int, ...]
    rounds: int
    steps: int
    """Moves of the mouse in a measurement of frames."""


FULL = Size((1000, 5000), 3, 120)
TINY = Size((40,), 1, 4)

Found = dict[str, list[float]]

MEASURED = {
    "first picture": "ms",
    "insert → picture": "ms",
    "insert → code and problems": "ms",
    "key in the code → graph, code, problems": "ms",
    "panning": FRAMES,
    "dragging": FRAMES,
    "panning, all in view": FRAMES,
    "the page with its text editor, compressed": "kB",
}
FIRST_LOAD = "first load of a mission without problems, compressed"


def run(size: Size, *, peers: bool) -> list[Row]:
    rows: list[Row] = []
    with web.browser() as browser:
        if browser is None:
            print("benchmarks: studio was left out: there is no Chromium", file=sys.stderr)
            return []
        for vertices in size.vertices:
            ours: Found = defaultdict(list)
            theirs: Found = defaultdict(list)
            with _blockly(vertices, wanted=peers) as peer:
                for _ in range(size.rounds):
                    # A studio of its own: another one would bring the work of the round before back.
                    with studio_of(vertices) as address:
                        _measure_studio(browser, address, size, ours)
                    if peer is not None:
                        _measure_blockly(browser, peer, vertices, size, theirs)
            name = f"Blockly {node.version('blockly')}" if theirs else ""
            rows += [
                Row(
                    f"{what}, {vertices} vertices",
                    unit,
                    _rate(ours[what], unit),
                    name,
                    _rate(theirs[what], unit) if theirs[what] else None,
                    lower_is_better=unit != FRAMES,
                )
                for what, unit in MEASURED.items()
            ]
        rows.append(Row(FIRST_LOAD, "kB", _rate([_measure_first_load(browser)], "kB"), lower_is_better=True))
    return rows


def _measure_first_load(browser: Browser) -> float:
    """What the page fetches before anybody touches it, in kB: what edits the text comes with a pointer or a problem."""
    with tempfile.TemporaryDirectory() as folder:
        copy = shutil.copytree(EXAMPLES / "draw-square", Path(folder, "draw-square"))
        with (
            web.studio(next(copy.glob("*.krt"))) as address,
            web.opened(browser, address, "document.querySelector('.canvas-node .vertex')") as (page, _),
        ):
            web.wait(page, f"!({WORKING})")
            page.wait_for_load_state("networkidle")
            return web.weight(page) / 1000


def _rate(values: list[float], unit: str) -> Rate:
    slow, fast = (min, max) if unit == FRAMES else (max, min)
    return Rate(statistics.median(values), slow(values), fast(values))


def mission_of(vertices: int) -> bytes:
    """A generated mission with a program of about so many vertices."""
    program = graph_of(tree_of_vertices(vertices))
    return write_mission(Mission(programs=[program], team=Team(agents=[Agent("robot-1", program.name)])))


@contextmanager
def studio_of(vertices: int) -> Iterator[str]:
    """A studio of its own on a generated mission; gives its address."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "measured.krt")
        path.write_bytes(mission_of(vertices))
        with web.studio(path) as address:
            yield address


@contextmanager
def _blockly(vertices: int, *, wanted: bool) -> Iterator[str | None]:
    """Blockly's page on the same program; None when it is not wanted or not to be had."""
    folder = node.installed("blockly") if wanted else None
    if folder is None:
        yield None
        return
    tree, robot = tree_of_vertices(vertices), catalogue().robot(ROBOT)
    state, _ = blockly.workspace(tree, robot)
    for number, stack in enumerate(state["blocks"]["blocks"]):
        stack |= {"x": 20 + 700 * (number % 8), "y": 20 + 3000 * (number // 8)}
    given = {"definitions": blockly.definitions(robot, tree), "workspace": state}
    here = Path(blockly.__file__).parent
    packed = b"\n".join(
        (folder / name).read_bytes()
        for name in ("blockly_compressed.js", "blocks_compressed.js", "javascript_compressed.js", "msg/en.js")
    )
    files = {
        "": ("text/html", (here / "blockly_page.html").read_bytes()),
        "blockly_page.css": ("text/css", (here / "blockly_page.css").read_bytes()),
        "blockly_page.js": ("text/javascript", (here / "blockly_page.js").read_bytes()),
        "blockly.min.js": ("text/javascript", packed),
        "given.json": ("application/json", json.dumps(given).encode()),
    }
    kinds = {".svg": "image/svg+xml", ".png": "image/png", ".gif": "image/gif", ".cur": "image/x-icon"}
    for path in (folder / "media").iterdir():
        if path.suffix in kinds:
            files[f"media/{path.name}"] = (kinds[path.suffix], path.read_bytes())
    with web.served(files) as address:
        yield address


def _measure_studio(browser: Browser, address: str, size: Size, found: Found) -> None:
    with web.opened(browser, address, "document.querySelector('.canvas-node .vertex')") as (page, first):
        found["first picture"].append(first)
        # What edits the text is fetched as the pointer comes to it, and counts.
        page.hover("[data-testid=code-editor]")
        page.wait_for_selector("[data-testid=code-editor][data-writable=true] .cm-line")
        web.wait(page, f"!({WORKING})")
        page.wait_for_load_state("networkidle")
        found["the page with its text editor, compressed"].append(web.weight(page) / 1000)
        found["insert → picture"].append(_insert(page, "true"))
        found["insert → code and problems"].append(_insert(page, f"!({WORKING})"))
        found["key in the code → graph, code, problems"].append(type_in_code(page))
        found["panning"].append(_pan(page, size))
        page.keyboard.press("Escape")
        found["dragging"].append(
            web.frames_while_dragging(page, *web.place_on(page, ".vertex .vertex-name", ".canvas"), size.steps)
        )
        page.get_by_role("button", name="Show the whole program").click()
        web.wait(page, f"!/scale\\(1\\)/.test({CAMERA}.style.transform)")
        found["panning, all in view"].append(_pan(page, size))


def _pan(page: Page, size: Size) -> float:
    return web.frames_while_dragging(page, *web.place_on(page, ".canvas-pane", ".canvas"), size.steps)


def _insert(page: Page, also: str) -> float:
    """A part put behind the first vertex in view, by keys."""
    page.locator(".vertex .vertex-name").first.click()
    page.keyboard.press("/")
    page.get_by_test_id("add-find").fill("wait")
    page.wait_for_selector("[data-testid=add-Wait][aria-selected=true]")
    before = page.evaluate("document.querySelector('.vertex.is-selected').dataset.testid")
    chosen = "document.querySelector('.vertex.is-selected')?.dataset.testid"
    taken = web.key_to_picture(page, "Enter", f"{chosen} && {chosen} !== '{before}' && {also}")
    web.wait(page, f"!({WORKING})")
    return taken


def type_in_code(page: Page) -> float:
    """One key in the code panel that changes a number of the first instruction: ms until all of the page follows."""
    page.locator("[data-testid=code-editor] .cm-content").focus()
    page.keyboard.press("Control+Home")
    page.keyboard.insert_text("WAIT(5);\n")
    web.wait(page, f"!({WORKING})")
    for key in ("ArrowUp", "End", "ArrowLeft", "ArrowLeft"):
        page.keyboard.press(key)
    drawn = "[...document.querySelectorAll('.vertex .box strong')].some((box) => box.textContent.startsWith('5.7'))"
    return web.key_to_picture(page, "7", f"{drawn} && !({WORKING})")


def _measure_blockly(browser: Browser, address: str, vertices: int, size: Size, found: Found) -> None:
    with web.opened(browser, address, "peer.ready") as (page, first):
        assert page.evaluate("peer.blocks()") == vertices - 2
        found["first picture"].append(first)
        found["the page with its text editor, compressed"].append(web.weight(page) / 1000)
        found["insert → picture"].append(web.act_to_picture(page, "peer.insert()"))
        web.wait(page, "peer.code > 0")
        again = "(peer.code = 0, peer.insert())"
        found["insert → code and problems"].append(web.act_to_picture(page, again, "peer.code > 0"))
        change = "(peer.code = 0, peer.change(57))"
        found["key in the code → graph, code, problems"].append(web.act_to_picture(page, change, "peer.code > 0"))
        found["panning"].append(_pan_blockly(page, size))
        block = web.place_on(page, ".blocklyDraggable .blocklyText", "#blocks")
        found["dragging"].append(web.frames_while_dragging(page, *block, size.steps))
        page.evaluate("peer.fit()")
        found["panning, all in view"].append(_pan_blockly(page, size))


def _pan_blockly(page: Page, size: Size) -> float:
    return web.frames_while_dragging(page, *web.place_on(page, ".blocklyMainBackground", "#blocks"), size.steps)
