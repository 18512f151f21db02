"""What the page that steers a run is told of it, and with it all who watch: frames, news, what became of it."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from fastapi import WebSocket
from pydantic import BaseModel

from kitrobot.server.broadcast import Broadcast, Telling
from kitrobot.server.shapes import ErrorMessage, StateMessage, problem_shapes
from kitrobot.server.watched_run import WatchedRun


class RunTelling:
    """The telling of the run on one socket. `broadcast`: to those who watch it; None while there is no run."""

    def __init__(self, socket: WebSocket) -> None:
        self._socket = socket
        self.begin_anew()

    def begin_anew(self) -> None:
        """Another run comes; nothing was told of it yet."""
        self.broadcast: Broadcast | None = None
        self._said: tuple[str, int] = ("", -1)
        self._state_now: StateMessage | None = None

    def looks_of_others(self) -> Collection[str]:
        """The agents at which those look who watch."""
        return self.broadcast.looks if self.broadcast is not None else ()

    async def news(self, watch: WatchedRun) -> None:
        """What changed since the last time: one frame, one message."""
        telling = Telling(*watch.tell())
        if self.broadcast is not None:
            self.broadcast.tell(telling)
        await self._socket.send_bytes(telling.frame)
        await self._socket.send_text(telling.text())

    async def state(self, watch: WatchedRun, status: Any) -> None:
        """Says what became of the run, when that is new."""
        said = (status, watch.tick if status != "running" else -1)
        if said == self._said:
            return
        self._said = said
        self._state_now = StateMessage(
            status=status,
            tick=watch.tick,
            seconds=watch.seconds,
            sentence=watch.sentence,
            hits=watch.hits if status == "paused" else [],
            problems=problem_shapes(watch.advice),
        )
        if self.broadcast is not None:
            self.broadcast.state(self._state_now)
        await self.tell(self._state_now)

    def state_at(self, watch: WatchedRun) -> StateMessage | None:
        """What was said last of the run, at the tick where it is now."""
        now = self._state_now
        return now and now.model_copy(update={"tick": watch.tick, "seconds": watch.seconds})

    async def break_off(self, message: str, help: str) -> None:
        """Says to everybody why the run is over."""
        self.end_for_others(message, help)
        await self.fail(message, help, ended=True)

    def end_for_others(self, message: str, help: str) -> None:
        """Says why the run is over to those who watch."""
        if self.broadcast is not None:
            self.broadcast.end(message, help)

    async def tell(self, message: BaseModel) -> None:
        """Sends the page a message."""
        await self._socket.send_text(message.model_dump_json())

    async def fail(self, message: str, help: str, ended: bool = False) -> None:
        """Says what was refused, or that the run has ended so."""
        await self.tell(ErrorMessage(message=message, help=help, ended=ended))
