"""`WS /api/sweep`: the fail sweep of a mission that the page has open.

It runs over processes of its own with one core left to the rest. Left to others: what a field is (`workspace.sweep`);
playing one, which is an ordinary run.
"""

from __future__ import annotations

from typing import ClassVar

from kitrobot.server.routes.websocket_jobs import WebSocketJob
from kitrobot.text.sentences import Sentence
from kitrobot.wire.sweep import (
    SWEEP_REQUEST,
    SweepMapMessage,
    SweepProgressMessage,
    SweepStartRequest,
    sweep_map_message,
)
from kitrobot.workspace.child_processes import cores, has_processes
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.sweep import SweepError, SweepOptions, run_sweep

MOST_FIELDS = 5000
"""Fields of a sweep in a page, which draws each of them."""


class _Sweep(WebSocketJob):
    kind = "sweep"
    request: ClassVar = SWEEP_REQUEST
    start = SweepStartRequest
    progress = SweepProgressMessage
    busy = Sentence("this studio is at a sweep already")

    def work(self, request: SweepStartRequest) -> SweepMapMessage:
        opened = self.open(request)
        fields = len(opened.mission.team.agents) * request.moments
        if fields > MOST_FIELDS:
            message = Sentence("this sweep has {total} fields; the studio shows at most {most}", fields, MOST_FIELDS)
            raise SweepError(message, Sentence("choose fewer moments, or use `kitrobot run --fail-sweep`"))
        prepared = opened.prepare(RunOptions(request.seed, request.seconds, request.fail_rate))
        options = SweepOptions(request.moments, jobs=max(2, cores() - 1) if has_processes() else 1)
        return sweep_map_message(run_sweep(prepared, options, self._came_to, self.stop.is_set))

    def _came_to(self, done: int, total: int) -> None:
        """Reports each hundredth."""
        if done * 100 // total != (done - 1) * 100 // total:
            self.send_progress(SweepProgressMessage(done=done, total=total))


sweep_routes = _Sweep.routes_at("/api/sweep")
