"""A walk by hand through the states of a mission, on the wire: the steps that were taken, and where they lead."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field

from kitrobot.checking.verification import MOST_FAILURES
from kitrobot.verifier.model.table_builder import KINDS
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.report.state_walk import MOST_STEPS, StateWalk
from kitrobot.verifier.report.storyboard import Scene
from kitrobot.verifier.tables.events import MOST_AT_ONCE
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.sentences import Clause, Spoken
from kitrobot.wire.values import View
from kitrobot.wire.verification import KindName


class StateWalkAskShape(BaseModel):
    """Take these steps from the first state of a mission; with `goes_on`, then those to which there is no other."""

    mission: MissionShape
    path: str
    seed: Annotated[int, Field(ge=0, le=2**53)]
    timing: Timing
    failures: Annotated[int, Field(ge=0, le=MOST_FAILURES)] = 0
    kinds: Annotated[list[KindName], Field(min_length=1, max_length=len(KINDS))] = ["fail", "stall"]
    places: Annotated[list[Annotated[int, Field(ge=0, lt=MOST_AT_ONCE)]], Field(max_length=MOST_STEPS)]
    goes_on: bool = False


class PossibleStepShape(View):
    """A step out of a state: see `kitrobot.verifier.report.state_walk.PossibleStep`."""

    place: int
    sentences: list[Clause]
    is_failure: bool
    returns_to: int
    breaks: list[str]


class StateWalkShape(BaseModel):
    """The state that a walk has come to, the last step to it, and the steps that are possible there.

    `more` is how many of them are left out at the end.
    """

    places: list[int]
    happened: list[Clause]
    situation: list[Spoken]
    shared: list[Clause]
    scene: Scene
    possible: list[PossibleStepShape]
    more: int


def state_walk_shape(walk: StateWalk) -> StateWalkShape:
    """A walk as the page gets it."""
    steps = walk.list_steps()
    return StateWalkShape(
        places=walk.places,
        happened=list(walk.describe_last_step()),
        situation=list(walk.describe_situation()),
        shared=list(walk.describe_shared()),
        scene=walk.draw(),
        possible=[PossibleStepShape.model_validate(one) for one in steps],
        more=walk.count_steps() - len(steps),
    )
