"""A meeting of a team whose members are processes, against a barrier over MQTT (mosquitto and paho) on this machine.

Milliseconds on the clock from a member's arrival until it goes on, all members meeting again and again; of all members
and meetings the median, and the slowest of a hundred. Ours is agreed by a majority and goes on without a member that
fails; the barrier knows nothing of failures and hangs without its broker. The peer is left out where there is no
`mosquitto` or no `paho-mqtt`.
"""

from __future__ import annotations

import importlib.util
import json
import shutil
import socket
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from benchmarks.measurement import Rate, Row, checkout_environment
from benchmarks.meeting import FLEET, KEY

TITLE = "meetings"
PEER = "mosquitto and paho"


@dataclass(frozen=True)
class Size:
    members: tuple[int, ...]
    rounds: int


FULL = Size(members=(3, 10), rounds=200)
TINY = Size(members=(2,), rounds=3)


def run(size: Size, *, peers: bool) -> list[Row]:
    rows: list[Row] = []
    broker = shutil.which("mosquitto") or shutil.which("mosquitto", path="/usr/sbin")
    has_peer = peers and broker is not None and importlib.util.find_spec("paho") is not None
    for members in size.members:
        rounds = max(3, size.rounds * 3 // max(3, members)) if members > 10 else size.rounds
        ours = _sorted(_kitrobot(members, rounds))
        theirs = _sorted(_mqtt(str(broker), members, rounds)) if has_peer else []
        for what, part in (("median", 0.5), ("99 %", 0.99)):
            peer = PEER if theirs else ""
            rows.append(
                Row(
                    f"{members} members meet, {what}",
                    "ms",
                    _part(ours, part),
                    peer,
                    _part(theirs, part) if theirs else None,
                    lower_is_better=True,
                )
            )
    return rows


def _sorted(taken: list[list[float]]) -> list[float]:
    """All times but those of the first meetings, for which connections are opened."""
    return sorted(time for one in taken for time in one[min(3, len(one) - 1) :])


def _part(times: list[float], part: float) -> Rate:
    """The time within which this part of all is over, and the slowest and quickest of all."""
    return Rate(times[min(len(times) - 1, int(part * len(times)))], times[-1], times[0])


def _kitrobot(members: int, rounds: int) -> list[list[float]]:
    from kitrobot.fleet.envelopes import BEGIN, EVERYBODY, HELLO, TEAM_PROCESS, WELCOME
    from kitrobot.fleet.keys import key_of
    from kitrobot.fleet.transport import Channel, Network

    where = f"tcp/127.0.0.1:{_free_port()}"
    channel = Channel(Network(FLEET, (where,)), TEAM_PROCESS, key_of(KEY, "here"))
    try:
        with _workers("kitrobot", members, rounds, where) as workers:
            channel.run = 1
            there: set[int] = set()
            while len(there) < members:
                for envelope in channel.receive(0.2):
                    if envelope.kind == HELLO and envelope.run == channel.run:
                        there.add(envelope.sender)  # It has read its welcome, and so will read that it begins.
                    elif envelope.kind == HELLO:
                        channel.send(envelope.sender, WELCOME, process=envelope.process)
            for _ in range(3):
                channel.send(EVERYBODY, BEGIN)
            return [json.loads(worker.communicate()[0]) for worker in workers]
    finally:
        channel.close()


def _mqtt(broker: str, members: int, rounds: int) -> list[list[float]]:
    port = _free_port()
    with tempfile.TemporaryDirectory() as folder:
        settings = Path(folder, "mosquitto.conf")
        settings.write_text(
            f"listener {port} 127.0.0.1\nallow_anonymous true\nmax_queued_messages 0\nset_tcp_nodelay true\n"
        )
        process = subprocess.Popen([broker, "-c", str(settings)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            while True:
                with socket.socket() as probe:
                    if probe.connect_ex(("127.0.0.1", port)) == 0:
                        break
            with _workers("mqtt", members, rounds, str(port)) as workers:
                return [json.loads(worker.communicate()[0]) for worker in workers]
        finally:
            process.kill()
            process.wait()


@contextmanager
def _workers(kind: str, members: int, rounds: int, where: str) -> Iterator[list[subprocess.Popen[str]]]:
    words = [str(members), str(rounds), where]
    root = Path(__file__).parents[2]
    started = [
        subprocess.Popen(
            [sys.executable, "-m", "benchmarks.meeting", kind, str(me), *words],
            stdout=subprocess.PIPE,
            text=True,
            cwd=root,
            env=checkout_environment(),
        )
        for me in range(members)
    ]
    try:
        yield started
    finally:
        for process in started:
            if process.poll() is None:
                process.kill()
                process.communicate()


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port
