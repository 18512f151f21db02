"""Programs that say themselves what is wrong with them.

An expectation is a comment on the guilty line: `#! CODE@COLUMN message`, where `@COLUMN` may be left out and the
message may be any part of the real one; two on one line are parted by ` || `. Without one a program has no mistake.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from kitrobot.diagnostics.model import Diagnostic

_EXPECTATION = re.compile(r"(?P<code>[a-z-]+)(?:@(?P<column>\d+))?(?: (?P<part>.*))?")


class Expectation(NamedTuple):
    """What must be said about a line."""

    line: int
    code: str
    column: int | None
    part: str


def expectations(text: str) -> list[Expectation]:
    """All expectations of a program, in its order."""
    found = []
    for number, line in enumerate(text.split("\n"), 1):
        _, marker, said = line.partition("#!")
        for one in said.split(" || ") if marker else []:
            match = _EXPECTATION.fullmatch(one.strip())
            assert match is not None, one
            column = int(match["column"]) if match["column"] else None
            found.append(Expectation(number, match["code"], column, match["part"] or ""))
    return found


def meets_expectations(text: str, diagnostics: list[Diagnostic]) -> None:
    """Compares what was told with what the program expects, in order, nothing more and nothing less."""
    wanted = expectations(text)
    told = [
        (item.place.line, item.code, item.place.column, item.message)
        for item in sorted(diagnostics, key=lambda item: (item.place.line, item.place.column) if item.place else (0, 0))
        if item.place is not None
    ]
    assert len(told) == len(diagnostics), "a diagnostic of a text has a place"
    assert [(line, code) for line, code, _, _ in told] == [(one.line, one.code) for one in wanted], told
    for one, (_, _, column, message) in zip(wanted, told, strict=True):
        assert one.column in (None, column), (one, column)
        assert one.part in message, (one, message)
