"""Real robots as a recording: what they tell, written down as it is heard, in the one format of traces.

A recording of real robots has a record for each tick of the clock of who records, which begins when the recording does:
so several robots share one timeline, and what a robot was silent about still takes its time. The robot's own count of
ticks stands beside its numbers. Robots tell only what changed, a few times a second, so a record holds what was heard
last. Nobody knows where a robot stands in the world, so it has no numbers for that; that is how a real robot is told
from a simulated one.

A recording never disturbs the watching: when it cannot be written any more it ends, and `error` says why. Left to
others: the link (deploy), names (board_names), what is carried along (board_carried), the file (trace).
"""

from __future__ import annotations

import shutil
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from kitrobot.deploy import Fault, News, Text
from kitrobot.trace import (
    LINK,
    PERSON,
    PROGRAM,
    ROBOT,
    Threads,
    TickRecord,
    TraceCommand,
    TraceError,
    TraceEvent,
    TraceWriter,
)
from kitrobot.workspace.board_traced import BEFORE, RecordedBoard, fault_said, header_of

SETTLE_S = 5.0
"""How much of a recording is lost at most when the program is killed."""
MOST_FILLED = 30_000
"""Ticks without news that are written one by one; of a longer silence only the last ones."""
LONGEST_TEXT = 500
IDLE, RUNNING, FAILED, SILENT = 0, 2, 3, 4
"""What a robot does, by the numbers of simulated ones."""
_CAUSES = {3: PROGRAM, 4: PROGRAM, 6: LINK}
"""What brings a fault about: a program that is too large or damaged, a link that was lost; else the robot itself."""


