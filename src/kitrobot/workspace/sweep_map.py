"""The heat map of a fail sweep as SVG: a square for each field, in the colour of its outcome.

Of single failures it has a row for each agent and a column for each moment. Of pairs it has a block for each two
agents, with the moments of the one of the row downwards and those of the one of the column to the right. Neighbours
with the same outcome are one rectangle, whose title says which they are. What is not done has a pattern besides its
colour. The same sweep gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Final

from kitrobot.sim.outcome import Outcome
from kitrobot.sim.sweep import Fault
from kitrobot.workspace.sweep import OUTCOMES, Sweep
from kitrobot.xml.writer import escape_text

COLOURS: Final[dict[str, str]] = {
    "done": "#2f9e78",
    "failed": "#f2b84b",
    "stuck": "#c0392b",
    "time": "#6c4fa3",
    "": "#e3e3e6",
}
WORDS: Final[dict[str, str]] = {
    "done": "done",
    "failed": "failed, with the reason",
    "stuck": "stuck",
    "time": "out of time",
    "": "not run",
}
_PATTERNS: Final[dict[str, str]] = {
    "failed": '<path d="M0 6 6 0" stroke="#8a5a00" stroke-width="1"/>',
    "stuck": '<path d="M0 0 6 6M0 6 6 0" stroke="#ffffff" stroke-width="1"/>',
    "time": '<circle cx="3" cy="3" r="1.2" fill="#ffffff"/>',
}
_ROW, _WIDE = 18, 800
"""Height of a row and width of all moments, of a map of single failures, in px."""
_GAP, _SMALL = 4, 4
"""Between blocks, and the least side of a square in them, in px."""
_BLOCK = 80
"""The least side of a block, in px."""
_LETTER = 7
"""About how wide a letter is, in px."""
_LEGEND = 40

Outcomes = dict[tuple[Fault, ...], Outcome]


def heat_map(sweep: Sweep, title: str) -> str:
    """The map as the text of an SVG file. `title` stands above it."""
    outcomes: Outcomes = {field.faults: field.outcome for field in sweep.fields}
    margin = 16 + _LETTER * max(len(name) for name in sweep.agents)
    if sweep.pairs:
        width, height, lines = _pairs(sweep, outcomes, margin)
    else:
        width, height, lines = _singles(sweep, outcomes, margin)
    width = max(width, 16 + _LETTER * len(title), 560)
    counts = sweep.counts
    told = ", ".join(f"{counts[outcome]} {WORDS[outcome]}" for outcome in OUTCOMES if counts[outcome])
    patterns = [
        f'<pattern id="{name}" width="6" height="6" patternUnits="userSpaceOnUse">'
        f'<rect width="6" height="6" fill="{COLOURS[name]}"/>{drawn}</pattern>'
        for name, drawn in _PATTERNS.items()
    ]
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height + _LEGEND}"'
            f' viewBox="0 0 {width} {height + _LEGEND}" font-family="sans-serif" font-size="12" role="img">',
            f"<title>{escape_text(title)}</title>",
            f"<desc>{len(sweep.fields)} of {sweep.total} fields: {told}</desc>",
            f"<defs>{''.join(patterns)}</defs>",
            '<rect width="100%" height="100%" fill="#ffffff"/>',
            f'<text x="8" y="20" font-size="14" fill="#1c1c1e">{escape_text(title)}</text>',
            *lines,
            *_legend(sweep, height + 8),
            "</svg>\n",
        )
    )


def _singles(sweep: Sweep, outcomes: Outcomes, margin: int) -> tuple[int, int, list[str]]:
    side = _WIDE / len(sweep.moments)
    lines, y = [], 34
    for agent, name in enumerate(sweep.agents):
        lines.append(_label(margin - 8, y + _ROW - 5, name, "end"))
        row = [outcomes.get((Fault(agent, tick),), "") for tick in sweep.moments]
        lines += _runs(sweep, row, name, (margin, y, side, _ROW - 2))
        y += _ROW
    lines += _scale(sweep, margin, y + 12, _WIDE)
    return margin + _WIDE + 24, y + 28, lines


def _pairs(sweep: Sweep, outcomes: Outcomes, margin: int) -> tuple[int, int, list[str]]:
    side = max(_SMALL, _BLOCK / len(sweep.moments))
    block = side * len(sweep.moments) + _GAP
    lines, last = [], len(sweep.agents) - 1
    for one, name in enumerate(sweep.agents[:-1]):
        y = 56 + one * block
        lines.append(_label(margin - 8, round(y + block / 2), name, "end"))
        for other in range(one + 1, last + 1):
            x = margin + (other - 1) * block
            rows = [
                [outcomes.get(_pair(Fault(one, tick), Fault(other, later)), "") for later in sweep.moments]
                for tick in sweep.moments
            ]
            n = 0
            for row, alike in groupby(rows):
                count = len(list(alike))
                told = f"{name} {_when(sweep, n, count)}, {sweep.agents[other]}"
                lines += _runs(sweep, row, told, (x, y + n * side, side, count * side))
                n += count
    for other in range(1, last + 1):
        lines.append(_label(round(margin + (other - 0.5) * block), 48, sweep.agents[other], "middle", block))
    return round(margin + last * block + 24), round(56 + last * block + 8), lines


def _pair(one: Fault, other: Fault) -> tuple[Fault, ...]:
    return (one, other) if one.tick <= other.tick else (other, one)


def _runs(sweep: Sweep, row: Sequence[str], told: str, place: tuple[float, float, float, float]) -> Iterator[str]:
    """Rectangles for the fields of a row; `place` is where it begins, and how wide and high a field is."""
    x, y, wide, high = place
    at = 0
    for outcome, group in groupby(row):
        count = len(list(group))
        when = _when(sweep, at, count)
        fill = f"url(#{outcome})" if outcome in _PATTERNS else COLOURS[outcome]
        yield (
            f'<rect x="{x + at * wide:.4g}" y="{y:.4g}" width="{count * wide:.4g}" height="{high:.4g}" fill="{fill}">'
            f"<title>{escape_text(f'{told} {when}: {WORDS[outcome]}')}</title></rect>"
        )
        at += count


def _when(sweep: Sweep, at: int, count: int) -> str:
    first, last = (f"{sweep.seconds(sweep.moments[n]):.1f}" for n in (at, at + count - 1))
    return f"at {first} s" if count == 1 else f"at {first} to {last} s"


def _label(x: float, y: float, text: str, anchor: str, room: float = 0) -> str:
    """A word; squeezed into `room`, where that is given."""
    squeezed = f' textLength="{room - 8:.4g}" lengthAdjust="spacingAndGlyphs"' if 0 < room < _LETTER * len(text) else ""
    return f'<text x="{x}" y="{y}" text-anchor="{anchor}"{squeezed} fill="#1c1c1e">{escape_text(text)}</text>'


def _scale(sweep: Sweep, x: float, y: float, width: float) -> list[str]:
    """Simulated seconds below a row of moments."""
    end = sweep.baseline.seconds
    return [_label(round(x + width * part / 4), round(y), f"{end * part / 4:.0f} s", "middle") for part in range(5)]


def _legend(sweep: Sweep, y: int) -> Iterator[str]:
    counts: dict[str, int] = {str(outcome): count for outcome, count in sweep.counts.items()}
    counts[""] = sweep.total - len(sweep.fields)
    x = 8
    for outcome in (*OUTCOMES, ""):
        if outcome != "done" and not counts[outcome]:
            continue
        fill = f"url(#{outcome})" if outcome in _PATTERNS else COLOURS[outcome]
        words = f"{WORDS[outcome]}: {counts[outcome]}"
        yield f'<rect x="{x}" y="{y}" width="14" height="14" fill="{fill}"/>'
        yield _label(x + 20, y + 12, words, "start")
        x += 40 + _LETTER * len(words)
