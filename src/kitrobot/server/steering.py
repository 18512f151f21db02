"""What a request does to a run or a recording, as a job to be done between two rounds of it, in a thread.

A job is done in short pieces: whoever does it looks after each whether it is still wanted.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kitrobot.server.shapes import (
    BreakpointsRequest,
    ForceRequest,
    HarmRequest,
    ResumeRequest,
    SeekRequest,
    SetRequest,
    Steering,
    StepRequest,
    StopRequest,
    breakpoint_from_shape,
)
from kitrobot.server.watched_run import WatchedRun

Job = Callable[[], Iterator[None]]
"""Begins it, and gives its pieces."""


def in_one_piece(work: Callable[[], object]) -> Job:
    """A job that is short."""

    def job() -> Iterator[None]:
        work()
        yield

    return job


def do_until(pieces: Iterator[None], until: float, clock: Callable[[], float]) -> bool:
    """Does pieces of a job until that moment of the clock; whether it is done."""
    return not any(clock() >= until for _ in pieces)


def job_of(request: Steering, watch: WatchedRun) -> Job | None:
    """The job of a request; None for one that changes only the pace, or who is looked at."""
    match request:
        case StepRequest(by="tick", back=False):
            return None
        case StepRequest(by="tick"):
            return lambda: watch.seek(watch.tick - 1)
        case StepRequest(back=True):
            return lambda: watch.step_back(request.agent)
        case StepRequest():
            return lambda: watch.step(request.agent)
        case ResumeRequest(latest=True):
            return watch.follow
        case StopRequest():
            return in_one_piece(watch.stop)
        case SeekRequest():
            return lambda: watch.seek(request.tick)
        case ForceRequest():
            return in_one_piece(lambda: watch.force(request.agent, request.sensor, request.value))
        case SetRequest():
            return in_one_piece(lambda: watch.set_variable(request.agent, request.variable, request.value))
        case HarmRequest():
            return in_one_piece(lambda: watch.harm(request.agent, request.kind))
        case BreakpointsRequest():
            return in_one_piece(lambda: watch.pause_at(breakpoint_from_shape(one) for one in request.breakpoints))
    return None


def goes_back(request: Steering) -> bool:
    """Whether the run pauses for it, since it goes to another moment."""
    return isinstance(request, SeekRequest) or (isinstance(request, StepRequest) and request.back)
