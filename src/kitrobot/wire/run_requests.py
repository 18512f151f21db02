"""A run on the wire: what the page asks over the WebSocket, as JSON with a `type`. What it is told is in `run`."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field, TypeAdapter

from kitrobot.mission.trial import Breakpoint
from kitrobot.sim.setup.limits import MAX_SECONDS
from kitrobot.wire.board import Address, Name, TeamBoards
from kitrobot.wire.mission import Many, MissionShape

FASTEST = 100.0
"""Times real time."""

Speed = Annotated[float, Field(ge=0, le=FASTEST, allow_inf_nan=False)]
"""Times real time; 0 is as fast as it goes."""

MOST_LOOKED_AT = 200
"""Agents that a page looks at closely at a time."""
MOST_ADDRESSES = 32
"""Real robots that are watched as one run."""


Breakpoints = Many[Breakpoint]


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
