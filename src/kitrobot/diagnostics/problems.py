"""Diagnostics on their way to a user: with the texts they point into, and with a way out for each."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Source, rules
from kitrobot.diagnostics.renderer import render

SHOWN = 10


@dataclass(eq=False)
class ProblemsError(KitRobotError):
    """Something could not be done because of the user's mistakes: `diagnostics`, and the texts they stand in.

    As text, which is what a traceback of Python shows, it has the first `SHOWN` of them.
    """

    sources: tuple[Source, ...] = ()

    def __str__(self) -> str:
        more = f"\n{len(self.diagnostics) - SHOWN} more in `diagnostics`" if len(self.diagnostics) > SHOWN else ""
        return f"{super().__str__()}\n{written_out(self.diagnostics[:SHOWN], self.sources)}".rstrip() + more


def with_help(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """The same diagnostics, each with a help line: where the finder had no better advice, what its rule is about."""
    known = rules()
    return [
        item if item.help or item.code not in known else replace(item, help=known[item.code].explanation)
        for item in diagnostics
    ]


def written_out(diagnostics: Iterable[Diagnostic], sources: Iterable[Source] = ()) -> str:
    """Diagnostics as people read them: place, sentence, the line with a caret under the mistake, help."""
    return render(with_help(diagnostics), {source.name: source for source in sources})
