"""What a request does to a run or a recording, as a job to be done between two rounds of it, in a thread."""

from __future__ import annotations

from collections.abc import Callable

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

Job = Callable[[], object]


def job_of(request: Steering, watch: WatchedRun, stop: Callable[[], bool]) -> Job | None:
    """The job of a request; None for one that changes only the pace, or who is looked at. `stop` breaks a job off."""
    match request:
        case StepRequest(by="tick", back=False):
            return None
        case StepRequest(by="tick"):
            return lambda: watch.seek(watch.tick - 1, stop)
        case StepRequest(back=True):
            return lambda: watch.step_back(request.agent, stop)
        case StepRequest():
            return lambda: watch.step(request.agent, stop)
        case ResumeRequest(latest=True):
            return watch.follow
        case StopRequest():
            return watch.stop
        case SeekRequest():
            return lambda: watch.seek(request.tick, stop)
        case ForceRequest():
            return lambda: watch.force(request.agent, request.sensor, request.value)
        case SetRequest():
            return lambda: watch.set_variable(request.agent, request.variable, request.value)
        case HarmRequest():
            return lambda: watch.harm(request.agent, request.kind)
        case BreakpointsRequest():
            return lambda: watch.pause_at(breakpoint_from_shape(one) for one in request.breakpoints)
    return None


def goes_back(request: Steering) -> bool:
    """Whether the run pauses for it, since it goes to another moment."""
    return isinstance(request, SeekRequest) or (isinstance(request, StepRequest) and request.back)
