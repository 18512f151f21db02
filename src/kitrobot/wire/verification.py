"""A check of a mission on the wire: what the page asks over its WebSocket, and what it is told."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Literal

from pydantic import AliasChoices, BaseModel, Field, TypeAdapter

from kitrobot.checking.background_check import CheckedColumn, ExplorationProgress
from kitrobot.checking.run_explanation import RunExplanation
from kitrobot.checking.verification import MOST_FAILURES
from kitrobot.verifier.exploration.budget import CutReason
from kitrobot.verifier.model.table_builder import KINDS
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.verdicts import Answer
from kitrobot.verifier.report.avoidance import Certainty
from kitrobot.verifier.report.replay import ConfirmedRun
from kitrobot.verifier.report.storyboard import Scene
from kitrobot.wire.job import WorkMessage, WorkRefusedMessage
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.sentences import Clause, Spoken
from kitrobot.wire.values import Row, View

LONGEST_S = 3_600.0
"""Seconds that a check in a page may take."""

KindName = Literal["fail", "stall", "mute"]


class VerifyStartRequest(BaseModel):
    """Check this mission, with up to so many failures of these kinds, for so many seconds of the clock on the wall.

    Or look at many more states approximately.
    """

    type: Literal["start"]
    mission: MissionShape
    path: str
    seed: Annotated[int, Field(ge=0, le=2**53)]
    failures: Annotated[int, Field(ge=0, le=MOST_FAILURES)] = 0
    kinds: Annotated[list[KindName], Field(min_length=1, max_length=len(KINDS))] = ["fail", "stall"]
    seconds: Annotated[float, Field(gt=0, le=LONGEST_S, allow_inf_nan=False)]
    approximate: bool = False


class VerifyStopRequest(BaseModel):
    """Break the check off; what was found until then is told."""

    type: Literal["stop"]


class VerifyProgressMessage(WorkMessage):
    """How far the check is under one assumption: see `kitrobot.checking.background_check.ExplorationProgress`."""

    type: Literal["progress"] = "progress"
    timing: Timing
    failures: int
    states: int
    depth: int
    seconds: float
    memory: int


class CheckedEventShape(Row):
    """One event of a run that breaks a property, and the step it is in."""

    step: int
    text: Spoken


class ConfirmingFailureShape(BaseModel):
    """What befell an agent in a run of the simulator."""

    agent: str
    at_s: float
    kind: Literal["fail", "stall", "mute", "revive"]


class ConfirmingRunShape(BaseModel):
    """A run of the simulator that breaks a property: the run of the same mission with that seed and these failures on
    its schedule, which breaks it in step `tick`, at `seconds`.
    """

    seed: int
    tick: int
    seconds: float
    failures: list[ConfirmingFailureShape]


class KeptRunShape(ConfirmingRunShape):
    """A run of the simulator that keeps a property, the same as the one that breaks it up to step `tick`, at `seconds`:
    the agent `delayed` waits `delay_s` there, or failures are missing ("").
    """

    delayed: str
    delay_s: float
    ends_well: bool


class GuiltyShape(View):
    """A vertex at which a property is broken, whose robot, what happens there, and whether it goes on for ever."""

    agent: str
    program: str
    vertex: str
    sentence: Spoken
    repeats: bool


class OtherWayShape(View):
    """A run that keeps a property from the deciding step on: see `kitrobot.checking.run_explanation.OtherWay`."""

    events: Annotated[list[CheckedEventShape], Field(validation_alias=AliasChoices("events", "story"))]
    ends_well: bool
    scenes: tuple[Scene, ...]


class WhyShape(View):
    """Why a property broke: see `kitrobot.checking.run_explanation.RunExplanation`."""

    sentences: list[Spoken]
    certainty: Certainty
    step: int
    left_out: int
    other: OtherWayShape | None
    tick: int
    seconds: float
    kept: KeptRunShape | None


class CheckedPropertyShape(View):
    """One answer: see `kitrobot.checking.background_check.PropertyAnswer`."""

    name: str
    sentence: Clause
    answer: Answer
    steps: int
    repeats_from: int
    events: Annotated[list[CheckedEventShape], Field(validation_alias=AliasChoices("events", "story"))]
    left_out: int
    confirmed: ConfirmingRunShape | None
    searched: bool
    scenes: tuple[Scene, ...]
    guilty: list[GuiltyShape]
    places: tuple[int, ...]
    why: WhyShape | None


class VerifyColumnMessage(WorkMessage):
    """The answers under one assumption. They come once more when the simulator was searched for what is broken.

    `odds`: of an approximate check, the odds that a state which a step leads to was missed.
    """

    type: Literal["column"] = "column"
    timing: Timing
    failures: int
    states: int
    depth: int
    cut: CutReason | None
    seconds: float
    is_approximate: bool
    odds: float | None
    properties: list[CheckedPropertyShape]


class VerifyEndMessage(WorkMessage):
    """The check is over; what is taken for granted in its answers."""

    type: Literal["end"] = "end"
    limits: list[Spoken]


VerifyRequest = Annotated[VerifyStartRequest | VerifyStopRequest, Field(discriminator="type")]
VERIFY_REQUEST: TypeAdapter[VerifyStartRequest | VerifyStopRequest] = TypeAdapter(VerifyRequest)
VerifyMessage = Annotated[
    VerifyProgressMessage | VerifyColumnMessage | VerifyEndMessage | WorkRefusedMessage, Field(discriminator="type")
]
VERIFY_REQUEST_MODELS: tuple[type[BaseModel], ...] = (VerifyStartRequest, VerifyStopRequest)
VERIFY_MESSAGE_MODELS: tuple[type[BaseModel], ...] = (VerifyProgressMessage, VerifyColumnMessage, VerifyEndMessage)


def verify_message(
    told: ExplorationProgress | CheckedColumn, tick_ms: int
) -> VerifyProgressMessage | VerifyColumnMessage:
    """What a check tells, as the page gets it."""
    if isinstance(told, ExplorationProgress):
        return VerifyProgressMessage.model_validate(told, from_attributes=True)
    answers = [replace(one, confirmed=None, why=None) for one in told.properties]
    message = VerifyColumnMessage.model_validate(replace(told, properties=tuple(answers)), from_attributes=True)
    for shape, answer in zip(message.properties, told.properties, strict=True):
        shape.confirmed = None if answer.confirmed is None else confirming_run_shape(answer.confirmed, tick_ms)
        shape.why = None if answer.why is None else _why_shape(answer.why, tick_ms)
    return message


def _why_shape(why: RunExplanation, tick_ms: int) -> WhyShape:
    """Why a property broke, as the page shows it."""
    kept = why.kept
    return WhyShape(
        sentences=list(why.sentences),
        certainty=why.certainty,
        step=why.step,
        left_out=why.left_out,
        other=None if why.other is None else OtherWayShape.model_validate(why.other, from_attributes=True),
        tick=why.tick,
        seconds=max(0, why.tick) * tick_ms / 1000,
        kept=None
        if kept is None
        else KeptRunShape(
            **dict(confirming_run_shape(kept, tick_ms)),
            delayed=kept.delayed,
            delay_s=kept.delay * tick_ms / 1000,
            ends_well=kept.ends_well,
        ),
    )


def confirming_run_shape(run: ConfirmedRun, tick_ms: int) -> ConfirmingRunShape:
    """A run of the simulator that shows something, as the page plays it."""
    return ConfirmingRunShape(
        seed=run.seed,
        tick=run.tick,
        seconds=run.tick * tick_ms / 1000,
        failures=[
            ConfirmingFailureShape.model_validate(
                {"agent": harm.agent, "at_s": harm.tick * tick_ms / 1000, "kind": harm.kind}
            )
            for harm in run.faults
        ],
    )
