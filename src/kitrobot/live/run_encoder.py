"""Encodes the records of a run for the page: frames of poses, and messages of what changed since the last one.

This is the only way from a trace to the page: a live run is recorded tick by tick and encoded from its records, a
recording is encoded from its stored records, so both are equal to the byte. A record names instructions, the page names
vertices: the header maps each agent's threads to vertices. The encoder remembers what it encoded, so that an agent that
did not change is left out. Numbers of a recording may be anything; a number that no page could hold is clamped. Texts
are English here: the sender translates them into the reader's language.
"""

from __future__ import annotations

import struct
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from kitrobot.live.team_snapshots import TeamSnapshotEncoder
from kitrobot.sim.recorder import DOING
from kitrobot.text.sentences import Sentence, clipped
from kitrobot.trace.drawing import PEN, Mark, News, Pen
from kitrobot.trace.model import (
    POSE_WORDS,
    PROGRAM,
    TEAM,
    Inner,
    Threads,
    TickRecord,
    TraceAgent,
    TraceError,
    TraceEvent,
    TraceHeader,
)
from kitrobot.trace.source import Ability
from kitrobot.wire.run import EVENT_CAUSES, EVENT_KINDS, StartedAgentShape, StartedMessage
from kitrobot.wire.world import world_shape
from kitrobot.world.model import World

MOST_EVENTS_SENT = 5000
"""Events in one message when all of them are sent again."""
MOST_REPORTED = 100
"""In a run of more agents than this, only selected ones are reported; all are in the frames."""
LONGEST_TEXT = 500
_MOST = 2**53
"""Numbers beyond it are no whole numbers of JavaScript."""
_POSE = POSE_WORDS
_NO_PLACE = ((None, 0.0),) * len(_POSE)
"""The pose of an agent whose position is unknown: its robot was a real one."""


def _bounded(number: int) -> int:
    return number if -_MOST <= number <= _MOST else _MOST if number > 0 else -_MOST


@dataclass(frozen=True)
class AgentColumns:
    """The columns of an agent's numbers in a record. `values`, `inputs` and `shown` are names with their columns;
    `parts` are those that show something of themselves: a pen's line is sent as a drawing.
    """

    name: str
    pose: tuple[tuple[int | None, float], ...]
    doing: int
    forced: int
    fault: int
    inputs: tuple[tuple[str, int], ...]
    values: tuple[tuple[str, int], ...]
    parts: tuple[tuple[str, tuple[int, ...]], ...]
    shown: tuple[tuple[str, tuple[int, ...]], ...]
    vertices: tuple[str | None, ...]
    inner: Inner
    watched: tuple[int, ...]

    def vertex(self, instruction: int) -> str | None:
        """The vertex of an instruction of its program."""
        return self.vertices[instruction] if instruction < len(self.vertices) else None

    def thread_vertices(self, threads: Threads) -> tuple[tuple[int, str], ...]:
        """(slot, vertex) of each live thread."""
        found = ((slot, self.vertex(instruction)) for slot, instruction in threads)
        return tuple((slot, vertex) for slot, vertex in found if vertex is not None)

    def inner_thread_vertices(self, threads: Threads) -> list[list[Any]]:
        """[slot, program, vertex] of each live thread that is in another program than the agent's own."""
        found = ((slot, self.inner[at] if at < len(self.inner) else None) for slot, at in threads)
        return [[slot, *place] for slot, place in found if place is not None]


