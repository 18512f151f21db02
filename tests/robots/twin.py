"""A robot in memory, as a session talks with it, and a clock that is moved by hand."""

from __future__ import annotations

from collections import deque
from dataclasses import replace

from kitrobot.deploy.errors import LineError
from kitrobot.deploy.line.board import Hello
from kitrobot.deploy.line.news import Fault, News, Text
from kitrobot.robots.state import ACTIVITIES, Activity
from kitrobot.text.sentences import Sentence


class Clock:
    now = 100.0

    def __call__(self) -> float:
        return self.now


class Twin:
    """Says what it is told to say; `asked` is what was asked of it. One that is `broken` is on no line any more."""

    def __init__(self, doing: Activity = "running", tick: int = 0, program: str = "12345678") -> None:
        self.hello = Hello(1, ACTIVITIES.index(doing), 0, 2000, tick, 0, 1, "c0ffee00", program)
        self.fault: Fault | None = None
        self.waiting: deque[News | Fault | Text] = deque()
        self.asked: list[object] = []
        self.broken = False

    def stands(self, doing: Activity, tick: int = 0) -> None:
        self.hello = replace(self.hello, state=ACTIVITIES.index(doing), tick=tick)

    def greet(self) -> Hello:
        return self.hello

    def look(self) -> Hello:
        self._on_the_line()
        return self.hello

    def start(self, held: bool = False) -> None:
        self._do(("start", held))
        self.stands("running")

    def stop(self) -> None:
        self._do("stop")
        self.stands("ready", self.hello.tick)

    def force(self, cell: int, value: int | None) -> None:
        self._do(("force", cell, value))

    def set(self, cell: int, value: int) -> None:
        self._do(("set", cell, value))

    def watch(self, period_ms: int) -> None:
        self._do(("watch", period_ms))

    def identify(self) -> None:
        self._do("identify")

    def last_fault(self) -> Fault | None:
        self._do("last fault")
        return self.fault

    def news(self, timeout: float) -> News | Fault | Text | None:
        self._on_the_line()
        return self.waiting.popleft() if self.waiting else None

    def hurry(self) -> None:
        """It answers at once anyway."""

    def close(self) -> None:
        self.asked.append("close")

    def _do(self, what: object) -> None:
        self._on_the_line()
        self.asked.append(what)

    def _on_the_line(self) -> None:
        if self.broken:
            raise LineError(Sentence("the line broke"))
