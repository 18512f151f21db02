"""The rows of a study made on a Dask cluster (`kitrobot[cluster]`): its scheduler hands them to workers anywhere.

Each worker says first which version of KitRobot it has. Workers get the plan with each batch, keep the mission of the
last plan hot, and give the rows of a batch back; nothing else is kept on the cluster, so a worker that is killed,
retired or paused costs its batch, which Dask runs again. A batch that takes workers along is made again row by row, so
that only the run that does it is given up.
"""

from __future__ import annotations

import asyncio
import logging
import math
import threading
import time
from collections import Counter, deque
from collections.abc import Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from itertools import islice
from pkgutil import resolve_name
from typing import Any, Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.executor import MOST_DEATHS, Work, died_row
from kitrobot.experiments.plan import PLAN_FILE, Plan, read_plan
from kitrobot.experiments.point_runner import Pace, PointRunner, Stop
from kitrobot.experiments.study_folder import expect_same_version, other_version
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.child_processes import cores

LOCAL: Final = "local"
MOST_IN_A_BATCH: Final = 50
BATCHES_A_THREAD: Final = 3
"""Batches that wait on the cluster for each of its threads."""
_CONNECT_S: Final = 20
_LOOK_S: Final = 0.5


class DaskCluster:
    """A Dask cluster by the address of its scheduler (`tcp://HOST:8786`), or `local`: processes of this machine.

    Args:
        address: the scheduler's address, or `local`.
        jobs: of a local one, how many processes.
    """

    def __init__(self, address: str, jobs: int | None = None) -> None:
        self._address = address
        self._jobs = jobs or cores()

    def run(self, work: Work, stop: Stop) -> Iterator[bytes]:
        """The lines of the rows, as they come.

        Raises:
            ExperimentError: Dask is not installed, the scheduler is not there or goes away, or its workers cannot make
                a run (as without KitRobot, or with another version of it).
        """
        distributed = _distributed()
        with _quiet_logs():
            yield from self._run(distributed, work, stop)

    def _run(self, distributed: Any, work: Work, stop: Stop) -> Iterator[bytes]:
        cluster = self._local(distributed) if self._address == LOCAL else None
        try:
            client = self._client(distributed, self._address if cluster is None else cluster)
            try:
                yield from _Batches(distributed, client, work).run(stop)
            finally:
                with suppress(Exception):  # A scheduler that has gone away needs no farewell.
                    client.close(timeout=2)
        finally:
            if cluster is not None:
                cluster.close()

    def _local(self, distributed: Any) -> Any:
        return distributed.LocalCluster(
            n_workers=self._jobs, threads_per_worker=1, dashboard_address=None, silence_logs=50
        )

    def _client(self, distributed: Any, where: Any) -> Any:
        try:
            return distributed.Client(where, timeout=_CONNECT_S, set_as_default=False)
        except (OSError, ValueError, TimeoutError) as error:
            raise ExperimentError(
                Sentence("there is no Dask scheduler at `{address}`", self._address),
                Sentence("start one with `dask scheduler`, and name the address that it prints"),
            ) from error


@contextmanager
def _quiet_logs() -> Iterator[None]:
    """Keeps Dask's own log of what goes away off the screen: a sentence says it."""
    loggers = [logging.getLogger(name) for name in ("distributed", "distributed.client")]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)


