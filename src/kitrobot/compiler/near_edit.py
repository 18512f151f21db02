"""A text that differs from the one a graph prints in some lines only: those alone are read, drawn and checked.

The lines must hold whole instructions of one body, and the new text must be the very one that its graph prints. Both
texts then read alike but for these lines, since an instruction is read without looking at what stands around it, and
comments belong to what their own lines hold. What comes of it is compared with what was typed, in tree and in text;
where anything of this does not hold, the answer is None and the whole is to be looked at.
"""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass, fields, replace
from typing import Any

from kitrobot.compiler.accepted_forms import normalise
from kitrobot.compiler.compilation import text_of
from kitrobot.compiler.graph_to_lll import Translation
from kitrobot.compiler.preserve_ids import Before
from kitrobot.compiler.retranslation import graph_to_lll_again
from kitrobot.compiler.stretch import Stretch, draw_stretch
from kitrobot.graph.model import Program
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_lines
from kitrobot.lll.tree import Parallel, Seq
from kitrobot.lll.walk import bodies
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.text.affixes import common_affixes

_MOST = 0.5
"""Of a text: where more of it changed, the whole is as quickly looked at."""


@dataclass(frozen=True)
class _Lines:
    """Whole lines of a text that are instructions of a body: from the item `first` to `last`, at these offsets.

    `path` leads to the body: the items of the bodies around it that hold it, and which of their bodies.
    """

    body: Seq
    first: int
    last: int
    start: int
    end: int
    path: tuple[tuple[int, int], ...]


def follow_near(before: Translation, text: str, catalogue: Catalogue) -> tuple[Program, Translation] | None:
    """The graph of the text and its translation, whose text is this one; None where the whole is to be looked at.

    The lineage's lock must be held. A text need not end with a line break.
    """
    text = text if text.endswith("\n") else f"{text}\n"
    lineage, tree = before.lineage, before.program
    if before.diagnostics or before.wiring.robot.level.is_team or not before.pieces:
        return None
    printed = text_of(before, catalogue)
    if lineage.read is not tree:
        read = parse(printed)
        if read.diagnostics or read.program != tree:
            return None
        lineage.read = tree
    start, tail = common_affixes(printed, text)
    end, new_end = len(printed) - tail, len(text) - tail
    begin = _line_start(printed, start)
    if not (_line_start(printed, end) == end and _line_start(text, new_end) == new_end):
        end = _line_end(printed, end)
    lines = _lines(tree, printed, begin, end, before)
    if lines is None:
        return None
    typed = text[lines.start : lines.end + len(text) - len(printed)]
    if len(typed) > _MOST * len(text):
        return None
    parsed = parse(typed)
    new = parsed.program
    if parsed.diagnostics or not new.items or new.below or new.hole is not None:
        return None
    normalise(new, catalogue)
    if print_lines(new, len(lines.path)) != typed:
        return None

    row = lines.body.items
    items = [*row[: lines.first], *new.items, *row[lines.last + 1 :]]
    stretch = Stretch(lines.body, replace(lines.body, items=items), lines.first, len(row) - 1 - lines.last)
    drawn = draw_stretch(
        stretch, before.wiring.robot, catalogue, Before(before, Seq(row[max(0, lines.first - 1) : lines.last + 2]))
    )
    if drawn is None:
        return None
    made = graph_to_lll_again(before, drawn, catalogue)
    if made.diagnostics or made.program != _with_items(tree, lines.path, items) or text_of(made, catalogue) != text:
        return None
    lineage.read = made.program
    return drawn, made


def _lines(tree: Seq, text: str, start: int, end: int, before: Translation) -> _Lines | None:
    """The lines around whole lines of a text that are instructions of the innermost body that those are in."""
    body, top = tree, 0
    path: tuple[tuple[int, int], ...] = ()
    found: _Lines | None = None
    while True:
        items = body.items
        if not all(_is_own(item, before) for item in items):
            return found
        first = bisect_left(items, start + 1, key=lambda item: _line_end(text, item.end))
        last = bisect_left(items, end, key=lambda item: _line_end(text, item.end))
        if last == len(items) or last < first - 1:
            return found
        begin = top if first == 0 else _line_end(text, items[first - 1].end)
        found = _Lines(body, first, last, begin, _line_end(text, items[last].end), path)
        inner = None if first != last or isinstance(items[first], Parallel) else _around(items[first], text, start, end)
        if inner is None:
            return found
        number, body = inner
        top = body.start + 1
        path = (*path, (first, number))


def _around(item: Any, text: str, start: int, end: int) -> tuple[int, Seq] | None:
    """The body of an instruction on whose own lines a stretch is, and which of its bodies that is."""
    for number, body in enumerate(bodies(item)):
        if text[body.start : body.start + 1] == "\n" and body.start < start and end <= _line_start(text, body.end):
            return number, body
    return None


def _is_own(item: Any, before: Translation) -> bool:
    """Whether an instruction is all that its vertex became."""
    piece = before.pieces.get(item.vertex)
    return piece is not None and len(piece.row) == 1 and piece.row[0] is item and item.vertex not in before.stretches


def _line_start(text: str, offset: int) -> int:
    """Where the line of an offset begins."""
    return text.rfind("\n", 0, offset) + 1


def _line_end(text: str, offset: int) -> int:
    """Where the line after that of an offset begins, or the text ends."""
    return text.find("\n", offset) + 1 or len(text)


def _with_items(seq: Seq, path: tuple[tuple[int, int], ...], items: list[Any]) -> Seq:
    """The tree with other items in the body that the path leads to; it shares all else."""
    if not path:
        return replace(seq, items=items)
    (at, number), *rest = path
    item: Any = seq.items[at]
    inner = bodies(item)[number]
    made = _with_items(inner, tuple(rest), items)
    part = next(one.name for one in fields(item) if getattr(item, one.name) is inner)
    return replace(seq, items=[*seq.items[:at], replace(item, **{part: made}), *seq.items[at + 1 :]])
