"""A run on the wire: what the page asks over the WebSocket and what it is told.

Poses are not here: they travel as binary frames (see `runs`). Everything else is JSON with a `type`.
"""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter

from kitrobot.server.realtime_clock import FASTEST
from kitrobot.server.sentences import Spoken
from kitrobot.server.shapes.board import Address, Name, TeamBoards
from kitrobot.server.shapes.mission import MOST_AGENTS, BreakpointShape, MissionShape
from kitrobot.server.shapes.problem import ProblemShape
from kitrobot.server.shapes.values import HitValue
from kitrobot.server.shapes.world import WorldShape
from kitrobot.sim import MAX_SECONDS
from kitrobot.trace import Ability

Speed = Annotated[float, Field(ge=0, le=FASTEST, allow_inf_nan=False)]
"""Times real time; 0 is as fast as it goes."""

MOST_LOOKED_AT = 200
"""Agents that a page looks at closely at a time."""
MOST_ADDRESSES = 32
"""Real robots that are watched as one run."""


Breakpoints = Annotated[list[BreakpointShape], Field(max_length=MOST_AGENTS)]


class StartRequest(BaseModel):
    """Run this mission; `path` is the file it was opened from, "" for a new one. `fail_rate` is the probability that
    an agent fails by chance within a minute, `seconds` the simulated time after which the run ends, null for never.
    """

    type: Literal["start"]
    mission: MissionShape
    path: str
    seed: Annotated[int, Field(ge=0, le=2**53)]
    speed: Speed
    fail_rate: Annotated[float, Field(ge=0, le=1, allow_inf_nan=False)] = 0.0
    seconds: Annotated[float, Field(gt=0, le=MAX_SECONDS, allow_inf_nan=False)] | None = None


class ReplayRequest(BaseModel):
    """Play a recording that was opened; `recording` is its name. From its first step on it pauses at breakpoints."""

    type: Literal["replay"]
    recording: Annotated[str, Field(max_length=20)]
    speed: Speed
    breakpoints: Breakpoints = []


class RobotsRequest(BaseModel):
    """Watch and steer real robots that this page holds; `holder` is its name among those with robots, and `mission` is
    what the programs of the robots are of. They run whatever is asked for; what is shown of them can be paused, and
    pauses at the breakpoints.
    """

    type: Literal["robots"]
    mission: MissionShape
    path: str
    holder: Name
    addresses: Annotated[list[Address], Field(min_length=1, max_length=MOST_ADDRESSES)]
    speed: Speed
    breakpoints: Breakpoints = []


class FleetRequest(BaseModel):
    """Run this mission as a team of processes, some of whose agents have a board: `holder` is the page's name among
    those with robots. It goes on in real time whatever is shown of it, and ends with this socket.
    """

    type: Literal["fleet"]
    mission: MissionShape
    path: str
    holder: Name
    boards: TeamBoards
    seed: Annotated[int, Field(ge=0, le=2**53)]
    speed: Speed
    breakpoints: Breakpoints = []


class WatchRequest(BaseModel):
    """Watch a run that another page steers; `run` is its name, `mission` what this page has open."""

    type: Literal["watch"]
    run: Annotated[str, Field(max_length=40)]
    mission: MissionShape


class PauseRequest(BaseModel):
    """Stand still."""

    type: Literal["pause"]


class ResumeRequest(BaseModel):
    """Go on; with `latest` from the latest tick, which with real robots is now."""

    type: Literal["resume"]
    latest: bool = False


class StepRequest(BaseModel):
    """Go one tick while paused, or until `agent` stands at another vertex ("" for anybody); `back` into the past."""

    type: Literal["step"]
    by: Literal["tick", "vertex"] = "tick"
    back: bool = False
    agent: str = ""


class SeekRequest(BaseModel):
    """Go to a tick that was run already, and pause there; one beyond the end goes to the end."""

    type: Literal["seek"]
    tick: Annotated[int, Field(ge=0, le=2**53)]


class ForceRequest(BaseModel):
    """Put a value in the place of what a sensor measures; null gives the sensor back."""

    type: Literal["force"]
    agent: str
    sensor: str
    value: Annotated[int, Field(ge=-(2**40), le=2**40)] | None


class SetRequest(BaseModel):
    """Set a variable of an agent."""

    type: Literal["set"]
    agent: str
    variable: str
    value: Annotated[int, Field(ge=-(2**40), le=2**40)]


class HarmRequest(BaseModel):
    """Let an agent fail for good, miss its ticks or lose its radio, or make it well again."""

    type: Literal["harm"]
    agent: str
    kind: Literal["fail", "stall", "mute", "revive", "apart"]


class LookRequest(BaseModel):
    """Of a run with very many agents: tell what these do; others are told only as poses."""

    type: Literal["look"]
    agents: Annotated[list[str], Field(max_length=MOST_LOOKED_AT)]


class BreakpointsRequest(BaseModel):
    """Pause at these from now on."""

    type: Literal["breakpoints"]
    breakpoints: Breakpoints


class StopRequest(BaseModel):
    """End the run."""

    type: Literal["stop"]


class SpeedRequest(BaseModel):
    """Run at another speed from now on."""

    type: Literal["speed"]
    value: Speed


Steering = (
    PauseRequest
    | ResumeRequest
    | StepRequest
    | SeekRequest
    | ForceRequest
    | SetRequest
    | HarmRequest
    | LookRequest
    | BreakpointsRequest
    | StopRequest
    | SpeedRequest
)
"""What can be asked of a run that is on."""

Beginning = StartRequest | ReplayRequest | RobotsRequest | FleetRequest
"""What begins a run of this page."""

RunRequest = Annotated[Beginning | WatchRequest | Steering, Field(discriminator="type")]
REQUEST: TypeAdapter[Beginning | WatchRequest | Steering] = TypeAdapter(RunRequest)


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

    `active` are vertices of its program by slot, `inner` slot, program and vertex in others that stand in it.
    """

    active: list[tuple[int, str]]
    inner: list[tuple[int, str, str]] = Field(default_factory=list)
    state: Literal["running", "waiting", "idle", "failed", "stalled"]
    values: dict[str, int]
    inputs: dict[str, int]
    shown: dict[str, list[int]]
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
    """A team as it stands: its members, and where some of them wait."""

    members: list[MemberShape]
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
REQUEST_MODELS: tuple[type[BaseModel], ...] = (
    StartRequest,
    ReplayRequest,
    RobotsRequest,
    FleetRequest,
    WatchRequest,
    PauseRequest,
    ResumeRequest,
    StepRequest,
    SeekRequest,
    ForceRequest,
    SetRequest,
    HarmRequest,
    LookRequest,
    BreakpointsRequest,
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
