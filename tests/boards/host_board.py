"""A board on CPython: the loop that runs on real boards, with a TCP socket on loopback for its serial line.

    python -m tests.boards.host_board FOLDER [--port N] [--pace P | --waits]

prints its address (`socket://127.0.0.1:PORT`) once it runs, and serves one host after the other until one of them says
`q`. What lies on it was laid into FOLDER (`tests.boards.booting.lay`); its drivers are those of `tests.boards.drivers`,
by their plain names. Its clock goes P times as fast as that of the wall, or waits for a host that is busy.
"""

from __future__ import annotations

import argparse
import select
import socket
from pathlib import Path

from tests.boards.clocks import Clock, TrafficClock, WallClock
from tests.boards.started import started


class SocketPort:
    """The port of `kitrobot_onboard.robot` over a listening socket; a host that goes is like a cable that is pulled."""

    def __init__(self, port: int = 0, clock: Clock | None = None) -> None:
        self.clock = clock or WallClock()
        self.listener = socket.create_server(("127.0.0.1", port))
        self.peer: socket.socket | None = None
        self.shows = False

    @property
    def address(self) -> str:
        return f"socket://127.0.0.1:{self.listener.getsockname()[1]}"

    def ticks(self) -> int:
        return int(self.clock.ms())

    def diff(self, later: int, earlier: int) -> int:
        return later - earlier

    def add(self, ticks: int, ms: int) -> int:
        return ticks + ms

    def read(self, ms: int) -> bytes:
        sockets = [self.listener] if self.peer is None else [self.listener, self.peer]
        ready, _, _ = select.select(sockets, [], [], ms / 1000 / self.clock.pace)
        if self.listener in ready:
            self.drop()
            self.peer, _ = self.listener.accept()
            self.peer.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.clock.heard()
            return b""
        if self.peer is None or self.peer not in ready:
            return b""
        try:
            data = self.peer.recv(64)
        except OSError:
            data = b""
        if data:
            self.clock.heard()
        else:
            self.drop()
        return data

    def write(self, data: bytes) -> None:
        if self.peer is not None:
            try:
                self.peer.sendall(data)
            except OSError:
                self.drop()

    def drop(self) -> None:
        if self.peer is not None:
            self.peer.close()
            self.peer = None
            self.clock.left()

    def identify(self, on: bool) -> None:
        self.shows = on

    def tidy(self) -> None:
        """There is room enough."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--pace", type=float, default=1.0)
    parser.add_argument("--waits", action="store_true")
    given = parser.parse_args()
    port = SocketPort(given.port, TrafficClock() if given.waits else WallClock(given.pace))
    robot, run = started(port, given.folder)
    print(port.address, flush=True)
    run(robot)


if __name__ == "__main__":
    main()
