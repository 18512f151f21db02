"""A study as HTML, for notebooks: a line for each point with its intervals, and how they were computed."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from kitrobot.experiments.study_rows import StudyRows
from kitrobot.experiments.summary import cell_text, summarise

MOST_POINTS = 60
"""Points that are shown; of more it is said how many there are."""


def study_html(study: StudyRows) -> str:
    """The numbers of a study so far as a table; everything that comes from files is escaped."""
    found, plan = summarise(study), study.plan
    done = sum(sum(one.outcomes.values()) for one in found)
    rows = [
        [*map(str, one.point.values()), str(sum(one.outcomes.values())), *(cell_text(cell) for cell in one.cells)]
        for one in found[:MOST_POINTS]
    ]
    methods = dict.fromkeys(
        f"{cell.interval.confidence:.4g}: {cell.interval.method}"
        for one in found
        for cell in one.cells
        if cell.interval is not None
    )
    notes = [*methods]
    if len(found) > MOST_POINTS:
        notes.insert(0, f"{MOST_POINTS} of {len(found)} points")
    return (
        f"<table><caption>{escape(study.folder.name)}: {done} of {plan.rows} runs</caption>"
        f"<thead>{_line('th', [*plan.addresses, 'runs', *plan.measured])}</thead>"
        f"<tbody>{''.join(_line('td', row) for row in rows)}</tbody></table>"
        + "".join(f"<p>{escape(note)}</p>" for note in notes)
    )


def _line(tag: str, cells: Sequence[str]) -> str:
    return f"<tr>{''.join(f'<{tag}>{escape(cell)}</{tag}>' for cell in cells)}</tr>"
