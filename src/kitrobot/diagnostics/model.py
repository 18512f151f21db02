"""How KitRobot says what is wrong: places, rules, diagnostics, and the root of raised errors.

A user's mistake is a `Diagnostic`: a value that is collected and shown, never raised. An operation that failed raises a
`KitRobotError`. Every diagnostic comes from a `Rule`, whose code is permanent and whose explanation is its page in the
documents; rules register themselves where they are made, nobody keeps a list.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property

from kitrobot.text.positions import TextPositions
from kitrobot.text.sentences import Help, Sentence


class Severity(StrEnum):
    """How bad it is: an error stops a program from running, a warning may surprise, a hint is advice."""

    ERROR = "error"
    WARNING = "warning"
    HINT = "hint"


@dataclass(frozen=True)
class Place:
    """A stretch of a file: lines and columns count from 1, columns in characters, the end is exclusive."""

    file: str
    line: int = 1
    column: int = 1
    end_line: int = 1
    end_column: int = 1


@dataclass(frozen=True)
class Source:
    """A text and the name people know it by; turns offsets into places."""

    name: str
    text: str

    @cached_property
    def _positions(self) -> TextPositions:
        return TextPositions(self.text)

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column (from 1) of a character offset."""
        return self._positions.position(offset)

    def place(self, start: int, end: int) -> Place:
        """The place between two offsets."""
        line, column = self.position(start)
        end_line, end_column = self.position(max(start, end))
        return Place(self.name, line, column, end_line, end_column)

    def line(self, number: int) -> str:
        """The text of a line (from 1) without its line break; empty when there is no such line."""
        starts = self._positions.line_starts
        if not 1 <= number <= len(starts):
            return ""
        end = starts[number] if number < len(starts) else len(self.text)
        return self.text[starts[number - 1] : end].rstrip("\r\n")


ArcName = tuple[str, str, str, str]
"""An arc as diagnostics name it: from, out-port, to, in-port."""


class FixKind(StrEnum):
    """What a fix does to a graph; to a text it always does the same."""

    TEXT = "text"
    ELEMENT = "element"
    SETTING = "setting"
    UNSET = "unset"
    UNWRAP = "unwrap"
    BEFORE = "before"


@dataclass(frozen=True)
class Fix:
    """The one right answer to a diagnostic.

    In a text, `text` takes the place of what stands at the diagnostic's place. In a graph the same is done to its first
    vertex: it becomes the element `name`, its setting `name` becomes `text` or goes, it gives way to what it holds, or
    the element `name` is put before it.
    """

    text: str
    kind: FixKind = FixKind.TEXT
    name: str = ""


@dataclass(frozen=True)
class Diagnostic:
    """One thing to tell the user: a sentence, where, and what to do (`help`).

    `program`, `vertices` and `arcs` say where in a graph, `thing` which thing of a world, by kind and number from 0
    (`road:0`); `fix` is there where there is one right answer.
    """

    code: str
    severity: Severity
    message: Sentence
    place: Place | None = None
    help: Help = ""
    program: str = ""
    vertices: tuple[str, ...] = ()
    arcs: tuple[ArcName, ...] = ()
    fix: Fix | None = None
    thing: str = ""

    @property
    def is_error(self) -> bool:
        """Whether this one stops the program from running."""
        return self.severity is Severity.ERROR


def in_reading_order(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """The same diagnostics by line and column; those without a place first."""
    return sorted(diagnostics, key=lambda item: (item.place.line, item.place.column) if item.place else (0, 0))


@dataclass(frozen=True)
class Rule:
    """A kind of diagnostic: calling it makes one."""

    code: str
    severity: Severity
    title: str
    explanation: Sentence

    def __call__(
        self,
        message: Sentence,
        place: Place | None = None,
        *,
        help: Help = "",
        program: str = "",
        vertices: Iterable[str] = (),
        arcs: Iterable[ArcName] = (),
        fix: Fix | None = None,
    ) -> Diagnostic:
        """A diagnostic of this rule."""
        return Diagnostic(self.code, self.severity, message, place, help, program, tuple(vertices), tuple(arcs), fix)


_RULES: dict[str, Rule] = {}


def rule(code: str, severity: Severity, title: str, explanation: str) -> Rule:
    """Makes and registers a rule; a code is used once, for ever."""
    assert code not in _RULES, f"the code {code} is taken"
    made = _RULES[code] = Rule(code, severity, title, Sentence(explanation))
    return made


def rules() -> Mapping[str, Rule]:
    """All rules of the rooms imported so far, by code."""
    return dict(sorted(_RULES.items()))


@dataclass(eq=False)  # two errors are never the same one, and an exception must stay hashable
class KitRobotError(Exception):
    """The root of what KitRobot raises when an operation failed: one sentence, a way out, and what was found."""

    message: Sentence
    help: Help = ""
    diagnostics: tuple[Diagnostic, ...] = field(default=())

    def __str__(self) -> str:
        return f"{self.message}\nhelp: {self.help}" if self.help else self.message
