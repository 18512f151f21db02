"""A trace's header as plain values and back; what comes from a file is looked through before it is believed."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from kitrobot.trace.model import TEAM, Column, TraceAgent, TraceError, TraceHeader, TracePart

MOST_AGENTS = 1_000_000
MOST_COLUMNS = 8_000_000
LONGEST_TICK_MS = 60_000


def header_to_json(header: TraceHeader) -> dict[str, Any]:
    """As plain values, keys in a fixed order."""
    return {
        "mission": header.mission,
        "seed": header.seed,
        "world": header.world,
        "tick_ms": header.tick_ms,
        "total": header.total,
        "fail_rate": header.fail_rate,
        "agents": [[one.name, one.program, one.robot, one.kind, one.number] for one in header.agents],
        "columns": [[column.owner, column.name, column.scale] for column in header.columns],
        "vertices": {program: list(vertices) for program, vertices in header.vertices.items()},
        "parts": [[part.file, part.text] for part in header.parts],
    }


def header_from_json(data: Any) -> TraceHeader:
    """The header from its plain values.

    Raises:
        TraceError: something is missing, of the wrong kind, or makes no sense.
    """
    try:
        header = TraceHeader(
            _text(data["mission"]),
            _whole(data["seed"], 0, 2**63),
            _text(data["world"]),
            _whole(data["tick_ms"], 1, LONGEST_TICK_MS),
            tuple(_agents(data["agents"])),
            tuple(_columns(data["columns"])),
            {_text(name): tuple(_vertices(found)) for name, found in data["vertices"].items()},
            tuple(TracePart(_text(file), _text(text)) for file, text in data["parts"]),
            _whole(data["total"], 0, 2**53),
            _rate(data["fail_rate"]),
        )
    except (AttributeError, KeyError, OverflowError, TypeError, ValueError) as error:
        raise TraceError("the header of this trace does not say what a trace's header says") from error
    names = {agent.name for agent in header.agents}
    owners = {column.owner for column in header.columns} - {TEAM}
    if len(names) < len(header.agents) or not owners <= names:
        raise TraceError("the header of this trace does not fit together: its agents are not those of its numbers")
    return header


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError("text")
    value.encode()
    return value


def _whole(value: Any, least: int, most: int) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
        raise ValueError("number")
    return value


def _rate(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 <= value <= 1:
        raise ValueError("probability")
    return float(value)


def _agents(rows: Any) -> Iterable[TraceAgent]:
    if len(rows) > MOST_AGENTS:
        raise ValueError("agents")
    for name, program, robot, kind, number in rows:
        yield TraceAgent(_text(name), _text(program), _text(robot), _text(kind), _whole(number, 0, 2**31))


def _columns(rows: Any) -> Iterable[Column]:
    if len(rows) > MOST_COLUMNS:
        raise ValueError("columns")
    for owner, name, scale in rows:
        if isinstance(scale, bool) or not isinstance(scale, (int, float)) or not 1e-9 <= abs(scale) <= 1e9:
            raise ValueError("scale")
        yield Column(_text(owner), _text(name), float(scale))


def _vertices(rows: Any) -> Iterable[str | None]:
    if not isinstance(rows, list):
        raise TypeError("list")
    for vertex in rows:
        yield None if vertex is None else _text(vertex)
