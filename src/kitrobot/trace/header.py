"""A trace's header as plain values and back; what comes from a file is looked through before it is believed.

The columns of an agent are those of its layout, which agents with the same robot share: ten thousand robots are ten
thousand short rows. So columns stand in the order of the agents, those of the team last.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import Any

from kitrobot.primitives.image_name import ImageName
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import TEAM, Column, TraceAgent, TraceError, TraceHeader, TracePart, TracePlan, TracePoint

MOST_AGENTS = 1_000_000
MOST_COLUMNS = 4_000_000
LONGEST_TICK_MS = 60_000

Layout = tuple[tuple[str, float], ...]
"""Names of numbers with their scales."""


def header_to_json(header: TraceHeader) -> dict[str, Any]:
    """As plain values, keys in a fixed order.

    Raises:
        TraceError: the columns are not in the order of the agents.
    """
    owners = [*(agent.name for agent in header.agents), TEAM]
    mine: dict[str, Layout] = dict.fromkeys(owners, ())
    for owner, columns in groupby(header.columns, key=lambda column: column.owner):
        mine[owner] = tuple((column.name, column.scale) for column in columns)
    if [(owner, *pair) for owner in owners for pair in mine[owner]] != [
        (column.owner, column.name, column.scale) for column in header.columns
    ]:
        raise TraceError(Sentence("the numbers of this trace are not in the order of its agents"))
    numbers: dict[Layout, int] = {}
    for agent in header.agents:
        numbers.setdefault(mine[agent.name], len(numbers))
    return {
        "mission": header.mission,
        "seed": header.seed,
        "world": header.world,
        "tick_ms": header.tick_ms,
        "total": header.total,
        "fail_rate": header.fail_rate,
        "agents": [
            [one.name, one.program, one.robot, one.kind, one.number, numbers[mine[one.name]]] for one in header.agents
        ],
        "layouts": [[list(pair) for pair in layout] for layout in numbers],
        "team": [list(pair) for pair in mine[TEAM]],
        "vertices": {name.text: list(vertices) for name, vertices in header.vertices.items()},
        "parts": [[part.file, part.text] for part in header.parts],
        **({"inner": {name.text: list(found) for name, found in header.inner.items()}} if header.inner else {}),
        **({"plan": _plan_to_json(header.plan)} if header.plan is not None else {}),
    }


def _plan_to_json(plan: TracePlan) -> dict[str, Any]:
    return {
        "members": list(plan.members),
        "roles": list(plan.roles),
        "groups": list(plan.groups),
        "points": [[one.program, one.vertex, one.waits, list(one.members)] for one in plan.points],
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
            tuple(_columns(data["agents"], [_layout(rows) for rows in data["layouts"]], _layout(data["team"]))),
            {ImageName.parse(_text(name)): tuple(_vertices(found)) for name, found in data["vertices"].items()},
            tuple(TracePart(_text(file), _text(text)) for file, text in data["parts"]),
            _whole(data["total"], 0, 2**53),
            _rate(data["fail_rate"]),
            {ImageName.parse(_text(name)): tuple(_inner(found)) for name, found in data.get("inner", {}).items()},
            _plan(data["plan"]) if "plan" in data else None,
        )
    except (AttributeError, KeyError, OverflowError, TypeError, ValueError) as error:
        raise TraceError(Sentence("the header of this trace does not say what a trace's header says")) from error
    names = {agent.name for agent in header.agents}
    if len(names) < len(header.agents) or TEAM in names:
        raise TraceError(Sentence("the header of this trace does not fit together: two of its agents have one name"))
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
    for name, program, robot, kind, number, _ in rows:
        yield TraceAgent(_text(name), _text(program), _text(robot), _text(kind), _whole(number, 0, 2**31))


def _layout(rows: Any) -> Layout:
    found = []
    for name, scale in rows:
        if isinstance(scale, bool) or not isinstance(scale, (int, float)) or not 1e-9 <= abs(scale) <= 1e9:
            raise ValueError("scale")
        found.append((_text(name), float(scale)))
    return tuple(found)


def _columns(agents: Any, layouts: Sequence[Layout], team: Layout) -> Iterable[Column]:
    chosen = [(row[0], layouts[_whole(row[5], 0, len(layouts) - 1)]) for row in agents]
    if sum(len(layout) for _, layout in chosen) + len(team) > MOST_COLUMNS:
        raise ValueError("columns")
    for owner, layout in [*chosen, (TEAM, team)]:
        for name, scale in layout:
            yield Column(owner, name, scale)


def _vertices(rows: Any) -> Iterable[str | None]:
    if not isinstance(rows, list):
        raise TypeError("list")
    for vertex in rows:
        yield None if vertex is None else _text(vertex)


def _inner(rows: Any) -> Iterable[tuple[str, str] | None]:
    if not isinstance(rows, list):
        raise TypeError("list")
    for row in rows:
        if row is None:
            yield None
        else:
            program, vertex = row
            yield _text(program), _text(vertex)


def _names(rows: Any) -> tuple[str, ...]:
    if not isinstance(rows, list):
        raise TypeError("list")
    return tuple(map(_text, rows))


def _plan(data: Any) -> TracePlan:
    points = []
    for program, vertex, waits, members in data["points"]:
        if not isinstance(waits, bool):
            raise TypeError("waits")
        points.append(TracePoint(_text(program), _text(vertex), waits, _names(members)))
    return TracePlan(_names(data["members"]), _names(data["roles"]), _names(data["groups"]), tuple(points))
