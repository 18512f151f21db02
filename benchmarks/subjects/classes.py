"""A class of fifty: what it costs the teacher's process, and what a kill of that process loses.

The class is a process of its own, as `kitrobot class --site` starts it. Ten pupils are pages in Chromium, each with a
Python of its own: they join, put a part in, take it out and run, again and again. The others are sockets and requests
of this process that speak the class's protocol: each reports every two seconds and hands a mission of ten parts in
every four. The teacher's page is a socket, too, which fetches a picture for each change. In the middle the process is
killed and started again after some seconds; at the end what each pupil was told to be kept, and what each page shows,
is compared with the folder of the class. Linux alone: it reads `/proc`.
No peer: no other tool shows a class in this way.
"""

from __future__ import annotations

import asyncio
import itertools
import json
import os
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import httpx
from playwright.async_api import Browser, Page, async_playwright
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import WebSocketException

from benchmarks.measurement import Rate, Row
from kitrobot.files.folder import revision_of
from kitrobot.packaging.site import make_site
from kitrobot.server.first_missions import first_missions
from tools import chromium
from tools.site_parts import PARTS, ROOT, fetch

TITLE = "class"
LEAST = 0.01
REPORT_S, HAND_IN_S, PAGE_S = 2.0, 4.0, 6.0
AWAY_S = 5.0
PARTS_IN_WORK = 10
PATIENCE_MS = 240_000


@dataclass(frozen=True)
class Size:
    """`seconds`: of the measurement; `pages`: of the pupils, how many are pages; `kill`: whether it is killed once."""

    pupils: int
    seconds: float
    pages: int
    kill: bool


FULL = Size(50, 600, 10, True)
TINY = Size(2, 1, 0, False)


@dataclass
class ClassMeasurement:
    """What was measured: times in ms, seconds of processor and of the clock, memory in MB."""

    waits: list[float] = field(default_factory=list)
    used: float = 0.0
    took: float = 0.0
    megabytes: float = 0.0
    runs: int = 0
    lost: int = 0