class RunEncoder:
    """Encodes one run for one page.

    Raises:
        TraceError: the header lacks a number that the page needs.
    """

    def __init__(self, header: TraceHeader) -> None:
        self._header = header
        by_owner: dict[str, list[tuple[str, int]]] = {}
        for at, column in enumerate(header.columns):
            by_owner.setdefault(column.owner, []).append((column.name, at))
        try:
            self._agents = [self._agent_columns(one, by_owner.get(one.name, [])) for one in header.agents]
            self._collisions = dict(by_owner.get(TEAM, []))["collisions"]
        except KeyError as error:
            raise TraceError(
                Sentence("the trace lacks numbers that every run has"), Sentence("record the run once more")
            ) from error
        self._poses = [place for agent in self._agents for place in agent.pose]
        team = by_owner.get(TEAM, [])
        self._stock = _named("stock ", team)
        self._delivered = _named("delivered ", team)
        # x and y of each thing, one after the other.
        self._things = [(at, header.columns[at].scale) for _, at in _named("thing ", team)]
        self._looked_at = self._first_agents()
        self._team = TeamSnapshotEncoder(header)
        self._before: list[tuple[object, ...] | None] = [None] * len(self._agents)
        self._used: list[set[str]] = [set() for _ in self._agents]

    def _agent_columns(self, agent: TraceAgent, mine: Sequence[tuple[str, int]]) -> AgentColumns:
        at = dict(mine)
        scales = self._header.columns
        placed = any(word in at for word in _POSE)
        pose = tuple((at[word], scales[at[word]].scale) for word in _POSE) if placed else _NO_PLACE
        inputs, values = _named("input ", mine), _named("variable ", mine)
        parts = _columns_by_part(_named("shown ", mine))
        shown = (*parts, *_columns_by_part(_named(PEN, mine)))
        watched = (at["doing"], at["forced"], at["fault"], *(place for _, place in (*inputs, *values)))
        watched += tuple(place for _, places in shown for place in places)
        vertices = self._header.vertices_of(agent)
        inner = self._header.inner.get(self._header.image_name(agent), ())
        doing, forced, fault = at["doing"], at["forced"], at["fault"]
        return AgentColumns(
            agent.name, pose, doing, forced, fault, inputs, values, parts, shown, vertices, inner, watched
        )

    def _first_agents(self) -> frozenset[int]:
        """The first agent of each program."""
        first: dict[str, int] = {}
        for index, agent in enumerate(self._header.agents):
            first.setdefault(agent.program, index)
        return frozenset(first.values())

    def look_at(self, agents: Iterable[str]) -> None:
        """Of very many agents only these are reported from now on, and always the first one of each program."""
        wanted = frozenset(agents)
        self._looked_at = self._first_agents() | {n for n, agent in enumerate(self._agents) if agent.name in wanted}

    @property
    def reported(self) -> Collection[int]:
        """The indices of the agents whose values are reported."""
        return self._looked_at if len(self._agents) > MOST_REPORTED else range(len(self._agents))

    def started(
        self,
        run: str,
        world: World,
        first: TickRecord,
        abilities: Iterable[Ability],
        recording: bool,
        pens: Iterable[Pen] = (),
    ) -> StartedMessage:
        """The first message; `first` is the first record there is."""
        header = self._header
        return StartedMessage(
            run=run,
            tick_ms=header.tick_ms,
            seed=header.seed,
            world=world_shape(world),
            agents=[
                StartedAgentShape(
                    name=one.name,
                    program=one.program,
                    robot=one.robot,
                    number=one.number,
                    kind=one.kind,
                    placed=columns.pose is not _NO_PLACE,
                )
                for one, columns in zip(header.agents, self._agents, strict=True)
            ],
            stock=self.stock(first),
            total=header.total,
            abilities=sorted(abilities),
            recording=recording,
            fail_rate=header.fail_rate,
            pens=[pen.agent for pen in pens],
        )

    def stock(self, record: TickRecord) -> dict[str, int]:
        """Boxes by storehouse."""
        return {name: _bounded(record.numbers[at]) for name, at in self._stock}

    def encode_frame(self, record: TickRecord) -> bytes:
        """All poses: float32, little-endian: tick, how many robots and how many things that can be pushed, then x, y,
        heading, load, flags of each robot, and x, y of each thing.
        """
        row = record.numbers
        if row and not (min(row) >= -_MOST and max(row) <= _MOST):
            row = [_bounded(number) for number in row]
        numbers = [0.0 if at is None else row[at] * scale for at, scale in self._poses]
        numbers += [row[at] * scale for at, scale in self._things]
        head = record.tick, len(self._agents), len(self._things) // 2
        return struct.pack(f"<{len(head) + len(numbers)}f", *head, *numbers)

    @property
    def with_unused_parts(self) -> Collection[int]:
        """The indices of the reported agents with parts that have shown nothing yet."""
        return [index for index in self.reported if len(self._used[index]) < len(self._agents[index].parts)]

    def note_used_parts(self, record: TickRecord) -> None:
        """Notes which parts show something; it is sent with the next message, also where they show nothing by then.

        `record` holds all numbers of `with_unused_parts`.
        """
        row = record.numbers
        for index in self.with_unused_parts:
            used = self._used[index]
            for name, places in self._agents[index].parts:
                if name not in used and any(row[at] for at in places):
                    used.add(name)

    def thread_positions(self, active: Sequence[Threads], agent: str) -> list[tuple[str, tuple[str | None, ...]]]:
        """The vertices at which the threads of the agent are, or of every agent ("")."""
        return [
            (one.name, tuple(one.vertex(instruction) for _, instruction in threads))
            for one, threads in zip(self._agents, active, strict=True)
            if agent in ("", one.name)
        ]

    def encode_changes(
        self,
        record: TickRecord,
        latest: int,
        again: bool,
        happened: Iterable[TraceEvent],
        drawn: News | None = None,
    ) -> dict[str, Any]:
        """What changed since the last time, in the shape of a `TickMessage`.

        `happened` is since the last time, or, with `again`, everything up to `latest`; `drawn` is since the last time.
        """
        row = record.numbers
        self.note_used_parts(record)
        changed = {}
        for index in sorted(self.reported):
            agent = self._agents[index]
            key = (record.active[index], len(self._used[index]), *[row[at] for at in agent.watched])
            if key != self._before[index]:
                self._before[index] = key
                changed[agent.name] = self._report(index, record)
        message = self._tick(record, latest, again, happened, changed)
        return {**message, "team": self._team.encode_if_changed(row), "drawing": _drawing_changes(drawn)}

    def encode_snapshot(
        self, record: TickRecord, latest: int, happened: Iterable[TraceEvent], marks: Sequence[Mark] = ()
    ) -> dict[str, Any]:
        """Everything, for a page that has been sent nothing yet, in the shape of a `TickMessage`; `happened` is all
        up to `latest`, `marks` all that is drawn. This does not count as sent to the others.
        """
        agents = {self._agents[index].name: self._report(index, record) for index in sorted(self.reported)}
        message = self._tick(record, latest, True, happened, agents)
        return {**message, "team": self._team.encode(record.numbers), "drawing": _drawing_changes(News(0, marks))}

    def _tick(
        self, record: TickRecord, latest: int, again: bool, happened: Iterable[TraceEvent], agents: dict[str, Any]
    ) -> dict[str, Any]:
        row = record.numbers
        return {
            "type": "tick",
            "tick": record.tick,
            "latest": latest,
            "again": again,
            "seconds": record.tick * self._header.tick_ms / 1000,
            "agents": agents,
            "stock": self.stock(record),
            "delivered": {name: _bounded(row[at]) for name, at in self._delivered},
            "collisions": _bounded(row[self._collisions]),
            "events": [self._event(event) for event in happened],
        }

    def _report(self, index: int, record: TickRecord) -> dict[str, Any]:
        agent, threads, row = self._agents[index], record.active[index], record.numbers
        doing, forced = row[agent.doing], row[agent.forced]
        return {
            "active": [[slot, vertex] for slot, vertex in agent.thread_vertices(threads)],
            "inner": agent.inner_thread_vertices(threads),
            "state": DOING[doing] if 0 <= doing < len(DOING) else DOING[0],
            "values": {name: _bounded(row[at]) for name, at in agent.values},
            "inputs": {name: _bounded(row[at]) for name, at in agent.inputs},
            "fault": _bounded(row[agent.fault]),
            "shown": {name: [_bounded(row[at]) for at in places] for name, places in agent.shown},
            "used": [name for name, _ in agent.parts if name in self._used[index]],
            "forced": [name for bit, (name, _) in enumerate(agent.inputs) if forced >> bit & 1],
        }

    def _event(self, event: TraceEvent) -> dict[str, Any]:
        return {
            "tick": event.tick,
            "kind": event.kind if event.kind in EVENT_KINDS else "message",
            "agent": self._header.agents[event.agent].name if event.agent >= 0 else "",
            "text": clipped(event.text, LONGEST_TEXT),
            "cause": event.cause if event.cause in EVENT_CAUSES else PROGRAM,
        }


def _drawing_changes(news: News | None) -> dict[str, Any] | None:
    """What was drawn, in the shape of a `DrawingShape`."""
    if news is None:
        return None
    return {"keep": news.keep, "marks": [mark[1:] for mark in news.marks]}


def _columns_by_part(columns: Iterable[tuple[str, int]]) -> tuple[tuple[str, tuple[int, ...]], ...]:
    """What actuators show: each one's numbers, in their order."""
    found: dict[str, list[int]] = {}
    for name, at in columns:
        found.setdefault(name.rpartition(" ")[0], []).append(at)
    return tuple((name, tuple(places)) for name, places in found.items())


def _named(start: str, columns: Sequence[tuple[str, int]]) -> tuple[tuple[str, int], ...]:
    return tuple((name.removeprefix(start), at) for name, at in columns if name.startswith(start))
