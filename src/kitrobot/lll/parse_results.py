"""Text → tree, by one reader for programs of robots, of teams, and for templates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar

from kitrobot.diagnostics.model import Diagnostic, Source
from kitrobot.lll import rules
from kitrobot.lll.parser import Parser
from kitrobot.lll.tokens import NAME, QUOTED, SYMBOL, tokenise
from kitrobot.lll.tree import Call, Condition, Instr, Members, Seq, TeamProgram
from kitrobot.text.collection import collection_paused
from kitrobot.text.forms import FINISH_MERGE, UNFINISHED_MERGE, conflict_mark
from kitrobot.text.sentences import Sentence

ProgramRead = TypeVar("ProgramRead", Seq, TeamProgram)


@dataclass(frozen=True)
class _ParseResult(Generic[ProgramRead]):
    """What was read: the program (what could be understood of it), the mistakes, and the text they point into."""

    program: ProgramRead
    diagnostics: list[Diagnostic]
    source: Source

    @property
    def ok(self) -> bool:
        """Whether the text is free of errors."""
        return not any(item.is_error for item in self.diagnostics)


class ParseResult(_ParseResult[Seq]):
    """The program of one robot as it was read, its mistakes, and the text they point into."""


class ParsedTeam(_ParseResult[TeamProgram]):
    """The program of a team as it was read, its mistakes, and the text they point into."""


def parse(text: str, name: str = "program.lll") -> ParseResult:
    """Reads an LLL program. `name` is the file name that diagnostics show. Never raises for a mistake in the text."""
    with collection_paused():
        parser = Parser(text, name, template=False)
        return ParseResult(parser.program(), _mistakes(parser), parser.source)


def parse_team(text: str, name: str = "team.lll") -> ParsedTeam:
    """Reads the program of a team: its declarations, and its instructions. Never raises for a mistake in the text."""
    with collection_paused():
        parser = Parser(text, name, template=False)
        parser.team = TeamProgram(start=0, end=len(text))
        parser.declarations()
        start = parser.tokens[parser.at][1]
        parser.team.seq = parser.program()
        parser.team.seq.start = start
        return ParsedTeam(parser.team, _mistakes(parser), parser.source)


def _mistakes(parser: Parser) -> list[Diagnostic]:
    """What is wrong; where a merge was not finished, that alone."""
    mark = conflict_mark(parser.text) if parser.diagnostics else None
    if mark is None:
        return parser.diagnostics
    return [rules.SYNTAX(UNFINISHED_MERGE, parser.source.place(mark, mark + 7), help=FINISH_MERGE)]


def parse_any(text: str, name: str = "program.lll") -> ParseResult | ParsedTeam:
    """Reads a program of one robot; one with forms of a team as a team's."""
    parsed = parse(text, name)
    if any(item.code == rules.TEAM_FORM.code for item in parsed.diagnostics):
        return parse_team(text, name)
    return parsed


def parse_members(text: str) -> Members | None:
    """The set that a text is, such as `carriers` or `{carriers, loader}`; None where it is none."""
    return Parser(text, "", template=False, team=True).whole_set()


def parse_names(text: str) -> list[str]:
    """Names parted by spaces, those between double quotes as they are; none where there is anything else."""
    tokens = tokenise(text, team=True).tokens[:-1]
    return [str(name) for *_, name in tokens] if all(kind in (NAME, QUOTED) for kind, *_ in tokens) else []


def parse_template(text: str, name: str = "template") -> tuple[Instr | Condition | Seq | None, list[Diagnostic]]:
    """Reads a constructor's `<code>`: one instruction, several (a `Seq`), or a condition, with holes.

    None when the text is not LLL; then the diagnostics say why.
    """
    if not text.strip():
        return None, [rules.SYNTAX(Sentence("a template cannot be empty"), Source(name, text).place(0, 0))]
    parser = Parser(text, name, template=True)
    program = parser.program()
    if not any(item.is_error for item in parser.diagnostics):
        if len(program.items) + (program.hole is not None) != 1:
            return program, parser.diagnostics
        if program.items and not isinstance(program.items[0], Call):
            return program.items[0], parser.diagnostics
    other = Parser(text, name, template=True)
    condition = other.whole_condition()
    if not other.diagnostics:
        return condition, []
    if any(item.is_error for item in parser.diagnostics):
        looks_like_condition = any(kind == SYMBOL and text in "&|" for kind, _, _, text in other.tokens)
        return None, other.diagnostics if looks_like_condition else parser.diagnostics
    return program.items[0] if program.items else program.hole, parser.diagnostics
