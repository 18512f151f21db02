"""A part of one's own on its way, on the wire: what a selection offers, what is chosen, what became of it."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field

from kitrobot.compiler.graph.own_part import ChosenSlot
from kitrobot.graph.model import MOST_VERTICES
from kitrobot.primitives.constructors import Role, SlotKind
from kitrobot.primitives.meaning import Meaning
from kitrobot.primitives.robot import Texts
from kitrobot.wire.catalogue import Colour, ConstructorShape
from kitrobot.wire.mission import MissionShape, ProgramValue
from kitrobot.wire.problem import ProblemShape, RequestFailureShape
from kitrobot.wire.values import Least, Most, Row, View

LONGEST_PART = 20_000
"""Characters of a part's LLL as it is typed; what can be kept is shorter."""


class SelectedShape(BaseModel):
    """Some vertices of a program; `path` is the mission's file, "" for a new one."""

    mission: MissionShape
    path: str
    program: str
    vertices: Annotated[list[str], Field(max_length=MOST_VERTICES)]


class PlaceShape(Row):
    """A slot or parameter of a vertex; the slot "" is the vertex itself."""

    vertex: str
    slot: str


class OfferShape(View):
    """What could be left open. `inside`: the offer that holds it; `is_open`: nothing fills it, so it has to be."""

    vertex: str
    slot: str
    kind: SlotKind
    name: str
    label: Texts
    inside: PlaceShape | None
    is_open: bool
    value: str
    min: Least[int]
    max: Most[int]
    unit: str
    meaning: Meaning | None = None


class OfferedShape(BaseModel):
    """What a selection offers; `problems` are in it while nothing is left open."""

    role: Role
    vertices: list[str]
    offers: list[OfferShape]
    problems: list[ProblemShape]


class OfferAnswerShape(BaseModel):
    """What a selection offers, or why it cannot be a part."""

    offered: OfferedShape | None
    refused: RequestFailureShape | None


class PartWishShape(SelectedShape):
    """A selection that is to be a part."""

    name: str
    icon: str = ""
    colour: Colour = "action"
    label: Texts = {}
    help: Texts = {}
    chosen: Annotated[list[ChosenSlot], Field(max_length=MOST_VERTICES)]


class PartShape(View):
    """The part, its LLL, and the program with a vertex of it in the selection's place."""

    constructor: ConstructorShape
    lll: str
    program: ProgramValue
    vertex: str


class PartAnswerShape(BaseModel):
    """What a wish became, or why it cannot be."""

    part: PartShape | None
    refused: RequestFailureShape | None


class PartTextShape(BaseModel):
    """A part of that mission as a person has edited it, for a robot; its code may have mistakes."""

    mission: MissionShape
    path: str
    robot: str
    constructor: ConstructorShape


class PartReadShape(View):
    """The part (None while there are mistakes) and its LLL in the one true layout.

    `drawing` is its template as a graph, whose holes are named `{name}`; problems have their places in the code as it
    was sent, those on line 0 are about the rest.
    """

    constructor: ConstructorShape | None
    lll: str
    drawing: ProgramValue | None
    problems: list[ProblemShape]


class PartFileShape(BaseModel):
    """The parts of a mission as a constructors file."""

    constructors: list[ConstructorShape]
