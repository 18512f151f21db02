"""A run on the wire: what the page is told over the WebSocket. What it asks is in `run_requests`.

Poses are not here: they travel as binary frames (see `runs`). Everything else is JSON with a `type`.
"""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field

from kitrobot.trace.source import Ability
from kitrobot.wire.problem import ProblemShape
from kitrobot.wire.sentences import Spoken
from kitrobot.wire.values import HitValue
from kitrobot.wire.world import WorldShape


class StartedAgentShape(BaseModel):
    """A robot of the run; the binary frames follow the order of this list. `placed`: whether it is known where it is;
    that of a real robot is not, and its pose in the frames means nothing.
    """

    name: str
    program: str
    robot: str
    number: int
    kind: str
    placed: bool


class _Message(BaseModel):
    model_config = ConfigDict(json_schema_serialization_defaults_required=True)


class StartedMessage(_Message):
    """The run is on, or a recording of one. `abilities`: what can be done to it here. `fleet`: its agents are
    processes, which go on whatever is shown of them. `watching`: another page steers it; `another`: what runs there is
    not the mission that this page has open.
    """

    type: Literal["started"] = "started"
    run: str
    tick_ms: int
    seed: int
    world: WorldShape
    agents: list[StartedAgentShape]
    stock: dict[str, int]
    total: int
    abilities: list[Ability]
    recording: bool = False
    fail_rate: float = 0.0
    fleet: bool = False
    watching: bool = False
    another: bool = False
    pens: list[int] = []
    """Of each pen the place of its robot in `agents`."""


class StateMessage(_Message):
    """What became of the run; `sentence` says why it ended, `hits` why it pauses. "end" is that of a recording only.
    `problems` are hints on a run that ended before anything could be seen.
    """

    type: Literal["state"] = "state"
    status: Literal["running", "paused", "done", "failed", "stuck", "time", "stopped", "end"]
    tick: int
    seconds: float
    sentence: Spoken
    hits: list[HitValue] = []
    problems: list[ProblemShape] = []


class AgentReportShape(BaseModel):
    """What an agent does: where its threads stand, its variables and sensors, what its displays and the like show.

    `active` are vertices of its program by slot, `inner` slot, program and vertex in others that stand in it. `used`:
    the parts that have shown something in this run, also between two messages.
    """

    active: list[tuple[int, str]]
    inner: list[tuple[int, str, str]] = Field(default_factory=list)
    state: Literal["running", "waiting", "idle", "failed", "stalled"]
    values: dict[str, int]
    inputs: dict[str, int]
    shown: dict[str, list[int]]
    used: list[str] = Field(default_factory=list)
    fault: int
    forced: list[str]


class MemberShape(BaseModel):
    """A robot of a team: its role ("" while it is spare), groups, in whose place it stands, whether it is missed."""

    name: str
    role: str
    groups: list[str]
    stands_for: str
    missed: bool


class MeetingShape(BaseModel):
    """A place of a team's program at which robots wait for others: who is there, who is missing, how many of how many.
    `vertex` is "" where there is none.
    """

    point: int
    program: str
    vertex: str
    here: list[str]
    missing: list[str]
    here_count: int
    count: int


class TeamNowShape(BaseModel):
    """A team as it stands: its members, the names of its groups, also of those left empty, and where some wait.

    A role that robots move from or to is a group of its name.
    """

    members: list[MemberShape]
    groups: list[str]
    meetings: list[MeetingShape]


EventKind = Literal["load", "unload", "message", "collision", "failure", "revival", "member", "end", "outside"]
EVENT_KINDS: tuple[str, ...] = get_args(EventKind)
"""outside: what somebody did to the run; member: who is in which role or group has changed."""
EventCause = Literal["program", "world", "person", "mission", "chance", "robot", "link"]
EVENT_CAUSES: tuple[str, ...] = get_args(EventCause)
"""What brings an event about: mission is its schedule, person a hand during the run; of a real
robot, robot is that itself and link the way to it."""


class RunEventShape(BaseModel):
    """Something worth a mark on the timeline."""

    tick: int
    kind: EventKind
    agent: str
    text: str
    cause: EventCause


MarkShape = tuple[int, Literal[1, 2, 4], int, int, int, int]
"""Pen, what becomes of the point (1 the line goes on there, 2 begins, 4 ends), x and y in tenths of a mm, colour (0…7),
width in mm."""


class DrawingShape(BaseModel):
    """What pens drew: of the marks that were told before, the first `keep` stay, and `marks` come after them.

    A line that has not ended goes on to where its robot is.
    """

    keep: int
    marks: list[MarkShape]


class TickMessage(_Message):
    """The run as it stands; `agents` holds only those that changed since the last message, and
    of very many only those that are looked at.

    `latest` is the furthest tick of this future: less than before when another one has begun. `events` are those since
    the last message, or with `again` all up to `latest`. `team` is null where it stands as before, or there is none,
    and so is `drawing`.
    """

    type: Literal["tick"] = "tick"
    tick: int
    latest: int
    again: bool
    seconds: float
    agents: dict[str, AgentReportShape]
    stock: dict[str, int]
    delivered: dict[str, int]
    collisions: int
    events: list[RunEventShape]
    team: TeamNowShape | None
    drawing: DrawingShape | None = None


class ProblemsMessage(_Message):
    """The mission has errors and was not started."""

    type: Literal["problems"] = "problems"
    problems: list[ProblemShape]


class ErrorMessage(_Message):
    """A request that could not be followed; `ended` when there is no run any more because of it."""

    type: Literal["error"] = "error"
    message: Spoken
    help: Spoken
    ended: bool


RunMessage = Annotated[
    StartedMessage | StateMessage | TickMessage | ProblemsMessage | ErrorMessage, Field(discriminator="type")
]
RUN_MESSAGE_MODELS: tuple[type[BaseModel], ...] = (
    StartedMessage,
    StateMessage,
    TickMessage,
    ProblemsMessage,
    ErrorMessage,
)
