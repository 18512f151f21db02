"""Filling backwards: what stands in the holes of a template, given LLL that may be made from it.

The fixed part of the template must be there word for word, without comments of its own; a hole takes whatever stands in
its place. A hole that occurs twice must hold the same twice.
"""

from __future__ import annotations

from dataclasses import fields
from typing import Any

from kitrobot.lll import Hole, Instruction, Node, Number, Seq
from kitrobot.primitives import Constructor, SlotKind

Bound = dict[str, Any]
"""Hole name → the part that stands there: a number, a node, a body; a repeated body gives the list of all branches."""

_PLACES = frozenset(("start", "end", "vertex", "above", "after", "method_start"))


def unfill(constructor: Constructor, template: Node, node: Node, *, any_number: bool = False) -> Bound | None:
    """The parts of `node` that stand in the holes of `template`; None where it is not made from it.

    `any_number`: numbers outside the range of their slot fit too.
    """
    bound: Bound = {}
    return bound if _Unfilling(constructor, bound, any_number).node(template, node) else None


def unfill_all(constructor: Constructor, templates: list[Any], nodes: list[Any]) -> Bound | None:
    """The same for a row of instructions; comments may stand above the first and behind the last only."""
    bound: Bound = {}
    matching = _Unfilling(constructor, bound, any_number=False)
    if len(templates) != len(nodes) or any(node.above for node in nodes[1:]) or any(node.after for node in nodes[:-1]):
        return None
    return bound if all(map(matching.node, templates, nodes)) else None


def unfill_row(constructor: Constructor, template: Seq, nodes: list[Any]) -> Bound | None:
    """The same for a row of instructions with a hole among them, which takes what the others leave."""
    assert template.hole is not None, "a row without a hole is unfilled as a whole"
    bound: Bound = {}
    matching = _Unfilling(constructor, bound, any_number=False)
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


class _Unfilling:
    def __init__(self, constructor: Constructor, bound: Bound, any_number: bool) -> None:
        self.constructor = constructor
        self.any_number = any_number
        self.bound = bound

    def node(self, template: Any, node: Any) -> bool:
        if type(template) is not type(node):
            return False
        for part in fields(template):
            if part.name in _PLACES:
                continue
            if not self.part(getattr(template, part.name), getattr(node, part.name)):
                return False
        return True

    def part(self, pattern: Any, value: Any) -> bool:
        if isinstance(pattern, Hole):
            return self.hole(pattern.name, value)
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
        if isinstance(number, int) and not self.any_number:
            if slot.minimum is not None and number < slot.minimum:
                return False
            if slot.maximum is not None and number > slot.maximum:
                return False
        elif not isinstance(number, int) and slot.kind in (SlotKind.NUMBER, SlotKind.TEXT):
            return False
        if name in self.bound:
            return bool(self.bound[name] == value)
        self.bound[name] = value
        return True

    def body(self, pattern: Seq, value: Seq) -> bool:
        """A body: its fixed instructions, and between them what its hole takes."""
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
