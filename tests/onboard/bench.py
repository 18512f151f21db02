"""A robot's loop on a bench: a thread of its own, a clock that stands still unless somebody waits, a wire of bytes."""

from __future__ import annotations

import queue
import struct
import threading
from pathlib import Path
from types import TracebackType

from kitrobot_onboard.link import unwrap, wrap
from tests.boards.booting import boot
from tests.patience import PATIENCE_S

CHUNK = 60


class Wire:
    """The port: what it reads and when is up to the test."""

    BYTE_US = 87

    def __init__(self) -> None:
        self.now = 0
        self.until = 0
        self.orders: queue.Queue[bytes | int | None] = queue.Queue()
        self.idle: queue.Queue[bool] = queue.Queue()
        self.sent = b""
        self.shows = False

    def ticks(self) -> int:
        return self.now

    def diff(self, later: int, earlier: int) -> int:
        return later - earlier

    def add(self, ticks: int, ms: int) -> int:
        return ticks + ms

    def read(self, ms: int) -> bytes:
        if self.now < self.until:
            self.now += min(ms, self.until - self.now) or 1
            return b""
        self.idle.put(True)
        order = self.orders.get(timeout=PATIENCE_S)
        if order is None:
            raise KeyboardInterrupt
        if isinstance(order, int):
            self.until = self.now + order
            return b""
        return order

    def write(self, data: bytes) -> None:
        self.now += len(data) * self.BYTE_US // 1000
        self.sent += data

    def identify(self, on: bool) -> None:
        self.shows = on

    def tidy(self) -> None:
        """There is room enough."""


class Bench:
    """A robot whose loop goes on while the `with` lasts. `program`: a program file, which is begun at once."""

    def __init__(self, folder: Path, program: bytes | None = None) -> None:
        self.wire = Wire()
        self.robot, run = boot(self.wire, folder, program, 7)

        def loop() -> None:
            try:
                run(self.robot)
            except KeyboardInterrupt:
                pass
            finally:
                self.wire.idle.put(False)

        self.thread = threading.Thread(target=loop, daemon=True)
        self.number = 0

    def __enter__(self) -> Bench:
        self.thread.start()
        assert self.rests()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self.wire.orders.put(None)
        self.thread.join(PATIENCE_S)
        assert not self.thread.is_alive()

    def rests(self) -> bool:
        """Waits until the loop has nothing more to do; False: it has ended."""
        return self.wire.idle.get(timeout=PATIENCE_S)

    def send(self, data: bytes) -> list[tuple[str, int, bytes]]:
        """Sends bytes; the frames that came since the last time."""
        for at in range(0, len(data), CHUNK):
            self.wire.orders.put(data[at : at + CHUNK])
            if not self.rests():
                break
        return self.frames()

    def wait(self, ms: int) -> list[tuple[str, int, bytes]]:
        """Lets so much time go by; the frames that came since the last time."""
        self.wire.orders.put(ms)
        self.rests()
        return self.frames()

    def frames(self) -> list[tuple[str, int, bytes]]:
        """What was sent since the last time, which must be whole frames and nothing else."""
        sent, self.wire.sent = self.wire.sent, b""
        found = []
        for part in sent.split(b"~"):
            if part:
                frame = unwrap(part)
                assert frame is not None, part
                found.append(frame)
        return found

    def ask(self, kind: str, data: bytes = b"") -> tuple[str, bytes]:
        """Sends a request; kind and payload of its one answer, which is the first thing that is sent."""
        self.number = self.number % 255 + 1
        frames = self.send(wrap(kind, self.number, data))
        assert [number for _, number, _ in frames].count(self.number) == 1, frames
        return next((kind, data) for kind, number, data in frames if number == self.number)

    def force(self, cell: int, value: int | None) -> None:
        assert self.ask("f", struct.pack("<BBi", cell, value is not None, value or 0)) == ("K", b"")
