"""The answers that an edit waits for, written straight from what was worked out.

A report has an entry for each vertex: making a shape of each, only to write it out, took half as long as compiling. The
dataclasses of the rooms have the fields of the shapes (`ReportShape`, `FollowedShape`); a test holds them to that. Only
problems are shaped, for they are few and said in the reader's language.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import orjson
from fastapi import Response

from kitrobot.compiler import Followed
from kitrobot.diagnostics import Diagnostic
from kitrobot.server.shapes import problem_shapes
from kitrobot.workspace import Report


def report_answer(report: Report) -> Response:
    """A report as `ReportShape`."""
    return _answer(_report(report))


def followed_answer(followed: Followed, report: Report | None, most_problems: int) -> Response:
    """A typed text as `FollowedShape`, with the report of its mission, if there is one."""
    return _answer(
        {
            "program": followed.program,
            "spans": followed.spans,
            "problems": _problems(followed.diagnostics[:most_problems]),
            "report": _report(report) if report is not None else None,
        }
    )


def _report(report: Report) -> dict[str, Any]:
    return {"programs": report.programs, "problems": _problems(report.problems)}


def _problems(diagnostics: Iterable[Diagnostic]) -> list[dict[str, Any]]:
    return [shape.model_dump(mode="json") for shape in problem_shapes(diagnostics)]


def _answer(value: dict[str, Any]) -> Response:
    return Response(orjson.dumps(value), media_type="application/json")
