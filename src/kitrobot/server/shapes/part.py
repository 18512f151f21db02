"""A part of one's own on its way, on the wire: what a selection offers, what is chosen, what became of it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from kitrobot.compiler import Chosen, Offer
from kitrobot.server.shapes.catalogue import Colour, ConstructorShape, Texts
from kitrobot.server.shapes.mission import MOST_VERTICES, MissionShape, ProgramShape, Words
from kitrobot.server.shapes.problem import FailureShape, ProblemShape

LONGEST_PART = 20_000
"""Characters of a part's LLL as it is typed; what can be kept is shorter."""


class SelectedShape(BaseModel):
    """Some vertices of a program; `path` is the mission's file, "" for a new one."""

    mission: MissionShape
    path: Words
    program: Words
    vertices: Annotated[list[Words], Field(max_length=MOST_VERTICES)]


class PlaceShape(BaseModel):
    """A slot or parameter of a vertex; the slot "" is the vertex itself."""

    vertex: str
    slot: str


class OfferShape(BaseModel):
    """What could be left open. `inside`: the offer that holds it; `is_open`: nothing fills it, so it has to be."""

    vertex: str
    slot: str
    kind: Literal["flow", "condition", "value", "number", "text", "action"]
    name: str
    label: Texts
    inside: PlaceShape | None
    is_open: bool
    value: str
    min: int
    max: int
    unit: str


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

    vertex: Words
    slot: Words
    name: Words
    min: int | None = None
    max: int | None = None
    default: Words | None = None
    unit: Words | None = None


class PartWishShape(SelectedShape):
    """A selection that is to be a part."""

    name: Words
    icon: Words = ""
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
    path: Words
    robot: Words
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


def offer_shape(offer: Offer) -> OfferShape:
    """An offer as it travels."""
    inside = PlaceShape(vertex=offer.inside[0], slot=offer.inside[1]) if offer.inside is not None else None
    return OfferShape(
        vertex=offer.vertex,
        slot=offer.slot,
        kind=offer.kind.value,
        name=offer.name,
        label=dict(offer.label),
        inside=inside,
        is_open=offer.is_open,
        value=offer.value,
        min=offer.minimum,
        max=offer.maximum,
        unit=offer.unit,
    )


def chosen_from_shape(shape: ChosenShape) -> Chosen:
    """The choice that travelled."""
    return Chosen(shape.vertex, shape.slot, shape.name, shape.min, shape.max, shape.default, shape.unit)
