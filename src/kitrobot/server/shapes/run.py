"""A run on the wire: what the page asks over the WebSocket and what it is told.

Poses are not here: they travel as binary frames (see `runs`). Everything else is JSON with a `type`.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter

from kitrobot.server.pacing import FASTEST
from kitrobot.server.sentences import Sentence
from kitrobot.server.shapes.mission import MissionShape
from kitrobot.server.shapes.problem import ProblemShape
from kitrobot.server.shapes.world import WorldShape

Speed = Annotated[float, Field(ge=0, le=FASTEST, allow_inf_nan=False)]
"""Times real time; 0 is as fast as it goes."""


class StartRequest(BaseModel):
    """Run this mission; `path` is the file it was opened from, "" for a new one."""

    type: Literal["start"]
    mission: MissionShape
    path: str
    seed: Annotated[int, Field(ge=0, le=2**53)]
    speed: Speed


class PauseRequest(BaseModel):
    """Stand still."""

    type: Literal["pause"]


class ResumeRequest(BaseModel):
    """Go on."""

    type: Literal["resume"]


class StepRequest(BaseModel):
    """Run one tick while paused."""

    type: Literal["step"]


class StopRequest(BaseModel):
    """End the run."""

    type: Literal["stop"]


class SpeedRequest(BaseModel):
    """Run at another speed from now on."""

    type: Literal["speed"]
    value: Speed


RunRequest = Annotated[
    StartRequest | PauseRequest | ResumeRequest | StepRequest | StopRequest | SpeedRequest, Field(discriminator="type")
]
REQUEST: TypeAdapter[StartRequest | PauseRequest | ResumeRequest | StepRequest | StopRequest | SpeedRequest] = (
    TypeAdapter(RunRequest)
)


class StartedAgentShape(BaseModel):
    """A robot of the run; the binary frames follow the order of this list."""

    name: str
    program: str
    robot: str
    number: int
    kind: str


class _Message(BaseModel):
    model_config = ConfigDict(json_schema_serialization_defaults_required=True)


class StartedMessage(_Message):
    """The run is on."""

    type: Literal["started"] = "started"
    run: str
    tick_ms: int
    seed: int
    world: WorldShape
    agents: list[StartedAgentShape]
    stock: dict[str, int]
    total: int


class StateMessage(_Message):
    """What became of the run; `sentence` says why it ended."""

    type: Literal["state"] = "state"
    status: Literal["running", "paused", "done", "failed", "stuck", "time", "stopped"]
    tick: int
    seconds: float
    sentence: Sentence


class AgentReportShape(BaseModel):
    """What an agent does: where its threads stand, its variables and sensors."""

    active: list[tuple[int, str]]
    state: Literal["running", "waiting", "idle", "failed"]
    values: dict[str, int]
    inputs: dict[str, int]
    fault: int


class RunEventShape(BaseModel):
    """Something worth a mark on the timeline."""

    tick: int
    kind: Literal["load", "unload", "message", "collision", "end"]
    agent: str
    text: str


class TickMessage(_Message):
    """The run as it stands; `agents` holds only those that changed since the last message."""

    type: Literal["tick"] = "tick"
    tick: int
    seconds: float
    agents: dict[str, AgentReportShape]
    stock: dict[str, int]
    delivered: dict[str, int]
    collisions: int
    events: list[RunEventShape]


class ProblemsMessage(_Message):
    """The mission has errors and was not started."""

    type: Literal["problems"] = "problems"
    problems: list[ProblemShape]


class ErrorMessage(_Message):
    """A request that could not be followed."""

    type: Literal["error"] = "error"
    message: Sentence
    help: Sentence


RunMessage = Annotated[
    StartedMessage | StateMessage | TickMessage | ProblemsMessage | ErrorMessage, Field(discriminator="type")
]
REQUEST_MODELS: tuple[type[BaseModel], ...] = (
    StartRequest,
    PauseRequest,
    ResumeRequest,
    StepRequest,
    StopRequest,
    SpeedRequest,
)
RUN_MESSAGE_MODELS: tuple[type[BaseModel], ...] = (
    StartedMessage,
    StateMessage,
    TickMessage,
    ProblemsMessage,
    ErrorMessage,
)
