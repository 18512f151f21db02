"""An edited text beside its graph: the graph that follows it, or what keeps it from following.

The graph follows a text without mistakes. Mistakes that the graph has already (a call the robot does not know, say) do
not count, or nothing else could be edited until they are mended. Every diagnostic has its place in the text as it was
typed and names the vertex that the instruction around it was, so that it can be shown on both sides.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import accumulate
from operator import itemgetter

from kitrobot.compiler.compilation import CheckResult
from kitrobot.compiler.graph.graph_to_lll import Translation
from kitrobot.compiler.graph.vertex_places import VertexPlace, vertex_places
from kitrobot.compiler.program.team_check import check_program
from kitrobot.compiler.target import read_for
from kitrobot.compiler.text.lll_to_graph import redraw
from kitrobot.compiler.text.preserve_ids import Before, Old
from kitrobot.diagnostics.model import Diagnostic, Source, in_reading_order
from kitrobot.graph.model import Program
from kitrobot.lll.tree import Node, Seq, TeamProgram
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.crew import Crew, declaring
from kitrobot.text.positions import TextPositions


@dataclass(frozen=True)
class TextEdit:
    """The graph of an edited text (None when there are mistakes in it), and what there is to say about the text.

    `tree` and `source` are the text's.

    `team` is what the text of a team's program declares, with its instructions; None for a program of one robot.

    `translation` is the graph's way back to LLL, for who compiles it next; its tree is not the one of the text, but
    equal to it where there is `checked`, what `check` found in the text.
    """

    program: Program | None
    tree: Seq = field(repr=False)
    source: Source = field(repr=False)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    translation: Translation | None = field(default=None, repr=False, compare=False)
    checked: CheckResult | None = field(default=None, repr=False, compare=False)
    team: TeamProgram | None = field(default=None, repr=False, compare=False)

    @cached_property
    def spans(self) -> list[VertexPlace]:
        """The outermost stretches of each vertex in the text, in reading order; none without a graph."""
        return [] if self.program is None else vertex_places(self.tree, self.source)


def follow_text(before: Translation, text: str, catalogue: Catalogue) -> TextEdit:
    """Draws a text anew beside the graph it came from.

    Args:
        before: the translation of that graph, by the same catalogue; nothing in it may change any more.
        text: what a person made of its LLL.
        catalogue: robots and constructors.

    Raises KitRobotError when the catalogue lacks the constructors to draw with.
    """
    program, robot = before.wiring.program, before.wiring.robot
    parsed = read_for(text, robot, f"{program.name}.lll")
    crew = catalogue.crew if parsed.team is None else declaring(catalogue.crew, parsed.team)
    redrawn = redraw(parsed.seq, robot, catalogue, program.name, Before(before)) if parsed.ok else None
    found = check_program(parsed.seq, robot, crew, parsed.source, program.name)
    # Of a text it is not said which vertices it has become.
    diagnostics = [
        replace(item, program=program.name, vertices=()) for item in in_reading_order(parsed.diagnostics + found)
    ]
    if redrawn is not None and not _news(found, before, catalogue.crew):
        drawn, made = redrawn
        checked = CheckResult(text.rstrip("\n"), found) if made.program == parsed.seq else None
        return TextEdit(drawn, parsed.seq, parsed.source, diagnostics, made, checked, parsed.team)
    around = _Around(parsed.seq, parsed.source, Old.beside(Before(before), parsed.seq))
    mistakes = [around.at_vertex(item) for item in diagnostics]
    return TextEdit(None, parsed.seq, parsed.source, mistakes, team=parsed.team)


def _news(found: list[Diagnostic], before: Translation, crew: Crew) -> bool:
    """Whether there are errors that the graph does not have already."""
    errors = _errors(found)
    if not errors:
        return False
    return bool(errors - _errors(check_program(before.program, before.wiring.robot, crew, Source("", ""))))


def _errors(found: list[Diagnostic]) -> Counter[tuple[str, str]]:
    return Counter((item.code, item.message) for item in found if item.is_error)


class _Around:
    """The vertices that instructions and conditions of a text were, by places in it."""

    def __init__(self, tree: Seq, source: Source, old: Old) -> None:
        self.old = old
        self.starts = TextPositions(source.text).line_starts
        known = [(node.start, at, node) for at, node in enumerate(nodes(tree)) if old.origin(node) is not None]
        self.known = sorted(known, key=itemgetter(0, 1))
        self.furthest = list(accumulate((node.end for _, _, node in self.known), max))
        """Where the furthest of the nodes so far ends."""

    def at_vertex(self, item: Diagnostic) -> Diagnostic:
        """The diagnostic with the vertex of the smallest instruction or condition around its place."""
        if item.place is None or item.vertices:
            return item
        offset = self.starts[item.place.line - 1] + item.place.column - 1
        around: list[tuple[int, int, Node]] = []
        index = bisect_right(self.known, offset, key=itemgetter(0))
        while index > 0 and self.furthest[index - 1] >= offset:
            index -= 1
            start, at, node = self.known[index]
            if node.end >= offset:
                around.append((node.end - start, at, node))
        if not around:
            return item
        origin = self.old.origin(min(around, key=itemgetter(0, 1))[2])
        assert origin is not None
        return replace(item, vertices=(origin.vertex.id,))
