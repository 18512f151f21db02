"""The debug map: instruction → its program, vertex and LLL. It stays on the host and is never sent."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple


class Origin(NamedTuple):
    """Where an instruction came from: a program, its vertex when it came from a graph, and a stretch of the LLL text.

    `program` is "" for a text or a tree without a name; `start` and `end` are offsets of characters, `end` exclusive.
    """

    program: str
    vertex: str | None
    start: int
    end: int


@dataclass(frozen=True)
class DebugMap:
    """`origins[i]` is where instruction i came from: the LLL instruction around it."""

    origins: list[Origin] = field(default_factory=list)

    def vertex(self, instruction: int) -> str | None:
        """The vertex of an instruction, or None when it came from no graph."""
        return self.origins[instruction].vertex if 0 <= instruction < len(self.origins) else None

    @property
    def vertices(self) -> list[str | None]:
        """The vertex of each instruction."""
        return [origin.vertex for origin in self.origins]

    def vertices_of(self, program: str) -> list[str | None]:
        """The same, without those of other programs that stand in this one."""
        return [origin.vertex if origin.program == program else None for origin in self.origins]

    def places_of(self, program: str) -> list[tuple[str, str] | None]:
        """The program and the vertex of each instruction of that program, where it has one."""
        return [(origin.program or program, origin.vertex) if origin.vertex else None for origin in self.origins]

    def inner_of(self, program: str) -> list[tuple[str, str] | None]:
        """Of each instruction its program and vertex, where that is another program than this one."""
        return [
            (origin.program, origin.vertex) if origin.program not in ("", program) and origin.vertex else None
            for origin in self.origins
        ]
