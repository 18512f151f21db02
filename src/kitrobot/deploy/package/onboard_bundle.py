"""The modules of `kitrobot_onboard` as they are installed on a board: minified, in pieces, with shared short names.

The modules of the loop share one namespace on a board, so they need no imports of one another.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path

import kitrobot_onboard
from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.minification.builtin_names import GLOBALS, LOCALS
from kitrobot.deploy.minification.constants import Constants, constants_of, inline_constants
from kitrobot.deploy.minification.minifier import parsed, shortened
from kitrobot.deploy.minification.short_names import renamed, short_names
from kitrobot.diagnostics.read_files import note_read
from kitrobot.text.sentences import Sentence, Word
from kitrobot_onboard.requests import BY_FAMILY, REQUESTS

ONBOARD = Path(kitrobot_onboard.__file__).parent
ROOT = "kitrobot_onboard"
_MOST_BYTES = 200_000
_LARGE = "imk"
"""Requests whose words are not named before: they differ from board to board, belong to some programs only, or are
asked once."""

_WORDS = 8
_PIECE = 90
"""Letters of a piece of a script, where a statement needs no more."""

LOOP = ("reports", "reaction", "robot", "link", "dispatch", "receive", "actuation", "request_checks", "device_setup")
"""Modules of the loop in the order in which a board compiles them: the largest first, because there is less and less
room for it."""

_SCRIPTED = ("requests", "driver", "error", "package", "space", "where", "memory", "place", "spot", "tail")
"""Names of variables that only a program file has."""

LITERAL_NAMES = tuple(f"literal{number}" for number in range(24))
"""Names for strings and bytes of functions in flash."""

_COMPOUND = re.compile(r"(if|for|def|while|try|with|class)\b")

_NOT_LINKED = ("__init__.py", "arrays.py", "flash.py", "image.py", "receiver.py")
"""Modules of `kitrobot_onboard` that share no names with the others on a board."""


def loop_files() -> Sequence[Path]:
    """The modules of the loop."""
    return [ONBOARD / f"{name}.py" for name in LOOP]


def linked_trees(names: Iterable[str]) -> list[ast.Module]:
    """Modules whose names share a space with those of others, without imports of ours."""
    return [_tree(ONBOARD / f"{name}.py") for name in names]


@cache
def _tree(path: Path) -> ast.Module:
    """A module whose names share a space with those of others, so that it needs no imports of ours."""
    tree = parsed(read_source(path), str(path))
    tree = renamed(inline_constants(tree, constants_of(tree), _constants()), module_names())
    tree.body = [
        statement
        for statement in tree.body
        if not (isinstance(statement, ast.ImportFrom) and (statement.module or "").startswith(ROOT))
    ]
    return tree


@cache
def minified_module(path: Path) -> bytes:
    """A module of the package, short."""
    return short_text(ast.unparse(_tree(path))).encode()


@cache
def script_pieces(name: str) -> Sequence[str]:
    """A script of the package in pieces, each short enough that a small board can compile it while a program runs."""
    return join_statements([short_text(ast.unparse(statement)) for statement in _tree(ONBOARD / f"{name}.py").body])


def join_statements(statements: Iterable[str]) -> list[str]:
    """Statements in pieces: short ones that stand in one line together, others each by itself."""
    found: list[str] = []
    room = 0
    for text in statements:
        if not text:
            continue  # a docstring
        plain = not _COMPOUND.match(text)
        if plain and found and len(text) < room:
            found[-1] += ";" + text
            room -= 1 + len(text)
        else:
            found.append(text)
            room = _PIECE - len(text) if plain else 0
    return found


@cache
def name_pieces() -> Sequence[str]:
    """What the answers that a small board compiles need names of, in pieces that do nothing but name them.

    A name is kept for ever, wherever there was room when it was first read; among the working memory of a program, it
    would cut that in two.
    """
    found: set[str | bytes] = set()
    for name in {name for kind, names in REQUESTS.items() if kind not in _LARGE for name in names}:
        for node in (one for piece in script_pieces(f"requests/{name}") for one in ast.walk(ast.parse(piece))):
            match node:
                case ast.Name(id=word) | ast.Attribute(attr=word) | ast.Constant(value=str(word) | bytes(word)):
                    found.add(word)
                case ast.Import():
                    found.update(alias.name for alias in node.names)
    listed = [repr(word) for word in sorted(found, key=repr) if word not in {*GLOBALS, *LOCALS}]
    return [",".join(listed[at : at + _WORDS]) for at in range(0, len(listed), _WORDS)]


def requests_file(family: str) -> bytes:
    """The file that a board reads to answer requests: each piece of an answer behind its letter and its size."""
    found = ""
    for kind, names in REQUESTS.items():
        for name in BY_FAMILY.get(family, {}).get(kind, names):
            found += "".join(f"{kind}{len(piece):03}{piece}" for piece in script_pieces(f"requests/{name}"))
    return found.encode()


@cache
def _linked_modules() -> frozenset[Path]:
    """The modules that call one another; drivers are called by fixed names only."""
    return frozenset(
        path
        for folder in (ONBOARD, ONBOARD / "ports", ONBOARD / "requests")
        for path in folder.glob("*.py")
        if path.name not in _NOT_LINKED
    )


@cache
def _constants() -> Mapping[str, Constants]:
    return {f"{ROOT}.{path.stem}": constants_of(parsed(read_source(path), path.name)) for path in _linked_modules()}


@cache
def module_names() -> Mapping[str, str]:
    """The short names on a board of the names that the modules of the package share."""
    trees = [parsed(read_source(path), path.name) for path in sorted(_linked_modules())]
    plain = [inline_constants(tree, constants_of(tree), _constants()) for tree in trees]
    return short_names(plain, (*_SCRIPTED, *LITERAL_NAMES))


_MARKED = re.compile(r"\$(\w+)")


def with_short_names(text: str) -> str:
    """A text in which each `$NAME` is replaced by its short name on a board."""
    names = module_names()
    return _MARKED.sub(lambda found: names.get(found[1], found[1]), text)


@cache
def short_text(text: str) -> str:
    """A text of Python, short."""
    return shortened(ast.parse(text))


def read_source(path: Path) -> str:
    """Returns the text of a module.

    Raises:
        PackageError: it cannot be read, is too large, or no UTF-8.
    """
    try:
        note_read(path)
        data = path.read_bytes()
        if len(data) > _MOST_BYTES:
            raise PackageError(
                Sentence("`{path}` is too large for a board: {size} bytes", path, len(data)),
                Sentence("make it shorter"),
            )
        return data.decode("utf-8-sig")
    except OSError as error:
        raise PackageError(
            Sentence("`{path}` cannot be read: {reason}", path, Word(error.strerror)), Sentence("look at its rights")
        ) from error
    except UnicodeDecodeError:
        raise PackageError(Sentence("`{path}` is no UTF-8 text", path), Sentence("save it as UTF-8")) from None
