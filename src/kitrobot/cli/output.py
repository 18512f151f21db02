"""Output of the command line: data on standard output, messages on standard error, UTF-8 on both, whatever the locale.

The error of a command is recorded, so that a caller who wanted JSON gets it as an object when the command ends without
data (`failure_json`). Standard output may be closed from the start (`>&-`): then it is None.
"""

from __future__ import annotations

import io
import json
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any, ClassVar, Final, TextIO

from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Place, Source
from kitrobot.text.sentences import Sentence

_CONTROL_CHARACTERS = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


_LONE_SURROGATE = re.compile("[\ud800-\udfff]")


INTERRUPTED: Final = 130
"""The status of a command that Ctrl-C ended."""

_CHUNK_LENGTH = 4096
"""Characters in one write."""


class OutputClosedError(Exception):
    """The reader of the output has gone. It is no OSError: Typer would make a status of its own of one."""


class _OutputState:
    """The data and errors that were printed since the command began."""

    given = False
    error: ClassVar[tuple[str, str]] = ("", "")
    problems: ClassVar[list[Diagnostic]] = []


def reset_output_state() -> None:
    """Forgets the output of an earlier command."""
    _OutputState.given, _OutputState.error, _OutputState.problems = False, ("", ""), []


def failure_json() -> str:
    """The error as one line of JSON; "" when the command has printed data already."""
    from kitrobot.diagnostics.problems import with_help

    if _OutputState.given:
        return ""
    problems = with_help(_OutputState.problems)
    first = next(((one.message, one.help) for one in problems if one.is_error), ("", ""))
    message, help = _OutputState.error if _OutputState.error[0] else first
    return json_text({"error": error_object(KitRobotError(Sentence(message), Sentence(help), tuple(problems)))}) + "\n"


def error_object(error: KitRobotError) -> dict[str, Any]:
    """`message`, `help`, and `diagnostics` as `kitrobot check --json` prints them."""
    from kitrobot.diagnostics.renderer import to_json
    from kitrobot.translation.reader_language import translate

    return {
        "message": translate(error.message),
        "help": translate(error.help),
        "diagnostics": [to_json(item) for item in error.diagnostics],
    }


def record_error(message: str, help: str = "") -> None:
    """Records the error, for `failure_json`."""
    _OutputState.error = (message, help)


def json_text(value: Any, indent: int | None = None) -> str:
    """JSON that is always valid UTF-8: an undecodable byte of a file's name is escaped."""
    text = json.dumps(value, ensure_ascii=False, indent=indent)
    return _LONE_SURROGATE.sub(lambda lone: f"\\u{ord(lone[0]):04x}", text)


class TolerantStderr(io.TextIOBase):
    """Standard error while a command runs: where it cannot be written, the command goes on all the same."""

    def __init__(self, stream: TextIO | None) -> None:
        self._stream = stream

    @property
    def encoding(self) -> str:  # type: ignore[override]
        """As of the stream."""
        return "utf-8"

    def writable(self) -> bool:
        """Always True."""
        return True

    def isatty(self) -> bool:
        """Whether it is a terminal."""
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
        """Writes the text, if possible."""
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
                redirect_to_devnull(self._stream)


def redirect_to_devnull(stream: TextIO | None) -> None:
    """Discards everything that is written to the stream from now on, also what Python writes at its end."""
    try:
        if stream is not None:
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, stream.fileno())
            os.close(nowhere)
    except (OSError, ValueError):
        return


@contextmanager
def standard_streams() -> Iterator[None]:
    """Sets both streams to UTF-8 with plain line feeds; what cannot be encoded is escaped, never refused. Standard
    error is a `TolerantStderr` meanwhile.
    """
    usual = sys.stderr
    for stream, errors in ((sys.stdout, "surrogateescape"), (usual, "backslashreplace")):
        reconfigure: Any = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(encoding="utf-8", errors=errors, newline="\n")
    sys.stderr = TolerantStderr(usual)
    try:
        yield
    finally:
        sys.stderr = usual


def sanitize(text: str) -> str:
    """The text with U+FFFD for each control character: a file's name may contain anything."""
    return _CONTROL_CHARACTERS.sub("\N{REPLACEMENT CHARACTER}", text)


def print_message(text: str) -> None:
    """Prints a sanitised message on standard error, in one write with its line feed: other processes write too."""
    if sys.stderr is not None:
        sys.stderr.write(f"{sanitize(text)}\n")


def print_no_answer(address: str) -> None:
    """Reports that a robot has not answered yet."""
    print_message(f"{address}: no answer yet, asking again")


def print_late_ticks(address: str) -> None:
    """Reports that a robot's program does not keep its time."""
    print_message(f"{address}: most ticks take longer than they may, so the program runs slower than it says")
    print_message("  help: `kitrobot bench` says which part takes so long; or give the robot a longer tick")


def print_data(text: str) -> None:
    """Prints data on standard output, without adding anything."""
    if sys.stdout is None:
        raise KitRobotError(
            Sentence("the output cannot be written: standard output is closed"), Sentence("open it, or write to a file")
        )
    _OutputState.given = _OutputState.given or bool(text)
    try:
        # In chunks: Python does not report that the reader has gone in the middle of one write.
        for at in range(0, len(text), _CHUNK_LENGTH):
            sys.stdout.write(text[at : at + _CHUNK_LENGTH])
    except BrokenPipeError:
        raise OutputClosedError from None


def print_diagnostics(diagnostics: Iterable[Diagnostic], sources: Iterable[Source] = ()) -> None:
    """Prints diagnostics on standard error."""
    from kitrobot.diagnostics.problems import written_out

    diagnostics = list(diagnostics)
    _OutputState.problems += diagnostics
    text = written_out(diagnostics, sources)
    if text:
        print_message(text)


def print_error(error: KitRobotError) -> None:
    """Prints an error on standard error: its diagnostics, its sentence and its help."""
    from kitrobot.translation.reader_language import translate

    record_error(error.message, error.help)
    place: Place | None = getattr(error, "place", None)
    if error.diagnostics:
        print_diagnostics(error.diagnostics, getattr(error, "sources", ()))
    where = f"{place.file}:{place.line}:{place.column}: " if place is not None else ""
    print_message(f"{where}error: {translate(error.message)}")
    if error.help:
        print_message(f"  help: {translate(error.help)}")
