"""Sends a run to the pages that watch it while another page steers it.

Everything is told to all of them at once and encoded once: the frame as it is, the JSON once for each language that has
words in it. Each watcher has a task of its own that sends what is newest; while it is still at it, what is told
meanwhile is put together (the frames, all that changed, all events), so a slow page gets fewer and larger
messages, misses nothing that lasts, and never holds up the run or the others.

Who joins is told the whole run as it stands, between two rounds of the run. Only the server's event loop touches
anything here. Left to others: what is told (run_messages), steering the run (runs).
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, Protocol

from fastapi import WebSocketDisconnect

from kitrobot.mission import Mission
from kitrobot.server.run_messages import MOST_EVENTS_TOLD
from kitrobot.server.shapes import ErrorMessage, StartedMessage, StateMessage
from kitrobot.text.json_text import to_json
from kitrobot.translation import reader_language, translate

MOST_WATCHERS = 200
"""Pages that watch one run at a time."""


_MOST_FRAMES = 64_000
"""Bytes of frames that wait for a slow page; of more only the newest are sent."""


class Line(Protocol):
    """What a watcher is told through: a WebSocket, or its twin in a test."""

    async def send_bytes(self, data: bytes) -> None:
        """Sends a frame; comes back when there is room for more."""

    async def send_text(self, data: str) -> None:
        """Sends a message; comes back when there is room for more."""


class Told(Protocol):
    """What a newcomer must be told of: a run, or a recording that is played."""

    def started(self, run: str) -> StartedMessage:
        """The first message."""

    def tell_whole(self) -> tuple[bytes, dict[str, Any]]:
        """The frame, and a `TickMessage` for somebody who knows nothing yet."""


class Telling:
    """The news of one round: a frame, and what goes with it in the shape of a `TickMessage` with English texts."""

    def __init__(self, frame: bytes, news: dict[str, Any]) -> None:
        self.frame = frame
        self._news = news
        self._texts: dict[str, str] = {}

    def text(self) -> str:
        """The news as JSON in the reader's language; made once for all who read it."""
        language = reader_language() if self._news["events"] else ""
        made = self._texts.get(language)
        if made is None:
            events = [{**event, "text": translate(event["text"])} for event in self._news["events"]]
            made = self._texts[language] = to_json({**self._news, "events": events}).decode()
        return made

    def after(self, before: Telling | None) -> Telling:
        """This one for somebody who missed `before`."""
        if before is None:
            return self
        missed, news = before._news, self._news
        events = news["events"] if news["again"] else [*missed["events"], *news["events"]][-MOST_EVENTS_TOLD:]
        agents = {**missed["agents"], **news["agents"]}
        again = news["again"] or missed["again"]
        drawing = _joined(missed.get("drawing"), news.get("drawing"))
        frames = before.frame + self.frame
        frame = frames if len(frames) <= _MOST_FRAMES else self.frame
        return Telling(frame, {**news, "agents": agents, "events": events, "again": again, "drawing": drawing})


def _joined(missed: dict[str, Any] | None, news: dict[str, Any] | None) -> dict[str, Any] | None:
    """What was drawn, for somebody who missed the first of two `DrawingShape`s."""
    if missed is None or news is None or news["keep"] <= missed["keep"]:
        return news if news is not None else missed
    stays = missed["marks"][: news["keep"] - missed["keep"]]
    return {"keep": missed["keep"], "marks": [*stays, *news["marks"]]}


class Watcher:
    """One page that watches; `another` says that its own mission is not the one that runs.

    `serve` is its task. What it is told in one order arrives in it, except that news may overtake a state that was
    told before them: of both only the newest waits.
    """

    def __init__(self, line: Line, another: bool = False) -> None:
        self._line = line
        self._another = another
        self._started: StartedMessage | None = None
        self._telling: Telling | None = None
        self._state: StateMessage | None = None
        self._last: ErrorMessage | None = None
        self._due = asyncio.Event()
        self.looks: tuple[str, ...] = ()
        """Agents that it looks at."""

    def begin(self, started: StartedMessage) -> None:
        """The first thing it is told."""
        self._started = started.model_copy(update={"watching": True, "abilities": [], "another": self._another})
        self._due.set()

    def tell(self, telling: Telling) -> None:
        """News, with what it was not yet told before."""
        self._telling = telling.after(self._telling)
        self._due.set()

    def state(self, state: StateMessage) -> None:
        """What became of the run."""
        self._state = state
        self._due.set()

    def end(self, message: ErrorMessage) -> None:
        """The last thing it is told."""
        self._last = message
        self._due.set()

    async def serve(self) -> None:
        """Sends what there is to tell, until it is cancelled, the page is gone, or the last thing is told."""
        with contextlib.suppress(WebSocketDisconnect, RuntimeError, OSError):
            while True:
                await self._due.wait()
                self._due.clear()
                started, self._started = self._started, None
                telling, self._telling = self._telling, None
                state, self._state = self._state, None
                last = self._last
                if started is not None:
                    await self._line.send_text(started.model_dump_json())
                if telling is not None:
                    await self._line.send_bytes(telling.frame)
                    await self._line.send_text(telling.text())
                if state is not None:
                    await self._line.send_text(state.model_dump_json())
                if last is not None:
                    await self._line.send_text(last.model_dump_json())
                    return


