"""Tasks shared out over processes of our own, each of which is prepared once; results come as tasks end."""

from __future__ import annotations

import queue
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from typing import TYPE_CHECKING, Any, Final, TypeVar

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.child_processes import end_with_parent

if TYPE_CHECKING:
    from concurrent.futures import Future

Task = TypeVar("Task")
Result = TypeVar("Result")

_LOOK_S: Final = 0.2
"""How long nobody looks whether to break off while no task ends, in seconds."""
_AHEAD: Final = 4
"""Tasks for each process that are sent before they are begun, so that none waits for the next one."""


class PoolError(KitRobotError):
    """A process died, and with it what it worked on."""


def run_tasks(
    work: Callable[[Task], Result],
    tasks: Iterable[Task],
    jobs: int,
    prepare: Callable[..., None],
    arguments: tuple[Any, ...],
    stop: Callable[[], bool],
) -> Iterator[Result]:
    """The results of tasks, as they come; ends early when `stop` says so, or when nobody wants more of them.

    Args:
        work: does a task, in a process.
        tasks: taken one by one, a few ahead; they may be endless.
        jobs: the number of processes.
        prepare: called once in each process, with the arguments and an event, at which `work` is to leave off.
        arguments: sent to each process.
        stop: asked now and then.

    Raises:
        PoolError: a process died.
    """
    # Where there are no processes, these modules cannot be had either.
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    # Not forked: the threads of this process would be missing in its copies.
    context = multiprocessing.get_context("spawn")
    leave_off = context.Event()
    pool = ProcessPoolExecutor(jobs, context, _begin, (prepare, arguments, leave_off))
    over: queue.SimpleQueue[Future[Result]] = queue.SimpleQueue()
    waiting = iter(tasks)
    try:
        left = 0
        while not stop():
            for task in islice(waiting, _AHEAD * jobs - left):
                pool.submit(work, task).add_done_callback(over.put)
                left += 1
            if not left:
                return
            try:
                ended = over.get(timeout=_LOOK_S)
            except queue.Empty:
                continue
            left -= 1
            yield ended.result()
    except BrokenProcessPool as error:
        raise PoolError(
            Sentence("a process that runs missions died"),
            Sentence("perhaps for want of memory: try fewer of them with --jobs"),
        ) from error
    finally:
        leave_off.set()
        pool.shutdown(wait=True, cancel_futures=True)


def _begin(prepare: Callable[..., None], arguments: tuple[Any, ...], leave_off: Any) -> None:
    """In a process, once. Ctrl-C is the parent's, which says so to all; it ends when the parent is gone."""
    end_with_parent()
    prepare(*arguments, leave_off)
