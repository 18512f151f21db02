"""Diagnostics as text with a caret under the guilty place, and as JSON.

The caret counts what a terminal draws: a wide character takes two places, a combining mark none. Characters that would
steer the terminal (a file may hold anything) are shown as U+FFFD, a tab as one space.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Mapping
from typing import Any

from kitrobot.diagnostics.model import Diagnostic, Source

_WIDEST = 160
"""Characters of a source line that are shown at most, so that a file of one long line stays readable."""

_STEERING = frozenset("\u2028\u2029\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")
"""Line breaks beside the line feed, and what turns the direction of writing about."""


def render_one(diagnostic: Diagnostic, source: Source | None) -> str:
    """`FILE:LINE:COLUMN: severity: message [code]`, the source line, the caret line and the help line."""
    place = diagnostic.place
    where = f"{place.file}:{place.line}:{place.column}: " if place else ""
    lines = [_shown(f"{where}{diagnostic.severity}: {diagnostic.message} [{diagnostic.code}]")]
    if place and source:
        text = source.line(place.line)
        until = place.end_column if place.end_line == place.line else len(text) + 1
        first = max(0, place.column - 1 - _WIDEST // 2) if place.column > _WIDEST else 0
        shown = _shown(text[first : first + _WIDEST])
        gutter = f"{place.line} | "
        before, guilty = shown[: place.column - 1 - first], shown[place.column - 1 - first : until - 1 - first]
        lines.append(f"  {gutter}{shown}".rstrip())
        lines.append("  " + " " * (len(gutter) + _width(before)) + "^" * max(1, _width(guilty)))
    if diagnostic.help:
        lines.append(_shown(f"  help: {diagnostic.help}"))
    return "\n".join(lines)


def _shown(text: str) -> str:
    """The text as it may go to a terminal, character for character."""
    if text.isprintable():
        return text
    return "".join(
        " " if one == "\t" else "\ufffd" if unicodedata.category(one) == "Cc" or one in _STEERING else one
        for one in text
    )


def _width(text: str) -> int:
    """How many places a terminal draws it in."""
    return len(text) if text.isascii() else sum(map(_places, text))


def _places(character: str) -> int:
    if unicodedata.category(character) in ("Mn", "Me", "Cf"):
        return 0
    return 2 if unicodedata.east_asian_width(character) in ("W", "F") else 1


def render(diagnostics: Iterable[Diagnostic], sources: Mapping[str, Source] | None = None) -> str:
    """All diagnostics, each with its source line when `sources` (by file name) holds it."""
    known = sources or {}
    return "\n".join(render_one(item, known.get(item.place.file) if item.place else None) for item in diagnostics)


def to_json(diagnostic: Diagnostic) -> dict[str, Any]:
    """The published shape: {file, line, column, end_line, end_column, severity, code, message, help}."""
    place = diagnostic.place
    return {
        "file": place.file if place else "",
        "line": place.line if place else 0,
        "column": place.column if place else 0,
        "end_line": place.end_line if place else 0,
        "end_column": place.end_column if place else 0,
        "severity": diagnostic.severity.value,
        "code": diagnostic.code,
        "message": diagnostic.message,
        "help": diagnostic.help,
    }


def to_page_json(diagnostic: Diagnostic) -> dict[str, Any]:
    """`to_json` and where in the graph: {program, vertices, arcs}, or in a world: {thing}, and what mends it: {fix}."""
    fix = diagnostic.fix
    return {
        **to_json(diagnostic),
        "program": diagnostic.program,
        "vertices": list(diagnostic.vertices),
        "arcs": [list(arc) for arc in diagnostic.arcs],
        "thing": diagnostic.thing,
        "fix": None if fix is None else {"text": fix.text, "kind": fix.kind.value, "name": fix.name},
    }
