"""Plots as SVG that is readable on light and dark paper; the numbers upwards are on a logarithmic axis."""

from __future__ import annotations

import math
from collections.abc import Sequence

WIDTH, HEIGHT = 640, 400
LEFT, RIGHT, TOP, BOTTOM = 70, 36, 48, 60
INK, PALE, GRID = "#222222", "#555555", "#dddddd"


class Plot:
    """A plot that is being drawn: a frame, and what is put into it.

    Args:
        title: what it says to those who cannot see it.
        head, below: its heading, and a line below that.
        values: what is to find room on the axis upwards.
        unit: what they are in.
        places: from the first to the last place of the axis to the right.
        axis: what that is.
    """

    def __init__(
        self,
        title: str,
        head: str,
        below: str,
        values: Sequence[float],
        unit: str,
        places: tuple[float, float],
        axis: str,
    ) -> None:
        self.low, self.high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
        self._places = places
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
            'font-size="13">',
            f"<title>{title}</title>",
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
            f'<text x="{LEFT}" y="22" font-size="15" font-weight="600" fill="{INK}">{head}</text>',
            f'<text x="{LEFT}" y="39" fill="{PALE}">{below}</text>',
        ]
        for power in range(self.low, self.high + 1):
            at = self.y(10**power)
            self.parts.append(f'<path d="M{LEFT} {at:.1f}H{WIDTH - RIGHT}" stroke="{GRID}"/>')
            self.text(LEFT - 8, at + 4, f"{_short(10.0**power)}{unit}", PALE, "end")
        self.text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 14, axis, PALE, "middle")

    def x(self, place: float) -> float:
        """Where a place of the axis to the right is."""
        first, last = self._places
        return LEFT + (place - first) / (last - first) * (WIDTH - LEFT - RIGHT)

    def y(self, value: float) -> float:
        """Where a value is."""
        return HEIGHT - BOTTOM - (math.log10(value) - self.low) / (self.high - self.low) * (HEIGHT - TOP - BOTTOM)

    def mark(self, place: float, text: str) -> None:
        """A line up from a place of the axis to the right, and what it says."""
        at = self.x(place)
        self.parts.append(f'<path d="M{at:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="{GRID}"/>')
        self.text(at, HEIGHT - BOTTOM + 20, text, PALE, "middle")

    def line(self, points: Sequence[tuple[float, float]], colour: str, dashes: str = "", dots: bool = True) -> None:
        """A line through places and their values."""
        shown = [(self.x(place), self.y(value)) for place, value in points]
        way = " ".join(f"{x:.1f},{y:.1f}" for x, y in shown)
        style = f'stroke-dasharray="{dashes}"' if dashes else 'stroke-width="2.5"'
        self.parts.append(f'<polyline points="{way}" fill="none" stroke="{colour}" {style}/>')
        if dots:
            self.parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}"/>' for x, y in shown]

    def text(self, x: float, y: float, words: str, colour: str, anchor: str = "start") -> None:
        """Words at a point of the picture."""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}">{words}</text>')

    def svg(self) -> str:
        """The picture."""
        return "\n".join([*self.parts, "</svg>"]) + "\n"


def _short(value: float) -> str:
    """A power of ten: 0.1, 10, 100 k, 1 M."""
    for factor, letter in ((1e6, " M"), (1e3, " k")):
        if value >= factor:
            return f"{value / factor:g}{letter}"
    return f"{value:g}"
