"""A mission on the wire: programs as graphs, the team, the world's name."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, BaseModel, Field

from kitrobot.graph import Arc, Note, Program, Vertex
from kitrobot.mission import Agent, Breakpoint, Failure, FailureKind, Goal, Mission, Team
from kitrobot.mission.trial import LONGEST_CONDITION, LONGEST_S, MOST_HITS
from kitrobot.primitives import MOST_OWN
from kitrobot.server.shapes.catalogue import ConstructorShape, constructor_shape
from kitrobot.server.shapes.own import OwnVariableShape, own_constructor, own_variable, own_variable_shape
from kitrobot.server.shapes.own_world import OwnWorldShape, own_world, own_world_shape

MOST_VERTICES = 100_000
MOST_AGENTS = 10_000
MOST_PROGRAMS = 1_000


def _sound(text: str) -> str:
    """The text with U+FFFD for what JSON can say and no file can hold: half of a character."""
    if text.isascii():
        return text
    return text.encode("utf-16", "surrogatepass").decode("utf-16", "replace")


Words = Annotated[str, AfterValidator(_sound)]


class NoteShape(BaseModel):
    """A comment of the user."""

    text: Words
    at: Words


class VertexShape(BaseModel):
    """A program element; `unknown` is XML of the file inside it that nobody knows, kept word for word."""

    id: Words
    element: Words
    settings: dict[Words, Words]
    notes: list[NoteShape]
    unknown: Words = ""


class ArcShape(BaseModel):
    """From the port `out` of one vertex to the port `at` of another."""

    source: Words
    target: Words
    out: Words
    at: Words


class ProgramShape(BaseModel):
    """A graph and the robot it is for."""

    name: Words
    robot: Words
    vertices: Annotated[list[VertexShape], Field(max_length=MOST_VERTICES)]
    arcs: Annotated[list[ArcShape], Field(max_length=2 * MOST_VERTICES)]


class AgentShape(BaseModel):
    """A robot of the team; `start` is a place of the world, "" for the one with the agent's name."""

    name: Words
    program: Words
    start: Words


class GoalShape(BaseModel):
    """What ends the mission as done: this storehouse holds this stock (a number, or `all`)."""

    storehouse: Words
    stock: Words


class BreakpointShape(BaseModel):
    """Where a run pauses: see `kitrobot.mission.Breakpoint`."""

    program: Words
    vertex: Words
    agents: list[Words] = []
    every: bool = False
    when: Annotated[Words, Field(max_length=LONGEST_CONDITION)] = ""
    hits: Annotated[int, Field(ge=1, le=MOST_HITS)] = 1
    enabled: bool = True


class ScheduledFailureShape(BaseModel):
    """What happens to an agent at so many simulated seconds."""

    agent: Words
    at_s: Annotated[float, Field(ge=0, le=LONGEST_S, allow_inf_nan=False)]
    kind: Literal["fail", "stall", "mute", "revive"]


class MissionShape(BaseModel):
    """All of a `.krt`; `world` is the name of a world's file, "" for the empty world; `own_world` counts instead.

    `unknown` is XML of the file that nobody knows, kept word for word; `label` and `help` are the title and what
    happens, by language.
    """

    version: Literal[1]
    programs: Annotated[list[ProgramShape], Field(max_length=MOST_PROGRAMS)]
    agents: Annotated[list[AgentShape], Field(max_length=MOST_AGENTS)]
    goals: Annotated[list[GoalShape], Field(max_length=MOST_AGENTS)]
    world: Words
    unknown: list[Words] = []
    label: dict[Words, Words] = {}
    help: dict[Words, Words] = {}
    constructors: Annotated[list[ConstructorShape], Field(max_length=MOST_OWN)] = []
    variables: Annotated[list[OwnVariableShape], Field(max_length=MOST_OWN)] = []
    breakpoints: Annotated[list[BreakpointShape], Field(max_length=MOST_AGENTS)] = []
    failures: Annotated[list[ScheduledFailureShape], Field(max_length=MOST_AGENTS)] = []
    own_world: OwnWorldShape | None = None


