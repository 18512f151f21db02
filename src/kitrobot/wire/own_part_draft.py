"""A part of one's own on its way, on the wire: what a selection offers, what is chosen, what became of it."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, Field, model_validator

from kitrobot.compiler.graph.own_part import ChosenSlot
from kitrobot.wire.catalogue import Colour, ConstructorShape, MeaningShape, Texts
from kitrobot.wire.mission import MOST_VERTICES, MissionShape, ProgramShape
from kitrobot.wire.problem import FailureShape, ProblemShape
from kitrobot.wire.values import Least, Most, View

LONGEST_PART = 20_000
"""Characters of a part's LLL as it is typed; what can be kept is shorter."""


class SelectedShape(BaseModel):
    """Some vertices of a program; `path` is the mission's file, "" for a new one."""

    mission: MissionShape
    path: str
    program: str
    vertices: Annotated[list[str], Field(max_length=MOST_VERTICES)]


class PlaceShape(BaseModel):
    """A slot or parameter of a vertex; the slot "" is the vertex itself."""

    vertex: str
    slot: str

    @model_validator(mode="before")
    @classmethod
    def _pair(cls, given: Any) -> Any:
        return {"vertex": given[0], "slot": given[1]} if isinstance(given, tuple) else given


class OfferShape(View):
    """What could be left open. `inside`: the offer that holds it; `is_open`: nothing fills it, so it has to be."""

    vertex: str
    slot: str
    kind: Literal["flow", "condition", "value", "number", "text", "action"]
    name: str
    label: Texts
    inside: PlaceShape | None
    is_open: bool
    value: str
    min: Least[int]
    max: Most[int]
    unit: str
    meaning: MeaningShape | None = None


class OfferedShape(BaseModel):
    """What a selection offers; `problems` are in it while nothing is left open."""

    role: Literal["instruction", "condition", "branch"]
    vertices: list[str]
    offers: list[OfferShape]
    problems: list[ProblemShape]


class OfferAnswerShape(BaseModel):
    """What a selection offers, or why it cannot be a part."""

    offered: OfferedShape | None
    refused: FailureShape | None


class ChosenShape(BaseModel):
    """An offer that becomes a slot under that name; numbers with one name become one slot."""

    vertex: str
    slot: str
    name: str
    min: int | None = None
    max: int | None = None
    default: str | None = None
    unit: str | None = None


class PartWishShape(SelectedShape):
    """A selection that is to be a part."""

    name: str
    icon: str = ""
    colour: Colour = "action"
    label: Texts = {}
    help: Texts = {}
    chosen: Annotated[list[ChosenShape], Field(max_length=MOST_VERTICES)]


class PartShape(BaseModel):
    """The part, its LLL, and the program with a vertex of it in the selection's place."""

    constructor: ConstructorShape
    lll: str
    program: ProgramShape
    vertex: str


class PartAnswerShape(BaseModel):
    """What a wish became, or why it cannot be."""

    part: PartShape | None
    refused: FailureShape | None


class PartTextShape(BaseModel):
    """A part of that mission as a person has edited it, for a robot; its code may have mistakes."""

    mission: MissionShape
    path: str
    robot: str
    constructor: ConstructorShape


class PartReadShape(BaseModel):
    """The part (None while there are mistakes) and its LLL in the one true layout.

    `drawing` is its template as a graph, whose holes are named `{name}`; problems have their places in the code as it
    was sent, those on line 0 are about the rest.
    """

    constructor: ConstructorShape | None
    lll: str
    drawing: ProgramShape | None
    problems: list[ProblemShape]


class PartFileShape(BaseModel):
    """The parts of a mission as a constructors file."""

    constructors: list[ConstructorShape]


def chosen_from_shape(shape: ChosenShape) -> ChosenSlot:
    """The choice that travelled."""
    return ChosenSlot(shape.vertex, shape.slot, shape.name, shape.min, shape.max, shape.default, shape.unit)
