"""LLL with holes as the text of an element: read, with what is wrong with it at its place in the XML file.

Entities and CDATA are followed, so a mistake inside `*[{a} &amp; {b}]` is shown where it stands. Left to others: which
holes there may be.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import accumulate

from kitrobot.lll.parse_results import parse_template
from kitrobot.lll.tree import Condition, Hole, Instr, Seq
from kitrobot.primitives import rules
from kitrobot.text.sentences import Sentence
from kitrobot.xml.element import Element

LONGEST_CODE = 10_000
"""Characters of a template, at most."""

Template = Instr | Condition | Seq


def read_template(element: Element) -> Template | None:
    """The template that an element's text is; None when it is not LLL, which is reported."""
    if len(element.text) > LONGEST_CODE:
        element.report(
            rules.TEMPLATE,
            Sentence("expected at most {longest} characters, found {count}", LONGEST_CODE, len(element.text)),
        )
        return None
    template, problems = parse_template(element.text, element.reader.name)
    offsets = element.reader.offsets_of_text(element)
    starts = [0, *accumulate(len(line) + 1 for line in element.text.split("\n"))]
    for problem in problems:
        if problem.place is not None:
            start = starts[problem.place.line - 1] + problem.place.column - 1
            end = starts[problem.place.end_line - 1] + problem.place.end_column - 1
            problem = replace(problem, place=element.reader.span(offsets[start], offsets[end]))
        element.add(problem)
    if isinstance(template, Hole):
        element.report(rules.TEMPLATE, Sentence("expected LLL around the hole, found only a hole"))
    return template
