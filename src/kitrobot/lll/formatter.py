"""Text → text in the canonical layout, with its comments; it needs no robot."""

from __future__ import annotations

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.lll.parse_results import parse_any
from kitrobot.lll.printer import print_program, print_team_program
from kitrobot.lll.tree import Seq


def format_text(text: str, name: str = "program.lll") -> tuple[str | None, list[Diagnostic]]:
    """The text laid out anew, and what the reader had to say; None when the text has errors."""
    parsed = parse_any(text, name)
    if not parsed.ok:
        return None, parsed.diagnostics
    program = parsed.program
    return print_program(program) if isinstance(program, Seq) else print_team_program(program), parsed.diagnostics