class Class:
    """The process of the class, which can be killed and started again at the same port."""

    def __init__(self, folder: Path, site: Path | None, found: ClassMeasurement) -> None:
        self.folder = folder
        self._site = site
        self._port = "0"
        self._found = found
        self._start()

    def _start(self) -> None:
        options = [] if self._site is None else ["--site", str(self._site)]
        command = [sys.executable, "-m", "kitrobot", "class", str(self.folder), "--no-browser", "--port", self._port]
        self._process = subprocess.Popen(
            [*command, *options], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        assert self._process.stdout is not None
        address = urlsplit(self._process.stdout.readline().strip())
        self.place, self.key = address.netloc, address.query.partition("=")[2]
        self._port = str(address.port)

    @property
    def code(self) -> str:
        return str(tomllib.loads((self.folder / "class.toml").read_text())["code"])

    def seconds(self) -> float:
        """Of processor that the process took."""
        fields = Path(f"/proc/{self._process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def _take(self) -> None:
        """Adds what the process took; it is over then."""
        lines = Path(f"/proc/{self._process.pid}/status").read_text().splitlines()
        kilobytes = int(next(line for line in lines if line.startswith("VmHWM")).split()[1])
        self._found.used += self.seconds()
        self._found.megabytes = max(self._found.megabytes, kilobytes / 1024)

    def end(self) -> None:
        """Ends it as a power cut would."""
        if self._process.poll() is None:
            self._take()
            self._process.kill()
        self._process.wait()

    async def is_away_for(self, seconds: float) -> None:
        """Is killed, and there again after a while."""
        self.end()
        await asyncio.sleep(seconds)
        await asyncio.to_thread(self._start)


def run(size: Size, *, peers: bool) -> list[Row]:
    found = ClassMeasurement()
    with tempfile.TemporaryDirectory() as folder:
        site = None
        if size.pages and chromium.find() is not None and fetch():
            site = Path(folder, "site")
            make_site(site, [ROOT / "web", PARTS], first=first_missions())
        there = Class(Path(folder, "Class"), site, found)
        try:
            asyncio.run(_measured(size, there, found))
        finally:
            there.end()
    many = f"{size.pupils} pupils" + (f", {size.pages} of them pages," if site is not None else "")
    waits = sorted(found.waits)
    middle = Rate(waits[len(waits) // 2], waits[-1], waits[0])
    return [
        Row(f"{many} for {size.seconds:.0f} s", "% of a core", _one(_percent(found)), lower_is_better=True),
        Row(f"{many} most memory of the process", "MB", _one(found.megabytes), lower_is_better=True),
        Row(f"{many} a mission handed in", "ms", middle, lower_is_better=True),
        Row(f"{many} missions kept", "in a second", _one(len(waits) / found.took)),
        Row(f"{many} runs in pages", "runs", _one(max(found.runs, LEAST))),
        Row(f"{many} work that was lost", "missions", _one(max(found.lost, LEAST)), lower_is_better=True),
    ]


def _percent(found: ClassMeasurement) -> float:
    return max(100 * found.used / found.took, LEAST)


async def _measured(size: Size, there: Class, found: ClassMeasurement) -> None:
    limits = httpx.Limits(max_connections=2 * size.pupils)
    async with httpx.AsyncClient(limits=limits, timeout=60) as client, _pages(size, there) as pages:
        keys = []
        for at in range(size.pupils - len(pages)):
            said = await client.post(
                f"http://{there.place}/api/class/join", json={"code": there.code, "name": f"Pupil {at}"}
            )
            keys.append(said.json()["key"])
        # What starting and coming in took is no part of the lesson.
        begun, found.used = time.perf_counter(), -there.seconds()
        until = begun + size.seconds
        work = [_pupil(client, there, key, at, size, until, found) for at, key in enumerate(keys)]
        work += [_page(page, until, found) for page in pages]
        await asyncio.gather(_teacher(client, there, until), *work, *([_kill(size, there)] if size.kill else []))
        there.end()
        found.took = time.perf_counter() - begun
        found.lost += sum([await _is_lost(page, there.folder / f"Page {at}") for at, page in enumerate(pages)])


async def _kill(size: Size, there: Class) -> None:
    await asyncio.sleep(size.seconds / 2)
    await there.is_away_for(AWAY_S)


# -- pupils by the protocol


async def _pupil(
    client: httpx.AsyncClient, there: Class, key: str, at: int, size: Size, until: float, found: ClassMeasurement
) -> None:
    """Begins anew where the class went away; what it was told to be kept must be in the folder at the end."""
    await asyncio.sleep(HAND_IN_S * at / size.pupils if size.seconds > HAND_IN_S else 0)
    base, edits, next_work = "", 0, 0.0
    while True:
        try:
            async with connect(f"ws://{there.place}/api/class/pupil?token={key}") as socket:
                reads = asyncio.ensure_future(_read(socket))
                try:
                    while True:
                        edits += 1
                        await socket.send(json.dumps(_report(edits)))
                        if time.perf_counter() >= next_work:
                            base = await _hand_in(client, there, key, edits, base, found)
                            next_work = time.perf_counter() + HAND_IN_S
                        if time.perf_counter() >= until:
                            kept = (there.folder / f"Pupil {at}" / "square.krt").read_bytes()
                            found.lost += revision_of(kept) != base
                            return
                        await asyncio.sleep(REPORT_S)
                finally:
                    reads.cancel()
        except (OSError, WebSocketException, httpx.TransportError):
            await asyncio.sleep(REPORT_S)


async def _hand_in(
    client: httpx.AsyncClient, there: Class, key: str, edits: int, base: str, found: ClassMeasurement
) -> str:
    """The revision that is kept."""
    wanted = {"name": "square.krt" if base else "square", "base": base, "mission": _mission(edits)}
    begun = time.perf_counter()
    address = f"http://{there.place}/api/class/work"
    said = await client.put(address, json=wanted, headers={"X-KitRobot-Token": key})
    said.raise_for_status()
    found.waits.append(1000 * (time.perf_counter() - begun))
    return str(said.json()["revision"])


async def _read(socket: ClientConnection) -> None:
    async for _ in socket:
        pass


async def _teacher(client: httpx.AsyncClient, there: Class, until: float) -> None:
    while time.perf_counter() < until:
        try:
            address = f"ws://{there.place}/api/class/teacher/watch?token={there.key}"
            async with connect(address, max_size=None) as socket:
                while (left := until - time.perf_counter()) > 0:
                    message = json.loads(await asyncio.wait_for(socket.recv(), left))
                    for card in message.get("changed", ()):
                        if card["version"]:
                            asked = {"folder": card["folder"]}
                            headers = {"X-KitRobot-Token": there.key}
                            picture = f"http://{there.place}/api/class/teacher/picture"
                            await client.get(picture, params=asked, headers=headers)
        except TimeoutError:
            return
        except (OSError, WebSocketException, httpx.TransportError):
            await asyncio.sleep(REPORT_S)


# -- pupils as pages


@asynccontextmanager
async def _pages(size: Size, there: Class) -> AsyncIterator[list[Page]]:
    """Pages of so many browsers in which a pupil has joined, and Python has begun."""
    if not size.pages or chromium.find() is None:
        yield []
        return
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=chromium.find(), args=list(chromium.FLAGS))
        yield [await _joined(browser, there, f"Page {at}") for at in range(size.pages)]
        await browser.close()


async def _joined(browser: Browser, there: Class, name: str) -> Page:
    context = await browser.new_context(viewport={"width": 1280, "height": 800})
    context.set_default_timeout(PATIENCE_MS)
    page = await context.new_page()
    await page.goto(f"http://{there.place}/")
    await page.get_by_test_id("join-code").fill(there.code)
    await page.get_by_test_id("join-name").fill(name)
    await page.get_by_test_id("join-go").click()
    await page.get_by_test_id("new-name").press("Escape")
    return page


async def _page(page: Page, until: float, found: ClassMeasurement) -> None:
    """Puts a part in, takes it out, and runs now and then; waits at the end until all is handed in."""
    edits = 0
    while time.perf_counter() < until:
        edits += 1
        await page.get_by_test_id("canvas").click(position={"x": 5, "y": 5})
        if edits % 2 == 0:
            await page.keyboard.press("Control+z")
        else:
            await page.keyboard.press("/")
            await page.keyboard.type("wait")
            await page.keyboard.press("Enter")
        if edits % 3 == 0:
            await page.get_by_test_id("run-button").click()
            found.runs += 1
        await asyncio.sleep(PAGE_S)
    await page.locator('[data-testid=class-kept][data-kept="yes"]').wait_for()


async def _is_lost(page: Page, folder: Path) -> bool:
    """Whether the folder has another number of parts than the page."""
    (kept,) = folder.glob("*.krt")
    shown = await page.locator(".vertex").count()
    return kept.read_text().count("<vertex ") != shown + len(("start", "stop"))


# -- what is handed in


def _report(edits: int) -> dict[str, Any]:
    goals = [{"reached": edits % 3 == 0, "why": "three sides, the way does not close"} for _ in range(4)]
    return {
        "type": "report",
        "running": edits % 5 == 0,
        "edits": edits,
        "runs": edits // 5,
        "file": "square",
        "exercise": "example:exercises/03-square.exercise.xml",
        "goals": goals,
    }


def _mission(edits: int) -> dict[str, Any]:
    parts = [f"v{at}" for at in range(PARTS_IN_WORK)]
    chain = ["start", *parts, "stop"]

    def vertex(name: str) -> dict[str, Any]:
        element = {"start": "Start", "stop": "Stop"}.get(name, "Wait")
        settings = {"duration": str(1 + edits % 9)} if element == "Wait" else {}
        return {"id": name, "element": element, "settings": settings, "notes": [], "unknown": ""}

    arcs = [{"source": one, "target": other, "out": "", "at": ""} for one, other in itertools.pairwise(chain)]
    program = {"name": "square", "robot": "mini-robot", "vertices": [vertex(one) for one in chain], "arcs": arcs}
    agents = [{"name": "robot-1", "program": "square", "start": ""}]
    return {"version": 1, "programs": [program], "agents": agents, "goals": [], "world": ""}


def _one(value: float) -> Rate:
    return Rate(value, value, value)