class BoardRecorder:
    """Records robots, each known by its place in `boards`, until it is closed. Safe to use from many threads.

    Raises:
        NoRecordingError: they run programs of several missions.
        TraceError: the file cannot be made.
    """

    def __init__(
        self, path: Path, boards: Sequence[RecordedBoard], clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.path = path
        self.error: TraceError | None = None
        self._boards = tuple(boards)
        self._clock = clock
        self._lock = threading.RLock()
        header = header_of(boards)
        self._tick_ms = header.tick_ms
        self._starts: list[int] = []
        self._numbers: list[int] = []
        for one in boards:
            self._starts.append(len(self._numbers))
            self._numbers += [0] * len(BEFORE) + list(one.carried.first)
        self._numbers.append(0)
        self._active: list[Threads] = [()] * len(boards)
        self._commands: list[TraceCommand] = []
        self._events: list[TraceEvent] = []
        self._sentences: dict[int, str] = {}
        self._faults: dict[int, Fault] = {}
        self._ended: set[int] = set()
        self._tick = 1
        self._done = False
        self._writer = TraceWriter(path, header)
        try:
            self._writer.record(TickRecord(0, self._numbers, self._active))
            self._writer.settle()
        except BaseException:
            self._writer.close()
            raise
        self._began = self._settled = clock()

    # -- what robots tell

    def stands(self, board: int, doing: str, tick: int) -> None:
        """How it stands, in the words of `Hello.state_name`: "ready", "running", "ended" or "fault"."""
        with self._lock:
            if not self._moves():
                return
            at = self._starts[board]
            self._numbers[at + 2] = tick
            self._numbers[at] = now = {"running": RUNNING, "fault": FAILED}.get(doing, IDLE)
            if now == RUNNING:
                self._sentences.pop(board, None)
                self._faults.pop(board, None)
                self._ended.discard(board)
            elif now == IDLE:
                self._active[board] = ()
            if doing == "ended" and board not in self._ended:
                self._ended.add(board)
                self._happens(board, "end", "its program has ended", PROGRAM)

    def told(self, board: int, news: News | Fault | Text) -> None:
        """What it said unasked."""
        with self._lock:
            if not self._moves():
                return
            if isinstance(news, Text):
                self._happens(board, "message", news.text.strip(), PROGRAM)
            elif isinstance(news, Fault):
                self._fails(board, news)
            else:
                self._hears(board, news)

    def lost(self, board: int, message: str) -> None:
        """Nothing is heard of it any more; `message` says so, and what becomes of the robot."""
        with self._lock:
            if self._moves():
                self._numbers[self._starts[board]] = SILENT
                self._active[board] = ()
                self._sentences[board] = message
                self._happens(board, "failure", message, LINK)

    # -- what people do

    def found(self, board: int) -> None:
        """It is heard again."""
        self._by_hand(board, "revival", "the link is back", LINK)
        self._sentences.pop(board, None)

    def started(self, board: int) -> None:
        """Somebody began its program."""
        self.stands(board, "running", 0)
        self._by_hand(board, "outside", "its program was started from here", PERSON)

    def stopped(self, board: int) -> None:
        """Somebody stopped it."""
        self.stands(board, "ready", 0)
        self._by_hand(board, "outside", "it was stopped from here", PERSON)

    def began_anew(self, board: int) -> None:
        """Its count of ticks began anew, and nobody asked for that."""
        self._by_hand(board, "message", "it began anew by itself", ROBOT)

    def forced(self, board: int, sensor: str, value: int | None) -> None:
        """Somebody put a value in the place of what a sensor measures; None: gave the sensor back."""
        with self._lock:
            bit = 1 << list(self._boards[board].names.sensors).index(sensor)
            at = self._starts[board] + 1
            if not self._moves():
                return
            if value is None:
                self._numbers[at] &= ~bit
                self._happens(board, "outside", f"the sensor {sensor} measures again", PERSON)
            else:
                self._numbers[at] |= bit
                self._set_cell(board, self._boards[board].names.sensors[sensor], value)
                self._happens(board, "outside", f"the sensor {sensor} is held at {value}", PERSON)

    def variable_set(self, board: int, variable: str, value: int) -> None:
        """Somebody set a variable."""
        with self._lock:
            if self._moves():
                cell = self._boards[board].names.variables[variable]
                self._set_cell(board, cell, value)
                self._happens(board, "outside", f"the variable {variable} was set to {value}", PERSON)

    # -- the file

    def pass_time(self) -> None:
        """Nothing was heard; brings the records up to now."""
        with self._lock:
            self._moves()

    def save(self, path: Path) -> None:
        """Writes what was recorded so far into another file, whole; the recording goes on.

        Raises:
            TraceError: it cannot be written there, or nothing could be recorded.
        """
        with self._lock:
            if not self._done:
                self._attempt(self._settle)
            try:
                shutil.copyfile(self.path, path)
                if not self._done and self.error is None:
                    TraceWriter.end(path, self.outcome())
            except OSError as error:
                raise TraceError(f"the recording cannot be saved: {error.strerror}") from error

    def close(self) -> None:
        """Ends the recording; again does nothing."""
        with self._lock:
            if self._done:
                return
            self._attempt(self._settle)
            self._done = True
            self._writer.finish(self.outcome())
            self._attempt(self._writer.close)

    def outcome(self) -> dict[str, Any]:
        """How it ended so far, as a trace says it last."""
        outcome, sentence = "stopped", ""
        if self._sentences:
            board, sentence = next(iter(self._sentences.items()))
            outcome = "failed"
            if len(self._boards) > 1:
                sentence = f"{self._boards[board].name}: {sentence}"
        elif len(self._ended) == len(self._boards):
            outcome, sentence = "done", "the program of each robot has ended"
        return {"outcome": outcome, "sentence": sentence, "ticks": self._tick - 1, "delivered": 0, "collisions": 0}

    # -- how it is written down

    def _moves(self) -> bool:
        """Brings the records up to now; False when nothing is recorded any more."""
        if self._done or self.error is not None:
            return False
        self._attempt(self._up_to_now)
        return self.error is None

    def _attempt(self, write: Callable[[], None]) -> None:
        try:
            write()
        except TraceError as error:
            self.error = self.error or error

    def _up_to_now(self) -> None:
        """What comes next belongs to the record of now; those before are written."""
        now = self._clock()
        tick = int((now - self._began) * 1000 / self._tick_ms)
        if tick <= self._tick:
            return
        self._write_record()
        for silent in range(max(self._tick, tick - MOST_FILLED), tick):
            self._writer.record(TickRecord(silent, self._numbers, self._active))
        self._tick = tick
        if now - self._settled >= SETTLE_S:
            self._settled = now
            self._writer.settle()

    def _settle(self) -> None:
        self._up_to_now()
        self._write_record()
        self._writer.settle()

    def _write_record(self) -> None:
        self._writer.record(TickRecord(self._tick, self._numbers, self._active, self._commands, self._events))
        self._commands, self._events = [], []
        self._tick += 1

    def _happens(self, board: int, kind: str, text: str, cause: str) -> None:
        self._events.append(TraceEvent(self._tick, kind, board, text[:LONGEST_TEXT], cause))

    def _by_hand(self, board: int, kind: str, text: str, cause: str) -> None:
        with self._lock:
            if self._moves():
                self._happens(board, kind, text, cause)

    def _set_cell(self, board: int, cell: int, value: int) -> None:
        if 0 <= cell < len(self._boards[board].carried.cells):
            self._numbers[self._starts[board] + len(BEFORE) + cell] = value

    def _hears(self, board: int, news: News) -> None:
        self._numbers[self._starts[board] + 2] = news.tick
        for cell, value in news.cells.items():
            self._set_cell(board, cell, value)
        threads = {**dict(self._active[board]), **news.threads}
        self._active[board] = tuple((slot, at) for slot, at in sorted(threads.items()) if at is not None)
        calls = self._boards[board].carried.calls
        for instruction in sorted(news.ran):
            if instruction in calls:
                self._commands.append(TraceCommand(board, *calls[instruction]))

    def _fails(self, board: int, fault: Fault) -> None:
        if not fault.number or self._faults.get(board) == fault:
            return
        self._faults[board] = fault
        at, names = self._starts[board], self._boards[board].names
        self._numbers[at], self._numbers[at + 2] = FAILED, fault.tick
        # Where it failed glows as long as it is so.
        self._active[board] = ((0, fault.instruction),) if fault.instruction is not None else ()
        sentence = fault_said(fault, names)
        self._sentences[board] = sentence
        self._happens(board, "failure", sentence, _CAUSES.get(fault.number, ROBOT))
