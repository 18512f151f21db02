"""A mission on the wire: programs as graphs, the team, the world's name."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, Field, field_validator

from kitrobot.graph.model import Program
from kitrobot.lll.tree import MAX_NUMBER, GroupDeclaration, Members, RoleDeclaration, WorkDeclaration
from kitrobot.mission.breakdown import Breakdown, BreakdownRule
from kitrobot.mission.model import Mission, Team
from kitrobot.mission.property_xml import LONGEST_NAME, AskedProperty, Form
from kitrobot.mission.radio import LARGEST_RANGE_MM, LONGEST_DELAY_MS, Radio
from kitrobot.mission.trial import LONGEST_CONDITION, LONGEST_S, MOST_HITS, Breakpoint, Failure, FailureKind
from kitrobot.primitives.levels import Level
from kitrobot.primitives.own_xml import MOST_OWN
from kitrobot.wire.catalogue import ConstructorShape, LevelName
from kitrobot.wire.own_parts import OwnVariableShape, own_constructor, own_variable
from kitrobot.wire.own_world import OwnWorldShape, own_world, own_world_shape
from kitrobot.wire.values import AgentValue, ArcValue, GoalValue, VertexValue, View

MOST_VERTICES = 100_000
MOST_AGENTS = 10_000
MOST_PROGRAMS = 1_000

Declared = Annotated[int, Field(ge=0, le=MAX_NUMBER)]


class ProgramShape(BaseModel):
    """A graph and the robot it is for, "" in one of a team."""

    name: str
    robot: str
    level: LevelName = "agent"
    vertices: Annotated[list[VertexValue], Field(max_length=MOST_VERTICES)]
    arcs: Annotated[list[ArcValue], Field(max_length=2 * MOST_VERTICES)]


class BreakpointShape(View):
    """Where a run pauses: see `kitrobot.mission.Breakpoint`."""

    program: str
    vertex: str
    agents: list[str] = Field(default_factory=list)
    every: bool = False
    when: Annotated[str, Field(max_length=LONGEST_CONDITION)] = ""
    hits: Annotated[int, Field(ge=1, le=MOST_HITS)] = 1
    enabled: bool = True


class ScheduledFailureShape(View):
    """What happens to an agent at so many simulated seconds."""

    agent: str
    at_s: Annotated[float, Field(ge=0, le=LONGEST_S, allow_inf_nan=False)]
    kind: Literal["fail", "stall", "mute", "revive", "apart"]


class RadioShape(View):
    """How the robots hear each other: how far (null: everywhere), how late, how many messages of a hundred get lost."""

    range_mm: Annotated[float | None, Field(ge=1, le=LARGEST_RANGE_MM, allow_inf_nan=False)] = None
    delay_ms: Annotated[int, Field(ge=0, le=LONGEST_DELAY_MS)] = 0
    loss: Annotated[float, Field(ge=0, le=100, allow_inf_nan=False)] = 0.0


class AskedPropertyShape(View):
    """What is demanded of every run: see `kitrobot.mission.AskedProperty`."""

    name: Annotated[str, Field(min_length=1, max_length=LONGEST_NAME)]
    form: Literal["never", "after", "eventually", "stays"]
    first: Annotated[str, Field(max_length=LONGEST_CONDITION)]
    second: Annotated[str, Field(max_length=LONGEST_CONDITION)] = ""


class BreakdownShape(View):
    """What becomes of a robot that fails for good on a road, and after how many seconds it is towed."""

    rule: Literal["stay", "tow", "pass"]
    after_s: Annotated[float, Field(ge=0, le=LONGEST_S, allow_inf_nan=False)] = 0


class DeclarationShape(View):
    """A name that a team declares, and the comments of its line."""

    name: str
    above: list[str] = Field(default_factory=list)
    after: str | None = None


class RoleShape(DeclarationShape):
    """A role, the kind of robot that can play it, and how many are wanted."""

    robot: str
    least: Declared
    most: Declared


class TeamGroupShape(DeclarationShape):
    """Roles, groups and agents under one name, and what happens when one of them fails."""

    members: Annotated[list[str], Field(min_length=1, max_length=MOST_AGENTS)]
    failure: Literal["drop", "substitute", "abort"]

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

    roles: list[RoleShape]
    groups: list[TeamGroupShape]
    works: list[WorkShape]


class MissionShape(BaseModel):
    """All of a `.krt`; `world` is the name of a world's file, "" for the empty world; `own_world` counts instead.

    `unknown` is XML of the file that nobody knows, kept word for word; `prolog` are comments and instructions before
    its first element, whose attributes with a prefix are in `attributes`; `label` and `help` are the title and what
    happens, by language.
    """

    version: Literal[1]
    programs: Annotated[list[ProgramShape], Field(max_length=MOST_PROGRAMS)]
    agents: Annotated[list[AgentValue], Field(max_length=MOST_AGENTS)]
    goals: Annotated[list[GoalValue], Field(max_length=MOST_AGENTS)]
    world: str
    unknown: list[str] = []
    label: dict[str, str] = {}
    help: dict[str, str] = {}
    constructors: Annotated[list[ConstructorShape], Field(max_length=MOST_OWN)] = []
    variables: Annotated[list[OwnVariableShape], Field(max_length=MOST_OWN)] = []
    breakpoints: Annotated[list[BreakpointShape], Field(max_length=MOST_AGENTS)] = []
    failures: Annotated[list[ScheduledFailureShape], Field(max_length=MOST_AGENTS)] = []
    breakdown: BreakdownShape | None = None
    properties: Annotated[list[AskedPropertyShape], Field(max_length=MOST_AGENTS)] = []
    own_world: OwnWorldShape | None = None
    radio: RadioShape | None = None
    roles: Annotated[list[RoleShape], Field(max_length=MOST_AGENTS)] = []
    groups: Annotated[list[TeamGroupShape], Field(max_length=MOST_AGENTS)] = []
    works: Annotated[list[WorkShape], Field(max_length=MOST_AGENTS)] = []
    prolog: list[str] = []
    attributes: dict[str, str] = {}


def mission_shape(mission: Mission) -> MissionShape:
    """A mission as it travels."""
    return MissionShape(
        version=1,
        programs=[_program_shape(program) for program in mission.programs],
        agents=mission.team.agents,
        goals=mission.team.goals,
        world=mission.world_href,
        unknown=mission.unknown,
        label=dict(mission.label),
        help=dict(mission.help),
        constructors=[ConstructorShape.model_validate(constructor) for constructor in mission.constructors],
        variables=[OwnVariableShape.model_validate(variable) for variable in mission.variables],
        breakpoints=[BreakpointShape.model_validate(one) for one in mission.breakpoints],
        failures=[ScheduledFailureShape.model_validate(one) for one in mission.failures],
        breakdown=None if mission.breakdown == Breakdown() else BreakdownShape.model_validate(mission.breakdown),
        properties=[AskedPropertyShape.model_validate(one) for one in mission.properties],
        own_world=None if mission.own_world is None else own_world_shape(mission.own_world),
        radio=None if mission.radio is None else RadioShape.model_validate(mission.radio),
        roles=[RoleShape.model_validate(one) for one in mission.team.roles],
        groups=[TeamGroupShape.model_validate(one) for one in mission.team.groups],
        works=[WorkShape.model_validate(one) for one in mission.team.works],
        prolog=mission.prolog,
        attributes=mission.attributes,
    )


def mission_from_shape(shape: MissionShape) -> Mission:
    """The mission that travelled.

    Raises:
        OwnPartError: a constructor or a variable that it brings along makes no sense.
    """
    programs = [_program(program) for program in shape.programs]
    constructors = [own_constructor(constructor) for constructor in shape.constructors]
    variables = [own_variable(variable) for variable in shape.variables]
    breakpoints = [breakpoint_from_shape(one) for one in shape.breakpoints]
    failures = [Failure(one.agent, one.at_s, FailureKind(one.kind)) for one in shape.failures]
    return Mission(
        shape.version,
        programs,
        _team(shape),
        shape.world,
        shape.unknown,
        shape.label,
        shape.help,
        constructors,
        variables,
        breakpoints,
        failures,
        None if shape.own_world is None else own_world(shape.own_world),
        None if shape.radio is None else Radio(shape.radio.range_mm, shape.radio.delay_ms, shape.radio.loss),
        Breakdown()
        if shape.breakdown is None
        else Breakdown(BreakdownRule(shape.breakdown.rule), round(shape.breakdown.after_s, 3)),
        [AskedProperty(one.name, Form(one.form), one.first, one.second) for one in shape.properties],
        shape.prolog,
        shape.attributes,
    )


def _team(shape: MissionShape) -> Team:
    roles = [RoleDeclaration(one.name, one.robot, one.least, one.most, **_notes(one)) for one in shape.roles]
    groups = [
        GroupDeclaration(one.name, Members(one.members, braced=len(one.members) != 1), one.failure, **_notes(one))
        for one in shape.groups
    ]
    works = [WorkDeclaration(one.name, one.units, one.lease, **_notes(one)) for one in shape.works]
    return Team(shape.agents, shape.goals, roles, groups, works)


def _notes(shape: DeclarationShape) -> dict[str, Any]:
    return {"above": shape.above, "after": shape.after}


def breakpoint_from_shape(shape: BreakpointShape) -> Breakpoint:
    """The breakpoint that travelled."""
    agents = tuple(shape.agents)
    return Breakpoint(shape.program, shape.vertex, agents, shape.every, shape.when, shape.hits, shape.enabled)


def _program_shape(program: Program) -> ProgramShape:
    return ProgramShape(
        name=program.name,
        robot=program.target,
        level=program.level.value,
        vertices=program.vertices,
        arcs=program.arcs,
    )


def _program(shape: ProgramShape) -> Program:
    return Program(shape.name, shape.robot, shape.vertices, shape.arcs, Level(shape.level))
