"""Teams for tests of what is said about their programs."""

from __future__ import annotations

from kitrobot.lll.parse_results import parse_team
from kitrobot.primitives.crew import Crew, declaring


def crew_declaring(crew: Crew, declared: str) -> Crew:
    """A team with what the text of a team's program declares."""
    parsed = parse_team(declared)
    assert parsed.diagnostics == []
    return declaring(crew, parsed.program)
