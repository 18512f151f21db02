"""Matches LLL against a template: what stands in the template's holes.

The fixed part of the template must be there word for word, without comments of its own; a hole takes whatever stands in
its place. A hole that occurs twice must hold the same twice.

One template may be made from another too: then it is the more specific of the two.
"""

from __future__ import annotations

import copy
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any

from kitrobot.lll.tree import Hole, Instruction, Members, Node, Number, Seq
from kitrobot.primitives.constructors import Constructor, SlotKind

Bound = dict[str, Any]
"""Hole name → the part that stands there: a number, a node, a body; a repeated body gives the list of all branches."""

_TYPED: dict[SlotKind, Any] = {SlotKind.NUMBER: int, SlotKind.TEXT: int | str | Members}
_PLACES = frozenset(("start", "end", "vertex", "above", "after", "method_start"))


def unfill(constructor: Constructor, template: Node, node: Node, *, any_number: bool = False) -> Bound | None:
    """The parts of `node` that stand in the holes of `template`; None where it is not made from it.

    `any_number`: numbers outside the range of their slot fit too.
    """
    bound: Bound = {}
    return bound if _TemplateMatcher(constructor, bound, any_number).node(template, node) else None


def unfill_all(constructor: Constructor, templates: list[Any], nodes: list[Any]) -> Bound | None:
    """The same for a row of instructions; comments may stand above the first and behind the last only."""
    bound: Bound = {}
    matching = _TemplateMatcher(constructor, bound, any_number=False)
    if len(templates) != len(nodes) or any(node.above for node in nodes[1:]) or any(node.after for node in nodes[:-1]):
        return None
    return bound if all(map(matching.node, templates, nodes)) else None


def unfill_row(constructor: Constructor, template: Seq, nodes: list[Any]) -> Bound | None:
    """The same for a row of instructions with a hole among them, which takes what the others leave."""
    assert template.hole is not None, "a row without a hole is unfilled as a whole"
    bound: Bound = {}
    matching = _TemplateMatcher(constructor, bound, any_number=False)
    end = len(nodes) - (len(template.items) - template.hole_at)
    if end < template.hole_at:
        return None
    own = [*nodes[: template.hole_at], *nodes[end:]]
    if any(node.above for node in own if node is not nodes[0]):
        return None
    if any(node.after for node in own if node is not nodes[-1]):
        return None
    if not all(map(matching.node, template.items, own)):
        return None
    return bound if matching.hole(template.hole.name, Seq(nodes[template.hole_at : end])) else None


def is_more_specific(one: Constructor, other: Constructor) -> bool:
    """Whether all that the first one's template makes could be made by the other's, and not the other way round."""
    return _is_made_from(one, other) and not _is_made_from(other, one)


def _is_made_from(one: Constructor, other: Constructor) -> bool:
    assert one.template is not None, "what adds a branch has no template"
    assert other.template is not None, "what adds a branch has no template"
    return _TemplateMatcher(other, {}, any_number=True, of=one).node(other.template, one.template)


def fill_with(template: Any, bound: Bound) -> Any:
    """The template with these parts in its holes: `unfill` forwards, without a graph."""
    if isinstance(template, Hole):
        return bound[template.name]
    if isinstance(template, Seq) and template.hole is not None:
        before, held = template.items[: template.hole_at], bound[template.hole.name]
        items = [fill_with(item, bound) for item in [*before, *template.items[template.hole_at :]]]
        return Seq([*items[: len(before)], *held.items, *items[len(before) :]], template.below + held.below)
    if isinstance(template, list):
        made: list[Any] = []
        for item in template:
            held = bound[item.hole.name] if isinstance(item, Seq) and item.hole is not None else None
            made += held if isinstance(held, list) else [fill_with(item, bound)]
        return made
    if not is_dataclass(template):
        return template
    filled = copy.copy(template)
    for part in fields(filled):
        setattr(filled, part.name, fill_with(getattr(filled, part.name), bound))
    return filled


@cache
def _parts(kind: type[Node]) -> tuple[str, ...]:
    """The fields of a node that a template speaks of."""
    return tuple(part.name for part in fields(kind) if part.name not in _PLACES)