class Subscriber:
    """The place of one watcher in an broadcast: from when it joins until it leaves."""

    def __init__(self, broadcast: Broadcast, line: Line, another: bool) -> None:
        self._broadcast = broadcast
        self._watcher = Watcher(line, another)
        broadcast.join(self._watcher)
        self._task = asyncio.create_task(self._watcher.serve())

    def look(self, agents: Iterable[str]) -> None:
        """As `Broadcast.look`."""
        self._broadcast.look(self._watcher, agents)

    async def leave(self) -> None:
        """Watches no more."""
        self._broadcast.leave(self._watcher)
        self._task.cancel()
        await asyncio.gather(self._task, return_exceptions=True)


class Broadcast:
    """Who watches one run. `path` is its mission's; `call` is called when somebody waits to be welcomed."""

    def __init__(self, path: str, mission: Mission | None, call: Callable[[], None]) -> None:
        self.path = path
        self.on = True
        """Whether the run goes on: then it is offered to pages that have its mission open."""
        self._mission = mission
        self._call = call
        self._watchers: list[Watcher] = []
        self._new: list[Watcher] = []
        self._looks_anew = False

    def __len__(self) -> int:
        return len(self._watchers) + len(self._new)

    def is_of(self, mission: Mission) -> bool:
        """Whether that mission is the one that runs, as far as a run depends on it."""
        return self._mission is None or _what_runs(mission) == _what_runs(self._mission)

    def join(self, watcher: Watcher) -> None:
        """Somebody wants to watch; it is welcomed before the run's next round."""
        self._new.append(watcher)
        self._call()

    def leave(self, watcher: Watcher) -> None:
        """Somebody watches no more."""
        for group in (self._new, self._watchers):
            if watcher in group:
                group.remove(watcher)
        self._looks_anew |= bool(watcher.looks)

    def look(self, watcher: Watcher, agents: Iterable[str]) -> None:
        """A watcher looks at these agents from now on."""
        watcher.looks = tuple(agents)
        self._looks_anew = True

    @property
    def looks(self) -> set[str]:
        """All that somebody looks at."""
        return {agent for watcher in (*self._watchers, *self._new) for agent in watcher.looks}

    def looks_anew(self) -> bool:
        """Whether `looks` may be another than when this was asked last."""
        anew, self._looks_anew = self._looks_anew, False
        return anew

    def welcome(self, run: str, told: Told, state: StateMessage | None) -> None:
        """Tells the newcomers how the run stands; nothing may be untold to the others at this moment."""
        if not self._new:
            return
        started, whole = told.started(run), Telling(*told.tell_whole())
        for watcher in self._new:
            watcher.begin(started)
            watcher.tell(whole)
            if state is not None:
                watcher.state(state)
        self._watchers += self._new
        self._new = []

    def tell(self, telling: Telling) -> None:
        """News of the run, for everybody."""
        for watcher in self._watchers:
            watcher.tell(telling)

    def state(self, state: StateMessage) -> None:
        """What became of the run, for everybody."""
        for watcher in self._watchers:
            watcher.state(state)

    def end(self, message: str, help: str) -> None:
        """There is no run any more, and why; those who know that it is over need not be told."""
        if not self.on and not self._new:
            return
        last = ErrorMessage(message=message, help=help, ended=True)
        for watcher in (*self._watchers, *self._new) if self.on else self._new:
            watcher.end(last)
        self.on = False


def _what_runs(mission: Mission) -> Mission:
    """A mission without what makes no difference to its run."""
    return replace(mission, breakpoints=[], label={}, help={}, unknown=[], prolog=[], attributes={})
