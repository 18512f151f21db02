"""Local processes that make the rows of a study, and their supervisor.

Each process keeps one mission hot, sends its rows some at a time, and notes the run that it is at in memory that the
supervisor sees. When it dies (killed, out of memory), that run counts a death, and is made again after the others that
were not sent, which are given out again at once.
Ctrl-C is the supervisor's alone; the processes end with it, however it ends.
"""

from __future__ import annotations

import math
import time
from collections import Counter, deque
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import islice
from typing import Any, Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.executor import MOST_DEATHS, Work, died_row
from kitrobot.experiments.plan import Function, Plan
from kitrobot.experiments.point_runner import Pace, PointRunner, Stop
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.child_processes import end_with_parent

MOST_GIVEN: Final = 64
"""Rows that a process has before it at most."""
MOST_FALSE_STARTS: Final = 8
"""Processes that may die before they are ready while no row comes, before the study is given up."""
_SEND_S: Final = 0.01
"""Seconds of its processor that a process works for rows before it sends them; one that takes longer goes alone."""
_LOOK_S: Final = 0.2
"""How long nobody looks whether the work is to end while no row comes, in seconds."""


@dataclass
class _Worker:
    """A process, the line to it, the row that it is at, and those that it was given and has not sent, in order."""

    process: Any
    line: Any
    at: Any
    given: deque[int] = field(default_factory=deque)
    is_ready: bool = False


class LocalWorkers:
    """So many processes on this machine."""

    def __init__(self, jobs: int) -> None:
        self._jobs = jobs
        self.workers: list[_Worker] = []
        self._false_starts = 0

    def run(self, work: Work, stop: Stop) -> Iterator[bytes]:
        """The lines of the rows, as they come.

        Raises:
            ExperimentError: processes die before they begin.
        """
        # Where there are no processes, this module cannot be had either.
        import multiprocessing
        from multiprocessing.connection import wait

        # Not forked: the threads of this process would be missing in its copies.
        context = multiprocessing.get_context("spawn")
        pace = work.pace()
        waiting, again, deaths, left = iter(work.rows), deque[int](), Counter[int](), work.count
        try:
            while left and not stop():
                while len(self.workers) < min(self._jobs, left):
                    self.workers.append(_begin(context, work, pace))
                for worker in self.workers:
                    if worker.is_ready:
                        self._give(worker, waiting, again, left)
                lines: list[Any] = wait([worker.line for worker in self.workers], _LOOK_S)
                for line in lines:
                    worker = next(one for one in self.workers if one.line is line)
                    try:
                        message = line.recv_bytes()
                    except (EOFError, OSError):
                        died = self._bury(worker, again, deaths)
                        if died is not None:
                            left -= 1
                            yield died_row(work.plan, died)
                        continue
                    self._false_starts = 0
                    if not message:
                        worker.is_ready = True
                        continue
                    for row in message.splitlines(keepends=True):
                        worker.given.popleft()
                        left -= 1
                        yield row
        finally:
            self._end()

    def _give(self, worker: _Worker, waiting: Iterator[int], again: deque[int], left: int) -> None:
        """Fills up the rows before a process, the fewer the fewer there are."""
        most = max(1, min(MOST_GIVEN, math.ceil(left / (2 * self._jobs))))
        if len(worker.given) > most // 4:
            return
        rows = [again.popleft() for _ in range(min(len(again), most - len(worker.given)))]
        rows += islice(waiting, max(0, most - len(worker.given) - len(rows)))
        if rows:
            worker.given += rows
            with suppress(OSError):  # Told of its death soon.
                worker.line.send(rows)

    def _bury(self, worker: _Worker, again: deque[int], deaths: Counter[int]) -> int | None:
        """Gives out again what a dead process had; the row that is given up, if there is one."""
        self.workers.remove(worker)
        worker.process.join()
        worker.line.close()
        if not worker.is_ready:
            self._false_starts += 1
            if self._false_starts >= MOST_FALSE_STARTS:
                raise ExperimentError(
                    Sentence("the processes of the study die before they begin"),
                    Sentence("perhaps for want of memory: try fewer of them with --jobs"),
                )
        if not worker.given:
            return None
        blamed = worker.at.value if worker.at.value in worker.given else worker.given[0]
        worker.given.remove(blamed)
        deaths[blamed] += 1
        again.extendleft(reversed(worker.given))
        if deaths[blamed] >= MOST_DEATHS:
            return blamed
        # Behind the others: what kills processes from outside is then hardly at this very run each time.
        again.append(blamed)
        return None

    def _end(self) -> None:
        for worker in self.workers:
            worker.process.terminate()
        for worker in self.workers:
            worker.process.join()
            worker.line.close()
        self.workers.clear()


def _begin(context: Any, work: Work, pace: Pace) -> _Worker:
    mine, theirs = context.Pipe()
    at = context.RawValue("q", -1)
    process = context.Process(target=_work, args=(theirs, at, work.plan, dict(work.functions), pace), daemon=True)
    process.start()
    theirs.close()
    return _Worker(process, mine, at)


def _work(line: Any, at: Any, plan: Plan, functions: Mapping[str, Function], pace: Pace) -> None:
    """In a process, until its supervisor is gone. An empty message says that it is ready."""
    end_with_parent()
    try:
        runner = PointRunner(plan, functions, pace)
    except KitRobotError:
        return  # It was opened where the study was planned: this machine has changed since.
    with suppress(EOFError, OSError):
        line.send_bytes(b"")
        while True:
            rows, since = bytearray(), time.process_time()
            for row in line.recv():
                at.value = row
                rows += runner.run(row)
                if time.process_time() - since > _SEND_S:
                    line.send_bytes(rows)
                    rows, since = bytearray(), time.process_time()
            if rows:
                line.send_bytes(rows)
