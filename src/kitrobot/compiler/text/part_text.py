"""A part of one's own as a person edits it: its LLL is read, its slots follow the holes, mistakes have their place.

A hole that has no slot yet gets one that fits where it stands, with the range of the parameter it is given to; a slot
without a hole goes. What is read at last has passed the reader of XML, so it can be saved.

`draw_template` is the other direction: the template as a graph, in which what stands for a hole is named `{hole}`.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass, field, fields, replace
from itertools import accumulate
from typing import Any

from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.diagnostics.model import Diagnostic, Place, Source
from kitrobot.graph.model import IN, START, STOP, Program
from kitrobot.lll.parse_results import parse_template
from kitrobot.lll.printer import print_template
from kitrobot.lll.tree import (
    MAX_NUMBER,
    And,
    Call,
    Event,
    Hole,
    Joint,
    Members,
    Move,
    Not,
    Number,
    Or,
    ProgramCall,
    Seq,
)
from kitrobot.lll.walk import nodes, without_comments
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Constructor, Slot, SlotKind
from kitrobot.primitives.own_xml import read_own, write_constructor
from kitrobot.primitives.robot import Robot, ValueType
from kitrobot.primitives.template_xml import Template
from kitrobot.primitives.templates import holes
from kitrobot.xml.writer import escape_text

FILE = "part.lll"
"""The name by which problems speak of the text."""

_STAND_IN = 1_000_000
"""Numbers from here on stand for holes while a template is drawn; no program can hold them."""


@dataclass(frozen=True)
class PartText:
    """A part as it was read (None when there are mistakes), and its LLL in the one true layout."""

    constructor: Constructor | None
    lll: str = ""
    diagnostics: list[Diagnostic] = field(default_factory=list)


def read_part(wanted: Constructor, robot: Robot) -> PartText:
    """Reads a part from its `code`; of its slots those count that have a hole.

    Args:
        wanted: the part; its `template` and `role` do not matter.
        robot: the robot whose parameters give new slots their ranges.
    """
    template, found = parse_template(wanted.code, FILE)
    if template is None or any(item.is_error for item in found):
        return PartText(None, diagnostics=found)
    slots = _slots(wanted, template, robot)  # before printing, which sets places
    lll = print_template(without_comments(template))
    whole = replace(wanted, slots=slots, code=" ".join(lll.split()))
    constructor, found = read_own(write_constructor(whole), FILE)
    if isinstance(constructor, Constructor):
        return PartText(constructor, lll)
    # Mistakes are shown in the text as it was typed, which the slots were made for.
    _, typed = read_own(write_constructor(replace(whole, code=wanted.code)), FILE)
    return PartText(None, lll, [_in_text(item, whole, wanted.code) for item in typed or found])


def _slots(wanted: Constructor, template: Template, robot: Robot) -> tuple[Slot, ...]:
    """The slots that have a hole, and new ones for holes without, in the order that they had, new ones last."""
    kinds: dict[str, tuple[SlotKind, ...]] = {}
    times: dict[str, int] = {}
    for hole, fitting, _ in sorted(holes(template), key=lambda found: found[0].start):
        kinds.setdefault(hole.name, fitting)
        times[hole.name] = times.get(hole.name, 0) + 1
    kept = {slot.name: slot for slot in wanted.slots if slot.name in kinds}
    made = _from_robot(template, robot)
    for name, fitting in kinds.items():
        new = made.get(name, Slot(name, fitting[0]))
        was = kept.get(name)
        if was is None:
            kept[name] = new
        elif was.kind not in fitting:
            kept[name] = replace(new, label=was.label)
        if times[name] > 1 and kept[name].kind is SlotKind.VALUE:
            kept[name] = replace(kept[name], kind=SlotKind.NUMBER)  # what is plugged in cannot be there twice
    return tuple(kept.values())


def _from_robot(template: Template, robot: Robot) -> dict[str, Slot]:
    """A slot for each hole that is given to a parameter the robot has."""
    made: dict[str, Slot] = {}
    for node in nodes(template):
        meaning = robot.calls.get((node.object, node.method)) if isinstance(node, Call) else None
        if meaning is None or not isinstance(node, Call):
            continue
        for parameter, given in zip(meaning[1].parameters, node.params, strict=False):
            if isinstance(given, Hole) and given.name not in made:
                low, high = max(0, parameter.minimum), max(0, min(parameter.maximum, MAX_NUMBER))
                kind = SlotKind.NUMBER if parameter.type is ValueType.BOOLEAN else SlotKind.VALUE
                default = str(min(max(parameter.default, low), high))
                made[given.name] = Slot(
                    given.name,
                    kind,
                    minimum=low,
                    maximum=high,
                    default=default,
                    unit=parameter.unit,
                    meaning=parameter.meaning,
                )
    return made


def _in_text(item: Diagnostic, written: Constructor, code: str) -> Diagnostic:
    """The diagnostic with its place in the text of the code, or without one where it is about something else."""
    lines = write_constructor(replace(written, code=code))
    at = next((index for index, line in enumerate(lines) if line.lstrip().startswith("<code>")), None)
    place = item.place
    if at is None or place is None or place.line != at + 2:  # the first line of the file is the mission's own
        return replace(item, place=None)
    head = lines[at].index("<code>") + len("<code>")
    starts = [0, *accumulate(len(escape_text(character)) for character in code)]
    source = Source(FILE, code)

    def offset(column: int) -> int:
        wanted = column - 1 - head
        return next((index for index, start in enumerate(starts) if start >= wanted), len(code))

    if place.column - 1 < head:
        return replace(item, place=Place(FILE))
    return replace(item, place=source.place(offset(place.column), offset(place.end_column)))


def draw_template(constructor: Constructor, robot: Robot, catalogue: Catalogue) -> Program:
    """The template of a part as a graph: a chain from Start to Stop, or a condition on its own.

    A hole for something is a vertex whose element is `{name}`; a hole for a number is the setting `{name}`.

    Raises KitRobotError when the catalogue lacks a constructor to draw with.
    """
    assert constructor.template is not None, "what adds a branch has no template"
    template: Any = copy.deepcopy(constructor.template)
    numbers: dict[int, str] = {}
    is_condition = isinstance(template, And | Or | Not | Joint)
    seq = template if isinstance(template, Seq) else Seq([Event(template, Seq()) if is_condition else template])
    for node in nodes(seq):
        _stand_in(node, numbers)
    program = lll_to_graph(seq, robot, catalogue, constructor.name, apart_from=constructor.name)
    holes = {str(number): hole for number, hole in numbers.items()}
    for vertex in program.vertices:
        if vertex.element.startswith("{"):
            vertex.element = vertex.element.removesuffix(".")
        vertex.settings |= {name: holes.get(text, text) for name, text in vertex.settings.items()}
    return without_chain(program) if is_condition else program


def _stand_in(node: Any, numbers: dict[int, str]) -> None:
    """Puts something that can be drawn in the place of each hole of a node."""

    def number(hole: Hole) -> int:
        value = _STAND_IN + len(numbers)
        numbers[value] = f"{{{hole.name}}}"
        return value

    for part in fields(node):
        value = getattr(node, part.name)
        if isinstance(value, Hole):
            if isinstance(node, Seq):
                node.items.insert(node.hole_at, Call(f"{{{value.name}}}", ""))
                node.hole = None
            elif part.name in ("count", "duration"):
                setattr(node, part.name, number(value))
            elif part.name == "members":
                node.members = Members([value.name])  # written as the hole is
            elif isinstance(node, ProgramCall | Move):
                setattr(node, part.name, f"{{{value.name}}}")
            else:
                setattr(node, part.name, Call(f"{{{value.name}}}", ""))
        elif isinstance(value, list) and not isinstance(node, Seq):
            value[:] = [Number(number(one)) if isinstance(one, Hole) else one for one in value]


def without_chain(program: Program) -> Program:
    """What does not stand in the chain: the condition of its only instruction."""
    chained = {arc.target for arc in program.arcs if arc.at == IN}
    gone = chained | {vertex.id for vertex in program.vertices if vertex.element in (START, STOP)}
    return replace(
        program,
        vertices=[vertex for vertex in program.vertices if vertex.id not in gone],
        arcs=[arc for arc in program.arcs if arc.source not in gone and arc.target not in gone],
    )
