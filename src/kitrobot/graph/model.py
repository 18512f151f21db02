"""A program as a graph: vertices joined by arcs between start and stop.

Representation: plain lists in the order of the file, which is also the canonical order of writing. Every vertex has the
ports `in` and `next`. A constructor has one out-port a flow slot (a repeated slot counts them: `branch.1`,
`branch.2`, …) and the in-port `return`: control enters the constructor, leaves through a slot, comes back at
`return`, goes on from `next`. What fills a condition, value or action slot is a vertex whose one arc ends at the port
of that slot's name.

Nothing here knows positions on a screen, and nothing here judges: structure is read off the arcs by the compiler.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated

from annotated_types import MaxLen

from kitrobot.primitives.levels import Level

MOST_VERTICES = 100_000
"""Of a program that a page sends; of arcs twice as many."""

START = "Start"
STOP = "Stop"
NEXT = "next"
IN = "in"
RETURN = "return"


@dataclass(slots=True)
class Note:
    """A comment of the user.

    `at` is "" for lines above the instruction, "after" for the rest of its line, "in:SLOT" for the end of that body
    (a repeated slot with its number, `in:branch.2`). A plain note of Stop stands at the end of the program.
    """

    text: str
    at: str = ""

    @property
    def lines(self) -> list[str]:
        """Its lines, as comments have them."""
        return [line.rstrip() for line in self.text.split("\n")]


@dataclass(slots=True)
class Vertex:
    """A program element: `element` is Start, Stop, a constructor's name, or `Object.Method`.

    `settings` holds what was typed into number and text slots, or parameters, by name. `unknown` keeps, word for word,
    XML inside the vertex that we do not know.
    """

    id: str
    element: str
    settings: dict[str, str] = field(default_factory=dict)
    notes: list[Note] = field(default_factory=list)
    unknown: str = ""


@dataclass(slots=True)
class Arc:
    """From a port of one vertex to a port of another."""

    source: str
    target: str
    out: str = NEXT
    at: str = IN


@dataclass(slots=True)
class Program:
    """A graph, and what it is for: `target` names the kind of robot of the agents that run it, "" for a team's.

    Examples:
        >>> import kitrobot
        >>> drive = Program("drive", "mini-robot")
        >>> drive.vertices = [Vertex("a", "Start"), Vertex("b", "Wheel.Advance", {"speed": "50"}), Vertex("c", "Stop")]
        >>> drive.arcs = [Arc("a", "b"), Arc("b", "c")]
        >>> kitrobot.compile_program(drive, "mini-robot").source.text.strip()
        'Wheel.Advance(50);'
    """

    name: str
    target: str = field(metadata={"alias": "robot"})
    vertices: Annotated[list[Vertex], MaxLen(MOST_VERTICES)] = field(default_factory=list)
    arcs: Annotated[list[Arc], MaxLen(2 * MOST_VERTICES)] = field(default_factory=list)
    level: Level = Level.AGENT


def empty_program(name: str, target: str) -> Program:
    """The paper's smallest graph: start → stop."""
    return Program(name, target, [Vertex("start", START), Vertex("stop", STOP)], [Arc("start", "stop")])
