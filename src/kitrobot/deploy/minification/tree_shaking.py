"""Removes the parts of a driver that a program does not use: a small board has no memory for them.

In the method `do(self, procedure, arguments)`, branches for procedures that the program does not call; `done`, when it
calls none that completes later; then constants of the module that are no longer read. In a module that drivers of ours
share, also branches `if kit == "..."` for words that no part gives the setting `kit`, whatever it is called.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class UsedParts:
    """The parts of a driver that a program uses: `procedures`, whether one of them completes later, and the
    settings that it gives, as name and value.
    """

    procedures: frozenset[str] = frozenset()
    later: bool = False
    settings: frozenset[tuple[str, str]] = frozenset()

    def __or__(self, other: UsedParts) -> UsedParts:
        return UsedParts(self.procedures | other.procedures, self.later or other.later, self.settings | other.settings)


def trim_shared_module(tree: ast.Module, used: UsedParts) -> ast.Module:
    """A module that drivers share, without the parts that none of them uses."""
    given: dict[str, set[str]] = {}
    for name, value in used.settings:
        given.setdefault(name, set()).add(value)
    _Words(given).visit(tree)
    return trim_driver(tree, used)


def trim_driver(tree: ast.Module, used: UsedParts) -> ast.Module:
    """The driver without the parts that are not used."""
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            for method in node.body:
                if isinstance(method, ast.FunctionDef) and method.name == "do" and len(method.args.args) > 1:
                    _Branches(method.args.args[1].arg, used.procedures).visit(method)
            if not used.later and not _calls(tree, "done"):
                node.body = [one for one in node.body if not (isinstance(one, ast.FunctionDef) and one.name == "done")]
    read = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}
    tree.body = [node for node in tree.body if _is_read(node, read)]
    return tree


def _calls(tree: ast.Module, name: str) -> bool:
    return any(isinstance(node, ast.Attribute) and node.attr == name for node in ast.walk(tree))


def _is_read(node: ast.stmt, read: set[str]) -> bool:
    match node:
        case ast.Assign(targets=[ast.Name(id=name)], value=ast.Constant()):
            return name in read
    return True


class _Branches(ast.NodeTransformer):
    def __init__(self, procedure: str, procedures: frozenset[str]) -> None:
        self.procedure = procedure
        self.procedures = procedures

    def visit_If(self, node: ast.If) -> ast.AST | list[ast.stmt]:
        self.generic_visit(node)
        match node.test:
            case ast.Compare(left=ast.Name(id=self.procedure), ops=[ast.Eq()], comparators=[ast.Constant(value=name)]):
                names = {name}
            case ast.Compare(left=ast.Name(id=self.procedure), ops=[ast.In()], comparators=[ast.Tuple() as several]):
                names = {one.value for one in several.elts if isinstance(one, ast.Constant)}
                if len(names) < len(several.elts):
                    return node
            case _:
                return node
        return node if names & self.procedures else node.orelse or [ast.Pass()]


class _Words(ast.NodeTransformer):
    """Decides `if kit == "word"`: left out where no part gives that, without the question where all give it."""

    def __init__(self, given: Mapping[str, set[str]]) -> None:
        self.given = given

    def visit_If(self, node: ast.If) -> ast.AST | list[ast.stmt]:
        self.generic_visit(node)
        match node.test:
            case ast.Compare(left=ast.Name(id=name), ops=[ast.Eq()], comparators=[ast.Constant(value=str(word))]) if (
                name in self.given
            ):
                if word not in self.given[name]:
                    return node.orelse or [ast.Pass()]
                if self.given[name] == {word}:
                    return node.body
        return node
