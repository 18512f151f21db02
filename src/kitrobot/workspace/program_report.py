"""What a mission and its programs become, as it is shown beside the graph: LLL with the place of each vertex."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.compiler.graph.vertex_places import VertexPlace
from kitrobot.diagnostics.model import Diagnostic, Source
from kitrobot.lll.tree import Instruction
from kitrobot.lll.walk import nodes


@dataclass(frozen=True)
class ProgramReport:
    """What a program becomes; `instructions` is 0 when it has errors."""

    name: str
    lll: str
    spans: tuple[VertexPlace, ...]
    instructions: int


@dataclass(frozen=True)
class ProjectionSpan:
    """A stretch of a projected program, as `VertexPlace`, and the team's program in which its vertex stands."""

    program: str
    vertex: str
    start: int
    end: int
    line: int


@dataclass(frozen=True)
class ProjectionReport:
    """What a team's program is for a kind of robot."""

    robot: str
    lll: str
    spans: tuple[ProjectionSpan, ...]


@dataclass(frozen=True)
class Report:
    """A mission looked through: each program, every problem, and the texts that the problems point into.

    `projections` are what the program of the whole team is for each kind of robot that runs it.
    """

    programs: tuple[ProgramReport, ...]
    problems: tuple[Diagnostic, ...]
    sources: tuple[Source, ...] = ()
    projections: tuple[ProjectionReport, ...] = ()

    @property
    def ok(self) -> bool:
        """Whether the mission can run."""
        return not any(problem.is_error for problem in self.problems)


def projection_report(robot: str, compiled: CompiledProgram) -> ProjectionReport:
    """The report of what a team's program is for a kind of robot."""
    return ProjectionReport(robot, compiled.source.text, tuple(_projected(compiled)))


def _projected(compiled: CompiledProgram) -> Iterable[ProjectionSpan]:
    """The outermost stretches of each vertex, in reading order; one of several lines may have many."""
    ends: dict[tuple[str, str], int] = {}
    for node in nodes(compiled.program):
        if not isinstance(node, Instruction) or node.vertex is None:
            continue
        key = (node.program or "", node.vertex)
        if node.start >= ends.get(key, 0) and node.end > node.start:
            ends[key] = node.end
            yield ProjectionSpan(*key, node.start, node.end, compiled.source.position(node.start)[0])


def program_report(name: str, compiled: CompiledProgram | None) -> ProgramReport:
    """The report of a program; `compiled` is None when its robot is not at hand."""
    if compiled is None:
        return ProgramReport(name, "", (), 0)
    instructions = compiled.image.instructions if compiled.image is not None else 0
    return ProgramReport(name, compiled.source.text, tuple(compiled.places), instructions)
