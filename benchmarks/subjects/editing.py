"""An edit as the server sees it: a key in the editor, or a setting in the graph, until the answer is written.

Counted: reading the request with its whole mission, the graph of the text, checking, lowering, verifying, setting the
mission up, and the JSON of the answer, as processor time of the process. Not counted: the network and the page. Each
edit is another one, and goes on from the answer before.
"""

from __future__ import annotations

import asyncio
import gc
import json
import re
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.measurement import Row, milliseconds
from benchmarks.subjects.studio import mission_of
from kitrobot.server.app import create_app
from kitrobot.server.garbage_collector import tune_garbage_collector
from kitrobot.server.in_page_server import InPageServer

TITLE = "editing"
PATH = "measured.krt"
_WARM = 3
"""Edits that do not count."""


@dataclass(frozen=True)
class Size:
    vertices: tuple[int, ...]
    edits: int


FULL = Size((20, 100, 1000), 40)
TINY = Size((40,), 1)


def run(size: Size, *, peers: bool) -> list[Row]:
    thresholds = gc.get_threshold()
    tune_garbage_collector()
    try:
        return _rows(size)
    finally:
        gc.set_threshold(*thresholds)
        gc.unfreeze()


def _rows(size: Size) -> list[Row]:
    rows: list[Row] = []
    for vertices in size.vertices:
        for what, measure in (("key in the code", _keys), ("setting in the graph", _settings)):
            with tempfile.TemporaryDirectory() as folder:
                Path(folder, PATH).write_bytes(mission_of(vertices))
                taken = asyncio.run(measure(Studio(Path(folder)), size.edits + _WARM))
            rows.append(Row(f"{what}, {vertices} vertices", "ms", milliseconds(taken[_WARM:]), lower_is_better=True))
    return rows


class Studio:
    """A studio on a folder, and the processor seconds of its last answer."""

    def __init__(self, folder: Path) -> None:
        self._server = InPageServer(create_app(folder, None, "token"), "token")
        self.seconds = 0.0

    async def ask(self, method: str, address: str, body: bytes = b"") -> Any:
        """The answer to a request."""
        begun = time.process_time()
        answer = await self._server.fetch(method, address, {"content-type": "application/json"}, body)
        self.seconds = time.process_time() - begun
        assert answer.status == 200, answer.body
        return json.loads(answer.body)


async def _keys(studio: Studio, edits: int) -> list[float]:
    mission, report = await _opened(studio)
    taken: list[float] = []
    for text in _texts(report["programs"][0]["lll"], edits):
        wanted = {"mission": mission, "path": PATH, "program": mission["programs"][0]["name"], "text": text}
        found = await studio.ask("POST", "/api/text", json.dumps(wanted).encode())
        taken.append(studio.seconds)
        mission["programs"] = [found["program"]]
    return taken


async def _settings(studio: Studio, edits: int) -> list[float]:
    mission, _ = await _opened(studio)
    settable = [one for one in mission["programs"][0]["vertices"] if one["settings"]]
    settings = settable[len(settable) // 2]["settings"]
    taken: list[float] = []
    for number in range(edits):
        settings[next(iter(settings))] = str(10 + number)
        await studio.ask("POST", "/api/check", json.dumps({"mission": mission, "path": PATH}).encode())
        taken.append(studio.seconds)
    return taken


async def _opened(studio: Studio) -> tuple[Any, Any]:
    """The mission, and what was said of it."""
    mission = (await studio.ask("GET", f"/api/mission?path={PATH}"))["mission"]
    return mission, await studio.ask("POST", "/api/check", json.dumps({"mission": mission, "path": PATH}).encode())


def _texts(text: str, count: int) -> Iterator[str]:
    """The text behind a wait, with other numbers in the place of one in its middle."""
    text = f"WAIT(1);\n{text}"
    numbers = [*re.finditer(r"(?<=\()\d+(?=[,)])", text)]
    middle = numbers[len(numbers) // 2]
    for number in range(count):
        yield f"{text[: middle.start()]}{10 + number}{text[middle.end() :]}"
