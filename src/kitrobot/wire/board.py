"""Real robots on the wire: what the page asks over `WS /api/boards`, and what it is told.

A robot is told of as a whole each time something about it changed: it is small, and a page that was slow then misses
nothing that lasts.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter

from kitrobot.wire.bench import BenchLeftOutShape, BenchStepShape, BoardBenchShape
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.problem import ProblemShape
from kitrobot.wire.sentences import Spoken

Address = Annotated[str, Field(min_length=1, max_length=200)]
"""A serial port, or a URL for the network: `socket://host:port`."""
Name = Annotated[str, Field(max_length=200)]


MOST_TEAM_BOARDS = 64
BoardWay = Literal["", "replace", "fresh"]
"""With what a sending that was refused can be asked for again."""


class TeamBoardShape(BaseModel):
    """The board of an agent; `way`: what else may be done when its program is sent."""

    agent: Name
    address: Address
    way: BoardWay = ""


TeamBoards = Annotated[list[TeamBoardShape], Field(max_length=MOST_TEAM_BOARDS)]


class BoardsLookRequest(BaseModel):
    """Tell which ports there are, and what is plugged in or out, from now on; or no more."""

    type: Literal["look"]
    on: bool


class BoardConnectRequest(BaseModel):
    """Greet the robot at that address. `mission` and `program` are what this page has open: when the robot has that
    program, what it does is told by its names.
    """

    type: Literal["connect"]
    address: Address
    mission: MissionShape
    path: str
    program: Name
    kit: Name = ""
    """What the robot is built of; "" as its own file says."""


class BoardSendRequest(BaseModel):
    """Put that program on the robot, then let it run: held by this page, free, or not at all."""

    type: Literal["send"]
    address: Address
    mission: MissionShape
    path: str
    program: Name
    kit: Name = ""
    """What the robot is built of; "" as its own file says."""

    then: Literal["held", "free", "ready"]
    replace: bool = False
    """Whether a program of somebody else on it may be overwritten."""

    fresh: bool = False
    """Whether to remove first what KitRobot put there; when there is no room for the new beside the old."""


class BoardBenchRequest(BaseModel):
    """Put the program that tries parts on the robot: those of the robot that the program is for. The answer is a
    message with the steps; what becomes of them is told with the robot.
    """

    type: Literal["bench"]
    address: Address
    mission: MissionShape
    path: str
    program: Name
    kit: Name = ""
    """What the robot is built of; "" as its own file says."""

    replace: bool = False
    """Whether a program of somebody else on it may be overwritten."""


class BoardTryRequest(BaseModel):
    """Do that step (its place among the steps) until the next request; None: end it."""

    type: Literal["try"]
    address: Address
    step: Annotated[int, Field(ge=0, lt=1000, strict=True)] | None


class BoardCancelRequest(BaseModel):
    """Break off the sending; the robot keeps the program that it had."""

    type: Literal["cancel"]
    address: Address


class BoardStartRequest(BaseModel):
    """Begin the program that is on the robot: held (it stops when this page goes away), or free."""

    type: Literal["start"]
    address: Address
    held: bool


class BoardStopRequest(BaseModel):
    """Stop the robot, or with "" every robot that the studio knows. Any page may."""

    type: Literal["stop"]
    address: Annotated[str, Field(max_length=200)]


class BoardIdentifyRequest(BaseModel):
    """Let the robot show which one it is."""

    type: Literal["identify"]
    address: Address


class BoardForgetRequest(BaseModel):
    """Let go of the robot; one that is held stops."""

    type: Literal["forget"]
    address: Address


class TeamSendRequest(BaseModel):
    """Put the programs of a team's agents onto their boards, which then wait for the team to be started. When one of
    them cannot be made, nothing is sent.
    """

    type: Literal["team-send"]
    mission: MissionShape
    path: str
    boards: TeamBoards


class TeamCancelRequest(BaseModel):
    """Break off the sending to a team."""

    type: Literal["team-cancel"]


BOARD_REQUEST_MODELS: tuple[type[BaseModel], ...] = (
    BoardsLookRequest,
    BoardConnectRequest,
    BoardSendRequest,
    BoardBenchRequest,
    BoardTryRequest,
    BoardCancelRequest,
    BoardStartRequest,
    BoardStopRequest,
    BoardIdentifyRequest,
    BoardForgetRequest,
    TeamSendRequest,
    TeamCancelRequest,
)
BoardRequest = Annotated[
    BoardsLookRequest
    | BoardConnectRequest
    | BoardSendRequest
    | BoardBenchRequest
    | BoardTryRequest
    | BoardCancelRequest
    | BoardStartRequest
    | BoardStopRequest
    | BoardIdentifyRequest
    | BoardForgetRequest
    | TeamSendRequest
    | TeamCancelRequest,
    Field(discriminator="type"),
]
BOARD_REQUEST: TypeAdapter[BoardRequest] = TypeAdapter(BoardRequest)


class _Message(BaseModel):
    model_config = ConfigDict(json_schema_serialization_defaults_required=True)


class BoardsWelcomeMessage(_Message):
    """The first message: by what name this page holds robots, and by which key ports that it opens itself."""

    type: Literal["welcome"] = "welcome"
    you: str
    key: str


class BoardPortShape(BaseModel):
    """A port of this machine where a robot may be; `firmware`: the page with its MicroPython, "" for none."""

    address: str
    name: str
    description: str
    firmware: str


class BoardPortsMessage(_Message):
    """All ports there are now."""

    type: Literal["ports"] = "ports"
    ports: list[BoardPortShape]


class BoardFaultShape(BaseModel):
    """Why the robot stopped by itself; `vertex` and `line` (of the LLL, from 1) are "" and 0 where nobody knows."""

    number: int
    sentence: Spoken
    text: str
    program: str
    vertex: str
    line: int
    tick: int


BoardStep = Literal["connect", "reset", "compare", "send", "start"]


class BoardProgressShape(BaseModel):
    """How far the sending is: `done` of `total` bytes."""

    step: BoardStep
    done: int
    total: int


class BoardStepsMessage(_Message):
    """What can be tried of the robot at that address."""

    type: Literal["steps"] = "steps"
    address: str
    steps: list[BenchStepShape]
    left_out: list[BenchLeftOutShape]


BoardPhase = Literal["closed", "connecting", "open", "sending", "lost"]
"""closed: nobody talks with it; open: it answers; lost: it did, and does so no more."""
BoardState = Literal["none", "ready", "running", "ended", "fault"]


class BoardMessage(_Message):
    """A robot as it stands. `package` and `installed` name what is on it; `program` is the name of that in the
    mission, "" when it is not what the page sent or has open. What its program does is told as a run (`RobotsRequest`).
    """

    type: Literal["board"] = "board"
    address: str
    name: str
    holder: str
    """The page that talks with it."""
    phase: BoardPhase
    state: BoardState
    held: bool
    free: int
    generation: int
    package: str
    installed: str
    program: str
    progress: BoardProgressShape | None
    fault: BoardFaultShape | None
    message: Spoken
    """What went wrong last, "" when nothing did."""
    help: Spoken
    way: BoardWay
    micropython: str
    """The version of MicroPython on its board, "" where it is not known."""
    recorded: bool
    """Whether there is a recording of its last run, or of the one that is on."""
    bench: BoardBenchShape | None
    """Its parts are tried."""


class BoardGoneMessage(_Message):
    """Nobody talks with that robot any more."""

    type: Literal["gone"] = "gone"
    address: str


TeamAgentState = Literal["idle", "sending", "sent", "starting", "there", "ended"]
"""sent: its board has its program; starting: its process is; there: it takes part; ended: it does no more."""


class TeamAgentShape(BaseModel):
    """An agent of the team that programs were sent to, or that was started, last; `address` of its board, "" for none.
    `message` is what it said last, or (`failed`) what went wrong.
    """

    name: str
    address: str
    state: TeamAgentState
    progress: BoardProgressShape | None
    message: Spoken
    help: Spoken
    way: BoardWay
    failed: bool


class TeamMessage(_Message):
    """The team of this studio as it stands; there is one at a time. `path` is the file of its mission.

    `stopped_ms`: within how many ms all agents said that they stand still, after the emergency stop; null before.
    """

    type: Literal["team"] = "team"
    phase: Literal["idle", "sending", "starting", "running", "stopping"]
    path: str
    agents: list[TeamAgentShape]
    message: Spoken
    help: Spoken
    failed: bool
    stopped_ms: int | None


class BoardRefusedMessage(_Message):
    """A request that was not followed; `problems` are those of the program that was to be sent. Of a team's requests
    `address` is `team`.
    """

    type: Literal["refused"] = "refused"
    address: str
    message: Spoken
    help: Spoken
    problems: list[ProblemShape]


BOARD_MESSAGE_MODELS: tuple[type[BaseModel], ...] = (
    BoardsWelcomeMessage,
    BoardPortsMessage,
    BoardMessage,
    BoardGoneMessage,
    BoardRefusedMessage,
    BoardStepsMessage,
    TeamMessage,
)
BoardsMessage = Annotated[
    BoardsWelcomeMessage
    | BoardPortsMessage
    | BoardMessage
    | BoardGoneMessage
    | BoardRefusedMessage
    | BoardStepsMessage
    | TeamMessage,
    Field(discriminator="type"),
]
