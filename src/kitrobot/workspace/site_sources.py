"""Python sources as a static site sends them: without docstrings and lines of comments, each statement on its line.

Nothing that runs reads these texts there, and a third of what travels would be of them. The standard library comes
without what no server imports. Sources that the Python here cannot read (those of a newer one) stay as they are.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import Final

_DOCUMENTED: Final = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
_DOC: Final = "Doc"
"""What annotations are documented with (`typing_extensions`)."""

_NAMES: Final = """
    _aix_support _android_support _apple_support _ios_support _osx_support _pyio _pyrepl __phello__ antigravity
    bdb cProfile cmd compileall ctypes curses dbm doctest ensurepip fileinput filecmp ftplib getpass imaplib
    lib2to3 mailbox modulefinder msilib netrc nntplib nturl2path optparse pdb pickletools pipes plistlib poplib
    profile profiling pstats pty pyclbr pydoc pydoc_data rlcompleter sched shelve smtplib sqlite3 symtable
    tabnanny telnetlib test this tkinter trace tty turtle turtledemo unittest venv wsgiref xdrlib xmlrpc zipapp
"""
NOT_IMPORTED: Final = frozenset(_NAMES.split())
"""Modules of the standard library that are left out."""
_LEFT_OUT: Final = ("xml/dom/", "xml/sax/", "asyncio/windows_", "asyncio/proactor_")
_ENCODINGS: Final = (
    *("big5", "cp", "euc_", "gb", "hp_", "hz", "iso", "johab", "koi8", "kz1048", "mac_", "ptcp", "shift_", "tis_"),
)
_NEEDED_ENCODINGS: Final = ("cp437", "cp1252")


def in_library(name: str) -> bool:
    """Whether a file of the standard library's archive is sent."""
    head, _, rest = name.partition("/")
    if head.removesuffix(".py") in NOT_IMPORTED or name.startswith(_LEFT_OUT):
        return False
    encoding = rest.removesuffix(".py")
    return head != "encodings" or encoding in _NEEDED_ENCODINGS or not encoding.startswith(_ENCODINGS)


def without_texts(source: bytes) -> bytes:
    """A module's source (UTF-8) without docstrings, and without lines that are only a comment."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return source
    lines = source.split(b"\n")
    inside = _inside_texts(tree)
    for row, line in enumerate(lines, 1):
        if row not in inside and line.lstrip().startswith(b"#"):
            lines[row - 1] = b""
    for (first, begin), (last, end) in sorted(_texts(tree), reverse=True):
        lines[first - 1] = lines[first - 1][:begin] + b'""' + lines[last - 1][end:]
        lines[first:last] = [b""] * (last - first)
    made = b"\n".join(lines)
    return made if _same(tree, made) else source


def _inside_texts(tree: ast.Module) -> set[int]:
    """The lines that begin in a text."""
    inside: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, (ast.Constant, ast.JoinedStr)) and node.end_lineno != node.lineno:
            inside.update(range(node.lineno + 1, (node.end_lineno or 0) + 1))
    return inside


Place = tuple[int, int]
"""Line and byte."""


def _texts(tree: ast.Module) -> Iterator[tuple[Place, Place]]:
    for text in _documenting(tree):
        yield (text.lineno, text.col_offset), (text.end_lineno or 0, text.end_col_offset or 0)


def _documenting(tree: ast.Module) -> Iterator[ast.Constant]:
    for node in ast.walk(tree):
        value: ast.expr | None = None
        if isinstance(node, _DOCUMENTED) and node.body and isinstance(node.body[0], ast.Expr):
            value = node.body[0].value
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == _DOC and node.args:
            value = node.args[0]
        if isinstance(value, ast.Constant) and isinstance(value.value, str):
            yield value


def _same(tree: ast.Module, made: bytes) -> bool:
    """Whether it is the same program, but for these texts."""
    for text in _documenting(tree):
        text.value = ""
    return ast.dump(tree) == ast.dump(ast.parse(made))
