"""Small graphs in few words.

Each line is a chain of vertices joined by arcs, `a > b > c`. A vertex is `id`, and `id:Element` where it is first named
(`id:Wheel.Advance speed=50` with its settings); `start` and `stop` are there from the beginning. `id.port` behind the
first one names the port the arc leaves by, behind the last one the port it ends at; ports of ids are split at the first
dot.
"""

from __future__ import annotations

from functools import cache

from kitrobot.compiler.graph.graph_to_lll import Translation, graph_to_lll
from kitrobot.graph.model import IN, NEXT, START, STOP, Arc, Note, Program, Vertex
from kitrobot.lll.printer import print_program
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.constructors_xml import read_constructors


@cache
def shipped() -> Catalogue:
    """What comes with the package."""
    return load_catalogue()


def with_constructors(xml: str) -> Catalogue:
    """The shipped catalogue and constructors of one's own, without problems."""
    text = f'<constructors version="1"><group name="Own" colour="loop">{xml}</group></constructors>'
    groups, problems = read_constructors(text.encode(), "own.xml")
    assert problems == []
    return Catalogue(shipped().robots, [*shipped().groups, *groups])


def graph(*lines: str, robot: str = "mini-robot", ends: bool = True) -> Program:
    """The graph of these lines; without `ends` there is no start and no stop but those named."""
    program = Program("p", robot)
    if ends:
        program.vertices += [Vertex("start", START), Vertex("stop", STOP)]
    for line in lines:
        parts = [part.strip() for part in line.split(">")]
        for index, part in enumerate(parts):
            name, _, element = part.partition(":")
            if element:
                element, *settings = element.split(" ")
                settings_by_name = dict(setting.split("=") for setting in settings)
                program.vertices.append(Vertex(name, element.replace("_", " "), settings_by_name))
            parts[index] = name
        for index in range(len(parts) - 1):
            source, _, out = parts[index].partition(".") if index == 0 else (parts[index], "", "")
            target, _, at = parts[index + 1].partition(".") if index == len(parts) - 2 else (parts[index + 1], "", "")
            program.arcs.append(Arc(source, target, out or NEXT, at or IN))
    return program


def noted(program: Program, **notes: list[Note]) -> Program:
    """The graph with notes at its vertices."""
    for vertex in program.vertices:
        vertex.notes += notes.get(vertex.id, [])
    return program


def translated(program: Program, catalogue: Catalogue | None = None) -> Translation:
    """What the graph means in LLL."""
    return graph_to_lll(program, catalogue or shipped())


def text_of(program: Program, catalogue: Catalogue | None = None) -> str:
    """The LLL of a graph in which nothing is wrong."""
    translation = translated(program, catalogue)
    assert translation.diagnostics == []
    return print_program(translation.program)


def lines_of(program: Program, catalogue: Catalogue | None = None) -> str:
    """The LLL as far as the graph could be read, on one line."""
    return " ".join(print_program(translated(program, catalogue).program).split())


def told(program: Program, catalogue: Catalogue | None = None) -> list[tuple[str, tuple[str, ...]]]:
    """Code and vertices of each diagnostic."""
    return [(item.code, item.vertices) for item in translated(program, catalogue).diagnostics]
