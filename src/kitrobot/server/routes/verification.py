"""`WS /api/verify`: a check of the mission that the page has open, in a process of its own.

Left to others: what is checked (`checking.verification`); playing a run that breaks one, which is a run like any.
"""

from __future__ import annotations

from typing import ClassVar

from kitrobot.checking.background_check import verify_apart
from kitrobot.checking.verification import VerificationOptions
from kitrobot.mission.model import DEFAULT_RUN_S
from kitrobot.server.routes.websocket_jobs import WebSocketJob
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.table_builder import KINDS
from kitrobot.wire.verification import (
    VERIFY_REQUEST,
    VerifyEndMessage,
    VerifyProgressMessage,
    VerifyStartRequest,
    verify_message,
)
from kitrobot.workspace.mission_run import RunOptions


class _Verification(WebSocketJob):
    kind = "check"
    request: ClassVar = VERIFY_REQUEST
    start = VerifyStartRequest
    progress = VerifyProgressMessage
    busy = Sentence("this studio is at a check already")

    def work(self, request: VerifyStartRequest) -> VerifyEndMessage:
        prepared = self.open(request).prepare(RunOptions(request.seed, DEFAULT_RUN_S))
        tick_ms = prepared.simulation.tick_ms
        kinds = tuple(kind for kind in KINDS if kind.value in request.kinds)
        options = VerificationOptions(
            failures=request.failures,
            kinds=kinds,
            seconds=request.seconds,
            stop=self.stop.is_set,
            approximate=request.approximate,
        )
        ended = verify_apart(prepared, options, lambda progress: self.send_progress(verify_message(progress, tick_ms)))
        return VerifyEndMessage(limits=[] if ended is None else list(ended.limits))


verify_routes = _Verification.routes_at("/api/verify")
