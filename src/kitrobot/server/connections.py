"""Limits on what one connection may hold: the size of a request's head, and how long it may take to arrive.

The server is reached from this machine alone, but by every program and every page on it. A connection that says
nothing, or a request that never becomes whole, is closed; one whose answer is being made, and a WebSocket, may take
their time.
"""

from __future__ import annotations

import asyncio

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

LARGEST_HEAD_BYTES = 32 * 1024
"""Of a request's first line and headers."""

MOST_CONNECTIONS = 500
"""At one time; more are answered with 503."""

WHOLE_WITHIN_S = 60.0
"""A request that is not whole is given so long, and at most twice that."""


class BoundedConnection(H11Protocol):
    """An HTTP connection that is closed where no whole request comes."""

    whole_within_s = WHOLE_WITHIN_S
    _look: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        self._look_again()

    def connection_lost(self, exc: Exception | None) -> None:
        if self._look is not None:
            self._look.cancel()
        super().connection_lost(exc)

    def _look_again(self) -> None:
        self._look = self.loop.call_later(self.whole_within_s, self._close_where_nothing_came, self.cycle)

    def _close_where_nothing_came(self, before: object) -> None:
        if self not in self.connections:
            return  # it is a WebSocket now
        answering = before is not None and not self.cycle.response_complete
        if self.cycle is before and (not answering or self.conn.their_state is h11.SEND_BODY):
            self.transport.close()
        else:
            self._look_again()
