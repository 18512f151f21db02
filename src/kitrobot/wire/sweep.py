"""A fail sweep on the wire: what the page asks over its WebSocket, and what it is told."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field, TypeAdapter

from kitrobot.wire.job import WorkMessage, WorkRefusedMessage
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.sentences import Spoken
from kitrobot.workspace.sweep import Sweep

MOST_MOMENTS = 200
"""Moments of a sweep that a page asks for."""
LONGEST_S = 36_000.0
"""Simulated seconds that each of its runs may take."""

Outcome = Literal["done", "failed", "stuck", "time"]


class SweepStartRequest(BaseModel):
    """Run this mission once for each agent and moment at which that one fails. Everything else is as in a run's start:
    the chosen field is the run of the same mission, seed and limit with that failure on its schedule.
    """

    type: Literal["start"]
    mission: MissionShape
    path: str
    seed: Annotated[int, Field(ge=0, le=2**53)]
    fail_rate: Annotated[float, Field(ge=0, le=1, allow_inf_nan=False)] = 0.0
    moments: Annotated[int, Field(ge=1, le=MOST_MOMENTS)]
    seconds: Annotated[float, Field(gt=0, le=LONGEST_S, allow_inf_nan=False)]


class SweepStopRequest(BaseModel):
    """Break the sweep off; what was found until then is told."""

    type: Literal["stop"]


class SweepProgressMessage(WorkMessage):
    """How many fields are over, of how many."""

    type: Literal["progress"] = "progress"
    done: int
    total: int


class SweepFieldShape(BaseModel):
    """One run: who failed, by the place in `agents`, and when, by that in `moments`; how it ended, when and why."""

    agent: int
    moment: int
    outcome: Outcome
    seconds: float
    sentence: Spoken


class SweepMapMessage(WorkMessage):
    """What came of a sweep: `moments` in simulated seconds, `fields` as far as they are over, `outcome` and `sentence`
    of the run without these failures.
    """

    type: Literal["map"] = "map"
    agents: list[str]
    moments: list[float]
    outcome: Outcome
    sentence: Spoken
    total: int
    fields: list[SweepFieldShape]


SweepRequest = Annotated[SweepStartRequest | SweepStopRequest, Field(discriminator="type")]
SWEEP_REQUEST: TypeAdapter[SweepStartRequest | SweepStopRequest] = TypeAdapter(SweepRequest)
SweepMessage = Annotated[SweepProgressMessage | SweepMapMessage | WorkRefusedMessage, Field(discriminator="type")]
SWEEP_REQUEST_MODELS: tuple[type[BaseModel], ...] = (SweepStartRequest, SweepStopRequest)
SWEEP_MESSAGE_MODELS: tuple[type[BaseModel], ...] = (SweepProgressMessage, SweepMapMessage, WorkRefusedMessage)


def sweep_map_message(sweep: Sweep) -> SweepMapMessage:
    """A sweep of single failures as the page gets it."""
    places = {tick: place for place, tick in enumerate(sweep.moments)}
    return SweepMapMessage(
        agents=list(sweep.agents),
        moments=[sweep.seconds(tick) for tick in sweep.moments],
        outcome=sweep.baseline.outcome,
        sentence=sweep.baseline.sentence,
        total=sweep.total,
        fields=[
            SweepFieldShape(
                agent=field.faults[0].agent,
                moment=places[field.faults[0].tick],
                outcome=field.outcome,
                seconds=sweep.seconds(field.ticks),
                sentence=field.sentence,
            )
            for field in sweep.fields
        ],
    )