class _Batches:
    """The batches of some work on a cluster."""

    def __init__(self, distributed: Any, client: Any, work: Work) -> None:
        self._distributed, self._client, self._work = distributed, client, work
        self._plan = work.plan.to_toml()
        self._pace = work.pace()
        self._under_way: dict[Any, list[int]] = {}
        self._again: deque[list[int]] = deque()
        self._deaths: Counter[int] = Counter()
        self._asked: set[str] = set()
        self._questions: list[Any] = []
        self._is_ready = False

    def run(self, stop: Stop) -> Iterator[bytes]:
        waiting, left = iter(self._work.rows), self._work.count
        while left and not stop():
            try:
                self._ask_workers()
                if self._is_ready:
                    self._fill(waiting, left)
                lines = [line for future in self._ended() for line in self._lines(future)]
            except (OSError, RuntimeError, CancelledError, asyncio.CancelledError) as error:
                raise _gone() from error
            left -= len(lines)
            yield from lines

    def _ask_workers(self) -> None:
        """Asks each new worker for its version, by a function of Python's: one of ours it could perhaps not even read,
        and would then say nothing. Nothing else is sent before one has answered.
        """
        for address in self._client.nthreads():
            if address not in self._asked:
                self._asked.add(address)
                self._questions.append(
                    self._client.submit(resolve_name, "kitrobot:__version__", workers=[address], pure=False)
                )
        for question in [one for one in self._questions if one.done()]:
            self._questions.remove(question)
            if question.status == "finished":
                if question.result() != self._work.plan.version:
                    raise _unfit(str(other_version(self._work.plan, question.result())))
                self._is_ready = True
            elif question.status == "error":
                error = question.exception()
                if not isinstance(error, self._distributed.KilledWorker):
                    raise _unfit(f"{type(error).__name__}: {error}") from error

    def _fill(self, waiting: Iterator[int], left: int) -> None:
        threads = max(1, sum(self._client.nthreads().values()))
        size = max(1, min(MOST_IN_A_BATCH, math.ceil(left / (4 * threads))))
        while len(self._under_way) < BATCHES_A_THREAD * threads:
            rows = self._again.popleft() if self._again else list(islice(waiting, size))
            if not rows:
                return
            # Each attempt is a task of its own: nothing that is given up is taken for another.
            arguments = (self._plan, rows, dict(self._work.functions), self._pace.name)
            self._under_way[self._client.submit(make_rows, *arguments, pure=False)] = rows

    def _ended(self) -> list[Any]:
        """The batches that are over; waits a moment for the first."""
        if self._client.status not in ("running", "connecting"):
            raise _gone()
        awaited = [*self._under_way, *self._questions]
        if not awaited:
            time.sleep(_LOOK_S)  # No worker is there.
        try:
            with self._client.as_current():
                self._distributed.wait(awaited, timeout=_LOOK_S, return_when="FIRST_COMPLETED")
        except TimeoutError:
            return []
        return [future for future in self._under_way if future.done()]

    def _lines(self, future: Any) -> list[bytes]:
        rows = self._under_way.pop(future)
        if future.status in ("cancelled", "lost"):
            raise _gone()
        error = future.exception() if future.status == "error" else None
        if error is None:
            lines: list[bytes] = future.result()
            return lines
        if not isinstance(error, self._distributed.KilledWorker):
            raise _unfit(f"{type(error).__name__}: {error}") from error
        if len(rows) > 1:
            self._again += [[row] for row in rows]
            return []
        self._deaths[rows[0]] += 1
        if self._deaths[rows[0]] >= MOST_DEATHS:
            return [died_row(self._work.plan, rows[0])]
        self._again.append(rows)
        return []


def _unfit(reason: str) -> ExperimentError:
    return ExperimentError(
        Sentence("a worker of the cluster cannot make a run: {reason}", reason),
        Sentence("install the same version of KitRobot on all workers"),
    )


def _gone() -> ExperimentError:
    return ExperimentError(
        Sentence("the Dask scheduler has gone away"),
        Sentence("every run that ended is kept; go on with --resume when it is back"),
    )


_hot: list[tuple[str, PointRunner]] = []
"""Of a worker: the plan that it had last, and what runs it."""
_hot_lock = threading.Lock()
"""A worker may have several threads."""


def make_rows(plan: str, rows: list[int], functions: dict[str, Any], pace: str) -> list[bytes]:
    """On a worker: the lines of some rows."""
    with _hot_lock:
        if not _hot or _hot[0][0] != plan:
            made: Plan = read_plan(plan, PLAN_FILE)
            try:
                expect_same_version(made)
            except KitRobotError as error:
                raise RuntimeError(str(error.message)) from None
            _hot[:] = [(plan, PointRunner(made, functions, Pace[pace]))]
        return [_hot[0][1].run(row) for row in rows]


def _distributed() -> Any:
    try:
        import distributed
    except ImportError as error:
        raise ExperimentError(
            Sentence("a cluster needs Dask, which is not installed"),
            Sentence("install it: {command}", '`pip install "kitrobot[cluster]"`'),
        ) from error
    return distributed
