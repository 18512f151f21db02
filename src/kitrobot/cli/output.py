"""Output of the command line: data on standard output, messages on standard error, UTF-8 on both, whatever the locale.

What a command says of its failure is remembered, so that whoever asked for JSON gets it as an object when the command
ends without data (`failure`). Standard output may be closed from the start (`>&-`): then it is None.
"""

from __future__ import annotations

import io
import json
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any, ClassVar, TextIO

from kitrobot.diagnostics import Diagnostic, KitRobotError, Place, Source
from kitrobot.text import Sentence

_STEERING = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


_LONE = re.compile("[\ud800-\udfff]")


_PIECE = 4096
"""Characters written at once."""


class NobodyReadsError(Exception):
    """Whoever read the output has gone. No OSError, of which Typer would make a status of its own."""


class _Said:
    """What was given and complained about since the command began."""

    given = False
    error: ClassVar[tuple[str, str]] = ("", "")
    problems: ClassVar[list[Diagnostic]] = []


def begin() -> None:
    """Forgets what an earlier command said."""
    _Said.given, _Said.error, _Said.problems = False, ("", ""), []


def failure() -> str:
    """What went wrong as one line of JSON; "" when the command has given data already."""
    from kitrobot.diagnostics import with_help

    if _Said.given:
        return ""
    problems = with_help(_Said.problems)
    first = next(((one.message, one.help) for one in problems if one.is_error), ("", ""))
    message, help = _Said.error if _Said.error[0] else first
    return json_text({"error": error_object(KitRobotError(Sentence(message), Sentence(help), tuple(problems)))}) + "\n"


def error_object(error: KitRobotError) -> dict[str, Any]:
    """`message`, `help`, and `diagnostics` as `kitrobot check --json` gives them."""
    from kitrobot.diagnostics import to_json
    from kitrobot.translation import translate

    return {
        "message": translate(error.message),
        "help": translate(error.help),
        "diagnostics": [to_json(item) for item in error.diagnostics],
    }


def remember(message: str, help: str = "") -> None:
    """Keeps what went wrong, for `failure`."""
    _Said.error = (message, help)


def json_text(value: Any, indent: int | None = None) -> str:
    """JSON that is UTF-8 whatever stands in it: a byte of a file's name that is none is escaped."""
    text = json.dumps(value, ensure_ascii=False, indent=indent)
    return _LONE.sub(lambda lone: f"\\u{ord(lone[0]):04x}", text)


class Talk(io.TextIOBase):
    """Standard error while a command runs: where nobody can be told anything, the work goes on all the same."""

    def __init__(self, stream: TextIO | None) -> None:
        self._stream = stream

    @property
    def encoding(self) -> str:  # type: ignore[override]
        """As of the stream."""
        return "utf-8"

    def writable(self) -> bool:
        """It always is."""
        return True

    def isatty(self) -> bool:
        """Whether somebody sits there."""
        try:
            return self._stream is not None and self._stream.isatty()
        except (OSError, ValueError):
            return False

    def fileno(self) -> int:
        """As of the stream.

        Raises:
            OSError: it has no number.
        """
        if self._stream is None:
            raise io.UnsupportedOperation("fileno")
        return self._stream.fileno()

    def write(self, text: str) -> int:
        """Writes it, where that can be."""
        self._attempt(lambda stream: stream.write(text))
        return len(text)

    def flush(self) -> None:
        """As `write`."""
        self._attempt(lambda stream: stream.flush())

    def _attempt(self, act: Callable[[TextIO], object]) -> None:
        if self._stream is not None:
            try:
                act(self._stream)
            except (OSError, ValueError):
                lead_nowhere(self._stream)


def lead_nowhere(stream: TextIO | None) -> None:
    """What is written there is lost from now on, also what Python writes at its end."""
    try:
        if stream is not None:
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, stream.fileno())
            os.close(nowhere)
    except (OSError, ValueError):
        return


@contextmanager
def standard_streams() -> Iterator[None]:
    """Both streams in UTF-8 with plain line feeds; what cannot be said is escaped, never refused. Standard error is a
    `Talk` meanwhile.
    """
    usual = sys.stderr
    for stream, errors in ((sys.stdout, "surrogateescape"), (usual, "backslashreplace")):
        reconfigure: Any = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(encoding="utf-8", errors=errors, newline="\n")
    sys.stderr = Talk(usual)
    try:
        yield
    finally:
        sys.stderr = usual


def clean(text: str) -> str:
    """The same with U+FFFD for what would steer the terminal: a file's name may hold anything."""
    return _STEERING.sub("\N{REPLACEMENT CHARACTER}", text)


def tell(text: str) -> None:
    """Talk, on standard error, cleaned; in one piece with its line feed, since other processes write there too."""
    if sys.stderr is not None:
        sys.stderr.write(f"{clean(text)}\n")


def tell_of_waiting(address: str) -> None:
    """That a robot has not answered yet."""
    tell(f"{address}: no answer yet, asking again")


def tell_of_lateness(address: str) -> None:
    """That a robot's program does not keep its time."""
    tell(f"{address}: most ticks take longer than they may, so the program runs slower than it says")
    tell("  help: `kitrobot bench` says which part takes so long; or give the robot a longer tick")


def give(text: str) -> None:
    """Data, on standard output, without adding anything."""
    if sys.stdout is None:
        raise KitRobotError(
            Sentence("the output cannot be written: standard output is closed"), Sentence("open it, or write to a file")
        )
    _Said.given = _Said.given or bool(text)
    try:
        # In pieces: of one write in the middle of which the reader goes, Python does not tell.
        for at in range(0, len(text), _PIECE):
            sys.stdout.write(text[at : at + _PIECE])
    except BrokenPipeError:
        raise NobodyReadsError from None


def show(diagnostics: Iterable[Diagnostic], sources: Iterable[Source] = ()) -> None:
    """Diagnostics, on standard error."""
    from kitrobot.diagnostics import written_out

    diagnostics = list(diagnostics)
    _Said.problems += diagnostics
    text = written_out(diagnostics, sources)
    if text:
        tell(text)


def complain(error: KitRobotError) -> None:
    """What went wrong, on standard error: the diagnostics where there are any, and the sentence with its way out."""
    from kitrobot.translation import translate

    remember(error.message, error.help)
    place: Place | None = getattr(error, "place", None)
    if error.diagnostics:
        show(error.diagnostics, getattr(error, "sources", ()))
    where = f"{place.file}:{place.line}:{place.column}: " if place is not None else ""
    tell(f"{where}error: {translate(error.message)}")
    if error.help:
        tell(f"  help: {translate(error.help)}")
