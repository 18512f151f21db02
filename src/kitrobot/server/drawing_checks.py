"""`WS /api/drawing-check`: what a mission that is being drawn may do for ever; asked after an edit, and only told.

Left to others: finding it (`workspace.drawing_check`). The page closes the socket at the next edit, which ends it.
"""

from __future__ import annotations

from typing import ClassVar

from kitrobot.server.background_work import BackgroundWork
from kitrobot.server.shapes.drawing_check import (
    DRAWING_CHECK_REQUEST,
    DrawingCheckMessage,
    DrawingCheckStartRequest,
    drawing_check_message,
)
from kitrobot.text import Sentence
from kitrobot.workspace import OpenMission, RunOptions
from kitrobot.workspace.drawing_check import EXPLORE_S, RUN_S, check_drawing


class _DrawingCheck(BackgroundWork):
    kind = "check while drawing"
    request: ClassVar = DRAWING_CHECK_REQUEST
    start = DrawingCheckStartRequest
    progress = DrawingCheckMessage
    busy = Sentence("this studio is at a check already")

    def work(self, request: DrawingCheckStartRequest, opened: OpenMission) -> DrawingCheckMessage:
        prepared = opened.prepare(RunOptions(request.seed, RUN_S))
        found = check_drawing(prepared, self.stop.is_set, EXPLORE_S)
        return drawing_check_message(found, prepared.simulation.tick_ms)


drawing_check_routes = _DrawingCheck.at("/api/drawing-check")
