"""What a constructor's template says about itself: its holes, and whether it can be run backwards.

A template that is one LLL construct around distinct holes and nothing else is the *inverse* for that construct: LLL
of that shape becomes a vertex of that constructor. The shape of a node is its class and which of its optional parts
are there. Both are read off the tree's classes, so no constructor is named here.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from typing import Literal

from kitrobot.lll.tree import (
    Call,
    Conditional,
    Hole,
    Interrupt,
    Joint,
    Move,
    Node,
    Parallel,
    ProgramCall,
    Seq,
    Where,
    While,
)
from kitrobot.lll.walk import children, nodes
from kitrobot.primitives.constructors import Constructor, SlotKind

Shape = tuple[type[Node], bool | str]
"""Class of a node, and whether its optional part (`condition`, `orelse`) is there, or its quantifier."""

_NUMBER = (SlotKind.NUMBER,)
_CONDITION = (SlotKind.CONDITION,)
_FLOW = (SlotKind.FLOW,)
_ACTION = (SlotKind.ACTION,)
_PARAMETER = (SlotKind.NUMBER, SlotKind.VALUE, SlotKind.TEXT)
_TEXT = (SlotKind.TEXT,)
_OPTIONAL: dict[type[Node], str] = {While: "condition", Conditional: "orelse", Where: "orelse"}
_NAMES = ("name", "source", "target")
_PLAIN = frozenset(("start", "end", "vertex", "program", "above", "after", "method_start", "quantifier"))


def holes(template: Node) -> Iterator[tuple[Hole, tuple[SlotKind, ...], bool]]:
    """Every hole in reading order, the kinds of slot that may fill it, and whether it may stand for many bodies."""
    branches: set[int] = set()
    for node in nodes(template):
        if isinstance(node, Parallel):
            branches.update(map(id, node.branches))
        if isinstance(node, Seq) and node.hole is not None:
            yield node.hole, _FLOW, id(node) in branches
        number = getattr(node, "count", None) or getattr(node, "duration", None)
        if isinstance(number, Hole):
            yield number, _NUMBER, False
        if isinstance(node, ProgramCall | Move):
            for name in (getattr(node, part, None) for part in _NAMES):
                if isinstance(name, Hole):
                    yield name, _TEXT, False
        fitting = _ACTION if isinstance(node, Interrupt) else _PARAMETER if isinstance(node, Call) else _CONDITION
        for child in children(node):
            if isinstance(child, Hole):
                yield child, _TEXT if child is getattr(node, "members", None) else fitting, False


def named_by(template: Node) -> dict[str, Literal["set", "program"]]:
    """What the text slots of a template name: roles, groups and agents, or a program. Others are left out."""
    found: dict[str, Literal["set", "program"]] = {}
    for node in nodes(template):
        if isinstance(node, ProgramCall) and isinstance(node.name, Hole):
            found[node.name.name] = "program"
        sets = (node.source, node.target) if isinstance(node, Move) else (getattr(node, "members", None),)
        found.update({hole.name: "set" for hole in sets if isinstance(hole, Hole)})
    return found


def shape(node: Node) -> Shape:
    """What decides which constructor an LLL construct becomes."""
    if isinstance(node, Joint):
        return Joint, node.quantifier
    part = _OPTIONAL.get(type(node))
    return type(node), part is not None and getattr(node, part) is not None


def shape_drawn(constructor: Constructor) -> Shape | None:
    """The shape that LLL must have to be drawn as this constructor; None where its template is not one construct."""
    template = constructor.template
    if template is None or isinstance(template, Seq | Call | Hole) or getattr(template, "above", None):
        return None
    return shape(template)


def inverse_shape(constructor: Constructor) -> Shape | None:
    """The shape that this constructor's template is the inverse for, or None."""
    template, drawn = constructor.template, shape_drawn(constructor)
    if template is None or drawn is None:
        return None
    names: list[str] = []
    for part in fields(template):
        value = getattr(template, part.name)
        if part.name in _PLAIN or value is None:
            continue
        for item in value if isinstance(value, list) else [value]:
            hole = item.hole if isinstance(item, Seq) else item
            if not isinstance(hole, Hole) or (isinstance(item, Seq) and (item.items or item.below)):
                return None
            names.append(hole.name)
    if isinstance(template, Parallel) and [slot.repeat for slot in constructor.slots] != [True]:
        return None
    return drawn if len(set(names)) == len(names) else None