def mission_shape(mission: Mission) -> MissionShape:
    """A mission as it travels."""
    return MissionShape(
        version=1,
        programs=[_program_shape(program) for program in mission.programs],
        agents=[AgentShape(name=agent.name, program=agent.program, start=agent.start) for agent in mission.team.agents],
        goals=[GoalShape(storehouse=goal.storehouse, stock=goal.stock) for goal in mission.team.goals],
        world=mission.world_href,
        unknown=mission.unknown,
        label=dict(mission.label),
        help=dict(mission.help),
        constructors=[constructor_shape(constructor) for constructor in mission.constructors],
        variables=[own_variable_shape(variable) for variable in mission.variables],
        breakpoints=[
            BreakpointShape(
                program=one.program,
                vertex=one.vertex,
                agents=list(one.agents),
                every=one.every,
                when=one.when,
                hits=one.hits,
                enabled=one.enabled,
            )
            for one in mission.breakpoints
        ],
        failures=[
            ScheduledFailureShape(agent=one.agent, at_s=one.at_s, kind=one.kind.value) for one in mission.failures
        ],
        own_world=None if mission.own_world is None else own_world_shape(mission.own_world),
    )


def mission_from_shape(shape: MissionShape, programs: list[Program] | None = None) -> Mission:
    """The mission that travelled; `programs` count in the place of those in the shape.

    Raises:
        OwnPartError: a constructor or a variable that it brings along makes no sense.
    """
    team = Team(
        agents=[Agent(name=agent.name, program=agent.program, start=agent.start) for agent in shape.agents],
        goals=[Goal(storehouse=goal.storehouse, stock=goal.stock) for goal in shape.goals],
    )
    if programs is None:
        programs = [_program(program) for program in shape.programs]
    constructors = [own_constructor(constructor) for constructor in shape.constructors]
    variables = [own_variable(variable) for variable in shape.variables]
    breakpoints = [breakpoint_from_shape(one) for one in shape.breakpoints]
    failures = [Failure(one.agent, one.at_s, FailureKind(one.kind)) for one in shape.failures]
    return Mission(
        shape.version,
        programs,
        team,
        shape.world,
        shape.unknown,
        shape.label,
        shape.help,
        constructors,
        variables,
        breakpoints,
        failures,
        None if shape.own_world is None else own_world(shape.own_world),
    )


def breakpoint_from_shape(shape: BreakpointShape) -> Breakpoint:
    """The breakpoint that travelled."""
    agents = tuple(shape.agents)
    return Breakpoint(shape.program, shape.vertex, agents, shape.every, shape.when, shape.hits, shape.enabled)


def _program_shape(program: Program) -> ProgramShape:
    return ProgramShape(
        name=program.name,
        robot=program.robot,
        vertices=[
            VertexShape(
                id=vertex.id,
                element=vertex.element,
                settings=vertex.settings,
                notes=[NoteShape(text=note.text, at=note.at) for note in vertex.notes],
                unknown=vertex.unknown,
            )
            for vertex in program.vertices
        ],
        arcs=[ArcShape(source=arc.source, target=arc.target, out=arc.out, at=arc.at) for arc in program.arcs],
    )


def _program(shape: ProgramShape) -> Program:
    vertices = [vertex_from_shape(vertex) for vertex in shape.vertices]
    return Program(shape.name, shape.robot, vertices, [arc_from_shape(arc) for arc in shape.arcs])


def vertex_from_shape(shape: VertexShape) -> Vertex:
    """The vertex that travelled."""
    notes = [Note(note.text, note.at) for note in shape.notes]
    return Vertex(shape.id, shape.element, shape.settings, notes, shape.unknown)


def arc_from_shape(shape: ArcShape) -> Arc:
    """The arc that travelled."""
    return Arc(shape.source, shape.target, shape.out, shape.at)
