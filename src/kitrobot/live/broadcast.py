"""Sends a run to the pages that watch it while another page steers it.

Each update goes to all watchers and is encoded once: the frame as it is, the JSON once for each language that has
words in it. Each watcher has a feed of its own that sends the newest update; while it is still sending, later updates
are merged (the frames, all that changed, all events), so a slow page gets fewer and larger messages, misses nothing
that lasts, and never holds up the run or the others.

A page that joins gets a snapshot of the whole run, between two rounds of the run. Only the server's event loop touches
anything here. Other modules encode the updates (run_encoder) and steer the run (runs).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, Protocol

from kitrobot.live.feed import Channel, Feed
from kitrobot.live.run_encoder import MOST_EVENTS_SENT
from kitrobot.mission.model import Mission
from kitrobot.text.json_text import to_json
from kitrobot.translation.reader_language import reader_language, translate
from kitrobot.wire.run import ErrorMessage, StartedMessage, StateMessage

MOST_WATCHERS = 200
"""Pages that watch one run at a time."""


_MOST_FRAMES = 64_000
"""Bytes of frames that wait for a slow page; of more only the newest are sent."""


class RunSnapshotSource(Protocol):
    """The source of the first messages of a new watcher: a run, or a recording that is played."""

    def started(self, run: str) -> StartedMessage:
        """The first message."""

    def encode_snapshot(self) -> tuple[bytes, dict[str, Any]]:
        """The frame, and a `TickMessage` that holds everything so far."""


class RunUpdate:
    """The update of one round: a frame, and the changes in the shape of a `TickMessage` with English texts."""

    def __init__(self, frame: bytes, news: dict[str, Any]) -> None:
        self.frame = frame
        self._news = news
        self._texts: dict[str, str] = {}

    def text(self) -> str:
        """The changes as JSON in the reader's language; encoded once for all readers of it."""
        language = reader_language() if self._news["events"] else ""
        made = self._texts.get(language)
        if made is None:
            events = [{**event, "text": translate(event["text"])} for event in self._news["events"]]
            made = self._texts[language] = to_json({**self._news, "events": events}).decode()
        return made

    def after(self, before: RunUpdate | None) -> RunUpdate:
        """This update merged with `before`, for a watcher that has not been sent it."""
        if before is None:
            return self
        missed, news = before._news, self._news
        events = news["events"] if news["again"] else [*missed["events"], *news["events"]][-MOST_EVENTS_SENT:]
        agents = {**missed["agents"], **news["agents"]}
        again = news["again"] or missed["again"]
        drawing = _merge_drawings(missed.get("drawing"), news.get("drawing"))
        frames = before.frame + self.frame
        frame = frames if len(frames) <= _MOST_FRAMES else self.frame
        return RunUpdate(frame, {**news, "agents": agents, "events": events, "again": again, "drawing": drawing})


def _merge_drawings(missed: dict[str, Any] | None, news: dict[str, Any] | None) -> dict[str, Any] | None:
    """Two successive `DrawingShape`s as one."""
    if missed is None or news is None or news["keep"] <= missed["keep"]:
        return news if news is not None else missed
    stays = missed["marks"][: news["keep"] - missed["keep"]]
    return {"keep": missed["keep"], "marks": [*stays, *news["marks"]]}


class Watcher:
    """One page that watches, over a feed; `another`: its own mission is not the one that runs.

    Messages arrive in the order in which they were sent, except that an update may overtake a state that was sent
    before it: of both only the newest waits.
    """

    def __init__(self, feed: Feed, another: bool = False) -> None:
        self._feed = feed
        self._another = another
        self._update: RunUpdate | None = None
        self.selected_agents: tuple[str, ...] = ()
        """Agents that the page has selected."""

    def begin(self, started: StartedMessage) -> None:
        """Queues the first message."""
        first = started.model_copy(update={"watching": True, "abilities": [], "another": self._another})
        self._feed.put((0, "started"), lambda: [first.model_dump_json()])

    def send_update(self, update: RunUpdate) -> None:
        """Queues an update, merged with the one that still waits."""
        self._update = update.after(self._update)
        self._feed.put((1, "update"), self._take_update)

    def _take_update(self) -> list[str | bytes]:
        update, self._update = self._update, None
        return [] if update is None else [update.frame, update.text()]

    def send_state(self, state: StateMessage) -> None:
        """Queues the state of the run."""
        self._feed.put((2, "state"), lambda: [state.model_dump_json()])

    def end(self, message: ErrorMessage) -> None:
        """Queues the last message."""
        self._feed.put((3, "end"), lambda: [message.model_dump_json()])
        self._feed.finish()


