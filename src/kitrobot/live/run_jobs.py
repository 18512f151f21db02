"""Jobs that steer a run or a recording: the effect of a request, done in a thread between two rounds of the run.

A job runs in short pieces; after each the caller checks whether it is still wanted.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kitrobot.live.watched_run import WatchedRun
from kitrobot.wire.run_requests import (
    BreakpointsRequest,
    ForceRequest,
    HarmRequest,
    ResumeRequest,
    SeekRequest,
    SetRequest,
    Steering,
    StepRequest,
    StopRequest,
)

Job = Callable[[], Iterator[None]]
"""Starts the job and yields after each piece."""


def single_step_job(work: Callable[[], object]) -> Job:
    """A job that is short."""

    def job() -> Iterator[None]:
        work()
        yield

    return job


def run_job_until(pieces: Iterator[None], until: float, clock: Callable[[], float]) -> bool:
    """Runs pieces of a job until that moment of the clock; returns whether the job is done."""
    return not any(clock() >= until for _ in pieces)


def job_for_request(request: Steering, watch: WatchedRun) -> Job | None:
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
            return single_step_job(watch.stop)
        case SeekRequest():
            return lambda: watch.seek(request.tick)
        case ForceRequest():
            return single_step_job(lambda: watch.force(request.agent, request.sensor, request.value))
        case SetRequest():
            return single_step_job(lambda: watch.set_variable(request.agent, request.variable, request.value))
        case HarmRequest():
            return single_step_job(lambda: watch.inject_fault(request.agent, request.kind))
        case BreakpointsRequest():
            return single_step_job(lambda: watch.pause_at(request.breakpoints))
    return None


def steps_back(request: Steering) -> bool:
    """Whether the run pauses for it, since it goes to another moment."""
    return isinstance(request, SeekRequest) or (isinstance(request, StepRequest) and request.back)
