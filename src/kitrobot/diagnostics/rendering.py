"""Diagnostics as text with a caret under the guilty place, and as JSON."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from kitrobot.diagnostics.model import Diagnostic, Source

_WIDEST = 160
"""Characters of a source line that are shown at most, so that a file of one long line stays readable."""


def render_one(diagnostic: Diagnostic, source: Source | None) -> str:
    """`FILE:LINE:COLUMN: severity: message [code]`, the source line, the caret line and the help line."""
    place = diagnostic.place
    where = f"{place.file}:{place.line}:{place.column}: " if place else ""
    lines = [f"{where}{diagnostic.severity}: {diagnostic.message} [{diagnostic.code}]"]
    if place and source:
        text = source.line(place.line)
        until = place.end_column if place.end_line == place.line else len(text) + 1
        first = max(0, place.column - 1 - _WIDEST // 2) if place.column > _WIDEST else 0
        shown = text[first : first + _WIDEST].replace("\t", " ")
        gutter = f"{place.line} | "
        width = max(1, min(until, first + len(shown) + 1) - place.column)
        lines.append(f"  {gutter}{shown}")
        lines.append("  " + " " * len(gutter) + " " * (place.column - 1 - first) + "^" * width)
    if diagnostic.help:
        lines.append(f"  help: {diagnostic.help}")
    return "\n".join(lines)


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
    """`to_json` and where in the graph: {program, vertices, arcs}."""
    return {
        **to_json(diagnostic),
        "program": diagnostic.program,
        "vertices": list(diagnostic.vertices),
        "arcs": [list(arc) for arc in diagnostic.arcs],
    }
