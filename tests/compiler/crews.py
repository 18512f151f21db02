"""Teams for tests of what is said about their programs."""

from __future__ import annotations

from kitrobot.lll import parse_team
from kitrobot.primitives import Crew, declaring


def crew_declaring(crew: Crew, declared: str) -> Crew:
    """A team with what the text of a team's program declares."""
    parsed = parse_team(declared)
    assert parsed.diagnostics == []
    return declaring(crew, parsed.program)
