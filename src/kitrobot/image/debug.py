"""The debug map: instruction → the LLL it came from and the vertex. It stays on the host and is never sent."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple


class Origin(NamedTuple):
    """Where an instruction came from: a stretch of the LLL text and, when it came from a graph, a vertex."""

    start: int
    end: int
    vertex: str | None


@dataclass(frozen=True)
class DebugMap:
    """`origins[i]` is where instruction i came from: the LLL instruction around it."""

    origins: list[Origin] = field(default_factory=list)

    def vertex(self, instruction: int) -> str | None:
        """The vertex of an instruction, or None when it came from no graph."""
        return self.origins[instruction].vertex if 0 <= instruction < len(self.origins) else None
