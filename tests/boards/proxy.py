"""A wire that is cut or disturbed: a TCP proxy on loopback between a host and a board's serial line.

A message is what the host writes at once: each of ours waits for its answer, so none runs into the next.
"""

from __future__ import annotations

import contextlib
import random
import socket
import threading
from collections.abc import Callable
from types import TracebackType

from tests.patience import PATIENCE_S

Disturb = Callable[[bytes], bytes]


class Proxy:
    """Passes on what comes, until message number `cut_after`, which it still passes on.

    `happens`: is told of each message of the host, by its number. `disturb`: what becomes of each piece, in both
    directions.
    """

    def __init__(
        self,
        port: int,
        *,
        cut_after: int | None = None,
        happens: Callable[[int], None] = lambda messages: None,
        disturb: Disturb = lambda data: data,
    ) -> None:
        self.target = ("127.0.0.1", port)
        self.cut_after = cut_after
        self.happens = happens
        self.disturb = disturb
        self.messages = 0
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.address = f"socket://127.0.0.1:{self.listener.getsockname()[1]}"
        self._open: list[socket.socket] = []
        self._threads: list[threading.Thread] = []

    def __enter__(self) -> Proxy:
        self._begin(self._serve)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.listener.close()
        self.cut()
        for thread in self._threads:
            thread.join(PATIENCE_S)

    def cut(self) -> None:
        """Hangs up on both."""
        for one in self._open:
            with contextlib.suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)
            one.close()

    def _begin(self, work: Callable[..., None], *given: object) -> None:
        thread = threading.Thread(target=work, args=given, daemon=True)
        self._threads.append(thread)
        thread.start()

    def _serve(self) -> None:
        try:
            self.listener.settimeout(PATIENCE_S)
            host, _ = self.listener.accept()
            board = socket.create_connection(self.target, timeout=PATIENCE_S)
        except OSError:
            return
        for one in (host, board):
            one.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._open += [host, board]
        self._begin(self._pass, board, host, False)
        self._pass(host, board, True)

    def _pass(self, source: socket.socket, target: socket.socket, counted: bool) -> None:
        try:
            while data := source.recv(4096):
                target.sendall(self.disturb(data))
                if counted:
                    self.messages += 1
                    self.happens(self.messages)
                    if self.messages == self.cut_after:
                        break
        except OSError:
            pass
        self.cut()


def noise(seed: int, share: float) -> Disturb:
    """Loses, changes and adds single bytes: each with a third of that probability a byte."""
    chance = random.Random(seed)
    lock = threading.Lock()

    def disturb(data: bytes) -> bytes:
        made = bytearray()
        with lock:
            for byte in data:
                fate = chance.random()
                if fate < share / 3:
                    continue
                if fate < 2 * share / 3:
                    made.append(chance.randrange(256))
                elif fate < share:
                    made += bytes((byte, chance.randrange(256)))
                else:
                    made.append(byte)
        return bytes(made)

    return disturb