class Subscription:
    """The place of one watcher in a broadcast, from when it joins until it leaves."""

    def __init__(self, broadcast: Broadcast, channel: Channel, another: bool) -> None:
        self._broadcast = broadcast
        self._feed = Feed(channel)
        self._watcher = Watcher(self._feed, another)
        broadcast.join(self._watcher)

    def select_agents(self, agents: Iterable[str]) -> None:
        """As `Broadcast.select_agents`."""
        self._broadcast.select_agents(self._watcher, agents)

    async def leave(self) -> None:
        """Watches no more."""
        self._broadcast.leave(self._watcher)
        await self._feed.close()


class Broadcast:
    """The watchers of one run. `path` is its mission's; `call` is called when a new watcher waits for its snapshot."""

    def __init__(self, path: str, mission: Mission | None, call: Callable[[], None]) -> None:
        self.path = path
        self.on = True
        """Whether the run goes on: then it is offered to pages that have its mission open."""
        self._mission = mission
        self._call = call
        self._watchers: list[Watcher] = []
        self._new: list[Watcher] = []
        self._selection_changed = False

    def __len__(self) -> int:
        return len(self._watchers) + len(self._new)

    def runs_mission(self, mission: Mission) -> bool:
        """Whether that mission is the one that runs, as far as a run depends on it."""
        return self._mission is None or _without_annotations(mission) == _without_annotations(self._mission)

    def join(self, watcher: Watcher) -> None:
        """Adds a watcher; it gets its snapshot before the run's next round."""
        self._new.append(watcher)
        self._call()

    def leave(self, watcher: Watcher) -> None:
        """Removes a watcher."""
        for group in (self._new, self._watchers):
            if watcher in group:
                group.remove(watcher)
        self._selection_changed |= bool(watcher.selected_agents)

    def select_agents(self, watcher: Watcher, agents: Iterable[str]) -> None:
        """These are a watcher's selected agents from now on."""
        watcher.selected_agents = tuple(agents)
        self._selection_changed = True

    @property
    def selected_agents(self) -> set[str]:
        """All agents that a watcher has selected."""
        return {agent for watcher in (*self._watchers, *self._new) for agent in watcher.selected_agents}

    def selection_changed(self) -> bool:
        """Whether `selected_agents` may have changed since the last call."""
        changed, self._selection_changed = self._selection_changed, False
        return changed

    def send_snapshot_to_new(self, run: str, source: RunSnapshotSource, state: StateMessage | None) -> None:
        """Sends new watchers the run as it is now; call it when the others have been sent everything."""
        if not self._new:
            return
        started, whole = source.started(run), RunUpdate(*source.encode_snapshot())
        for watcher in self._new:
            watcher.begin(started)
            watcher.send_update(whole)
            if state is not None:
                watcher.send_state(state)
        self._watchers += self._new
        self._new = []

    def send_update(self, update: RunUpdate) -> None:
        """Sends an update to every watcher."""
        for watcher in self._watchers:
            watcher.send_update(update)

    def send_state(self, state: StateMessage) -> None:
        """Sends the state of the run to every watcher."""
        for watcher in self._watchers:
            watcher.send_state(state)

    def end(self, message: str, help: str) -> None:
        """Sends watchers why there is no run any more, except those that know that it is over."""
        if not self.on and not self._new:
            return
        last = ErrorMessage(message=message, help=help, ended=True)
        for watcher in (*self._watchers, *self._new) if self.on else self._new:
            watcher.end(last)
        self.on = False


def _without_annotations(mission: Mission) -> Mission:
    """A mission without what makes no difference to its run."""
    return replace(mission, breakpoints=[], label={}, help={}, unknown=[], prolog=[], attributes={})
