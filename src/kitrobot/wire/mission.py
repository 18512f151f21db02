"""A mission on the wire: programs as graphs, the team, the world's name."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypeVar

from annotated_types import Ge, Le, MaxLen, MinLen
from pydantic import Field, field_validator

from kitrobot.graph.model import Program
from kitrobot.lll.tree import MAX_NUMBER, GroupDeclaration, Members, RoleDeclaration, WorkDeclaration
from kitrobot.lll.tree import Failure as GroupFailure
from kitrobot.mission.breakdown import Breakdown
from kitrobot.mission.model import Mission, Team
from kitrobot.mission.property_forms import AskedProperty
from kitrobot.mission.radio import Radio
from kitrobot.mission.trial import Breakpoint, Failure
from kitrobot.primitives.own_xml import MOST_OWN
from kitrobot.primitives.robot import Texts
from kitrobot.wire.catalogue import ConstructorShape
from kitrobot.wire.own_parts import OwnVariableShape, own_constructor, own_variable
from kitrobot.wire.own_world import OwnWorldShape, own_world, own_world_shape
from kitrobot.wire.values import AgentValue, GoalValue, View, WireFields

MOST_AGENTS = 10_000
MOST_PROGRAMS = 1_000

T = TypeVar("T")
Many = Annotated[list[T], MaxLen(MOST_AGENTS)]
Declared = Annotated[int, Ge(0), Le(MAX_NUMBER)]

ProgramValue = Annotated[Program, WireFields("level", "unknown")]
FailureValue = Annotated[Failure, WireFields()]
BreakdownValue = Annotated[Breakdown, WireFields("after_s")]


class DeclarationShape(View):
    """A name that a team declares, and the comments of its line."""

    name: str
    above: list[str] = Field(default_factory=list)
    after: str | None = None


class TeamRoleShape(DeclarationShape):
    """A role, the kind of robot that can play it, and how many are wanted."""

    robot: str
    least: Declared
    most: Declared


class TeamGroupShape(DeclarationShape):
    """Roles, groups and agents under one name, and what happens when one of them fails."""

    members: Annotated[list[str], MinLen(1), MaxLen(MOST_AGENTS)]
    failure: GroupFailure

    @field_validator("members", mode="before")
    @classmethod
    def _names(cls, given: Any) -> Any:
        return given.names if isinstance(given, Members) else given


class WorkShape(DeclarationShape):
    """Units of work, and the seconds after which an unfinished one is free again."""

    units: Declared
    lease: Declared | None = None


class DeclaredShape(View):
    """What the text of a team's program declares before its instructions."""

    roles: list[TeamRoleShape]
    groups: list[TeamGroupShape]
    works: list[WorkShape]


class MissionShape(View):
    """All of a `.krt`; `world` is the name of a world's file, "" for the empty world; `own_world` counts instead.

    `unknown` is XML of the file that nobody knows, kept word for word; `prolog` are comments and instructions before
    its first element, whose attributes with a prefix are in `attributes`; `label` and `help` are the title and what
    happens, by language.
    """

    version: Literal[1]
    programs: Annotated[list[ProgramValue], MaxLen(MOST_PROGRAMS)]
    agents: Many[AgentValue]
    goals: Many[GoalValue]
    world: str
    unknown: list[str] = Field(default_factory=list)
    label: Texts = Field(default_factory=dict)
    help: Texts = Field(default_factory=dict)
    constructors: Annotated[list[ConstructorShape], MaxLen(MOST_OWN)] = Field(default_factory=list)
    variables: Annotated[list[OwnVariableShape], MaxLen(MOST_OWN)] = Field(default_factory=list)
    breakpoints: Many[Breakpoint] = Field(default_factory=list)
    failures: Many[FailureValue] = Field(default_factory=list)
    breakdown: BreakdownValue | None = None
    properties: Many[AskedProperty] = Field(default_factory=list)
    own_world: OwnWorldShape | None = None
    radio: Radio | None = None
    roles: Many[TeamRoleShape] = Field(default_factory=list)
    groups: Many[TeamGroupShape] = Field(default_factory=list)
    works: Many[WorkShape] = Field(default_factory=list)
    prolog: list[str] = Field(default_factory=list)
    attributes: dict[str, str] = Field(default_factory=dict)


_AS_THEY_ARE = (
    *("programs", "unknown", "label", "help", "breakpoints", "failures", "properties", "radio", "prolog", "attributes"),
)
"""Fields that a mission and its shape have alike."""


def mission_shape(mission: Mission) -> MissionShape:
    """A mission as it travels."""
    team = mission.team
    return MissionShape(
        version=1,
        agents=team.agents,
        goals=team.goals,
        world=mission.world_href,
        constructors=[ConstructorShape.model_validate(one) for one in mission.constructors],
        variables=[OwnVariableShape.model_validate(one) for one in mission.variables],
        breakdown=None if mission.breakdown == Breakdown() else mission.breakdown,
        own_world=None if mission.own_world is None else own_world_shape(mission.own_world),
        roles=[TeamRoleShape.model_validate(one) for one in team.roles],
        groups=[TeamGroupShape.model_validate(one) for one in team.groups],
        works=[WorkShape.model_validate(one) for one in team.works],
        **{name: getattr(mission, name) for name in _AS_THEY_ARE},
    )


def mission_from_shape(shape: MissionShape) -> Mission:
    """The mission that travelled.

    Raises:
        OwnPartError: a constructor or a variable that it brings along makes no sense.
    """
    towing = shape.breakdown or Breakdown()
    return Mission(
        shape.version,
        team=_team(shape),
        world_href=shape.world,
        constructors=[own_constructor(one) for one in shape.constructors],
        variables=[own_variable(one) for one in shape.variables],
        own_world=None if shape.own_world is None else own_world(shape.own_world),
        breakdown=Breakdown(towing.rule, round(towing.after_s, 3)),
        **{name: getattr(shape, name) for name in _AS_THEY_ARE},
    )


def _team(shape: MissionShape) -> Team:
    roles = [RoleDeclaration(**dict(one)) for one in shape.roles]
    groups = [
        GroupDeclaration(**{**dict(one), "members": Members(one.members, braced=len(one.members) != 1)})
        for one in shape.groups
    ]
    return Team(shape.agents, shape.goals, roles, groups, [WorkDeclaration(**dict(one)) for one in shape.works])
