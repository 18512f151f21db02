"""Limits on what one connection may hold: the size of a request's head, and how long it may take to arrive.

A studio is reached from this machine alone, but by every program and every page on it; a class by a whole network. A
silent connection, or a request that never becomes whole, is closed; one whose answer is being made, and a WebSocket,
may take their time. When there are many connections, silent ones are closed for new ones: first those of the address
that has most of them.
"""

from __future__ import annotations

import asyncio
from collections import Counter

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol, RequestResponseCycle

LARGEST_HEAD_BYTES = 32 * 1024
"""Of a request's first line and headers."""

MOST_CONNECTIONS = 500
"""At one time; more are answered with 503."""

MOST_BEFORE_ROOM_IS_MADE = 450
"""With more, a silent one is closed for each new one."""

WHOLE_WITHIN_S = 60.0
"""The time limit for a request to become whole; at most twice that passes."""


class BoundedConnection(H11Protocol):
    """An HTTP connection that is closed where no whole request comes."""

    whole_within_s = WHOLE_WITHIN_S
    last_received_s = 0.0
    """The time of the last data."""
    _timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        if len(self.connections) > MOST_BEFORE_ROOM_IS_MADE:
            self._close_oldest_silent()
        self._schedule_check()

    def connection_lost(self, exc: Exception | None) -> None:
        if self._timer is not None:
            self._timer.cancel()
        super().connection_lost(exc)

    def _close_oldest_silent(self) -> None:
        others = [one for one in self.connections if isinstance(one, BoundedConnection) and one is not self]
        silent = [one for one in others if not one.transport.is_closing() and not one.is_answering]
        if silent:
            many = Counter(one.client[0] if one.client else "" for one in silent)
            most = max(many.values())
            old = (one for one in silent if many[one.client[0] if one.client else ""] == most)
            min(old, key=lambda one: one.last_received_s).transport.close()

    def data_received(self, data: bytes) -> None:
        self.last_received_s = self.loop.time()
        super().data_received(data)

    @property
    def is_answering(self) -> bool:
        """Whether a request came whole, and its answer is being made."""
        # uvicorn's types claim that there always is one; there is none before the first request.
        cycle: RequestResponseCycle | None = self.cycle
        whole = self.conn.their_state is not h11.SEND_BODY
        return cycle is not None and not cycle.response_complete and whole

    def _schedule_check(self) -> None:
        self._timer = self.loop.call_later(self.whole_within_s, self._close_if_idle, self.cycle)

    def _close_if_idle(self, before: object) -> None:
        if self not in self.connections:
            return  # it is a WebSocket now
        if self.cycle is before and not self.is_answering:
            self.transport.close()
        else:
            self._schedule_check()
