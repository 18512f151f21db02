"""`PROGRAM name` in a team's program gives way to a copy of that program; its instructions say where they are from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any, Protocol

from kitrobot.compiler.graph.rules import TOO_DEEP
from kitrobot.compiler.rules import TOO_LARGE
from kitrobot.diagnostics.model import Rule
from kitrobot.image.model import MOST_INSTRUCTIONS
from kitrobot.lll.tree import MAX_NESTING, Instruction, Members, Node, ProgramCall, Seq
from kitrobot.text.sentences import Help, Sentence


class Report(Protocol):
    """Collects a diagnostic."""

    def __call__(self, rule: Rule, message: Sentence, node: Node, help: Help = "") -> None: ...


def inlined(seq: Seq, name: str, programs: Mapping[str, Seq], report: Report) -> Seq:
    """A copy of a program, called `name`, in which each `PROGRAM` is what it stands for.

    Programs that are not there, and circles, are left out: they are told where names are checked. What nests too deep
    or becomes too large is left out and reported at the outermost `PROGRAM`.
    """
    return _Inliner(programs, report).copied(seq, name)


class _Inliner:
    def __init__(self, programs: Mapping[str, Seq], report: Report) -> None:
        self._programs = programs
        self._report = report
        self._open: list[str] = []
        self._outermost: Node | None = None
        self._depth = 0
        self._left = MOST_INSTRUCTIONS
        self._reported = False

    def copied(self, seq: Seq, name: str) -> Seq:
        self._open.append(name)
        made = self._seq(seq)
        self._open.pop()
        return made

    def _seq(self, seq: Seq) -> Seq:
        made = Seq(start=seq.start, end=seq.end)
        self._depth += 1
        if self._depth > MAX_NESTING:
            self._report_once(
                TOO_DEEP,
                Sentence("with all programs in their places this nests deeper than {most} levels", MAX_NESTING),
            )
        else:
            for node in seq.items:
                if isinstance(node, ProgramCall):
                    made.items += self._called(node)
                else:
                    made.items.append(self._node(node))
        self._depth -= 1
        return made

    def _called(self, node: ProgramCall) -> list[Any]:
        assert isinstance(node.name, str), "no template"
        called = self._programs.get(node.name)
        if called is None or node.name in self._open or self._reported:
            return []
        outermost = self._outermost
        self._outermost = outermost or node
        items = self.copied(called, node.name).items
        self._outermost = outermost
        return items

    def _node(self, node: Any) -> Any:
        if isinstance(node, Seq):
            return self._seq(node)
        if isinstance(node, list):
            return [self._node(item) for item in node]
        if not isinstance(node, Node) or isinstance(node, Members):
            return node
        made = type(node)(**{part.name: self._node(getattr(node, part.name)) for part in fields(node) if part.init})
        if isinstance(made, Instruction):
            made.program = self._open[-1]
            made.above, made.after = [], None
            self._left -= 1
            if self._left < 0:
                what = "with all programs in their places this has more than {most} instructions"
                self._report_once(TOO_LARGE, Sentence(what, MOST_INSTRUCTIONS))
        return made

    def _report_once(self, rule: Rule, message: Sentence) -> None:
        if not self._reported and self._outermost is not None:
            self._reported = True
            self._report(rule, message, self._outermost, Sentence("take a PROGRAM away, or split the program"))
