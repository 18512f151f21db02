"""Rewrites forms of a constructor that are read besides its own LLL (`<reads>`) to its own form."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

from kitrobot.lll.tree import Instruction, Node, Seq
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.match_template import fill_with, unfill
from kitrobot.primitives.templates import shape


def normalise(program: Seq, catalogue: Catalogue) -> None:
    """Changes a program in place; what is written anew keeps its place in the text and its comments."""
    found = nodes(program)
    kinds = {kind for kind, _ in catalogue.reads}
    if not any(type(node) in kinds and _normalised(node, catalogue) is not node for node in found):
        return
    for node in reversed(found):  # what is inside comes first
        for part in fields(node):
            value = getattr(node, part.name)
            if isinstance(value, list):
                value[:] = [_normalised(item, catalogue) for item in value]
            elif isinstance(value, Node):
                setattr(node, part.name, _normalised(value, catalogue))


def _normalised(node: Any, catalogue: Catalogue) -> Any:
    if not isinstance(node, Node) or isinstance(node, Seq):
        return node
    for constructor, template in catalogue.reads.get(shape(node), ()):
        bound = unfill(constructor, template, node)
        if bound is not None:
            made = fill_with(constructor.template, bound)
            made.start, made.end = node.start, node.end
            if isinstance(made, Instruction) and isinstance(node, Instruction):
                made.above, made.after = node.above, node.after
            return made
    return node
