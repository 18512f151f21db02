"""All passes in a row: a graph, a text or a tree becomes an image, with everything there is to say about it."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property

from kitrobot.compiler.graph.graph_to_lll import Translation, graph_to_lll
from kitrobot.compiler.graph.rules import NOT_A_NUMBER, UNKNOWN_ELEMENT
from kitrobot.compiler.graph.vertex_places import VertexPlace, vertex_places
from kitrobot.compiler.program.checker import check
from kitrobot.compiler.program.lowering import lower
from kitrobot.compiler.program.team_check import check_program
from kitrobot.compiler.rules import UNKNOWN_METHOD, UNKNOWN_OBJECT
from kitrobot.compiler.target import Target, print_for, target_of
from kitrobot.diagnostics.model import Diagnostic, Source, in_reading_order
from kitrobot.graph.model import Program
from kitrobot.image.debug import DebugMap
from kitrobot.image.model import Image
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Seq
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.text.collection import collection_paused


@dataclass(frozen=True)
class CompiledProgram:
    """What became of a program: its LLL (tree and text), its image (None when there are errors), its debug map."""

    program: Seq
    source: Source
    image: Image | None
    debug: DebugMap
    diagnostics: list[Diagnostic] = field(default_factory=list)

    @cached_property
    def places(self) -> list[VertexPlace]:
        """Where the vertices are in the text."""
        return vertex_places(self.program, self.source)

    @property
    def ok(self) -> bool:
        """Whether there is an image to run."""
        return self.image is not None


@dataclass(frozen=True)
class CheckResult:
    """What `check` found in a tree, with its places in this text, which is without line breaks at its end."""

    text: str
    diagnostics: list[Diagnostic]

    def is_of(self, text: str) -> bool:
        """Whether it holds for an equal tree with that text."""
        return not self.diagnostics or text.rstrip("\n") == self.text


def compile_lll(
    program: Seq,
    target: Target,
    source: Source | None = None,
    name: str = "",
    checked: CheckResult | None = None,
) -> CompiledProgram:
    """Checks a tree for a target and lowers it. Without a `source` the tree is printed first, to have a text.

    `name` is the program's name in its mission, set on the diagnostics; `checked`: of an equal
    tree.
    """
    if source is None:
        source = Source(f"{name or 'program'}.lll", print_program(program))
    if checked is not None and checked.is_of(source.text):
        diagnostics = [*checked.diagnostics]
    else:
        diagnostics = check(program, target, source, name)
    if any(item.is_error for item in diagnostics):
        return CompiledProgram(program, source, None, DebugMap(), diagnostics)
    image, debug, too_large = lower(program, target, name)
    diagnostics += [replace(item, place=source.place(0, 0), program=name) for item in too_large]
    return CompiledProgram(program, source, image, debug, diagnostics)


def compile_text(text: str, target: Target, name: str = "program.lll") -> CompiledProgram:
    """Reads an LLL text and compiles it; `name` is the file name that diagnostics show."""
    parsed = parse(text, name)
    if parsed.ok:
        compiled = compile_lll(parsed.program, target, parsed.source)
    else:
        found = check(parsed.program, target, parsed.source)
        compiled = CompiledProgram(parsed.program, parsed.source, None, DebugMap(), found)
    return replace(compiled, diagnostics=in_reading_order(parsed.diagnostics + compiled.diagnostics))


def compile_program(
    program: Program,
    catalogue: Catalogue,
    translation: Translation | None = None,
    checked: CheckResult | None = None,
) -> CompiledProgram:
    """Translates a graph to LLL and compiles it for its target. Vertices are named in the diagnostics and debug map.

    `translation`: the graph's, where it was made already; `checked`: of a tree equal to its own.

    Raises KitRobotError when the catalogue has no such robot.
    """
    with collection_paused():
        return _compile_program(program, catalogue, translation, checked)


def not_compiled(program: Program, why: Diagnostic) -> CompiledProgram:
    """What stands for a program that is not even translated."""
    return CompiledProgram(Seq(), Source(f"{program.name}.lll", ""), None, DebugMap(), [why])


def _compile_program(
    program: Program, catalogue: Catalogue, translation: Translation | None, checked: CheckResult | None
) -> CompiledProgram:
    target = target_of(program, catalogue)
    if translation is None:
        translation = graph_to_lll(program, catalogue)
    source = Source(f"{program.name}.lll", print_for(translation.program, target, catalogue.crew))
    if not translation.ok or target.level.is_team:  # what a team's program becomes is each robot's own
        found = check_program(translation.program, target, catalogue.crew, source, program.name)
        diagnostics = translation.diagnostics + _news(found, translation.diagnostics)
        return CompiledProgram(translation.program, source, None, DebugMap(), diagnostics)
    compiled = compile_lll(translation.program, target, source, program.name, checked)
    return CompiledProgram(
        compiled.program, source, compiled.image, compiled.debug, translation.diagnostics + compiled.diagnostics
    )


def _news(found: list[Diagnostic], told: list[Diagnostic]) -> list[Diagnostic]:
    """What the checker found, without calls that the graph's translation has named as unknown already, and without
    remarks on loops while a number is none: they would speak of the one that was put in its place.
    """
    if any(item.code == NOT_A_NUMBER.code for item in told):
        found = [item for item in found if item.is_error]
    unknown = {vertex for item in told if item.code == UNKNOWN_ELEMENT.code for vertex in item.vertices}
    codes = (UNKNOWN_OBJECT.code, UNKNOWN_METHOD.code)
    return [item for item in found if item.code not in codes or unknown.isdisjoint(item.vertices)]
