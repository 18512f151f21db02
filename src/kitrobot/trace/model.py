"""What happened, tick by tick: the values that every watcher of a run reads.

A run is a `TraceHeader` (who takes part, what the numbers mean) and one `TickRecord` a tick. All numbers of a tick
stand in one flat list of whole numbers, one for each `Column` of the header, so that a record is compared and stored
fast; a column's `scale` turns a number back into its unit (0.1: tenths). Nothing here comes from a clock on the wall.

Left to others: bytes (coding, writer, reader), and who produced it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from kitrobot.diagnostics import KitRobotError

TEAM = ""
"""The owner of a column that belongs to no single agent."""


class TraceError(KitRobotError):
    """A trace that cannot be written or read; the message says where."""


@dataclass(frozen=True)
class TraceAgent:
    """Somebody who takes part."""

    name: str
    program: str
    robot: str


@dataclass(frozen=True)
class Column:
    """The meaning of one number of a record: whose (`TEAM` or an agent's name), what, and its unit's `scale`."""

    owner: str
    name: str
    scale: float = 1.0


@dataclass(frozen=True)
class TraceHeader:
    """What holds for the whole run. `mission` is the SHA-256 of the canonical mission, in hex."""

    mission: str
    seed: int
    world: str
    tick_ms: int
    agents: tuple[TraceAgent, ...]
    columns: tuple[Column, ...]

    def to_json(self) -> dict[str, Any]:
        """As plain values, keys in a fixed order."""
        return {
            "mission": self.mission,
            "seed": self.seed,
            "world": self.world,
            "tick_ms": self.tick_ms,
            "agents": [[agent.name, agent.program, agent.robot] for agent in self.agents],
            "columns": [[column.owner, column.name, column.scale] for column in self.columns],
        }

    @staticmethod
    def from_json(data: Any) -> TraceHeader:
        """The header from its plain values.

        Raises:
            TraceError: something is missing or of the wrong kind.
        """
        try:
            return TraceHeader(
                str(data["mission"]),
                int(data["seed"]),
                str(data["world"]),
                int(data["tick_ms"]),
                tuple(TraceAgent(str(name), str(program), str(robot)) for name, program, robot in data["agents"]),
                tuple(Column(str(owner), str(name), float(scale)) for owner, name, scale in data["columns"]),
            )
        except (KeyError, TypeError, ValueError) as error:
            raise TraceError("the header of this trace does not say what a trace's header says") from error


@dataclass(frozen=True)
class TraceCommand:
    """A command that a device took: which agent (its index), which procedure, with what."""

    agent: int
    actuator: str
    procedure: str
    arguments: tuple[int, ...] = ()


@dataclass(frozen=True)
class TraceEvent:
    """What happened at one moment: load, unload, message, collision, end. `agent` is -1 for the whole team."""

    kind: str
    agent: int
    text: str


Threads = tuple[tuple[int, int], ...]
"""Where the live threads of one agent stand: (slot, instruction) each."""


@dataclass
class TickRecord:
    """One tick: `numbers` by column, `active` by agent; `commands` and `events` only of this tick."""

    tick: int
    numbers: list[int]
    active: list[Threads]
    commands: list[TraceCommand] = field(default_factory=list)
    events: list[TraceEvent] = field(default_factory=list)

    def values(self, header: TraceHeader) -> Mapping[str, Mapping[str, float]]:
        """Owner → name → value in its unit."""
        table: dict[str, dict[str, float]] = {}
        for column, number in zip(header.columns, self.numbers, strict=True):
            table.setdefault(column.owner, {})[column.name] = number if column.scale == 1.0 else number * column.scale
        return table
