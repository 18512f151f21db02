"""Grading the submissions of a class: each is evaluated in its own bounded process and becomes one row.

The parent opens the named file, which must be a regular file of at most `MOST_BYTES` and no link, and gives its bytes
to a fresh process (`grader_process`) whose answer is bounded by `MOST_ANSWER_BYTES`. Every outcome becomes a `Grade`:
one submission never keeps another from being graded.
"""

from __future__ import annotations

import json
import multiprocessing
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, Final

from kitrobot.classroom.grader_process import MOST_CPU_S, ready_exercise, serve
from kitrobot.classroom.grades import GoalGrade, Grade, translate_all
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.regular import open_regular
from kitrobot.mission.writer import write_mission
from kitrobot.text.sentences import Sentence, Word
from kitrobot.workspace.child_processes import check_jobs

MOST_BYTES: Final = 1024 * 1024
"""Bytes of a submission: some hundred times what a large exercise takes."""
LONGEST_WAIT_S: Final = 600.0
"""How long one process is waited for on the clock on the wall, where the system has no limit of processor time."""
MOST_ANSWER_BYTES: Final = 256 * 1024
MOST_SUBMISSIONS: Final = 10_000

_LOOK_S: Final = 0.2

Progress = Callable[[int, int], None]
"""PupilStatus how many submissions are graded, and how many there are."""


class GradingError(KitRobotError):
    """Grading that makes no sense, or a submission that cannot be read."""


def grade(
    submissions: Sequence[Path],
    exercise: Path | None,
    jobs: int,
    progress: Progress | None = None,
    stop: threading.Event | None = None,
) -> Iterator[Grade]:
    """Grades submissions, in the order in which they are ready; hidden goals and seeds count too.

    Args:
        submissions: their files.
        exercise: the exercise's file; None: of each that one of those that come along whose programs it has.
        jobs: in so many processes at a time.
        progress: told after each.
        stop: when set, no more are begun and those that are on are ended.

    Raises:
        GradingError, JobsError: a number makes no sense.
    """
    check_jobs(jobs)
    if len(submissions) > MOST_SUBMISSIONS:
        raise GradingError(Sentence("at most {most} submissions are graded at once", MOST_SUBMISSIONS))
    stop = stop or threading.Event()
    context = _context()
    chosen = None if exercise is None else str(exercise.resolve())
    beginnings = _StartGoals(context, stop)
    done = 0
    with ThreadPoolExecutor(min(jobs, max(1, len(submissions)))) as pool:
        left = {pool.submit(_grade_one, context, path, chosen, stop, beginnings) for path in submissions}
        try:
            while left:
                over, left = wait(left, _LOOK_S, FIRST_COMPLETED)
                for future in over:
                    made = future.result()
                    if made is None:
                        continue
                    done += 1
                    if progress is not None:
                        progress(done, len(submissions))
                    yield made
        finally:
            stop.set()


def _context() -> Any:
    """How processes begin: where the system can, as copies of one that has imported everything and read nothing."""
    if "forkserver" in multiprocessing.get_all_start_methods():
        made = multiprocessing.get_context("forkserver")
        made.set_forkserver_preload(["kitrobot.classroom.grader_process", "kitrobot.sim.step.step_loop"])
        return made
    return multiprocessing.get_context("spawn")


class _StartGoals:
    """Which goals of exercises are reached by the missions that they begin with; each is judged once."""

    def __init__(self, context: Any, stop: threading.Event) -> None:
        self._context = context
        self._stop = stop
        self._lock = threading.Lock()
        self._found: dict[str, tuple[bool, ...]] = {}

    def reached(self, exercise: str) -> tuple[bool, ...]:
        """For each goal; none where the mission cannot be judged. Whoever asks meanwhile waits."""
        with self._lock:
            found = self._found.get(exercise)
            if found is None:
                start = ready_exercise(Path(exercise)).start
                answer = _judged(self._context, write_mission(start.mission), start.name, exercise, self._stop)
                goals = answer["goals"] if isinstance(answer, dict) else []
                found = self._found[exercise] = tuple(bool(goal["reached"]) for goal in goals)
            return found


def _grade_one(
    context: Any, path: Path, exercise: str | None, stop: threading.Event, beginnings: _StartGoals
) -> Grade | None:
    """In a thread: one submission, from its file to its row; None when it was broken off."""
    name = str(path)
    try:
        answer = None if stop.is_set() else _judged(context, read_submission(path), path.name, exercise, stop)
        if isinstance(answer, Sentence):
            return Grade(name, {}, problem=translate_all(answer))
        if answer is None:
            return None
        reached = beginnings.reached(answer["file"]) if answer["file"] else ()
    except KitRobotError as error:
        return Grade(name, {}, problem=translate_all(error.message))
    return None if stop.is_set() else _row(name, answer, reached)


def _judged(
    context: Any, data: bytes, name: str, exercise: str | None, stop: threading.Event
) -> dict[str, Any] | Sentence | None:
    """What a process of its own says of a mission, or how it died; None when it was broken off."""
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=serve, args=(theirs, data, name, exercise), daemon=True)
    try:
        process.start()
        theirs.close()
        answer = _answer(ours, stop)
        if answer is None and stop.is_set():
            return None
        process.join(_LOOK_S * 5)
        return answer if answer is not None else _how_it_died(process.exitcode)
    finally:
        ours.close()
        if process.is_alive():
            process.kill()
        process.join()


def read_submission(path: Path) -> bytes:
    """The bytes of the very file that was named.

    Raises:
        GradingError: it is not there, no regular file, a link, or too large.
    """
    try:
        with open_regular(path, follow=False) as stream:
            data = stream.read(MOST_BYTES + 1)
    except FileNotFoundError:
        raise GradingError(Sentence("there is no such file")) from None
    except (OSError, ValueError) as error:
        reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
        raise GradingError(Sentence("it could not be read: {reason}", Word(reason))) from None
    if len(data) > MOST_BYTES:
        raise GradingError(Sentence("it is larger than {most} kB", MOST_BYTES // 1024))
    return data


def _answer(connection: Connection, stop: threading.Event) -> dict[str, Any] | None:
    """What the process says; None when it says nothing that can be used, or is broken off."""
    waited = 0.0
    try:
        while not connection.poll(_LOOK_S):
            waited += _LOOK_S
            if stop.is_set() or waited > LONGEST_WAIT_S:
                return None
        answer = json.loads(connection.recv_bytes(MOST_ANSWER_BYTES))
    except (EOFError, OSError, ValueError):
        return None
    return answer if isinstance(answer, dict) else None


def _how_it_died(status: int | None) -> Sentence:
    import signal

    if status is not None and status in (-getattr(signal, "SIGXCPU", 0), -getattr(signal, "SIGKILL", 0)) and status:
        return Sentence("judging it took more than {seconds} s of processor time", MOST_CPU_S)
    if status is None:
        return Sentence("judging it took too long")
    return Sentence("judging it ended without an answer, perhaps for want of memory")


def _row(name: str, answer: dict[str, Any], reached: Sequence[bool]) -> Grade:
    conditions = reached or [False] * len(answer["goals"])
    goals = tuple(
        GoalGrade(**{**goal, "condition": one}) for goal, one in zip(answer["goals"], conditions, strict=True)
    )
    return Grade(name, answer["exercise"], goals, answer["problem"])
