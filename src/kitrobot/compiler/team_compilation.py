"""A team's program for each kind of robot: projected, checked and compiled for a robot that has `Team`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from kitrobot.compiler.compilation import CompiledProgram, compile_lll
from kitrobot.compiler.team.effects import MovesBoxes, report_effects_done_twice
from kitrobot.compiler.team.moves import report_emptied
from kitrobot.compiler.team.names import Names
from kitrobot.compiler.team.points import TeamPlan
from kitrobot.compiler.team.projection import project
from kitrobot.diagnostics.model import Diagnostic, Rule, Source
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Call, Instruction, Node, Seq
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.levels import Level
from kitrobot.primitives.team_objects import with_team
from kitrobot.text.sentences import Help, Sentence


@dataclass(frozen=True)
class CompiledTeam:
    """What became of a team's program: of each kind of robot its program, the points, and what is wrong with it."""

    kinds: Mapping[str, CompiledProgram]
    plan: TeamPlan
    diagnostics: list[Diagnostic] = field(default_factory=list)


def compile_team(
    name: str,
    programs: Mapping[str, CompiledProgram],
    catalogue: Catalogue,
    kinds: Iterable[str],
    moves_boxes: MovesBoxes = lambda part: False,
) -> CompiledTeam:
    """A team's program, compiled for kinds of robots.

    Args:
        name: which of the programs it is.
        programs: the mission's programs by name; none has an error.
        catalogue: the robots at hand, and the team.
        kinds: the kinds of robots of those that run it.
        moves_boxes: whether a part moves boxes of a storehouse.
    """
    whole = programs[name]
    others = {other: compiled.program for other, compiled in programs.items()}
    known = catalogue.teams[Level.SOCIAL].calls

    def shared(call: Call) -> bool:
        meaning = known.get((call.object, call.method))
        return meaning is not None and meaning[0].shared

    projection = project(whole.program, catalogue.crew, others, whole.source, name, shared)
    found = list(projection.diagnostics)
    made: dict[str, CompiledProgram] = {}
    if not any(item.is_error for item in found):
        for kind in kinds:
            seq = projection.programs.get(kind, Seq([]))
            source = Source(f"{name}.{kind}.lll", print_program(seq))
            made[kind] = compile_lll(seq, with_team(catalogue.robots[kind], catalogue.crew.works), source, name)
            found += [item for item in made[kind].diagnostics if item.is_error]

        def report(rule: Rule, message: Sentence, node: Node, help: Help = "") -> None:
            program = (node.program if isinstance(node, Instruction) else None) or name
            place = programs[program].source.place(node.start, node.end)
            vertices = (node.vertex,) if node.vertex else ()
            found.append(rule(message, place, help=help, program=program, vertices=vertices))

        report_emptied(projection.whole, Names(catalogue.crew), report)
        report_effects_done_twice(projection.whole, catalogue.crew, catalogue.robots, moves_boxes, report)
    return CompiledTeam(made, projection.plan, found)
