"""A class of fifty: what it costs the teacher's process.

The class is a process of its own, as `kitrobot class` starts it; the pupils are sockets and requests of this process
that speak the class's protocol: each reports every two seconds and hands a mission of ten parts in every
four. The teacher's page is a socket, too, which fetches a picture for each change. Programs are not run. Linux alone:
it reads `/proc`.
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
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import httpx
from websockets.asyncio.client import ClientConnection, connect

from benchmarks.measuring import Rate, Row

TITLE = "class"
LEAST = 0.01
REPORT_S, HAND_IN_S = 2.0, 4.0
PARTS = 10


@dataclass(frozen=True)
class Size:
    """`seconds`: of the measurement."""

    pupils: int
    seconds: float


FULL = Size(50, 30)
TINY = Size(2, 1)


def run(size: Size, *, peers: bool) -> list[Row]:
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "kitrobot", "class", f"{folder}/Class", "--no-browser", "--port", "0"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        try:
            assert process.stdout is not None
            teacher = urlsplit(process.stdout.readline().strip())
            code = tomllib.loads((Path(folder) / "Class" / "class.toml").read_text())["code"]
            made = asyncio.run(_measured(size, process.pid, teacher.netloc, teacher.query.partition("=")[2], code))
        finally:
            process.kill()
            process.wait()
    many = f"{size.pupils} pupils"
    return [
        Row(f"{many} hand in and report", "% of a core", _one(made.percent), lower_is_better=True),
        Row(f"{many}, memory of the process", "MB", _one(made.megabytes), lower_is_better=True),
        Row(f"{many}, a mission handed in", "ms", made.waits, lower_is_better=True),
        Row(f"{many}, missions kept", "in a second", _one(made.kept)),
    ]


@dataclass(frozen=True)
class _Made:
    percent: float
    megabytes: float
    waits: Rate
    kept: float


async def _measured(size: Size, pid: int, place: str, key: str, code: str) -> _Made:
    waits: list[float] = []
    limits = httpx.Limits(max_connections=2 * size.pupils)
    async with httpx.AsyncClient(base_url=f"http://{place}", limits=limits, timeout=60) as client:
        keys = []
        for at in range(size.pupils):
            said = await client.post("/api/class/join", json={"code": code, "name": f"Pupil {at}"})
            keys.append(said.json()["key"])
        begun, before = time.perf_counter(), _seconds(pid)
        until = begun + size.seconds
        work = [_pupil(client, place, one, at, size, until, waits) for at, one in enumerate(keys)]
        await asyncio.gather(_teacher(client, place, key, until), *work)
        took, used = time.perf_counter() - begun, _seconds(pid) - before
    waits.sort()
    middle = Rate(waits[len(waits) // 2], waits[-1], waits[0])
    return _Made(max(100 * used / took, LEAST), _megabytes(pid), middle, len(waits) / took)


async def _pupil(
    client: httpx.AsyncClient, place: str, key: str, at: int, size: Size, until: float, waits: list[float]
) -> None:
    await asyncio.sleep(HAND_IN_S * at / size.pupils if size.seconds > HAND_IN_S else 0)
    base, edits, next_work = "", 0, 0.0
    async with connect(f"ws://{place}/api/class/pupil?token={key}") as socket:
        reads = asyncio.ensure_future(_read(socket))
        while True:
            edits += 1
            await socket.send(json.dumps(_report(edits)))
            if time.perf_counter() >= next_work:
                next_work = time.perf_counter() + HAND_IN_S
                wanted = {"name": "square", "base": base, "mission": _mission(edits)}
                begun = time.perf_counter()
                said = await client.put("/api/class/work", json=wanted, headers={"X-KitRobot-Token": key})
                said.raise_for_status()
                waits.append(1000 * (time.perf_counter() - begun))
                base = said.json()["revision"]
            if time.perf_counter() >= until:
                break
            await asyncio.sleep(REPORT_S)
        reads.cancel()


async def _teacher(client: httpx.AsyncClient, place: str, key: str, until: float) -> None:
    async with connect(f"ws://{place}/api/class/teacher/watch?token={key}", max_size=None) as socket:
        while (left := until - time.perf_counter()) > 0:
            try:
                message = json.loads(await asyncio.wait_for(socket.recv(), left))
            except TimeoutError:
                return
            for card in message.get("changed", ()):
                if card["version"]:
                    asked = {"folder": card["folder"]}
                    headers = {"X-KitRobot-Token": key}
                    await client.get("/api/class/teacher/picture", params=asked, headers=headers)


async def _read(socket: ClientConnection) -> None:
    async for _ in socket:
        pass


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
    parts = [f"v{at}" for at in range(PARTS)]
    chain = ["start", *parts, "stop"]

    def vertex(name: str) -> dict[str, Any]:
        element = {"start": "Start", "stop": "Stop"}.get(name, "Wait")
        settings = {"duration": str(1 + edits % 9)} if element == "Wait" else {}
        return {"id": name, "element": element, "settings": settings, "notes": [], "unknown": ""}

    arcs = [{"source": one, "target": other, "out": "", "at": ""} for one, other in itertools.pairwise(chain)]
    program = {"name": "square", "robot": "mini-robot", "vertices": [vertex(one) for one in chain], "arcs": arcs}
    agents = [{"name": "robot-1", "program": "square", "start": ""}]
    return {"version": 1, "programs": [program], "agents": agents, "goals": [], "world": ""}


def _seconds(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _megabytes(pid: int) -> float:
    lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    return int(next(line for line in lines if line.startswith("VmRSS")).split()[1]) / 1024


def _one(value: float) -> Rate:
    return Rate(value, value, value)
