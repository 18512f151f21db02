"""The request of a walk by hand through the states of a mission: the page keeps the steps, and each answer is whole."""

from __future__ import annotations

from kitrobot.checking.mission_walk import begin_walk
from kitrobot.mission.model import DEFAULT_RUN_S
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.verifier.model.table_builder import KINDS
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.state_walk import StateWalkAskShape, StateWalkShape, state_walk_shape
from kitrobot.workspace.mission_run import RunOptions

state_walk_routes = api_router()


@state_walk_routes.post("/walk")
def walk_states(studio: ThisStudio, wanted: StateWalkAskShape) -> StateWalkShape:
    """Takes steps through the states of a mission from its first one on."""
    prepared = studio.open(mission_from_shape(wanted.mission), wanted.path).prepare(
        RunOptions(wanted.seed, DEFAULT_RUN_S)
    )
    kinds = tuple(kind for kind in KINDS if kind.value in wanted.kinds)
    walk = begin_walk(prepared, wanted.timing, wanted.failures, kinds)
    for place in wanted.places:
        walk.take_step(place)
    if wanted.goes_on:
        walk.go_on()
    return state_walk_shape(walk)
