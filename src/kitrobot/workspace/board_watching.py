"""What is seen of a real robot: where its program stands, its values, its faults, in names as far as they are known."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from kitrobot.deploy import Fault, Hello, News, Text
from kitrobot.workspace.board_names import BoardNames, kept_names
from kitrobot.workspace.boards import NoBoardError, load_board_program

_MOST_PRINTED = 200


def names_for(hello: Hello, mission: Path | None = None, program: str | None = None) -> BoardNames | None:
    """The names of what runs on a robot: of the mission that is named, else those that were kept when it was sent.

    Raises:
        NoBoardError: the robot runs something else than that mission holds now.
        KitRobotError: the mission cannot be used.
    """
    if mission is None:
        return kept_names(hello.program)
    ready = load_board_program(mission, program=program)
    if not ready.is_called(hello.program):
        raise NoBoardError(
            f"the robot runs another program than `{ready.names.program}` of `{mission}` as it is now",
            "send it with `kitrobot deploy`, or name the mission as it was sent",
        )
    return ready.names


def place_of(instruction: int | None, names: BoardNames | None) -> str:
    """Where an instruction came from, in words; empty when there is none."""
    if instruction is None:
        return ""
    if names is None or not names.line(instruction):
        return f"instruction {instruction}"
    vertex = names.vertex(instruction)
    return f"{f'{vertex}, ' if vertex else ''}line {names.line(instruction)}: {names.text(instruction)}"


def fault_sentence(fault: Fault, names: BoardNames | None) -> str:
    """A fault in words: number, meaning, what the robot says of it, tick, place in the program."""
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


class View:
    """What is known of a robot while it is watched."""

    def __init__(self, hello: Hello, names: BoardNames | None) -> None:
        self.hello = hello
        self.names = names
        self.tick = hello.tick
        self.variables: dict[str, int] = {}
        self.inputs: dict[str, int] = {}
        self.threads: dict[int, int] = {}
        self.printed: list[str] = []

    def renew(self, hello: Hello) -> None:
        """Takes a new greeting: state and tick of a robot where nothing changes."""
        self.hello = hello
        self.tick = hello.tick

    def take(self, news: News | Fault | Text) -> None:
        """Takes what a robot told."""
        if isinstance(news, Text):
            self._print(news.text.strip("\n"))
        elif isinstance(news, Fault):
            self._print(fault_sentence(news, self.names))
        else:
            self.tick = news.tick
            variables, inputs = self._named(news.cells)
            self.variables |= variables
            self.inputs |= inputs
            for slot, instruction in news.threads.items():
                if instruction is None:
                    self.threads.pop(slot, None)
                else:
                    self.threads[slot] = instruction

    def title(self) -> str:
        """What is watched, and how it is."""
        name = self.names.program if self.names is not None else self.hello.program
        late = f", {self.hello.late} ticks late" if self.hello.late else ""
        return f"{name}: {self.hello.state_name}, tick {self.tick}{late}, {self.hello.free} bytes of memory left"

    def standing(self) -> list[str]:
        """Where each thread stands."""
        return [place_of(self.threads[slot], self.names) for slot in sorted(self.threads)]

    def values(self, values: Mapping[str, int]) -> list[str]:
        """Names with their values."""
        return [f"{name} = {value}" for name, value in values.items()]

    def told(self, news: News | Fault | Text) -> list[str]:
        """What is new, a line each."""
        if isinstance(news, Text):
            return news.text.strip("\n").split("\n")
        if isinstance(news, Fault):
            return [fault_sentence(news, self.names)]
        variables, inputs = self._named(news.cells)
        words = self.values(variables | inputs)
        if news.threads:
            words.append(" | ".join(self.standing()) or "nothing runs")
        return [f"tick {news.tick}: {', '.join(words)}"] if words else []

    def to_json(self, news: News | Fault | Text) -> dict[str, Any]:
        """What is new, as data; `active` is the whole of where threads stand."""
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
            "active": [self._place(slot, at) for slot, at in sorted(self.threads.items())],
            "ran": [self._place(None, at) for at in sorted(news.ran)],
        }

    def _place(self, slot: int | None, instruction: int) -> dict[str, Any]:
        names = self.names
        found: dict[str, Any] = {} if slot is None else {"slot": slot}
        return found | {
            "instruction": instruction,
            "vertex": names.vertex(instruction) if names is not None else None,
            "line": names.line(instruction) if names is not None else 0,
        }

    def _named(self, cells: Mapping[int, int]) -> tuple[dict[str, int], dict[str, int]]:
        if self.names is not None:
            return self.names.named(cells)
        return {f"cell {cell}": value for cell, value in cells.items() if cell}, {}

    def _print(self, text: str) -> None:
        self.printed = [*self.printed, *text.split("\n")][-_MOST_PRINTED:]
