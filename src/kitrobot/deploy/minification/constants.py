"""Named constants are replaced by their numbers: on a small board a name takes memory wherever it is used.

A constant is a name in capitals that a module assigns a whole number at its top level, once. Its uses are replaced in
that module and in those that import it, and its definition is left out.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Mapping

Constants = Mapping[str, int]
"""Name → number."""


def constants_of(tree: ast.Module) -> dict[str, int]:
    """The constants of a module."""
    stores = Counter(
        node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    )
    return {
        name: value
        for statement in tree.body
        if (found := _definition(statement)) is not None
        for name, value in [found]
        if stores[name] == 1
    }


def inline_constants(tree: ast.Module, own: Constants, modules: Mapping[str, Constants]) -> ast.Module:
    """The module without constants. `modules`: those of the modules it may import from, by their full names."""
    known = dict(own)
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module is not None and node.module in modules:
            theirs = modules[node.module]
            known |= {alias.asname or alias.name: theirs[alias.name] for alias in node.names if alias.name in theirs}
            node.names = [alias for alias in node.names if alias.name not in theirs]
    tree.body = [
        statement
        for statement in tree.body
        if not (isinstance(statement, ast.ImportFrom) and not statement.names)
        and ((found := _definition(statement)) is None or found[0] not in own)
    ]
    in_place = _ConstantInliner(known).visit(tree)
    assert isinstance(in_place, ast.Module)
    return in_place


def _definition(statement: ast.stmt) -> tuple[str, int] | None:
    match statement:
        case ast.Assign(targets=[ast.Name(id=name)], value=ast.Constant(value=int() as value)) if name.isupper():
            return name, value
    return None


class _ConstantInliner(ast.NodeTransformer):
    def __init__(self, known: Constants) -> None:
        self.known = known

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if isinstance(node.ctx, ast.Load) and node.id in self.known:
            return ast.copy_location(ast.Constant(self.known[node.id]), node)
        return node
