"""What is seen of a real robot: where its program stands, its values, its faults, in names as far as they are known;
and watching one, or several into one recording.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from kitrobot.deploy import Board, Fault, Hello, LineError, News, SilentError, Text, connect
from kitrobot.diagnostics import KitRobotError
from kitrobot.workspace.board_carried import Carried, kept_carried
from kitrobot.workspace.board_names import BoardNames, kept_names
from kitrobot.workspace.board_recording import BoardRecorder
from kitrobot.workspace.board_traced import NoRecordingError, RecordedBoard
from kitrobot.workspace.boards import BoardProgram, NoBoardError, load_board_program
from kitrobot.workspace.files import same_file
from kitrobot.workspace.running import TracePlaceError

_MOST_PRINTED = 200


def names_for(
    hello: Hello, mission: Path | None = None, program: str | None = None, robot: str | None = None
) -> BoardNames | None:
    """The names of what runs on a robot: of the mission that is named, else those that were kept when it was sent.

    `robot`: what an `.lll` is for, which does not say so itself.

    Raises:
        NoBoardError: the robot runs something else than that mission holds now.
        KitRobotError: the mission cannot be used.
    """
    if mission is None:
        return kept_names(hello.program)
    return _program_of(hello, mission, program, robot).names


def _program_of(hello: Hello, mission: Path, program: str | None, robot: str | None) -> BoardProgram:
    ready = load_board_program(mission, robot=robot, program=program)
    if not ready.is_called(hello.program):
        raise NoBoardError(
            f"the robot runs another program than `{ready.names.program}` of `{mission}` as it is now",
            "send it with `kitrobot deploy`, or name the mission as it was sent",
        )
    return ready


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


LOOK_S = 0.5
"""How often it is looked how a robot stands; it is asked only while it tells nothing of that itself."""


class Watched:
    """A robot that is watched, and recorded when `recorder` is set; `news` is what it told last, if that is anything
    new.
    """

    def __init__(self, address: str, board: Board, names: BoardNames | None, carried: Carried | None) -> None:
        self.address = address
        self.board = board
        self.view = View(board.hello, names)
        self.carried = carried
        self.news: News | Fault | Text | None = None
        self.recorder: BoardRecorder | None = None
        self.number = 0
        self._faulty = False
        self._looked = time.monotonic()
        self._period_ms = 0

    def begin(self, period_ms: int) -> None:
        """Has it tell what changes, at most so often."""
        self._period_ms = period_ms
        self._stands(self.board.hello)
        self.board.watch(period_ms)

    def listen(self, timeout_s: float) -> KitRobotError | None:
        """Waits for news at most so long, and takes them; the error when its link is lost.

        Raises:
            KitRobotError: the robot said no.
        """
        try:
            self.news = self.board.news(timeout_s)
            if self.news is not None:
                self.view.take(self.news)
                if self.recorder is not None:
                    self.recorder.told(self.number, self.news)
                if isinstance(self.news, News) and self.news.is_empty:
                    self.news = None
            elif self.recorder is not None:
                self.recorder.pass_time()
            if time.monotonic() - self._looked >= LOOK_S:
                self._looked = time.monotonic()
                self._stands(self.board.look())
        except (LineError, SilentError) as error:
            if self.recorder is not None:
                self.recorder.lost(self.number, "the link is lost")
            return error
        return None

    def end(self) -> None:
        """Watches no more."""
        with suppress(KitRobotError):
            self.board.watch(0)

    def _stands(self, hello: Hello) -> None:
        was, recorder = self.view.hello, self.recorder
        self.view.renew(hello)
        began_anew = hello.state == was.state and hello.tick < was.tick
        if began_anew:
            self.board.watch(self._period_ms)  # it does not know any more that it is watched
        if recorder is None:
            return
        if began_anew:
            recorder.began_anew(self.number)
        recorder.stands(self.number, hello.state_name, hello.tick)
        if hello.fault and not self._faulty:
            fault = self.board.last_fault()
            if fault is not None:
                recorder.told(self.number, fault)
        self._faulty = bool(hello.fault)


@contextmanager
def connected(
    address: str,
    mission: Path | None = None,
    program: str | None = None,
    robot: str | None = None,
    waits: Callable[[], None] = lambda: None,
) -> Iterator[Watched]:
    """A robot to be watched, with names as `names_for` finds them. `waits` is told when it takes a while.

    Raises:
        KitRobotError: it does not answer, or runs something else than that mission holds now.
    """
    with connect(address, waits=waits) as board:
        if mission is None:
            called = board.hello.program
            yield Watched(address, board, kept_names(called), kept_carried(called))
        else:
            ready = _program_of(board.hello, mission, program, robot)
            yield Watched(address, board, ready.names, ready.carried)


def recorder_of(path: Path, watched: Sequence[Watched], mission: Path | None = None) -> BoardRecorder:
    """Records these robots into a file from now on; whoever asked closes it.

    Raises:
        NoRecordingError: of a robot it is not known which mission it runs, or they are of different ones.
        TracePlaceError: the recording would be written over the mission.
        TraceError: the file cannot be made.
    """
    if mission is not None and same_file(path, mission):
        raise TracePlaceError(f"the trace would be written over `{path}`", "give it a name of its own")
    boards = []
    for one in watched:
        if one.view.names is None or one.carried is None:
            raise NoRecordingError(
                f"a recording brings its mission along, and of what `{one.address}` runs none is known here",
                "name the mission with --mission; a program that is no mission yet, `kitrobot convert` makes one",
            )
        boards.append(RecordedBoard(one.address.rpartition("://")[2], one.view.names, one.carried))
    recorder = BoardRecorder(path, boards)
    for number, one in enumerate(watched):
        one.recorder, one.number = recorder, number
    return recorder
