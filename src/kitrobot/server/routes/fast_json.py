"""JSON of the answers to an edit, written without models: they are what an edit waits for.

A report has an entry for each vertex: making a shape of each, only to write it out, took half as long as compiling. So
they are written as plain dictionaries with the fields of the shapes (`ReportShape`, `FollowedShape`); a test holds
them to that. Only problems are models, for they are few and translated into the reader's language.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from fastapi import Response

from kitrobot.compiler.graph.vertex_places import VertexPlace
from kitrobot.compiler.text.text_edit import TextEdit
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.graph.model import Arc, Program, Vertex
from kitrobot.lll.tree import TeamProgram
from kitrobot.text.json_text import to_json
from kitrobot.wire.mission import DeclaredShape
from kitrobot.wire.problem import problem_shapes
from kitrobot.workspace.program_report import Report


def report_answer(report: Report) -> Response:
    """A report as `ReportShape`."""
    return _answer(_report(report))


def followed_answer(followed: TextEdit, report: Report | None, most_problems: int) -> Response:
    """A text typed over a program as `FollowedShape`, with the report of its mission, if there is one."""
    drawn = followed.program
    printed = {one.name: one.lll for one in report.programs} if report is not None else {}
    same = drawn is not None and printed.get(drawn.name) == followed.source.text
    return _answer(
        {
            "program": _program(drawn) if drawn is not None else None,
            "spans": None if same else _spans(followed.spans),
            "problems": None if same else _problems(followed.diagnostics[:most_problems]),
            "report": _report(report) if report is not None else None,
            "declared": _declared(followed.team) if drawn is not None else None,
        }
    )


def _declared(team: TeamProgram | None) -> dict[str, Any] | None:
    return None if team is None else DeclaredShape.model_validate(team).model_dump(mode="json")


def _report(report: Report) -> dict[str, Any]:
    programs = [
        {"name": one.name, "lll": one.lll, "spans": _spans(one.spans), "instructions": one.instructions}
        for one in report.programs
    ]
    projections = [
        {
            "robot": one.robot,
            "lll": one.lll,
            "spans": [
                {"vertex": at.vertex, "start": at.start, "end": at.end, "line": at.line, "program": at.program}
                for at in one.spans
            ],
        }
        for one in report.projections
    ]
    return {"programs": programs, "problems": _problems(report.problems), "projections": projections}


def _program(program: Program) -> dict[str, Any]:
    return {
        "name": program.name,
        "robot": program.target,
        "level": program.level.value,
        "vertices": [_vertex(one) for one in program.vertices],
        "arcs": [_arc(one) for one in program.arcs],
    }


# By hand: orjson takes twice as long over a dataclass with slots.
def _vertex(one: Vertex) -> dict[str, Any]:
    notes = [{"text": note.text, "at": note.at} for note in one.notes]
    return {"id": one.id, "element": one.element, "settings": one.settings, "notes": notes, "unknown": one.unknown}


def _arc(one: Arc) -> dict[str, Any]:
    return {"source": one.source, "target": one.target, "out": one.out, "at": one.at}


def _spans(spans: Iterable[VertexPlace]) -> list[dict[str, Any]]:
    return [{"vertex": one.vertex, "start": one.start, "end": one.end, "line": one.line} for one in spans]


def _problems(diagnostics: Iterable[Diagnostic]) -> list[dict[str, Any]]:
    return [shape.model_dump(mode="json") for shape in problem_shapes(diagnostics)]


def _answer(value: dict[str, Any]) -> Response:
    return Response(to_json(value), media_type="application/json")
