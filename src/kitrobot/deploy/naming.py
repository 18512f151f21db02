"""Short names for what the modules of `kitrobot_onboard` call one another: a small board has no room for long ones.

python-minifier shortens names inside functions; names of functions, classes and attributes that cross modules it must
leave alone, because it sees one module at a time. Here all modules are seen at once. A name is shortened when it is
defined in one of them, and when nothing that others made (Python, MicroPython, a driver of somebody's own) may be meant
by it. The short name hangs on the name alone, so a module that did not change stays as it was.
"""

from __future__ import annotations

import ast
import builtins
import hashlib
import io
import keyword
import string
import struct
from collections.abc import Iterable, Iterator, Mapping

DRIVER_FACE = frozenset({"make", "do", "done", "stop", "read", "show"})
"""What a driver offers, and what users write."""

_FOREIGN = frozenset(
    name
    for thing in (builtins, str, bytes, bytearray, list, dict, tuple, int, set, io.BytesIO, io.StringIO, struct)
    for name in dir(thing)
)
_LETTERS = string.ascii_letters


def short_names(trees: Iterable[ast.Module], first: ast.Module) -> dict[str, str]:
    """Long name → short name, for those that may be shortened; the words of `first`, which is `main.py`, are kept."""
    modules = list(trees)
    kept = set(DRIVER_FACE | _FOREIGN | set(keyword.kwlist))
    kept.update(node.attr for node in ast.walk(first) if isinstance(node, ast.Attribute))
    kept.update(_others(first))
    defined: set[str] = set()
    for tree in modules:
        defined.update(_defined(tree))
        kept.update(_others(tree))
    taken = kept | {node.id for tree in modules for node in ast.walk(tree) if isinstance(node, ast.Name)}
    names: dict[str, str] = {}
    for name in sorted(defined - kept):
        if len(name) < 3 or name.startswith("__"):
            continue
        short = next(one for one in _candidates(name) if one not in taken)
        taken.add(short)
        names[name] = short
    return names


def renamed(tree: ast.Module, names: Mapping[str, str]) -> ast.Module:
    """The module with the short names."""
    for node in ast.walk(tree):
        match node:
            case ast.Name():
                node.id = names.get(node.id, node.id)
            case ast.Attribute():
                node.attr = names.get(node.attr, node.attr)
            case ast.FunctionDef() | ast.ClassDef():
                node.name = names.get(node.name, node.name)
            case ast.arg():
                node.arg = names.get(node.arg, node.arg)
            case ast.Global() | ast.Nonlocal():
                node.names = [names.get(name, name) for name in node.names]
            case ast.ExceptHandler() if node.name:
                node.name = names.get(node.name, node.name)
            case ast.ImportFrom() if (node.module or "").startswith("kitrobot_onboard."):
                for alias in node.names:
                    _rename_import(alias, names, ours=True)
            case ast.Import() | ast.ImportFrom():
                for alias in node.names:
                    _rename_import(alias, names, ours=False)
    return tree


def with_short_parameters(tree: ast.Module) -> ast.Module:
    """The module with letters for the parameters of its functions: its calls name none of them."""
    for function in tree.body:
        if isinstance(function, ast.FunctionDef):
            letters = {given.arg: _LETTERS[number] for number, given in enumerate(function.args.args)}
            taken = {node.id for node in ast.walk(function) if isinstance(node, ast.Name)} - set(letters)
            if taken & set(letters.values()):
                continue
            for node in ast.walk(function):
                if isinstance(node, ast.Name):
                    node.id = letters.get(node.id, node.id)
                elif isinstance(node, ast.arg):
                    node.arg = letters.get(node.arg, node.arg)
    return tree


def _rename_import(alias: ast.alias, names: Mapping[str, str], *, ours: bool) -> None:
    bound = alias.asname or alias.name
    wanted = names.get(bound, bound)
    if ours:
        alias.name = names.get(alias.name, alias.name)
    alias.asname = wanted if wanted != alias.name else None


def _defined(tree: ast.Module) -> Iterator[str]:
    """Names of functions, classes, module variables and attributes of `self`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node.attr
    for statement in tree.body:
        for node in ast.walk(statement) if isinstance(statement, ast.Assign) else ():
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                yield node.id


def _others(tree: ast.Module) -> Iterator[str]:
    """Names that others made: what is imported from elsewhere, attributes of that, names in strings."""
    foreign = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            ours = isinstance(node, ast.ImportFrom) and (node.module or "").startswith("kitrobot_onboard")
            for alias in node.names:
                if not ours:
                    yield alias.name
                    foreign.add(alias.asname or alias.name)
                else:
                    module = f"{node.module}.{alias.name}" if isinstance(node, ast.ImportFrom) else ""
                    yield from module.split(".")[:-1]
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value.isidentifier():
            yield node.value
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute):
            root = node.value
            while isinstance(root, ast.Attribute | ast.Call | ast.Subscript):
                root = root.func if isinstance(root, ast.Call) else root.value
            if isinstance(root, ast.Name) and root.id in foreign:
                yield node.attr


def _candidates(name: str) -> Iterator[str]:
    number = int.from_bytes(hashlib.sha256(name.encode()).digest()[:4], "big")
    while True:
        yield _LETTERS[number % 52] + _LETTERS[number // 52 % 52]
        number += 1
