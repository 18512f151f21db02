"""`WS /api/drawing-check`: endless behaviour of a mission that is being drawn; checked after an edit.

Left to others: finding it (`checking.drawing_check`). The page closes the socket at the next edit, which ends it.
"""

from __future__ import annotations

from typing import ClassVar

from kitrobot.checking.drawing_check import EXPLORE_S, RUN_S, check_drawing
from kitrobot.server.routes.websocket_jobs import WebSocketJob
from kitrobot.text.sentences import Sentence
from kitrobot.wire.drawing_check import (
    DRAWING_CHECK_REQUEST,
    DrawingCheckMessage,
    DrawingCheckStartRequest,
    drawing_check_message,
)
from kitrobot.workspace.mission_run import RunOptions


class _DrawingCheck(WebSocketJob):
    kind = "check while drawing"
    request: ClassVar = DRAWING_CHECK_REQUEST
    start = DrawingCheckStartRequest
    progress = DrawingCheckMessage
    busy = Sentence("this studio is at a check already")

    def work(self, request: DrawingCheckStartRequest) -> DrawingCheckMessage:
        prepared = self.open(request).prepare(RunOptions(request.seed, RUN_S))
        found = check_drawing(prepared, self.stop.is_set, EXPLORE_S)
        return drawing_check_message(found, prepared.simulation.tick_ms)


drawing_check_routes = _DrawingCheck.routes_at("/api/drawing-check")
