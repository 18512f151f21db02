"""A network of namespaces on one machine: its switch loses and delays frames, and can fall in two."""

from __future__ import annotations

import contextlib
import ctypes
import fcntl
import heapq
import os
import random
import select
import struct
import subprocess
import sys
import threading
import time

PREFIX = "krtest"
TEAM, BROKER = "team", "router"
"""The places of the team's process and of a router, beside those of the agents."""


def call(*words: str) -> None:
    subprocess.run(words, check=True, capture_output=True)


class Switch(threading.Thread):
    """Hands on the frames of all places; `loss` is a probability, `delay` in seconds, `side` cut off from the rest."""

    def __init__(self, cards: list[int]) -> None:
        super().__init__(daemon=True)
        self.cards = cards
        self.loss, self.delay = 0.0, 0.0
        self.side: set[int] = set()
        self.over = False
        self.frames = 0

    def run(self) -> None:
        chance, ports = random.Random(1), dict[bytes, int]()
        waiting: list[tuple[float, int, int, bytes]] = []
        while not self.over:
            first = waiting[0][0] - time.monotonic() if waiting else 0.05
            ready, _, _ = select.select(self.cards, [], [], max(0.0, min(0.05, first)))
            for card in ready:
                frame = os.read(card, 65_536)
                at = self.cards.index(card)
                ports[frame[6:12]] = at
                known = ports.get(frame[:6])
                for to in range(len(self.cards)) if known is None else (known,):
                    if to != at and (to in self.side) == (at in self.side) and chance.random() >= self.loss:
                        self.frames += 1
                        heapq.heappush(waiting, (time.monotonic() + self.delay, self.frames, to, frame))
            while waiting and waiting[0][0] <= time.monotonic():
                _, _, to, frame = heapq.heappop(waiting)
                with contextlib.suppress(OSError):
                    os.write(self.cards[to], frame)


def card_in(space: str) -> int:
    """The network card `eth0` of a namespace, as a file."""
    libc = ctypes.CDLL(None, use_errno=True)
    with open("/proc/self/ns/net") as ours, open(f"/run/netns/{space}") as theirs:
        if libc.setns(theirs.fileno(), 0) != 0:
            raise OSError(ctypes.get_errno(), "setns")
        try:
            card = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
            fcntl.ioctl(card, 0x400454CA, struct.pack("16sH22x", b"eth0", 0x0002 | 0x1000))
        finally:
            libc.setns(ours.fileno(), 0)
    return card


class Lab:
    """Namespaces of the agents, and those of team and router, on one switch."""

    def __init__(self, agents: int) -> None:
        self.places = [*(str(n) for n in range(agents)), TEAM, BROKER]
        self.started: list[subprocess.Popen[str]] = []

    def __enter__(self) -> Lab:
        self.clear()
        cards = []
        for place in self.places:
            space = f"{PREFIX}-{place}"
            call("ip", "netns", "add", space)
            cards.append(card_in(space))
            call("ip", "-n", space, "addr", "add", f"{self.address(place)}/24", "dev", "eth0")
            call("ip", "-n", space, "link", "set", "eth0", "up")
            call("ip", "-n", space, "link", "set", "lo", "up")
        self.switch = Switch(cards)
        self.switch.start()
        return self

    def __exit__(self, *_: object) -> None:
        for process in self.started:
            process.kill()
            process.communicate()
        self.switch.over = True
        self.switch.join()
        for card in self.switch.cards:
            os.close(card)
        self.clear()

    def clear(self) -> None:
        for place in self.places:
            subprocess.run(["ip", "netns", "del", f"{PREFIX}-{place}"], capture_output=True, check=False)

    def address(self, place: str) -> str:
        return f"10.77.0.{10 + self.places.index(place)}"

    def within(self, place: str) -> tuple[str, ...]:
        """The words before those of a command that is to run in a namespace."""
        return ("ip", "netns", "exec", f"{PREFIX}-{place}")

    def start(self, place: str, *words: str, quiet: bool = False) -> subprocess.Popen[str]:
        """A Python process in a namespace."""
        process = subprocess.Popen(
            [*self.within(place), sys.executable, *words],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL if quiet else subprocess.PIPE,
            text=True,
        )
        self.started.append(process)
        return process
