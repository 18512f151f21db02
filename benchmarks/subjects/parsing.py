"""Reading LLL: text → tree, against Lark with the same grammar.

Counted: one text read into a tree of all its constructs. Not counted: making the text, building Lark's tables. Ours
also keeps every node's place and the comments, and looks for missing `;`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from benchmarks.measurement import Rate, Row, in_turns
from benchmarks.peers.lark_parser import LarkParser, calls
from benchmarks.random_programs import text_of_lines
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import Call
from kitrobot.lll.walk import nodes

TITLE = "parsing"


@dataclass(frozen=True)
class Size:
    lines: int
    rounds: int


FULL = Size(40_000, 5)
TINY = Size(60, 1)


def run(size: Size, *, peers: bool) -> list[Row]:
    text = text_of_lines(size.lines)
    lines = text.count("\n")
    parsed = parse(text)
    assert not parsed.diagnostics
    work: dict[str, Callable[[], object]] = {"ours": lambda: parse(text)}
    lark = LarkParser() if peers else None
    if lark is not None:
        ours, theirs = sum(isinstance(node, Call) for node in nodes(parsed.program)), calls(lark.parse(text))
        assert ours == theirs, f"Lark reads {theirs} calls and we read {ours}"
        del parsed
        work["lark"] = lambda: lark.parse(text)
    seconds = in_turns(work, size.rounds)
    what = "LLL text → tree"
    if lark is None:
        return [Row(what, "lines/s", Rate.of(lines, seconds["ours"]))]
    rates = {name: Rate.of(lines, taken) for name, taken in seconds.items()}
    return [Row(what, "lines/s", rates["ours"], lark.name, rates["lark"])]
