"""A real robot for a terminal: its threads, values and faults as text and data, in names as far as they are known."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from typing import Any

from kitrobot.deploy.errors import LineError, SilentError
from kitrobot.deploy.line.board import Hello, is_slow
from kitrobot.deploy.line.news import Fault, News, Text
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.robots.board_link import Link
from kitrobot.robots.names import BoardNames
from kitrobot.robots.records import active_of
from kitrobot.robots.session import InstalledProgram, RobotSession

_MOST_PRINTED = 200


def place_of(instruction: int | None, names: BoardNames | None) -> str:
    """Where an instruction came from, in words; empty when there is none."""
    if instruction is None:
        return ""
    if names is None or not names.line(instruction):
        return f"instruction {instruction}"
    vertex = names.vertex(instruction)
    return f"{f'{vertex}, ' if vertex else ''}line {names.line(instruction)}: {names.text(instruction)}"


def fault_sentence(fault: Fault, names: BoardNames | None) -> str:
    """A fault in words: number, meaning, the robot's text, tick, place in the program."""
    text = names.fault_text(fault.text) if names is not None else fault.text
    place = place_of(fault.instruction, names)
    return (
        f"fault {fault.number} in tick {fault.tick}: {fault.meaning}"
        f"{f' ({text.strip()})' if text.strip() else ''}{f', at {place}' if place else ''}"
    )


def fault_object(fault: Fault, names: BoardNames | None) -> dict[str, Any]:
    """The same as data."""
    return {
        "kind": "fault",
        "number": fault.number,
        "meaning": fault.meaning,
        "tick": fault.tick,
        "text": names.fault_text(fault.text) if names is not None else fault.text,
        "instruction": fault.instruction,
        "vertex": names.vertex(fault.instruction) if names is not None else None,
        "line": names.line(fault.instruction) if names is not None else 0,
    }


class WatchedRobot:
    """A robot that is watched; `news` is what it sent last, if that is new, `printed` the last lines of text."""

    def __init__(self, address: str, link: Link, hello: Hello, known: InstalledProgram | None) -> None:
        self.address = address
        self.session = RobotSession()
        self.hello = hello
        self.known = known
        self._link = link
        self.news: News | Fault | Text | None = None
        self.printed: list[str] = []

    @property
    def names(self) -> BoardNames | None:
        """The names of its program, where they are known."""
        return self.known.names if self.known is not None else None

    def begin(self, period_ms: int) -> None:
        """Has it send what changes, at most so often."""
        self.session.open(self._link, self.hello, self.known)
        self.session.watch(period_ms)

    def listen(self, timeout_s: float) -> KitRobotError | None:
        """Waits for news at most so long; the error when its link is lost.

        Raises:
            KitRobotError: the robot refused.
        """
        try:
            self.session.poll(timeout_s)
        except (LineError, SilentError) as error:
            self.session.lose("the link is lost")
            return error
        self.news = news = self.session.news
        if isinstance(news, News):
            self.news = None if news.is_empty else news
        elif news is not None:
            self.printed = [*self.printed, *self.describe(news)][-_MOST_PRINTED:]
        return None

    def end(self) -> None:
        """Watches no more."""
        self._link.hurry()
        with suppress(KitRobotError):
            self.session.watch(0)

    @property
    def is_slow(self) -> bool:
        """Whether most of its ticks take longer than they may."""
        return is_slow(self.session.state.doing, self.session.state.late, self.session.state.tick)

    def title(self) -> str:
        """What is watched, and how it is."""
        state, names = self.session.state, self.names
        name = names.program if names is not None else state.installed
        late = f", {state.late} ticks late" if state.late else ""
        doing = "no program" if state.doing == "none" else state.doing
        return f"{name}: {doing}, tick {state.tick}{late}, {state.free} bytes of memory left"

    def thread_places(self) -> list[str]:
        """The place of each thread."""
        return [place_of(at, self.names) for _, at in active_of(self.session.state)]

    def variables(self) -> list[str]:
        """Variables with their values; cells by their numbers where no names are known."""
        return _lines(self._named(self.session.state.cells)[0])

    def inputs(self) -> list[str]:
        """Sensors with their values."""
        return _lines(self._named(self.session.state.cells)[1])

    def describe(self, news: News | Fault | Text) -> list[str]:
        """What is new, a line each."""
        if isinstance(news, Text):
            return news.text.strip("\n").split("\n")
        if isinstance(news, Fault):
            return [fault_sentence(news, self.names)]
        variables, inputs = self._named(news.cells)
        words = _lines(variables | inputs)
        if news.threads:
            words.append(" | ".join(self.thread_places()) or "nothing runs")
        return [f"tick {news.tick}: {', '.join(words)}"] if words else []

    def to_json(self, news: News | Fault | Text) -> dict[str, Any]:
        """What is new, as data; `active` is the places of all threads."""
        if isinstance(news, Text):
            return {"kind": "text", "text": news.text}
        if isinstance(news, Fault):
            return fault_object(news, self.names)
        variables, inputs = self._named(news.cells)
        return {
            "kind": "news",
            "tick": news.tick,
            "variables": variables,
            "inputs": inputs,
            "active": [{"slot": slot} | self._place(at) for slot, at in active_of(self.session.state)],
            "ran": [self._place(at) for at in sorted(news.ran)],
        }

    def _place(self, instruction: int) -> dict[str, Any]:
        names = self.names
        return {
            "instruction": instruction,
            "vertex": names.vertex(instruction) if names is not None else None,
            "line": names.line(instruction) if names is not None else 0,
        }

    def _named(self, cells: Mapping[int, int]) -> tuple[dict[str, int], dict[str, int]]:
        if self.names is not None:
            return self.names.named(cells)
        return {f"cell {cell}": value for cell, value in cells.items() if cell}, {}


def _lines(values: Mapping[str, int]) -> list[str]:
    return [f"{name} = {value}" for name, value in values.items()]
