"""The catalogue on the wire: what the palette, the inspector and the chips are made of."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, TypeAdapter

from kitrobot.primitives import Catalogue, Constructor, Group, Method, Parameter, Robot, RobotObject, Slot
from kitrobot.server.shapes.problem import ProblemShape, problem_shapes
from kitrobot.sim import length_of

Texts = dict[str, str]
Colour = Literal["loop", "choice", "parallel", "action", "test", "team"]


_COLOURS: TypeAdapter[Colour] = TypeAdapter(Colour)


class SlotShape(BaseModel):
    """A hole of a constructor."""

    name: str
    kind: Literal["flow", "condition", "value", "number", "text", "action"]
    label: Texts
    loop: bool
    repeat: bool
    least: int
    min: int | None
    max: int | None
    default: str
    unit: str


class AddsShape(BaseModel):
    """The constructor, and its slot, that a branch adds itself to."""

    constructor: str
    slot: str


class ConstructorShape(BaseModel):
    """A building block of programs."""

    name: str
    group: str
    icon: str
    colour: Colour
    label: Texts
    help: Texts
    slots: list[SlotShape]
    role: Literal["instruction", "condition", "branch"]
    adds: AddsShape | None
    code: str


class GroupShape(BaseModel):
    """A heading of the palette."""

    name: str
    colour: Colour
    label: Texts
    constructors: list[ConstructorShape]


class ParameterShape(BaseModel):
    """A parameter of a method; `min` and `max` are included."""

    name: str
    kind: Literal["integer", "boolean"]
    min: int
    max: int
    default: int
    unit: str
    label: Texts
    help: Texts


class MethodShape(BaseModel):
    """What a robot object can do or tell. `phrase`: words for chips, with holes, `{object} = {value}`."""

    name: str
    kind: Literal["procedure", "test", "value"]
    label: Texts
    help: Texts
    icon: str
    parameters: list[ParameterShape]
    completes_later: bool
    stop: str | None
    phrase: Texts


class RobotObjectShape(BaseModel):
    """A part of a robot."""

    name: str
    category: Literal["actuator", "sensor", "variable", "system"]
    device: str
    icon: str
    label: Texts
    help: Texts
    methods: list[MethodShape]
    type: Literal["integer", "boolean"]
    min: int
    max: int
    initial: int
    shared: bool


class RobotShape(BaseModel):
    """A kind of robot; `length_mm` is how long it is, 0 for one without wheels."""

    name: str
    label: Texts
    help: Texts
    tick_ms: int
    wait_unit_ms: int
    objects: list[RobotObjectShape]
    length_mm: float = 0.0


class CatalogueShape(BaseModel):
    """Every word that programs can be made of, and what was wrong with the files that hold them."""

    groups: list[GroupShape]
    robots: list[RobotShape]
    problems: list[ProblemShape]


def catalogue_shape(catalogue: Catalogue) -> CatalogueShape:
    """The catalogue as it travels."""
    return CatalogueShape(
        groups=[_group(group) for group in catalogue.groups],
        robots=[_robot(robot) for robot in catalogue.robots.values()],
        problems=problem_shapes(catalogue.problems),
    )


def _group(group: Group) -> GroupShape:
    return GroupShape(
        name=group.name,
        colour=_colour(group.colour),
        label=dict(group.label),
        constructors=[constructor_shape(constructor) for constructor in group.constructors],
    )


def constructor_shape(constructor: Constructor) -> ConstructorShape:
    """A constructor as it travels."""
    adds = constructor.adds
    return ConstructorShape(
        name=constructor.name,
        group=constructor.group,
        icon=constructor.icon,
        colour=_colour(constructor.colour),
        label=dict(constructor.label),
        help=dict(constructor.help),
        slots=[_slot(slot) for slot in constructor.slots],
        role=constructor.role.value,
        adds=AddsShape(constructor=adds[0], slot=adds[1]) if adds else None,
        code=constructor.code,
    )


def _colour(name: str) -> Colour:
    found: Colour = _COLOURS.validate_python(name)
    return found


def _slot(slot: Slot) -> SlotShape:
    return SlotShape(
        name=slot.name,
        kind=slot.kind.value,
        label=dict(slot.label),
        loop=slot.loop,
        repeat=slot.repeat,
        least=slot.least,
        min=slot.minimum,
        max=slot.maximum,
        default=slot.default,
        unit=slot.unit,
    )


def _robot(robot: Robot) -> RobotShape:
    return RobotShape(
        name=robot.name,
        label=dict(robot.label),
        help=dict(robot.help),
        tick_ms=robot.tick_ms,
        wait_unit_ms=robot.wait_unit_ms,
        objects=[object_shape(part) for part in robot.objects],
        length_mm=length_of(robot),
    )


def object_shape(part: RobotObject) -> RobotObjectShape:
    """A part of a robot as it travels."""
    return RobotObjectShape(
        name=part.name,
        category=part.category.value,
        device=part.device,
        icon=part.icon,
        label=dict(part.label),
        help=dict(part.help),
        methods=[_method(method) for method in part.methods],
        type=part.type.value,
        min=part.minimum,
        max=part.maximum,
        initial=part.initial,
        shared=part.shared,
    )


def _method(method: Method) -> MethodShape:
    return MethodShape(
        name=method.name,
        kind=method.kind.value,
        label=dict(method.label),
        help=dict(method.help),
        icon=method.icon,
        parameters=[_parameter(parameter) for parameter in method.parameters],
        completes_later=method.completes_later,
        stop=method.stop,
        phrase=dict(method.phrase),
    )


def _parameter(parameter: Parameter) -> ParameterShape:
    return ParameterShape(
        name=parameter.name,
        kind=parameter.type.value,
        min=parameter.minimum,
        max=parameter.maximum,
        default=parameter.default,
        unit=parameter.unit,
        label=dict(parameter.label),
        help=dict(parameter.help),
    )
