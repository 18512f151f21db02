"""A program of a `.krt`, both ways: `<program>` with its vertices and arcs ↔ `Program`.

Writing is canonical: vertices then arcs in the order of the program, one a line, attributes in one order and left out
when they say the usual (`out="next"`, `at="in"`), so that the same program gives the same bytes and a difference
reads well. Reading what was written gives the same program. Characters that XML cannot hold become U+FFFD when
written.

Nothing is lost: XML inside a vertex that we do not know is kept word for word, a comment goes into the vertex that
follows it, and a vertex whose id is missing or taken gets a new one. Left to others: the rest of the `.krt` (mission),
and whether the graph makes sense (compiler).
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from kitrobot.graph.model import IN, NEXT, Arc, Note, Program, Vertex
from kitrobot.primitives.attribute_kinds import LEVEL
from kitrobot.primitives.levels import Level
from kitrobot.text.forms import name_form
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import NAME, Kind, needed, optional
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.foreign import fragment
from kitrobot.xml.rules import DUPLICATE, MISSING, UNKNOWN_ATTRIBUTE
from kitrobot.xml.writer import attributes, escape_text


class _Setting(NamedTuple):
    name: str
    value: str


class _Unknown(str):
    """XML inside a vertex that we do not know."""

    __slots__ = ()


def _program(element: Element) -> Program:
    level = Level(element.choice("level"))
    if level.is_team and "robot" in element.attributes:
        message = Sentence("a program of the level {level} is for several robots, so robot is left out", level)
        element.report(UNKNOWN_ATTRIBUTE, message, "robot")
    target = "" if level.is_team else element.required("robot")
    program = Program(element.required("name"), target, level=level)
    taken = {vertex.id for vertex in element.found(Vertex)}
    seen: set[str] = set()
    last: dict[str, int] = {}
    for vertex, around in element.found_at(Vertex):
        if not vertex.id or vertex.id in seen:
            old, vertex.id = vertex.id, _fresh(vertex.id or "vertex", taken, last)
            _renamed(around, program.name, old, vertex.id)
        taken.add(vertex.id)
        seen.add(vertex.id)
        program.vertices.append(vertex)
    program.arcs = element.found(Arc)
    if program.vertices:
        for before, raw in element.take_remarks():
            following = (value for value, _ in element.values[before:] if isinstance(value, Vertex))
            next(following, program.vertices[-1]).unknown += raw
    return program


def _fresh(name: str, taken: set[str], last: dict[str, int]) -> str:
    """`name-2` or the next number that is free; `last` remembers how far each name has come."""
    number = last.get(name, 1) + 1
    while f"{name}-{number}" in taken:
        number += 1
    last[name] = number
    return f"{name}-{number}"


def _renamed(element: Element, program: str, old: str, new: str) -> None:
    if old:
        made = DUPLICATE(
            Sentence("the vertex id {old} is there already; this vertex is now {new}", shown(old), shown(new)),
            element.place("id"),
            help=Sentence("arcs to this id lead to the first vertex that has it"),
        )
    else:
        made = MISSING(
            Sentence('expected id="…" on <vertex>, found none; this vertex is now {new}', shown(new)), element.place()
        )
    element.add(replace(made, program=program, vertices=(new,)))


def _vertex(element: Element) -> Vertex:
    vertex = Vertex(element.attributes.get("id", ""), element.required("element"))
    if element.values:
        for setting, around in element.found_at(_Setting):
            if setting.name in vertex.settings:
                around.report(
                    DUPLICATE,
                    Sentence("the setting {setting} is there already; this one counts", shown(setting.name)),
                    "name",
                )
            vertex.settings[setting.name] = setting.value
        vertex.notes = element.found(Note)
        vertex.unknown = "".join(element.found(_Unknown))
    return vertex


def _setting(element: Element) -> _Setting | None:
    name = element.required("name")
    return _Setting(name, name_form(element.text)) if name else None


def _note(element: Element) -> Note:
    return Note(element.text, element.attributes.get("at", ""))


def _keep(element: Element, raw: str) -> None:
    element.values.append((_Unknown(raw), element))


def _arc(element: Element) -> Arc | None:
    source, target = element.required("from"), element.required("to")
    if not source or not target:
        return None
    return Arc(source, target, element.attributes.get("out", NEXT), element.attributes.get("at", IN))


_SET = Tag(_setting, {"name": needed()}, text=True, about="What was typed into a slot or parameter.")
_NOTE = Tag(
    _note,
    {"at": optional(Kind(pattern="after|in:.+|"))},
    text=True,
    about="A comment. at: nothing (above), after (same line), in:SLOT (end of that body).",
)
_VERTEX = Tag(
    _vertex,
    {
        "id": needed(),
        "element": needed(about="Start, Stop, the name of a constructor, or Object.Method."),
    },
    {"set": _SET, "note": _NOTE},
    keep=_keep,
    about="A program element. XML of other kinds inside it is kept word for word.",
)
_ARC = Tag(
    _arc,
    {"from": needed(), "out": optional(NAME, NEXT), "to": needed(), "at": optional(NAME, IN)},
    about="From a port of one vertex to a port of another.",
)
PROGRAM = Tag(
    _program,
    {
        "name": needed(),
        "robot": optional(NAME, about="The kind of robot that it is for; needed in a program of the level agent."),
        "level": optional(LEVEL, Level.AGENT, about="Of whom it speaks: one robot, a group of them, or all."),
    },
    {"vertex": _VERTEX, "arc": _ARC},
)
"""A `<program>`: goes among the children of the element that holds it, where `found(Program)` gives what was read."""


def write_program(program: Program, indent: str = "  ") -> list[str]:
    """The lines of a `<program>`, without line breaks; what is inside stands two spaces deeper than `indent`."""
    inner = indent + "  "
    what = ("level", program.level) if program.level.is_team else ("robot", program.target)
    lines = [f"{indent}<program{attributes(('name', program.name), what)}>"]
    lines += [inner + _vertex_line(vertex) for vertex in program.vertices]
    lines += [inner + _arc_line(arc) for arc in program.arcs]
    lines.append(f"{indent}</program>")
    return lines


def _vertex_line(vertex: Vertex) -> str:
    start = f"<vertex{attributes(('id', vertex.id), ('element', vertex.element))}"
    inside = [f"<set{attributes(('name', name))}>{escape_text(value)}</set>" for name, value in vertex.settings.items()]
    inside += [f"<note{attributes(('at', note.at or None))}>{escape_text(note.text)}</note>" for note in vertex.notes]
    if vertex.unknown:
        inside.append(fragment(vertex.unknown))
    content = "".join(inside)
    return f"{start}>{content}</vertex>" if content else f"{start}/>"


def _arc_line(arc: Arc) -> str:
    out = arc.out if arc.out != NEXT else None
    at = arc.at if arc.at != IN else None
    return f"<arc{attributes(('from', arc.source), ('out', out), ('to', arc.target), ('at', at))}/>"
