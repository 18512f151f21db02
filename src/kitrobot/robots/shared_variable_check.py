"""The warning about shared variables, which real robots do not pass on to one another."""

from __future__ import annotations

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.diagnostics.model import Diagnostic, Severity, rule
from kitrobot.lll.tree import Call
from kitrobot.lll.walk import nodes
from kitrobot.primitives.robot import Robot
from kitrobot.text.sentences import Sentence

SHARED_ON_BOARD = rule(
    "shared-on-board",
    Severity.WARNING,
    "Real robots do not pass shared variables on to one another",
    "In the simulator the team shares them by radio. A real robot has each of them for itself: it starts with the "
    "initial value, and sees only what its own program sets.",
)


def warn_of_shared_variables(name: str, robot: Robot, compiled: CompiledProgram) -> list[Diagnostic]:
    """A warning for each shared variable that a program uses, at the first place; `name` is the program's. None for one
    with errors: it is not sent, and its tree is not that of its text.
    """
    shared = {variable.name for variable in robot.variables if variable.shared and compiled.ok}
    found: dict[str, Diagnostic] = {}
    vertex = None
    for node in nodes(compiled.program) if shared else ():
        vertex = node.vertex or vertex
        if not isinstance(node, Call) or node.object not in shared or node.object in found:
            continue
        place = compiled.source.place(node.start, node.end)
        where = (
            Sentence("line {line}, vertex `{vertex}`", place.line, vertex)
            if vertex
            else Sentence("line {line}", place.line)
        )
        found[node.object] = SHARED_ON_BOARD(
            Sentence(
                "`{object}` is shared with the team, and real robots do not pass it on: {where}", node.object, where
            ),
            place,
            help=Sentence(
                "the robot runs, and sees only what it sets itself; as a team: in the simulator or with `kitrobot team`"
            ),
            program=name,
            vertices=(vertex,) if vertex else (),
        )
    return list(found.values())
