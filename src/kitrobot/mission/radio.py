"""How the robots of a mission hear each other, both ways: `<radio>` in a `.krt`.

Without one, everybody hears everybody, and what is said is heard before the next tick.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from annotated_types import Ge, Le

from kitrobot.xml.attributes import decimal, optional, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.writer import attributes

LARGEST_RANGE_MM = 1_000_000.0
LONGEST_DELAY_MS = 2000


@dataclass(frozen=True)
class Radio:
    """`range_mm`: how far a robot is heard, from middle to middle, None for everywhere; `delay_ms`: how long a message
    takes; `loss`: the part of all messages that gets lost, in %.
    """

    range_mm: Annotated[float, Ge(1), Le(LARGEST_RANGE_MM)] | None = None
    delay_ms: Annotated[int, Ge(0), Le(LONGEST_DELAY_MS)] = 0
    loss: Annotated[float, Ge(0), Le(100)] = 0.0


def _radio(element: Element) -> Radio | None:
    range_mm = round(element.decimal("range"), 3) if "range" in element.attributes else None
    delay_ms, loss = element.integer("delay"), round(element.decimal("loss"), 3)
    return None if element.faulty else Radio(range_mm, delay_ms, loss)


RADIO: dict[str, Tag] = {
    "radio": Tag(
        _radio,
        {
            "range": optional(decimal(1.0, LARGEST_RANGE_MM), about="How far it is heard, in mm; else everywhere."),
            "delay": optional(whole(0, LONGEST_DELAY_MS), "0", about="How long a message takes, in ms."),
            "loss": optional(decimal(0.0, 100.0), "0", about="How many messages of a hundred get lost."),
        },
        about="How the robots hear each other; else everybody hears everybody, at once.",
    )
}
"""Goes among the children of a mission."""


def write_radio(radio: Radio) -> str:
    """One line without its break."""
    range_mm = None if radio.range_mm is None else _number(radio.range_mm)
    loss = _number(radio.loss) if radio.loss else None
    return f"<radio{attributes(('range', range_mm), ('delay', radio.delay_ms or None), ('loss', loss))}/>"


def _number(value: float) -> str:
    return f"{value:.3f}".rstrip("0").rstrip(".")
