"""A text from a clipboard or of a file → a piece of a graph: LLL, or the XML of a behaviour tree.

Instructions become a chain between Start and Stop. A condition by itself ("Sign.EqualTo(0) & Run.IsTrue()") is no
program: it is read as the guard of an empty event; that graph without its chain is the condition alone.
"""

from __future__ import annotations

from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.compiler.text.part_text import without_chain
from kitrobot.diagnostics.model import Diagnostic, KitRobotError
from kitrobot.graph.model import Program
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import Seq
from kitrobot.mission.model import Mission
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.robot import Robot
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.wire.fragment import FragmentRequestShape, FragmentShape
from kitrobot.wire.own_parts import own_constructor, own_variable
from kitrobot.wire.problem import problem_shapes
from kitrobot.workspace.behaviour_trees import read_tree
from kitrobot.workspace.file_check import TREE_ELEMENT, first_element

FILE, TREE_FILE = "clipboard.lll", "clipboard.xml"
"""The names by which problems speak of the text."""

routes = api_router()


@routes.post("/fragment")
def fragment(studio: ThisStudio, wanted: FragmentRequestShape) -> FragmentShape:
    """Reads a text for a robot; one that is neither LLL nor a behaviour tree gives its problems and no graph."""
    own = Mission(
        constructors=[own_constructor(one) for one in wanted.constructors],
        variables=[own_variable(one) for one in wanted.variables],
    )
    catalogue = studio.parts_of(own, wanted.path)
    robot = catalogue.robot(wanted.robot)
    program, problems = read_fragment(wanted.text, robot, catalogue)
    return FragmentShape(program=program, problems=problem_shapes(problems))


def read_fragment(text: str, robot: Robot, catalogue: Catalogue) -> tuple[Program | None, list[Diagnostic]]:
    """The graph of a text, or None and what is wrong with it."""
    if first_element(text) == TREE_ELEMENT:
        read = read_tree(text.encode(), TREE_FILE, robot)
        if read.text is None:
            return None, read.diagnostics
        text = read.text.text
    parsed = parse(text, FILE)
    if parsed.ok:
        return _drawn(parsed.program, robot, catalogue), parsed.diagnostics
    guarded = parse(f"<{text}>();", FILE)
    if guarded.ok and len(guarded.program.items) == 1:
        drawn = _drawn(guarded.program, robot, catalogue)
        if drawn is not None:
            return without_chain(drawn), []
    return None, parsed.diagnostics


def _drawn(program: Seq, robot: Robot, catalogue: Catalogue) -> Program | None:
    try:
        return lll_to_graph(program, robot, catalogue, "fragment")
    except KitRobotError:
        return None
