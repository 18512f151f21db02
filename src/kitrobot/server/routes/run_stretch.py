"""`POST /api/run-stretch`: a run of a mission between two of its steps, to be played beside another one."""

from __future__ import annotations

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.mission.model import DEFAULT_RUN_S
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.text.sentences import Sentence
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.run_stretch import RunStretchAskShape, RunStretchShape, run_stretch_shape
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.previews import record_stretch, stretch_apart

run_stretch_routes = api_router()


@run_stretch_routes.post("/run-stretch")
def run_stretch(studio: ThisStudio, wanted: RunStretchAskShape) -> RunStretchShape:
    """Records a stretch of a run."""
    first, last = wanted.first, wanted.last
    if last <= first:
        raise KitRobotError(Sentence("a stretch of a run ends after step {first}, not at step {last}", first, last))
    opened = studio.open(mission_from_shape(wanted.mission), wanted.path)
    run = opened.prepare(RunOptions(wanted.seed, DEFAULT_RUN_S)).simulation
    tick_s = run.tick_ms / 1000
    apart = stretch_apart(first, last, len(run.members))
    preview, events = record_stretch(run, first, last, apart)
    return run_stretch_shape(opened, preview, events, first, apart * tick_s, tick_s, run.sentence)
