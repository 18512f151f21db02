"""What is wrong, on the wire."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from pydantic import BaseModel

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.diagnostics.renderer import to_page_json
from kitrobot.wire.sentences import Clause, FileName, Spoken


class FixShape(BaseModel):
    """The one right answer: `text` for the place, and what that is in a graph."""

    text: str
    kind: Literal["text", "element", "setting", "unset", "unwrap", "before"]
    name: str


class ProblemShape(BaseModel):
    """A diagnostic; lines and columns count from 1 and are 0 where there is no file."""

    file: FileName
    line: int
    column: int
    end_line: int
    end_column: int
    severity: Literal["error", "warning", "hint"]
    code: str
    message: Clause
    help: Clause
    program: str
    vertices: list[str]
    arcs: list[tuple[str, str, str, str]]
    thing: str = ""
    fix: FixShape | None = None


class RequestFailureShape(BaseModel):
    """Why a request could not be done: a sentence and a way out; `problems` where a file was the reason."""

    message: Spoken
    help: Spoken
    problems: list[ProblemShape] = []


def problem_shapes(diagnostics: Iterable[Diagnostic]) -> list[ProblemShape]:
    """Diagnostics as they travel."""
    return [ProblemShape.model_validate(to_page_json(diagnostic)) for diagnostic in diagnostics]
