"""How large a program becomes when its parts are put in their places; what no image holds is not even begun.

A part of a thousand instructions that is used two thousand times is a small file and two million instructions. What its
vertices become is known beforehand (`Constructor.size`), so it is counted before anything is made.
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.compiler.rules import TOO_LARGE
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.graph.model import Program
from kitrobot.image.model import MOST_INSTRUCTIONS
from kitrobot.lll.tree import Seq
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.text.sentences import Sentence

MOST_OF_MISSION = 2 * MOST_INSTRUCTIONS
"""By how many instructions all programs of a mission may grow together."""

MOST_FOR_KINDS = 2 * MOST_OF_MISSION
"""Instructions of a team's program, for each kind of robot that runs it, together."""


def expansion(program: Program, catalogue: Catalogue) -> int:
    """By how many instructions a program grows when its parts are in their places."""
    growth = catalogue.growth
    return sum(growth[vertex.element] for vertex in program.vertices if vertex.element in growth)


def left_out(programs: Sequence[Program], catalogue: Catalogue) -> list[Program]:
    """The programs of a mission before which others have grown to what all of them may; one that grows too much by
    itself is none of both.
    """
    grown, found = 0, []
    for program in programs:
        more = expansion(program, catalogue)
        if more <= MOST_INSTRUCTIONS:
            grown += more
            if grown > MOST_OF_MISSION:
                found.append(program)
    return found


def oversize(program: Program, catalogue: Catalogue) -> Diagnostic | None:
    """What is wrong with a program that grows beyond what an image holds; None where it does not."""
    if expansion(program, catalogue) <= MOST_INSTRUCTIONS:
        return None
    used = {vertex.element: vertex for vertex in program.vertices if vertex.element in catalogue.growth}
    growth = dict.fromkeys(used, 0)
    for vertex in program.vertices:
        if vertex.element in growth:
            growth[vertex.element] += catalogue.growth[vertex.element]
    largest = max(growth, key=lambda element: growth[element])
    return TOO_LARGE(
        Sentence("with all parts in their places this program has more than {most} instructions", MOST_INSTRUCTIONS),
        help=Sentence("use `{part}` less often, or make it smaller", largest),
        program=program.name,
        vertices=(used[largest].id,),
    )


def oversize_for_kinds(program: Seq, kinds: int) -> Sentence | None:
    """What is wrong with a team's program, all programs in it in their places, that so many kinds of robots run; None
    where nothing is.
    """
    size = sum(len(node.items) for node in nodes(program) if isinstance(node, Seq))
    if size * kinds <= MOST_FOR_KINDS:
        return None
    return Sentence(
        "{size} instructions for each of {kinds} kinds of robots are more than {most}", size, kinds, MOST_FOR_KINDS
    )


def oversize_in_mission(program: Program) -> Diagnostic:
    """What is wrong with a program where those before it have grown to what a mission may."""
    return TOO_LARGE(
        Sentence(
            "with all parts in their places the programs of this mission have more than {most} instructions",
            MOST_OF_MISSION,
        ),
        help=Sentence("use large parts less often, or make several missions of it"),
        program=program.name,
    )
