"""Many pages watching one run: what that costs the server, and what reaches them.

The studio's server is in this process, so its processor time is this process's; the pages are sockets in a process of
their own, which read everything and look at nothing (`benchmarks.audience`). One starts the transport mission at real
time, the others watch it. Rounds without watchers and with them take turns. No peer: no other tool shares a run.
"""

from __future__ import annotations

import json
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import uvicorn

from benchmarks.measurement import Rate, Row
from kitrobot.files.examples import examples_folder
from kitrobot.server.app import create_app
from kitrobot.server.web_server import server_config

TITLE = "watchers"
TOKEN = "measuring"
MISSION = "transport.krt"
LEAST = 0.01
"""Percent of a core that can be told from nothing."""


@dataclass(frozen=True)
class Size:
    """`seconds`: of each measurement."""

    watchers: int
    seconds: float
    rounds: int


FULL = Size(50, 10, 3)
TINY = Size(2, 0.5, 1)


def run(size: Size, *, peers: bool) -> list[Row]:
    alone, shared, rates = [], [], []
    with _studio() as address:
        for _ in range(size.rounds):
            alone.append(_measured(address, 0, size.seconds)[0])
            taken, frames = _measured(address, size.watchers, size.seconds)
            shared.append(taken)
            rates += frames
    added = [max(one - other, LEAST) for one, other in zip(shared, alone, strict=True)]
    many = f"{size.watchers} watchers"
    return [
        Row("a run that nobody else watches", "% of a core", _percent(alone), lower_is_better=True),
        Row(f"a run with {many}", "% of a core", _percent(shared), lower_is_better=True),
        Row(f"{many}, besides the run", "% of a core", _percent(added), lower_is_better=True),
        Row(f"reaches each of {many}", "frames/s", Rate(statistics.median(rates), max(min(rates), LEAST), max(rates))),
    ]


def _percent(shares: list[float]) -> Rate:
    return Rate(statistics.median(shares), max(shares), min(shares))


@contextmanager
def _studio() -> Iterator[str]:
    """The server in a thread, as `kitrobot` configures it, on a copy of the transport mission; gives its address."""
    examples = examples_folder()
    assert examples is not None, "KitRobot comes with examples"
    with tempfile.TemporaryDirectory() as folder, socket.socket() as listening:
        shutil.copy(examples / "transport" / MISSION, folder)
        listening.bind(("127.0.0.1", 0))
        server = uvicorn.Server(server_config(create_app(Path(folder), None, TOKEN)))
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]}, daemon=True)
        thread.start()
        while not server.started:
            time.sleep(0.01)
        try:
            yield f"ws://127.0.0.1:{listening.getsockname()[1]}"
        finally:
            server.should_exit = True
            thread.join()


def _measured(address: str, watchers: int, seconds: float) -> tuple[float, list[float]]:
    """The share of a core, in percent, that a run with so many watchers takes, and the frames a second of each."""
    command = [sys.executable, "-m", "benchmarks.audience", address, TOKEN, MISSION, str(watchers)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as pages:
        assert pages.stdin is not None
        assert pages.stdout is not None
        assert pages.stdout.readline() == "all watch\n"
        begun, worked = time.perf_counter(), time.process_time()
        time.sleep(seconds)
        share = 100 * (time.process_time() - worked) / (time.perf_counter() - begun)
        took = time.perf_counter() - begun
        pages.stdin.write("enough\n")
        pages.stdin.flush()
        counts = json.loads(pages.stdout.readline())
    assert pages.returncode == 0
    return share, [count / took for count in counts]
