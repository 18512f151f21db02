"""The rows of a class as CSV and as one HTML page that needs nothing else.

The page holds every text in every language; which one is shown is chosen in it without a script. All that
comes from files is escaped. In the CSV no cell can begin as a formula of a spreadsheet does.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from typing import Final

from kitrobot.classroom.grades import GoalGrade, Grade, TextsByLanguage, translate_all
from kitrobot.text.sentences import Sentence
from kitrobot.translation.languages import ENGLISH, LANGUAGES

_FORMULA: Final = re.compile(r"""(^|[;,|\t\r\n])([\s"']*)(?=[=+\-@＝＋－＠])""")
"""Where a formula would begin: in a cell, or behind any sign at which a spreadsheet may part it into more."""
_QUOTED: Final = re.compile("`([^`]*)`")


def by_exercise(grades: Sequence[Grade]) -> list[list[Grade]]:
    """Those that were judged, of one exercise each, in the order in which exercises first come."""
    found: dict[tuple[str, ...], list[Grade]] = {}
    for one in grades:
        if one.problem is None:
            found.setdefault((one.exercise["en"], *(goal.label["en"] for goal in one.goals)), []).append(one)
    return list(found.values())


def grounds(rows: Sequence[Grade]) -> Iterator[tuple[int, TextsByLanguage, int]]:
    """How it is known that goals are reached: a goal's number, the ground, and in how many rows of an exercise."""
    for number in range(1, len(rows[0].goals) + 1):
        known = [goal.why for goal in (row.goals[number - 1] for row in rows) if goal.reached and goal.why["en"]]
        for ground in {one["en"]: one for one in known}.values():
            yield number, ground, known.count(ground)


def as_csv(grades: Sequence[Grade]) -> str:
    """A line for each submission and goal: spreadsheets make any table of it. In English, with a byte order mark."""
    out = io.StringIO()
    lines = csv.writer(out, lineterminator="\r\n")
    lines.writerow(["submission", "exercise", "goal", "reached", "points", "of", "seed", "seconds", "why"])
    for one in grades:
        if one.problem is not None:
            lines.writerow(map(as_cell, [one.submission, "", "", "no", 0, "", "", "", one.problem["en"]]))
            continue
        for goal, earned in zip(one.goals, one.earned, strict=True):
            lines.writerow(map(as_cell, _line(one, goal, earned)))
        lines.writerow(
            map(as_cell, [one.submission, one.exercise["en"], "all", _yes(one.full), one.points, one.of, "", "", ""])
        )
    return "\ufeff" + out.getvalue()


def _line(one: Grade, goal: GoalGrade, earned: int) -> list[object]:
    return [
        *(one.submission, one.exercise["en"], goal.label["en"], _yes(goal.reached), earned, goal.points),
        *("" if value is None else value for value in (goal.seed, goal.seconds)),
        goal.why["en"],
    ]


def _yes(value: bool) -> str:
    return "yes" if value else "no"


def as_cell(value: object) -> object:
    """A cell that no spreadsheet takes for a formula, nor what it makes of it: many part lines at semicolons."""
    return _FORMULA.sub(r"\1\2'", value) if isinstance(value, str) else value


def as_html(grades: Sequence[Grade]) -> str:
    """The page."""
    tables = "\n".join(_table(rows) for rows in by_exercise(grades))
    lost = [one for one in grades if one.problem is not None]
    title = Sentence("Grades")
    choice = "\n".join(
        f'<input type="radio" name="language" id="{code}"{" checked" if code == ENGLISH else ""}>'
        f'<label for="{code}" lang="{code}" class="choice">{language.name}</label>'
        for code, language in LANGUAGES.items()
    )
    return f"""<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>{escape(title)}</title>
<style>{_STYLE}{_language_rules()}</style>
<body>
{choice}
<main>
<h1>{_spans(translate_all(title))}</h1>
{tables}
{_lost(lost)}
</main>
</body>
</html>
"""


def _table(rows: Sequence[Grade]) -> str:
    heads = "".join(f"<th>{number}</th>" for number in range(1, len(rows[0].goals) + 1))
    goals = "".join(f"<li>{_spans(goal.label)}{_remarks(goal)}</li>" for goal in rows[0].goals)
    body = "\n".join(
        f'<tr><th scope="row" dir="auto">{escape(one.submission)}</th>{"".join(map(_mark, one.goals))}'
        f"<td>{one.points} / {one.of}</td></tr>"
        for one in rows
    )
    wrong = "".join(item for one in rows for item in _wrong(one))
    known = "".join(
        f"<li>{number}: {_spans(ground)} <small>({count} / {len(rows)})</small></li>"
        for number, ground, count in grounds(rows)
    )
    return f"""<section>
<h2>{_spans(rows[0].exercise)}</h2>
<ol>{goals}</ol>
<div class="scroll"><table>
<thead><tr><th>{_spans(translate_all(Sentence("Submission")))}</th>{heads}<th>{_spans(translate_all(Sentence("Points")))}</th></tr></thead>
<tbody>
{body}
</tbody>
</table></div>
{_list(Sentence("How it is known"), known)}
{_list(Sentence("What went wrong"), wrong)}
</section>"""


def _list(heading: Sentence, items: str) -> str:
    return f"<h3>{_spans(translate_all(heading))}</h3><ul>{items}</ul>" if items else ""


def _remarks(goal: GoalGrade) -> str:
    """What is to be known of a goal besides: that it is hidden, and that it counts only beside others."""
    words = [Sentence("hidden")] * goal.hidden + [Sentence("counts once another goal is reached")] * goal.condition
    return "".join(f" <small>({_spans(translate_all(one))})</small>" for one in words)


def _mark(goal: GoalGrade) -> str:
    words = Sentence("reached") if goal.reached else Sentence("not reached")
    sign, kind = ("✓", "yes") if goal.reached else ("✗", "no")
    spoken = f'<span class="spoken">{_spans(translate_all(words))}</span>'
    return f'<td class="{kind}"><span aria-hidden="true">{sign}</span>{spoken}</td>'


def _wrong(one: Grade) -> Iterator[str]:
    for number, goal in enumerate(one.goals, 1):
        if goal.reached:
            continue
        where = ""
        if goal.seed is not None and goal.seconds is not None:
            where = _spans(translate_all(Sentence("seed {seed}, at {seconds} s", goal.seed, f"{goal.seconds:.1f}")))
            where = f" <small>({where})</small>"
        yield f"<li><b dir='auto'>{escape(one.submission)}</b>, {number}: {_spans(goal.why)}{where}</li>"


def _lost(lost: Sequence[Grade]) -> str:
    if not lost:
        return ""
    items = "".join(f"<li><b dir='auto'>{escape(one.submission)}</b>: {_spans(one.problem or {})}</li>" for one in lost)
    return f"<section><h2>{_spans(translate_all(Sentence('Not judged')))}</h2><ul>{items}</ul></section>"


def _spans(texts: TextsByLanguage | Mapping[str, str]) -> str:
    """A text in each language, of which one is shown; what stands between back quotes is a name."""
    return "".join(
        f'<span class="said" lang="{code}" dir="{language.direction}">{_with_names(texts.get(code, ""))}</span>'
        for code, language in LANGUAGES.items()
    )


def _language_rules() -> str:
    """The rules of CSS that show the chosen language alone."""
    others = ",\n".join(f"#{code}:checked ~ main .said:not([lang={code}])" for code in LANGUAGES)
    mirrored = (code for code, language in LANGUAGES.items() if language.direction == "rtl")
    turned = ", ".join(f"#{code}:checked ~ main" for code in mirrored)
    return f"{others} {{ display: none; }}\n{turned} {{ direction: rtl; line-height: 2; }}\n"


def _with_names(text: str) -> str:
    return _QUOTED.sub(r"<code>\1</code>", escape(text))


_STYLE: Final = """
:root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif; }
body { max-width: 72rem; margin: 1.5rem auto; padding: 0 1rem; }
.choice { margin-inline-end: 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.25rem; margin-top: 2rem; } h3 { font-size: 1rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; }
th, td { padding: .3rem .7rem; border: 1px solid #8888; text-align: center; }
tbody th { text-align: start; font-weight: 500; }
.yes { background: #1a7f3722; } .no { background: #cf222e22; font-weight: 700; }
.spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
@media print { input, .choice { display: none; } body { margin: 0; max-width: none; }
  section { break-inside: avoid-page; } .yes, .no { print-color-adjust: exact; } }
"""
