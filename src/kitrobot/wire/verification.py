"""A check of a mission on the wire: what the page asks over its WebSocket, and what it is told."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field, TypeAdapter

from kitrobot.checking.background_check import CheckedColumn, ExplorationProgress, PropertyAnswer
from kitrobot.checking.verification import MOST_FAILURES
from kitrobot.verifier.model.table_builder import KINDS
from kitrobot.verifier.report.replay import ConfirmedRun
from kitrobot.wire.job import WorkMessage, WorkRefusedMessage
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.sentences import Clause, Spoken

LONGEST_S = 3_600.0
"""Seconds that a check in a page may take."""

TimingName = Literal["lockstep", "prompt", "free"]
KindName = Literal["fail", "stall", "mute"]
CutName = Literal["states", "memory", "time", "stopped", "size"]


class VerifyStartRequest(BaseModel):
    """Check this mission, with up to so many failures of these kinds, for so many seconds of the clock on the wall."""

    type: Literal["start"]
    mission: MissionShape
    path: str
    seed: Annotated[int, Field(ge=0, le=2**53)]
    failures: Annotated[int, Field(ge=0, le=MOST_FAILURES)] = 0
    kinds: Annotated[list[KindName], Field(min_length=1, max_length=len(KINDS))] = ["fail", "stall"]
    seconds: Annotated[float, Field(gt=0, le=LONGEST_S, allow_inf_nan=False)]


class VerifyStopRequest(BaseModel):
    """Break the check off; what was found until then is told."""

    type: Literal["stop"]


class VerifyProgressMessage(WorkMessage):
    """How far the check is under one assumption: see `kitrobot.checking.background_check.Explored`."""

    type: Literal["progress"] = "progress"
    timing: TimingName
    failures: int
    states: int
    depth: int
    seconds: float
    memory: int


class CheckedEventShape(BaseModel):
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


class StandShape(BaseModel):
    """A robot in a scene; `at` are the vertices at which its program stands, each with the name of its program."""

    x_mm: float
    y_mm: float
    heading_rad: float
    at: list[tuple[str, str]]


class SceneShape(BaseModel):
    """What a run of the model looks like before a step; the robots are in the order of the mission's agents."""

    step: int
    robots: list[StandShape]


class GuiltyShape(BaseModel):
    """A vertex at which a property is broken, whose robot, what happens there, and whether it goes on for ever."""

    agent: str
    program: str
    vertex: str
    sentence: Spoken
    repeats: bool


class CheckedPropertyShape(BaseModel):
    """One answer: see `kitrobot.checking.background_check.Answered`."""

    name: str
    sentence: Clause
    answer: Literal["holds", "broken", "not finished", "vacuous"]
    steps: int
    repeats_from: int
    events: list[CheckedEventShape]
    left_out: int
    confirmed: ConfirmingRunShape | None
    searched: bool
    scenes: list[SceneShape]
    guilty: list[GuiltyShape]


class VerifyColumnMessage(WorkMessage):
    """The answers under one assumption. They come once more when the simulator was searched for what is broken."""

    type: Literal["column"] = "column"
    timing: TimingName
    failures: int
    states: int
    depth: int
    cut: CutName | None
    seconds: float
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
        return VerifyProgressMessage(
            timing=told.timing.value,
            failures=told.failures,
            states=told.states,
            depth=told.depth,
            seconds=told.seconds,
            memory=told.memory,
        )
    return VerifyColumnMessage(
        timing=told.timing.value,
        failures=told.failures,
        states=told.states,
        depth=told.depth,
        cut=None if told.cut is None else told.cut.value,
        seconds=told.seconds,
        properties=[_answer(one, tick_ms) for one in told.properties],
    )


def _answer(one: PropertyAnswer, tick_ms: int) -> CheckedPropertyShape:
    run = one.confirmed
    return CheckedPropertyShape(
        name=one.name,
        sentence=one.sentence,
        answer=one.answer.value,
        steps=one.steps,
        repeats_from=one.repeats_from,
        events=[CheckedEventShape(step=step, text=text) for step, text in one.story],
        left_out=one.left_out,
        searched=one.searched,
        scenes=[
            SceneShape(
                step=scene.step,
                robots=[
                    StandShape(
                        x_mm=round(robot.x_mm, 1),
                        y_mm=round(robot.y_mm, 1),
                        heading_rad=round(robot.heading_rad, 3),
                        at=list(robot.at),
                    )
                    for robot in scene.robots
                ],
            )
            for scene in one.scenes
        ],
        guilty=[
            GuiltyShape(
                agent=found.agent,
                program=found.vertex[0],
                vertex=found.vertex[1],
                sentence=found.sentence,
                repeats=found.repeats,
            )
            for found in one.guilty
        ],
        confirmed=None if run is None else confirming_run_shape(run, tick_ms),
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
