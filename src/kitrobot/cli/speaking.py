"""How the command line speaks: data on standard output, talk on standard error, UTF-8 on both, whatever the locale."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from typing import Any

from kitrobot.diagnostics import Diagnostic, KitRobotError, Place, Source

_STEERING = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


def use_utf8() -> None:
    """Both streams in UTF-8 with plain line feeds; what cannot be said is escaped, never refused."""
    for stream, errors in ((sys.stdout, "surrogateescape"), (sys.stderr, "backslashreplace")):
        reconfigure: Any = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(encoding="utf-8", errors=errors, newline="\n")


def clean(text: str) -> str:
    """The same with U+FFFD for what would steer the terminal: a file's name may hold anything."""
    return _STEERING.sub("\N{REPLACEMENT CHARACTER}", text)


def tell(text: str) -> None:
    """Talk, on standard error, cleaned."""
    print(clean(text), file=sys.stderr)


def tell_of_waiting(address: str) -> None:
    """That a robot has not answered yet."""
    tell(f"{address}: no answer yet, asking again")


def give(text: str) -> None:
    """Data, on standard output, without adding anything."""
    sys.stdout.write(text)


def show(diagnostics: Iterable[Diagnostic], sources: Iterable[Source] = ()) -> None:
    """Diagnostics, on standard error."""
    from kitrobot.workspace import written_out

    text = written_out(diagnostics, sources)
    if text:
        tell(text)


def complain(error: KitRobotError) -> None:
    """What went wrong, on standard error: the diagnostics where there are any, and the sentence with its way out."""
    place: Place | None = getattr(error, "place", None)
    if error.diagnostics:
        show(error.diagnostics, getattr(error, "sources", ()))
    where = f"{place.file}:{place.line}:{place.column}: " if place is not None else ""
    tell(f"{where}error: {error.message}")
    if error.help:
        tell(f"  help: {error.help}")
