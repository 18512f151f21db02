"""A watcher that reads slowly: it gets fewer messages, and misses nothing."""

from __future__ import annotations

import asyncio
import json
from typing import Any

import orjson

from kitrobot.live.broadcast import RunUpdate, Watcher
from kitrobot.live.feed import ChannelClosedError, Feed
from kitrobot.translation.reader_language import override_language
from kitrobot.wire.run import ErrorMessage, StateMessage
from tests import coroutines


class SlowLine:
    """A line that has no room until it is given some."""

    def __init__(self) -> None:
        self.sent: list[Any] = []
        self.room = asyncio.Event()

    async def receive(self) -> str:
        raise ChannelClosedError

    async def send_bytes(self, data: bytes) -> None:
        await self.room.wait()
        self.sent.append(data)

    async def send_text(self, data: str) -> None:
        await self.room.wait()
        self.sent.append(json.loads(data))


def news(tick: int, agents: dict[str, Any], texts: list[str], again: bool = False) -> dict[str, Any]:
    return {"type": "tick", "tick": tick, "again": again, "agents": agents, "events": [{"text": one} for one in texts]}


def told_late(told: list[Any]) -> list[Any]:
    """What a watcher is sent that had no room while it was told all that."""

    async def scene() -> list[Any]:
        line = SlowLine()
        feed = Feed(line)
        watcher = Watcher(feed)
        for one in told:
            if isinstance(one, RunUpdate):
                watcher.send_update(one)
            elif isinstance(one, StateMessage):
                watcher.send_state(one)
            else:
                watcher.end(one)
            await asyncio.sleep(0)
        line.room.set()
        await feed.wait()
        return line.sent

    return coroutines.run(scene())


LAST = ErrorMessage(message="Over.", help="", ended=True)


def test_a_slow_watcher_gets_fewer_messages_and_misses_nothing():
    told = [RunUpdate(b"0", news(0, {"a": 0, "b": 0}, ["zero"], again=True))]
    told += [RunUpdate(b"%d" % n, news(n, {"a": n}, [f"at {n}"])) for n in range(1, 100)]
    sent = told_late([*told, LAST])
    assert [one for one in sent if isinstance(one, bytes)] == [b"0", b"".join(b"%d" % n for n in range(1, 100))]
    last = sent[3]
    assert (last["tick"], last["agents"], last["again"]) == (99, {"a": 99}, False)
    assert [event["text"] for event in last["events"]] == [f"at {n}" for n in range(1, 100)]
    assert sent[-1]["message"] == "Over."


def test_of_frames_that_are_too_many_for_a_slow_watcher_only_the_newest_come():
    frames = [bytes([n]) * 30_000 for n in range(4)]
    sent = told_late([*[RunUpdate(one, news(n, {}, [])) for n, one in enumerate(frames)], LAST])
    assert [one for one in sent if isinstance(one, bytes)] == [frames[0], frames[3]]


def test_of_a_slow_watchers_states_the_newest_is_told_after_the_news():
    states = [StateMessage(status="paused", tick=n, seconds=0, sentence="") for n in range(3)]
    sent = told_late([RunUpdate(b"0", news(0, {}, [])), *states, RunUpdate(b"1", news(1, {}, [])), LAST])
    assert [one if isinstance(one, bytes) else one["type"] for one in sent] == [
        b"0",
        "tick",
        b"1",
        "tick",
        "state",
        "error",
    ]
    assert sent[-2]["tick"] == 2


def test_all_events_again_take_the_place_of_those_that_wait():
    first, second = RunUpdate(b"1", news(1, {"a": 1}, ["gone"])), RunUpdate(b"2", news(2, {}, ["again"], again=True))
    third = RunUpdate(b"3", news(3, {}, ["more"]))
    both = json.loads(third.after(second.after(first)).text())
    assert ([event["text"] for event in both["events"]], both["again"]) == (["again", "more"], True)
    assert both["agents"] == {"a": 1}


def test_news_are_encoded_once_for_all_who_read_them(monkeypatch):
    made = []
    dumps = orjson.dumps

    def counted(what: Any, **options: Any) -> bytes:
        made.append(what)
        return dumps(what, **options)

    monkeypatch.setattr(orjson, "dumps", counted)
    silent, spoken = RunUpdate(b"", news(1, {}, [])), RunUpdate(b"", news(1, {}, ["its program has ended"]))
    for language in ("en", "fr", "ur", "fr"):
        with override_language(language):
            silent.text()
    assert len(made) == 1, "without words one text is for every language"
    for language in ("en", "fr", "ur", "fr"):
        with override_language(language):
            spoken.text()
    assert len(made) == 4


def test_what_was_drawn_is_told_whole_to_who_missed_some_of_it():
    def drew(n: int, keep: int, *marks: int) -> RunUpdate:
        return RunUpdate(b"%d" % n, {**news(n, {}, []), "drawing": {"keep": keep, "marks": list(marks)}})

    def drawing(*told: RunUpdate) -> object:
        made = told[0]
        for one in told[1:]:
            made = one.after(made)
        return json.loads(made.text())["drawing"]

    quiet = RunUpdate(b"9", {**news(9, {}, []), "drawing": None})
    assert drawing(drew(1, 4, 5, 6), drew(2, 6, 7), quiet) == {"keep": 4, "marks": [5, 6, 7]}
    assert drawing(drew(1, 4, 5, 6), drew(2, 5, 8)) == {"keep": 4, "marks": [5, 8]}
    assert drawing(drew(1, 4, 5, 6), drew(2, 3, 8)) == {"keep": 3, "marks": [8]}
