"""Parts that come and go beside a mission, on the wire: files with robots, constructors, worlds, and new variables."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from kitrobot.primitives.own_xml import MOST_OWN
from kitrobot.wire.catalogue import CatalogueShape
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.own_parts import OwnVariableShape
from kitrobot.wire.own_world import OwnWorldShape
from kitrobot.wire.problem import ProblemShape
from kitrobot.wire.sentences import FileName, Spoken
from kitrobot.wire.world import WorldShape


class PartsShape(BaseModel):
    """What the files around a mission hold; `stamp` names their state, as `parts` of `NewsMessage` does."""

    stamp: str
    catalogue: CatalogueShape


class WorldFileShape(BaseModel):
    """The world of a mission: None when its file is not there, or is no world."""

    world: WorldShape | None


class PlanShape(BaseModel):
    """A world's file as something that can be changed: None when it is not there or has mistakes, which are told."""

    world: OwnWorldShape | None
    problems: list[ProblemShape]


class TemplateShape(BaseModel):
    """A world to begin with; `world` has its label and help."""

    name: str
    world: OwnWorldShape


class WorldEntryShape(BaseModel):
    """A world that a mission can take place in; `href` is what the mission calls it, "" for the empty one."""

    href: FileName
    shipped: bool
    label: dict[str, str]
    help: dict[str, str]
    world: WorldShape | None
    problems: list[ProblemShape]


class AbsentPartShape(BaseModel):
    """A part of a robot that a kit has nothing for."""

    category: Literal["actuator", "sensor"]
    name: str


class KitEntryShape(BaseModel):
    """What a robot can be built of; `micropython` is the least version that it needs, "" for any, and `firmware` the
    page where its file says that it is to be had. `file` is the ending of the file that its board takes from its drive,
    "" for none. `picture` is an SVG of it, drawn from its file. `absent` are the parts that the kit has nothing for, by
    the robot whose parts they are.
    """

    name: str
    label: dict[str, str]
    help: dict[str, str]
    micropython: str
    firmware: str
    file: Literal["", ".hex", ".uf2"]
    picture: str
    absent: dict[str, list[AbsentPartShape]]


class KitFitAskShape(BaseModel):
    """Asks on which kits a program of a mission runs; `path` is the file it was opened from, "" for a new one."""

    path: str
    mission: MissionShape
    program: str


class LackingShape(BaseModel):
    """A part of a robot that a kit lacks; its label is by language."""

    part: str
    label: dict[str, str]


class KitFitShape(BaseModel):
    """Whether a program runs on a kit, "" as its robot's own file says: the used parts that the kit lacks,
    and why the program cannot be sent, "" when it can.
    """

    kit: str
    missing: list[LackingShape]
    problem: Spoken


class PartsDifferenceShape(BaseModel):
    """What is different in a kit's file from the one that is there, a sentence each; nothing where it is no kit."""

    changes: list[str]


class PartsFileShape(BaseModel):
    """A file that was put beside a mission: its name there, and the names that it brings along.

    `known` tells that the very same file was there already.
    """

    file: str
    kind: Literal["robot", "board", "constructors", "world"]
    names: list[str]
    known: bool


class VariableAskShape(BaseModel):
    """A variable that a person wants for a kind of robot; `was` is the name of the one that it takes the place of.

    `variables` are those of the mission already; min, max and initial of a truth are not looked at but `initial` != 0.
    """

    path: str
    variables: Annotated[list[OwnVariableShape], Field(max_length=MOST_OWN)]
    robot: str
    was: str = ""
    name: str
    type: Literal["integer", "boolean"]
    min: int
    max: int
    initial: int
    shared: bool
