"""The static site as its user waits for it, in Chromium, from a plain file server on this machine.

A first visit is one of a browser that has nothing of it; a second visit is another page of the same browser, whose
service worker has the files. Both wait for the graph of the transport mission, then run it once at full speed. Memory
is what the largest process of the browser keeps after that run: page and worker are in it, and a third of it is the
browser's own program. There is no peer, but for a key in the code, which is measured beside the installed studio on
the same mission.
"""

from __future__ import annotations

import base64
import gzip
import statistics
import sys
import tempfile
import threading
import time
import zlib
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from playwright.sync_api import Browser, Page

from benchmarks import browser as web
from benchmarks.measurement import Rate, Row
from benchmarks.subjects.studio import WORKING, mission_of, studio_of, type_in_code
from kitrobot.packaging.site import make_site
from kitrobot.packaging.site_packer import PACKED
from kitrobot.server.first_missions import first_missions
from tools.site_parts import PARTS, ROOT, fetch

TITLE = "site"
PATIENCE_MS = 120_000
SLOWED = 4
GRAPH = "document.querySelector('.canvas-node .vertex')"
USABLE = "!document.querySelector('.studio[aria-busy=true]')"
DONE = "document.querySelector('[data-testid=status]')?.textContent.includes('Done')"


@dataclass(frozen=True)
class Size:
    rounds: int
    second: bool
    """Whether second visits are measured too."""
    vertices: tuple[int, ...]
    """Of the programs in whose code a key is pressed."""


FULL, TINY = Size(3, True, (100, 1000)), Size(1, False, (20,))

Found = dict[str, list[float]]


def run(size: Size, *, peers: bool) -> list[Row]:
    with web.browser() as browser:
        if browser is None or not fetch():
            print("benchmarks: site was left out: there is no Chromium, or no wheel for Pyodide", file=sys.stderr)
            return []
        found: Found = defaultdict(list)
        with tempfile.TemporaryDirectory() as folder:
            place = Path(folder, "site")
            make_site(place, [ROOT / "web", PARTS], first=first_missions())
            found["files, compressed (kB)"] = [_weight(place) / 1000]
            with _served(Path(folder)) as address:
                for _ in range(size.rounds):
                    _visits(browser, f"{address}site/", size, found)
                    _slow_visit(browser, f"{address}site/", found)
                keys = [_keys(browser, f"{address}site/", vertices, size.rounds) for vertices in size.vertices]
    return keys + [
        Row(
            what.partition(" (")[0],
            what.partition("(")[2].rstrip(")"),
            Rate(statistics.median(values), max(values), min(values)),
            lower_is_better=True,
        )
        for what, values in found.items()
    ]


