"""Short names for the names that the modules of `kitrobot_onboard` share: a small board has no memory for long ones.

python-minifier shortens names inside functions; names of functions, classes and attributes that cross modules it must
leave alone, because it sees one module at a time. Here all modules are processed together. A name is shortened when
one of them defines it, and when it cannot be a name of Python, MicroPython or a user's driver. The most used ones get
single letters; other short names depend on the long name alone, so that an unchanged module mostly keeps its bytes.
"""

from __future__ import annotations

import ast
import builtins
import hashlib
import io
import keyword
import string
import struct
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from kitrobot.deploy.minification.builtin_names import GLOBALS, LETTERS, LOCALS

DRIVER_FACE = frozenset({"make", "do", "done", "stop", "read", "show", "tend"})
"""What a driver offers, and what users write."""

_FOREIGN = frozenset(
    name
    for thing in (builtins, str, bytes, bytearray, list, dict, tuple, int, set, io.BytesIO, io.StringIO, struct)
    for name in dir(thing)
)


def short_names(trees: Iterable[ast.Module], more: Iterable[str] = ()) -> dict[str, str]:
    """Long name → short name, for those that may be shortened; `more`: names that no module defines."""
    modules = list(trees)
    kept = set(DRIVER_FACE | _FOREIGN | set(keyword.kwlist))
    defined: set[str] = set(more)
    for tree in modules:
        defined.update(_defined(tree))
        kept.update(_others(tree))
    taken = kept | {node.id for tree in modules for node in ast.walk(tree) if isinstance(node, ast.Name)}
    wanted = {name for name in defined - kept if len(name) > 1 and not name.startswith("__")}
    uses = Counter(node.id for tree in modules for node in ast.walk(tree) if isinstance(node, ast.Name))
    often = sorted(wanted, key=lambda name: (-uses[name], name))[: len(LETTERS)]
    names = dict(zip(often, LETTERS, strict=False))
    for name in sorted(wanted - set(often)):
        names[name] = next(one for one in _candidates(name) if one not in taken)
        taken.add(names[name])
    return names


def own_names(tree: ast.Module) -> dict[str, str]:
    """Short names for the classes, functions and constants of a module that nobody imports but for its `make`."""
    names = {node.name for node in tree.body if isinstance(node, ast.ClassDef | ast.FunctionDef)}
    names |= {name for node in tree.body if isinstance(node, ast.Assign) for name in _stored(node)}
    attributes = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    named = {word.arg for word in ast.walk(tree) if isinstance(word, ast.keyword)}
    taken = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)} | attributes
    free = iter(word for word in GLOBALS if word not in taken)
    kept = DRIVER_FACE | attributes | named
    return {name: next(free) for name in sorted(names) if name not in kept and not name.startswith("__")}


def renamed(tree: ast.Module, names: Mapping[str, str]) -> ast.Module:
    """The module with the short names."""
    _rename(tree, names)
    return tree


def _rename(tree: ast.AST, names: Mapping[str, str], *, variables: bool = False) -> None:
    """Gives new names to all that have one of these; `variables`: attributes, and what modules offer, keep theirs."""
    for node in ast.walk(tree):
        match node:
            case ast.Name():
                node.id = names.get(node.id, node.id)
            case ast.Attribute() if not variables:
                node.attr = names.get(node.attr, node.attr)
            case ast.FunctionDef() | ast.ClassDef():
                node.name = names.get(node.name, node.name)
            case ast.arg():
                node.arg = names.get(node.arg, node.arg)
            case ast.Global() | ast.Nonlocal():
                node.names = [names.get(name, name) for name in node.names]
            case ast.ExceptHandler() if node.name:
                node.name = names.get(node.name, node.name)
            case ast.ImportFrom() if not variables and (node.module or "").startswith("kitrobot_onboard."):
                for alias in node.names:
                    _rename_import(alias, names, ours=True)
            case ast.Import() | ast.ImportFrom():
                for alias in node.names:
                    _rename_import(alias, names, ours=False)


def with_known_locals(tree: ast.Module) -> ast.Module:
    """The module with names for the variables of its functions that cost a small board nothing.

    Left as they are: those that somebody names in a call, and those that are the module's or another function's.
    """
    named = {word.arg for word in ast.walk(tree) if isinstance(word, ast.keyword)}
    for function in _outermost_functions(tree):
        count = Counter(_variables(function))
        others = {node.id for node in ast.walk(function) if isinstance(node, ast.Name)} - set(count)
        others |= {name for node in ast.walk(function) if isinstance(node, ast.Global) for name in node.names}
        mine = [name for name, _ in count.most_common() if name not in others | named]
        taken = others | (set(count) - set(mine))
        words = [word for word in LOCALS if word not in taken]
        own = function.name
        _rename(function, dict(zip(mine, words, strict=False)), variables=True)
        function.name = own
    return tree


def _outermost_functions(tree: ast.AST) -> Iterator[ast.FunctionDef]:
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.FunctionDef):
            yield node
        else:
            yield from _outermost_functions(node)


def _variables(function: ast.FunctionDef) -> Iterator[str]:
    """The variables of a function and of those inside it, each as often as it stands there."""
    stored = {node.id for node in ast.walk(function) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
    for node in ast.walk(function):
        match node:
            case ast.arg(arg=name) | ast.ExceptHandler(name=str(name)):
                stored.add(name)
            case ast.FunctionDef(name=name) if node is not function:
                stored.add(name)
            case ast.Import() | ast.ImportFrom():
                stored.update(alias.asname or alias.name for alias in node.names)
    for node in ast.walk(function):
        match node:
            case ast.Name(id=name) | ast.arg(arg=name) | ast.ExceptHandler(name=str(name)) if name in stored:
                yield name
            case ast.FunctionDef(name=name) if node is not function:
                yield name
            case ast.Import() | ast.ImportFrom():
                yield from (alias.asname or alias.name for alias in node.names)


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
    yield from _stored(tree)


def _stored(node: ast.AST) -> Iterator[str]:
    """Variables of the module itself."""
    for child in ast.iter_child_nodes(node):
        match child:
            case ast.FunctionDef() | ast.ClassDef():
                continue
            case ast.Name(id=name, ctx=ast.Store()) | ast.ExceptHandler(name=str(name)) | ast.alias(asname=str(name)):
                yield name
        yield from _stored(child)


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
    for _ in GLOBALS:
        yield GLOBALS[number % len(GLOBALS)]
        number += 1
    while True:
        yield string.ascii_letters[number % 52] + string.ascii_letters[number // 52 % 52]
        number += 1
