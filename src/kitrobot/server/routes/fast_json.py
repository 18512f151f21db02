"""JSON of the answers to an edit, written without models: they are what an edit waits for.

A report has an entry for each vertex: making a shape of each, only to write it out, took half as long as compiling. So
they are written as plain dictionaries with the fields of the shapes (`ReportShape`, `FollowedShape`); a test holds
them to that. Only problems are models, for they are few and translated into the reader's language.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from fastapi import Response

from kitrobot.compiler.text_edit import Followed
from kitrobot.compiler.vertex_places import VertexPlace
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.graph.model import Arc, Program, Vertex
from kitrobot.lll.tree import TeamProgram
from kitrobot.text.affixes import common_affixes
from kitrobot.text.json_text import to_json
from kitrobot.wire.list_delta import encode_delta
from kitrobot.wire.mission import DeclaredShape
from kitrobot.wire.problem import problem_shapes
from kitrobot.workspace.mission_loader import Report
from kitrobot.workspace.program_report import ProgramReport

Bases = Mapping[str, ProgramReport]
"""By the names of programs, the reports that whoever asks has of them."""


def report_answer(report: Report, bases: Bases) -> Response:
    """A report as `ReportShape`."""
    return _answer(_report(report, bases))


def followed_answer(
    before: Program, followed: Followed, report: Report | None, bases: Bases, most_problems: int
) -> Response:
    """A text typed over a program as `FollowedShape`, with the report of its mission, if there is one."""
    same = followed.printed and report is not None
    return _answer(
        {
            "program": _drawn(before, followed.program) if followed.program is not None else None,
            "spans": None if same else _spans(followed.spans),
            "problems": None if same else _problems(followed.diagnostics[:most_problems]),
            "report": _report(report, bases) if report is not None else None,
            "declared": _declared(followed.team) if followed.program is not None else None,
        }
    )


def _declared(team: TeamProgram | None) -> dict[str, Any] | None:
    return None if team is None else DeclaredShape.model_validate(team).model_dump(mode="json")


def _report(report: Report, bases: Bases) -> dict[str, Any]:
    programs = [_program(one, bases.get(one.name)) for one in report.programs]
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


def _program(one: ProgramReport, base: ProgramReport | None) -> dict[str, Any]:
    told = {"name": one.name, "instructions": one.instructions, "known": one.known}
    if base is None:
        return {**told, "lll": one.lll, "spans": _spans(one.spans)}
    at, tail = common_affixes(base.lll, one.lll)
    return {
        **told,
        "of": base.known,
        "at": at,
        "removed": len(base.lll) - tail - at,
        "inserted": one.lll[at : len(one.lll) - tail],
        "spans": _moved(base.spans, one.spans),
    }


def _moved(before: Sequence[VertexPlace], after: Sequence[VertexPlace]) -> list[dict[str, Any]]:
    """The places as what became of those before: the first ones that stayed, those between, the last ones, moved."""
    shorter, start = min(len(before), len(after)), common_affixes(before, after)[0]
    tail = characters = lines = 0
    if start < shorter:
        characters, lines = after[-1].start - before[-1].start, after[-1].line - before[-1].line
    while tail < shorter - start:
        old, new = before[-1 - tail], after[-1 - tail]
        if (old.vertex, old.start + characters, old.end + characters, old.line + lines) != new:
            break
        tail += 1
    rows = _spans(after[start : len(after) - tail])
    if start:
        rows.insert(0, {"start": 0, "end": start, "characters": 0, "lines": 0})
    if tail:
        rows.append({"start": len(before) - tail, "end": len(before), "characters": characters, "lines": lines})
    return rows


def _drawn(before: Program, after: Program) -> dict[str, Any]:
    return {
        "vertices": encode_delta(before.vertices, after.vertices, lambda one: one.id, _vertex),
        "arcs": encode_delta(before.arcs, after.arcs, lambda one: (one.source, one.out, one.target, one.at), _arc),
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
