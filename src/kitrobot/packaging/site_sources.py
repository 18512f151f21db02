"""Python sources as a static site sends them: without docstrings and lines of comments, each statement on its line.

Nothing that runs reads these texts there, and a third of what travels would be of them. The standard library comes
without what no server imports. Sources that the Python here cannot read (those of a newer one) stay as they are.
"""

from __future__ import annotations

import ast
import warnings
from collections.abc import Iterable, Iterator
from types import CodeType
from typing import Final

_DOCUMENTED: Final = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
_DOC: Final = "Doc"
"""What annotations are documented with (`typing_extensions`)."""

_OF_CODE: Final = ("co_name", "co_names", "co_varnames", "co_freevars", "co_cellvars", "co_flags", "co_firstlineno")

_NAMES: Final = """
    __phello__ _aix_support _android_support _apple_support _ios_support _osx_support _pydatetime _pyio
    _pyrepl antigravity argparse bdb cProfile cmd compileall configparser ctypes curses dbm doctest
    ensurepip filecmp fileinput ftplib getopt getpass imaplib lib2to3 mailbox modulefinder msilib
    multiprocessing netrc nntplib nturl2path optparse pdb pickletools pipes plistlib poplib profile
    profiling pstats pty pyclbr pydoc pydoc_data rlcompleter sched shelve smtplib socketserver sqlite3
    symtable tabnanny telnetlib test this tkinter trace tracemalloc tty turtle turtledemo
    unittest venv wave wsgiref xdrlib xmlrpc zipapp
"""
NOT_IMPORTED: Final = frozenset(_NAMES.split())
"""Modules of the standard library that are left out."""
_LEFT_OUT: Final = (
    *("xml/dom/", "xml/sax/", "asyncio/windows_", "asyncio/proactor_", "concurrent/futures/process.py"),
    *("concurrent/interpreters/", "http/cookiejar.py", "http/server.py", "logging/config.py", "logging/handlers.py"),
)
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
        nodes = list(ast.walk(tree))
        texts = list(_documenting(nodes))
        made = _without(source, texts, _inside_texts(nodes))
        for text in texts:
            text.value = ""
        same = _same(_compiled(tree), _compiled(made))
    except (SyntaxError, ValueError):
        return source
    return made if same else source


def _without(source: bytes, texts: Iterable[ast.Constant], inside: set[int]) -> bytes:
    """The source with `""` in place of the texts; lines that begin inside of a text are no comments."""
    lines = source.split(b"\n")
    for row, line in enumerate(lines, 1):
        if row not in inside and line.lstrip().startswith(b"#"):
            lines[row - 1] = b""
    for text in sorted(texts, key=lambda text: (text.lineno, text.col_offset), reverse=True):
        first, last = text.lineno, text.end_lineno or 0
        lines[first - 1] = lines[first - 1][: text.col_offset] + b'""' + lines[last - 1][text.end_col_offset or 0 :]
        lines[first:last] = [b""] * (last - first)
    return b"\n".join(lines)


def _inside_texts(nodes: Iterable[ast.AST]) -> set[int]:
    """The lines that begin in a text."""
    inside: set[int] = set()
    for node in nodes:
        if isinstance(node, (ast.Constant, ast.JoinedStr)) and node.end_lineno != node.lineno:
            inside.update(range(node.lineno + 1, (node.end_lineno or 0) + 1))
    return inside


def _documenting(nodes: Iterable[ast.AST]) -> Iterator[ast.Constant]:
    for node in nodes:
        value: ast.expr | None = None
        if isinstance(node, _DOCUMENTED) and node.body and isinstance(node.body[0], ast.Expr):
            value = node.body[0].value
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == _DOC and node.args:
            value = node.args[0]
        if isinstance(value, ast.Constant) and isinstance(value.value, str):
            yield value


def _compiled(module: ast.Module | bytes) -> CodeType:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        code: CodeType = compile(module, "", "exec", dont_inherit=True)
        return code


def _same(one: object, other: object) -> bool:
    """Whether two constants are the same; of code, whether it does the same, wherever it stands in its line."""
    if isinstance(one, CodeType) and isinstance(other, CodeType):
        return (
            one.co_code == other.co_code
            and all(getattr(one, name) == getattr(other, name) for name in _OF_CODE)
            and len(one.co_consts) == len(other.co_consts)
            and all(map(_same, one.co_consts, other.co_consts))
        )
    if isinstance(one, frozenset) and isinstance(other, frozenset):
        return one == other
    return type(one) is type(other) and repr(one) == repr(other)
