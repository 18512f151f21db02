"""Text → text in the one true layout, comments kept; asks nothing of a robot."""

from __future__ import annotations

from kitrobot.diagnostics import Diagnostic
from kitrobot.lll.parser import parse
from kitrobot.lll.printer import print_program


def format_text(text: str, name: str = "program.lll") -> tuple[str | None, list[Diagnostic]]:
    """The text laid out anew, and what the reader had to say; None when the text has errors."""
    parsed = parse(text, name)
    return (print_program(parsed.program) if parsed.ok else None), parsed.diagnostics
