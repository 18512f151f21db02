"""The catalogue on the wire: what the palette, the inspector and the chips are made of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Annotated, Any, Literal, TypeVar

from pydantic import BaseModel, Field

from kitrobot.primitives.automatic import work_object
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Role, Slot
from kitrobot.primitives.levels import Level
from kitrobot.primitives.meaning import Meaning
from kitrobot.primitives.own_xml import own_label
from kitrobot.primitives.robot import (
    LAST_PLACE,
    Category,
    Kind,
    Parameter,
    Robot,
    SearchWords,
    Texts,
    ValueType,
)
from kitrobot.sim.devices import DisplayKind, ManualControl
from kitrobot.sim.setup.settings import appearance_of, length_of
from kitrobot.wire.problem import ProblemShape, problem_shapes
from kitrobot.wire.values import Least, Most, Row, View, WireFields

T = TypeVar("T")

Colour = Literal["loop", "choice", "parallel", "action", "test", "team"]


SlotValue = Annotated[Slot, WireFields("names", "meaning", deep=False)]
ParameterValue = Annotated[Parameter, WireFields("meaning", deep=False)]


class AddsShape(Row):
    """The constructor, and its slot, that a branch adds itself to."""

    constructor: str
    slot: str


class ConstructorShape(View):
    """A building block of programs."""

    name: str
    group: str
    icon: str
    colour: Colour
    label: Texts
    help: Texts
    slots: tuple[SlotValue, ...]
    role: Role
    adds: AddsShape | None
    code: str
    level: Level = Level.AGENT
    order: int = LAST_PLACE
    words: SearchWords = Field(default_factory=dict)


class GroupShape(View):
    """A tab of the palette. `holds`: which parts of a robot that say no group are in it too."""

    name: str
    colour: Colour
    label: Texts
    icon: str = ""
    holds: Literal["", "actuators", "sensors", "values"] = ""
    constructors: list[ConstructorShape]


class MethodShape(View):
    """What a robot object can do or tell. `phrase`: words for chips, with holes, `{object} = {value}`."""

    name: str
    kind: Kind
    label: Texts
    help: Texts
    icon: str
    parameters: tuple[ParameterValue, ...]
    completes_later: bool
    stop: str | None
    phrase: Texts
    test: Literal["", "equal", "less", "greater"] = ""
    to: int | None = None
    alone: bool = False
    group: str = ""
    order: int = LAST_PLACE
    words: SearchWords = Field(default_factory=dict)


class RayShape(BaseModel):
    """Where a range finder looks: how far from its robot's edge, in mm, and counter-clockwise from the front."""

    reach_mm: float
    angle_rad: float


class RobotObjectShape(View):
    """A part of a robot. In the arena, `look` is how an actuator is drawn, and `hand` how a person works a sensor."""

    name: str
    category: Category
    look: DisplayKind = ""
    hand: ManualControl = ""
    ray: RayShape | None = None
    icon: str
    label: Texts
    help: Texts
    methods: list[MethodShape]
    type: ValueType
    min: Least[int]
    max: Most[int]
    initial: int
    shared: bool
    unit: str = ""
    meaning: Meaning | None = None
    group: str = ""
    words: SearchWords = Field(default_factory=dict)


class RobotShape(View):
    """A kind of robot; `length_mm` is how long it is, 0 for one without wheels, `figure` how it is drawn."""

    name: str
    label: Texts
    help: Texts
    tick_ms: int
    wait_unit_ms: int
    objects: list[RobotObjectShape]
    length_mm: float = 0.0
    figure: str = ""


class CatalogueShape(BaseModel):
    """Every word that programs can be made of, and what was wrong with the files that hold them."""

    groups: list[GroupShape]
    robots: list[RobotShape]
    problems: list[ProblemShape]
    work: RobotObjectShape | None = None
    """What a work of a team can do and tell, without its name."""
    own_label: Texts = Field(default_factory=dict)
    """What stands over a mission's own constructors."""


def catalogue_shape(catalogue: Catalogue, language: str) -> CatalogueShape:
    """The catalogue as it travels to a reader of that language: with those texts and the English ones alone."""
    kept = ("", language)
    return CatalogueShape(
        groups=[GroupShape.model_validate(_in_languages(group, kept)) for group in catalogue.groups],
        robots=[_robot(_in_languages(robot, kept)) for robot in catalogue.robots.values()],
        work=RobotObjectShape.model_validate(_in_languages(work_object("", 0), kept)),
        own_label=_only(own_label(), kept),
        problems=problem_shapes(catalogue.problems),
    )


_TEXTS = frozenset({"label", "help", "phrase", "words", "units"})
"""Fields that hold something for each language."""


def _only(texts: Mapping[str, T], languages: Sequence[str]) -> Mapping[str, T]:
    return {language: texts[language] for language in languages if language in texts}


@cache
def _fields_of(kind: type) -> tuple[str, ...]:
    """The names of the fields of a dataclass; nothing of another type."""
    return tuple(field.name for field in fields(kind)) if is_dataclass(kind) else ()


def _in_languages(value: T, languages: Sequence[str]) -> T:
    """A part of the catalogue with the texts of those languages alone, in all that it is made of."""
    if isinstance(value, tuple):
        parts: Any = tuple(_in_languages(one, languages) for one in value)
        return parts if type(value) is tuple else value
    kind: type = type(value)
    names = _fields_of(kind)
    if not names:
        return value
    made = copy(value)
    for name in names:
        inside = getattr(value, name)
        kept: Any = _only(inside, languages) if name in _TEXTS else _in_languages(inside, languages)
        if kept is not inside:
            # Nothing that such a value checks when it is made depends on its texts.
            object.__setattr__(made, name, kept)
    return made


def _robot(robot: Robot) -> RobotShape:
    shape = RobotShape.model_validate(robot).model_copy(update={"length_mm": length_of(robot)})
    for part, seen in zip(robot.objects, shape.objects, strict=True):
        seen.look, seen.hand, resting, ray = appearance_of(part)
        seen.ray = None if ray is None else RayShape(reach_mm=ray[0], angle_rad=ray[1])
        seen.initial = part.initial or resting
    return shape
