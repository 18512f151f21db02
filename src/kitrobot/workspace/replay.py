"""A recording as plain values and as text: what it is of, what happened in it, and how all stood at a moment."""

from __future__ import annotations

import math
from typing import Any

from kitrobot.sim.recorder import DOING
from kitrobot.trace.model import TEAM, TickRecord, TraceEvent
from kitrobot.workspace.traces import OpenTrace

_DECIMALS = {"x_mm": 1, "y_mm": 1, "heading_rad": 3}
"""Places, with how much of them is told; null for a real robot, which nobody knows that of."""


def summary_of(trace: OpenTrace) -> dict[str, Any]:
    """What a recording is of, in the published shape: whose run, how it ended, and everything that happened."""
    reader = trace.reader
    header = reader.header
    outcome = reader.outcome.get("outcome")
    sentence = reader.outcome.get("sentence")
    return {
        "seed": header.seed,
        "fail_rate": header.fail_rate,
        "world": trace.world.name,
        "tick_ms": header.tick_ms,
        "ticks": reader.last_tick,
        "seconds": _seconds(reader.last_tick, header.tick_ms),
        "outcome": outcome if isinstance(outcome, str) else "cut",
        "sentence": sentence if isinstance(sentence, str) else "",
        "cut": reader.cut,
        "agents": [{"name": one.name, "program": one.program, "robot": one.robot} for one in header.agents],
        "real": header.real,
        "events": [_event(trace, event) for _, event in reader.events],
    }


def _seconds(tick: int, tick_ms: int) -> float:
    return round(tick * tick_ms / 1000, 3)


def _event(trace: OpenTrace, event: TraceEvent) -> dict[str, Any]:
    header = trace.reader.header
    return {
        "tick": event.tick,
        "seconds": _seconds(event.tick, header.tick_ms),
        "kind": event.kind,
        "agent": header.agents[event.agent].name if event.agent >= 0 else "",
        "text": event.text,
        "cause": event.cause,
    }


def state_at(trace: OpenTrace, seconds: float) -> dict[str, Any]:
    """How all stood after so many simulated seconds, in the published shape; beyond the end, at the end."""
    reader = trace.reader
    tick = math.floor(seconds * 1000 / reader.header.tick_ms + 1e-6)
    record = reader.seek(min(tick, reader.last_tick))
    values = record.values(reader.header)
    team = values.get(TEAM, {})
    return {
        "tick": record.tick,
        "seconds": _seconds(record.tick, reader.header.tick_ms),
        "agents": {
            agent.name: _agent(trace, record, index, dict(values.get(agent.name, {})))
            for index, agent in enumerate(reader.header.agents)
        },
        "stock": _named(team, "stock "),
        "delivered": _named(team, "delivered "),
        "collisions": team.get("collisions", 0),
        "events": [_event(trace, event) for event in record.events],
        "real": reader.header.real,
    }


def _agent(trace: OpenTrace, record: TickRecord, index: int, values: dict[str, float]) -> dict[str, Any]:
    header = trace.reader.header
    vertices = header.vertices_of(header.agents[index])
    stands = [vertices[one] for _, one in record.active[index] if one < len(vertices)]
    program = trace.mission.program(header.agents[index].program)
    elements = {vertex.id: vertex.element for vertex in program.vertices} if program is not None else {}
    inputs = _named(values, "input ")
    doing, forced = int(values.get("doing", 0)), int(values.get("forced", 0))
    return {
        **{name: round(values[name], digits) if name in values else None for name, digits in _DECIMALS.items()},
        "load": values.get("load"),
        "state": DOING[doing] if 0 <= doing < len(DOING) else DOING[0],
        "vertices": [{"vertex": one, "element": elements.get(one, "")} for one in stands if one is not None],
        "values": _named(values, "variable "),
        "inputs": inputs,
        "forced": [name for bit, name in enumerate(inputs) if forced >> bit & 1],
        "fault": values.get("fault", 0),
    }


def _named(values: Any, start: str) -> dict[str, Any]:
    return {name.removeprefix(start): value for name, value in values.items() if name.startswith(start)}
