"""A drawing as SVG: what pens drew, in mm, as large as the world; y goes up in a world and down in SVG."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kitrobot.trace.drawing import Stroke

COLOURS = ("#1b1f27", "#d3202f", "#1c8548", "#1d6ad4", "#e07a1f", "#7549cc", "#d9a400", "#d9529a")
"""The colours of pens by number: black, red, green, blue, orange, violet, yellow, pink."""


def drawing_svg(strokes: Iterable[Stroke], width_mm: float, height_mm: float, floor: Iterable[str] = ()) -> str:
    """The file; the same drawing gives the same bytes. `floor` is SVG that lies under it, line by line."""
    size = f"{_number(width_mm)} {_number(height_mm)}"
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_number(width_mm)}mm" height="{_number(height_mm)}mm" '
        f'viewBox="0 0 {size}" fill="none" stroke-linecap="round" stroke-linejoin="round">',
        *floor,
        *(stroke_svg(stroke, height_mm) for stroke in strokes),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def stroke_svg(stroke: Stroke, height_mm: float) -> str:
    """A line of the file, in mm; y goes up in the stroke."""
    return f'  <path d="{" ".join(_points(stroke, height_mm))}" stroke="{COLOURS[stroke.colour]}" ' + (
        f'stroke-width="{stroke.width_mm}"/>'
    )


def _points(stroke: Stroke, height_mm: float) -> Iterator[str]:
    for at, (x, y) in enumerate(stroke.points):
        yield f"{'L' if at else 'M'}{_number(x)} {_number(height_mm - y)}"
    if len(stroke.points) == 1:
        yield "h0"


def _number(value: float) -> str:
    text = f"{value:.1f}".removesuffix(".0")
    return "0" if text == "-0" else text
