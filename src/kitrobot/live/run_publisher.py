"""Publishes a run to the page that steers it and to all that watch: frames, changes, the run's state."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from pydantic import BaseModel

from kitrobot.live.broadcast import Broadcast, RunUpdate
from kitrobot.live.feed import Channel
from kitrobot.live.watched_run import WatchedRun
from kitrobot.wire.problem import problem_shapes
from kitrobot.wire.run import ErrorMessage, StateMessage


class RunPublisher:
    """Publishes the run on one channel. `broadcast`: to its watchers; None while there is no run."""

    def __init__(self, channel: Channel) -> None:
        self._channel = channel
        self.reset()

    def reset(self) -> None:
        """Prepares for another run, of which nothing has been sent yet."""
        self.broadcast: Broadcast | None = None
        self._last_status: tuple[str, int] = ("", -1)
        self._last_state: StateMessage | None = None

    def watcher_selected_agents(self) -> Collection[str]:
        """The agents that watchers have selected."""
        return self.broadcast.selected_agents if self.broadcast is not None else ()

    async def publish_update(self, watch: WatchedRun) -> None:
        """Sends what changed since the last update: one frame, one message."""
        update = RunUpdate(*watch.encode_update())
        if self.broadcast is not None:
            self.broadcast.send_update(update)
        await self._channel.send_bytes(update.frame)
        await self._channel.send_text(update.text())

    async def publish_state(self, watch: WatchedRun, status: Any) -> None:
        """Sends the state of the run, when it has changed."""
        current = (status, watch.tick if status != "running" else -1)
        if current == self._last_status:
            return
        self._last_status = current
        self._last_state = StateMessage(
            status=status,
            tick=watch.tick,
            seconds=watch.seconds,
            sentence=watch.sentence,
            hits=watch.hits if status == "paused" else [],
            problems=problem_shapes(watch.advice),
        )
        if self.broadcast is not None:
            self.broadcast.send_state(self._last_state)
        await self.send(self._last_state)

    def latest_state(self, watch: WatchedRun) -> StateMessage | None:
        """The last state that was sent, with the tick at which the run is now."""
        now = self._last_state
        return now and now.model_copy(update={"tick": watch.tick, "seconds": watch.seconds})

    async def end_for_all(self, message: str, help: str) -> None:
        """Sends everybody why the run is over."""
        self.end_for_others(message, help)
        await self.send_error(message, help, ended=True)

    def end_for_others(self, message: str, help: str) -> None:
        """Sends watchers why the run is over."""
        if self.broadcast is not None:
            self.broadcast.end(message, help)

    async def send(self, message: BaseModel) -> None:
        """Sends the page a message."""
        await self._channel.send_text(message.model_dump_json())

    async def send_error(self, message: str, help: str, ended: bool = False) -> None:
        """Sends what was refused, or why the run has ended."""
        await self.send(ErrorMessage(message=message, help=help, ended=ended))
