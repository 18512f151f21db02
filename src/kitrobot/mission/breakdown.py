"""What becomes of a robot that fails for good on a road, as a mission says it: `<breakdown rule="tow" after="5"/>`.

Left to others: doing it (sim).
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated

from annotated_types import Ge, Le

from kitrobot.mission import rules
from kitrobot.mission.trial import LONGEST_S
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import decimal, needed, one, optional
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.writer import attributes


class BreakdownRule(StrEnum):
    """It stays where it is; it is towed away, and its box goes back; the others drive round it."""

    STAY = "stay"
    TOW = "tow"
    PASS = "pass"


@dataclass(frozen=True, slots=True)
class Breakdown:
    """The rule, and after how many simulated seconds a robot is towed."""

    rule: BreakdownRule = BreakdownRule.STAY
    after_s: Annotated[float, Ge(0), Le(LONGEST_S)] = 0.0

    @property
    def words(self) -> str:
        """The rule as a few words."""
        if self.rule is BreakdownRule.TOW:
            return Sentence("towed after {seconds} s", f"{self.after_s:g}")
        return Sentence("they stay") if self.rule is BreakdownRule.STAY else Sentence("others drive round them")


def _breakdown(element: Element) -> Breakdown | None:
    rule = BreakdownRule(element.choice("rule"))
    after_s = round(element.decimal("after"), 3)
    if "after" in element.attributes and rule is not BreakdownRule.TOW:
        message = Sentence("`{rule}` takes no time: only who is towed waits for that", rule.value)
        element.report(rules.BREAKDOWN, message, "after", Sentence('take it away, or write rule="tow"'))
    return None if element.faulty else Breakdown(rule, after_s)


BREAKDOWN: dict[str, Tag] = {
    "breakdown": Tag(
        _breakdown,
        {
            "rule": needed(one(*(rule.value for rule in BreakdownRule))),
            "after": optional(
                decimal(0.0, LONGEST_S), "0", about="Simulated seconds until it is towed; 0 if nothing is said."
            ),
        },
        kept_whole=True,
        about="What becomes of a robot that fails for good on a road.",
    )
}
"""Goes among the children of an element with `keep`."""


def write_breakdown(breakdown: Breakdown) -> list[str]:
    """Its line without the break; none for a robot that stays."""
    if breakdown.rule is BreakdownRule.STAY:
        return []
    seconds = f"{breakdown.after_s:.3f}".rstrip("0").rstrip(".")
    after = seconds if breakdown.rule is BreakdownRule.TOW and breakdown.after_s != 0 else None
    return [f"<breakdown{attributes(('rule', breakdown.rule.value), ('after', after))}/>"]


def the_breakdown(root: Element) -> Breakdown:
    """What a mission says; that a robot stays, when it says nothing. A second one is told."""
    found = root.found_at(Breakdown)
    for _, element in found[1:]:
        element.report(
            rules.BREAKDOWN,
            Sentence("this mission has said already what becomes of robots that fail on a road"),
            help=Sentence("take one away"),
        )
    return found[0][0] if found else Breakdown()