class _TemplateMatcher:
    """One comparison. `of`: the constructor whose template is the node, which then has holes of its own."""

    def __init__(self, constructor: Constructor, bound: Bound, any_number: bool, of: Constructor | None = None) -> None:
        self.constructor = constructor
        self.any_number = any_number
        self.bound = bound
        self.of = of

    def node(self, template: Any, node: Any) -> bool:
        if type(template) is not type(node):
            return False
        names = _parts(template.__class__)
        return all(self.part(getattr(template, name), getattr(node, name)) for name in names)

    def part(self, pattern: Any, value: Any) -> bool:
        if isinstance(pattern, Hole):
            return value is not None and self.hole(pattern.name, value)
        if isinstance(pattern, Seq):
            return isinstance(value, Seq) and self.body(pattern, value)
        if isinstance(pattern, list):
            return self.row(pattern, value)
        if isinstance(pattern, Node):
            return self.node(pattern, value)
        return bool(pattern == value)

    def hole(self, name: str, value: Any) -> bool:
        slot = self.constructor.slot(name)
        assert slot is not None, "a template's holes are its constructor's slots"
        number = value.value if isinstance(value, Number) else value
        if isinstance(value, Hole):
            return self.takes(slot.kind, value) and self.bound.setdefault(name, value) == value
        if isinstance(number, int) and not self.any_number:
            if slot.minimum is not None and number < slot.minimum:
                return False
            if slot.maximum is not None and number > slot.maximum:
                return False
        elif not isinstance(number, _TYPED.get(slot.kind, object)):
            return False
        if name in self.bound:
            return bool(self.bound[name] == value)
        self.bound[name] = value
        return True

    def takes(self, kind: SlotKind, hole: Hole) -> bool:
        """Whether all that fits into a hole of the other template fits into one of that kind."""
        slot = self.of.slot(hole.name) if self.of is not None else None
        return slot is not None and (slot.kind is kind or (kind is SlotKind.VALUE and slot.kind is not SlotKind.FLOW))

    def body(self, pattern: Seq, value: Seq) -> bool:
        """A body: its fixed instructions, and between them what its hole takes."""
        if value.hole is not None and not self.holds(pattern, value, value.hole):
            return False
        before, behind = pattern.items[: pattern.hole_at], pattern.items[pattern.hole_at :]
        if pattern.hole is None:
            return pattern.below == value.below and self.fixed(pattern.items, value.items)
        end = len(value.items) - len(behind)
        if end < len(before) or value.below[: len(pattern.below)] != pattern.below:
            return False
        if not self.fixed(before, value.items[: len(before)]) or not self.fixed(behind, value.items[end:]):
            return False
        if not before and not behind and not pattern.below:
            return self.hole(pattern.hole.name, value)
        middle = Seq(items=value.items[len(before) : end], below=value.below[len(pattern.below) :])
        return self.hole(pattern.hole.name, middle)

    def holds(self, pattern: Seq, value: Seq, hole: Hole) -> bool:
        """Whether the hole of a body of the other template is among what a body's own hole takes."""
        slot = self.of.slot(hole.name) if self.of is not None else None
        if pattern.hole is None or slot is None or (slot.repeat and not self.repeats(pattern.hole)):
            return False
        behind = len(pattern.items) - pattern.hole_at
        return pattern.hole_at <= value.hole_at <= len(value.items) - behind

    def fixed(self, patterns: list[Any], values: list[Any]) -> bool:
        """Instructions of the template itself; a comment at one of them has no place in a vertex."""
        if len(patterns) != len(values):
            return False
        for pattern, value in zip(patterns, values, strict=True):
            if isinstance(value, Instruction) and (value.above or value.after is not None):
                return False
            if not self.node(pattern, value):
                return False
        return True

    def row(self, patterns: list[Any], values: list[Any]) -> bool:
        """Branches or parameters: one by one, and a repeated slot takes what the others leave."""
        for at, pattern in enumerate(patterns):
            if isinstance(pattern, Seq) and pattern.hole is not None and self.repeats(pattern.hole):
                rest = len(values) - (len(patterns) - at - 1)
                if rest < at or not self.hole(pattern.hole.name, values[at:rest]):
                    return False
                patterns = patterns[:at] + patterns[at + 1 :]
                values = values[:at] + values[rest:]
                break
        return len(patterns) == len(values) and all(map(self.part, patterns, values))

    def repeats(self, hole: Hole) -> bool:
        slot = self.constructor.slot(hole.name)
        return slot is not None and slot.repeat