def _keys(browser: Browser, address: str, vertices: int, rounds: int) -> Row:
    """A key in the code, on the site and in the installed studio by turns."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    packed = packer.compress(mission_of(vertices)) + packer.flush()
    link = f"{address}#mission={base64.urlsafe_b64encode(packed).decode().rstrip('=')}&name=measured"
    ours, theirs = list[float](), list[float]()
    for _ in range(rounds):
        ours.append(_key(browser, link))
        with studio_of(vertices) as installed:
            theirs.append(_key(browser, installed))
    rates = [Rate(statistics.median(values), max(values), min(values)) for values in (ours, theirs)]
    what = f"key in the code → graph, code, problems, {vertices} vertices"
    return Row(what, "ms", rates[0], "the installed studio", rates[1], lower_is_better=True)


def _key(browser: Browser, address: str) -> float:
    with web.opened(browser, address, GRAPH) as (page, _):
        page.set_default_timeout(PATIENCE_MS)
        page.hover("[data-testid=code-editor]")
        page.wait_for_selector("[data-testid=code-editor][data-writable=true] .cm-line", timeout=PATIENCE_MS)
        web.wait(page, f"!({WORKING})")
        return type_in_code(page)


def _weight(place: Path) -> int:
    """As a server sends it that compresses what is not packed already."""
    files = [path for path in place.rglob("*") if path.is_file()]
    return sum(
        path.stat().st_size
        if path.suffix in (PACKED, ".woff", ".woff2")
        else len(gzip.compress(path.read_bytes(), 6, mtime=0))
        for path in files
    )


def _visits(browser: Browser, address: str, size: Size, found: Found) -> None:
    context = browser.new_context(viewport={"width": web.WIDTH, "height": web.HEIGHT})
    context.set_default_timeout(PATIENCE_MS)
    try:
        page = context.new_page()
        _visit(page, address, "first visit", found)
        kept, own = _memory(browser)
        found["memory after a run (MB)"].append(kept)
        found["memory after a run, without pages of the browser's files (MB)"].append(own)
        if size.second:
            page.evaluate("navigator.serviceWorker.ready.then(() => null)")
            page.close()
            _visit(context.new_page(), address, "second visit", found)
    finally:
        context.close()


def _visit(page: Page, address: str, which: str, found: Found) -> None:
    begun = time.monotonic()
    page.goto(address, wait_until="commit")
    page.wait_for_selector(".studio")
    found[f"page, {which} (ms)"].append(1000 * (time.monotonic() - begun))
    page.wait_for_function(f"() => {GRAPH}", polling=20)
    found[f"graph, {which} (ms)"].append(1000 * (time.monotonic() - begun))
    # The first mission of a first visit is edited before Python is there.
    _change(page)
    found[f"graph is changed, {which} (ms)"].append(1000 * (time.monotonic() - begun))
    page.keyboard.press("Control+z")
    page.wait_for_function(f"() => {USABLE}", polling=20)
    found[f"Python is there, {which} (ms)"].append(1000 * (time.monotonic() - begun))
    page.get_by_test_id("speed").press("End")
    pressed = time.monotonic()
    page.get_by_test_id("run-button").click()
    page.wait_for_function(f"() => {DONE}", polling=20)
    ended = time.monotonic()
    found[f"first run to its end, {which} (ms)"].append(1000 * (ended - begun))
    found[f"transport at full speed, {which} (ms)"].append(1000 * (ended - pressed))


def _change(page: Page) -> None:
    """Removes a vertex by the mouse and a key, and waits until undo would bring it back.

    What Playwright asks of an element before it clicks would take time in the page too.
    """
    at = page.evaluate(
        """() => {
          const { x, y, width, height } = document.querySelectorAll(".canvas-node .vertex")[1].getBoundingClientRect();
          return [x + width / 2, y + height / 2];
        }"""
    )
    page.mouse.click(*at)
    page.keyboard.press("Delete")
    page.wait_for_function("() => document.querySelector('[data-testid=undo]')?.disabled === false", polling="raf")


def _slow_visit(browser: Browser, address: str, found: Found) -> None:
    """A first visit until the graph was changed, on a processor that is a quarter as fast."""
    context = browser.new_context(viewport={"width": web.WIDTH, "height": web.HEIGHT})
    try:
        page = context.new_page()
        page.set_default_timeout(PATIENCE_MS)
        context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": SLOWED})
        begun = time.monotonic()
        page.goto(address, wait_until="commit")
        page.wait_for_function(f"() => {GRAPH}", polling=20)
        _change(page)
        what = f"graph is changed, first visit, processor slowed {SLOWED} times (ms)"
        found[what].append(1000 * (time.monotonic() - begun))
    finally:
        context.close()


def _memory(browser: Browser) -> tuple[float, float]:
    """What the largest process of the browser keeps in memory, in MB; and that without the pages of files, which are
    the browser's program, the same for all its processes.
    """
    session = browser.new_browser_cdp_session()
    pages = [one["id"] for one in session.send("SystemInfo.getProcessInfo")["processInfo"] if one["type"] == "renderer"]
    kept = [(1000, 1000)]
    for number in pages:
        status = Path(f"/proc/{number}/status")
        lines = (line.split() for line in status.read_text().splitlines()) if status.is_file() else iter(())
        sizes = {line[0]: int(line[1]) for line in lines if line[0] in ("VmRSS:", "RssFile:")}
        kept.append((sizes["VmRSS:"], sizes["VmRSS:"] - sizes["RssFile:"]))
    whole, own = max(kept)
    return whole / 1000, own / 1000


@contextmanager
def _served(root: Path) -> Iterator[str]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(root)))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_: object) -> None:
        pass
