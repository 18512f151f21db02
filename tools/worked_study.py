"""Do the worked study; write the notebook docs/worked-study.ipynb, the page docs/worked-study.md and its figures.

    python -m tools.worked_study            do it, and write all of it
    python -m tools.worked_study --check    only say whether the page is the notebook's; status 1 if it is not

What cells show is what they gave when they were executed here, one after another, as a notebook does. The page is made
of the notebook alone.
"""

from __future__ import annotations

import ast
import contextlib
import html
import io
import json
import os
import re
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

DOCS = Path(__file__).resolve().parents[1] / "docs"
NOTEBOOK = DOCS / "worked-study.ipynb"
PAGE = DOCS / "worked-study.md"
FIGURE = "pictures/worked-study-{number}.svg"

SEEDS = "range(1, 201)"
"""As the first cell says it; a test does the study with fewer."""

CELLS = (
    """# A worked study: does a second spare loader pay?

In the mission `transport-team` robots carry twelve boxes from storehouse A to storehouse B. Two loaders are there for
the work of one: when one fails, the other takes over. Does a second spare pay?

The studio answers this with *Run → Experiment…*, the command line with `kitrobot sweep`. Here it is in Python, as a
[notebook](worked-study.ipynb) that you can open in Jupyter; all numbers on this page come from it.

## The runs

Every robot fails within a minute with a probability of 20 %. Two loaders, as the mission has them, one and three get
the same 200 seeds.""",
    f"""```python
import kitrobot

study = kitrobot.sweep(
    "transport-team",
    vary={{"agents.loader": [2, 1, 3]}},
    fail_rate=0.2,
    seeds={SEEDS},
    seconds=300,
    measures=["done", "delivered", "seconds"],
    folder="spare-loaders",
)
study
```""",
    """Each cell of the table has the mean and, in brackets, the interval that holds it with 95 % confidence. `done` is
the share of runs that deliver all boxes. The folder `spare-loaders` holds all runs: a script that is started again
makes only those that are missing.

## The picture""",
    """```python
study.plot("done")
```""",
    """## Is the difference real?

Runs with the same seed make pairs: chance begins the same on both sides. So differences of pairs say more than two
means side by side. The first value is compared with each of the others; the p-values are Holm's, since there are two
comparisons.""",
    """```python
for one in study.compare("agents.loader", "done"):
    low, high = one.interval.low, one.interval.high
    print(f"{one.other} instead of {one.first} loaders: {one.interval.estimate:+.1%} done", end="")
    print(f" ({low:+.1%} to {high:+.1%}), p = {one.p_value:.2g}")
```""",
    """## Why do runs fail?

Each row has the sentence that its run ended with. With three loaders, this is who was missing:""",
    """```python
import re
from collections import Counter

failed = [row for row in study if row.point["agents.loader"] == 3 and row.outcome == "failed"]
missing = Counter(re.search("nobody is left of ([\\\\w-]+)", str(row.sentence)).group(1) for row in failed)
for role, runs in missing.most_common():
    print(f"{runs:3} runs: nobody is left of {role}")
```""",
    """## The run behind a number

A row is a run that can be played. This one delivered least:""",
    """```python
from pathlib import Path

row = study.best("delivered")
print(f"{row.point}, seed {row.seed}: {row.sentence}")
recording = row.record(Path("least.krtrace"))
```""",
    """`kitrobot studio least.krtrace` plays it. In the studio, a press on a dot of the figure does the same.

## What it costs to be sure

How probable is it that two loaders deliver everything within two minutes? As many runs are made as the answer
takes.""",
    """```python
found = kitrobot.probability("transport-team", "done within 120", fail_rate=0.2, precision=0.05, jobs=1)
print(f"{found.interval.estimate:.1%} ({found.interval.low:.1%} to {found.interval.high:.1%}) of {found.runs} runs")
```""",
)


def do_study(cells: Sequence[str] = CELLS) -> dict[str, Any]:
    """The notebook, in nbformat 4.5, with what its cells gave when they were executed in a folder of their own."""
    names: dict[str, Any] = {"__name__": "__main__"}
    made: list[dict[str, Any]] = []
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for number, cell in enumerate(cells):
                made.append(
                    _cell(cell, f"cell-{number}", len([one for one in made if one["cell_type"] == "code"]) + 1, names)
                )
        finally:
            os.chdir(before)
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    metadata = {"kernelspec": kernel, "language_info": {"name": "python"}}
    return {"cells": made, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}


def _cell(text: str, name: str, count: int, names: dict[str, Any]) -> dict[str, Any]:
    if not text.startswith("```python\n"):
        return {"cell_type": "markdown", "id": name, "metadata": {}, "source": text.splitlines(keepends=True)}
    code = text.removeprefix("```python\n").removesuffix("\n```")
    return {
        "cell_type": "code",
        "execution_count": count,
        "id": name,
        "metadata": {},
        "outputs": _execute(code, count, names),
        "source": code.splitlines(keepends=True),
    }


def _execute(code: str, count: int, names: dict[str, Any]) -> list[dict[str, Any]]:
    """What the code prints, and what its last expression is."""
    tree = ast.parse(code)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    printed = io.StringIO()
    value = None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "the notebook", "exec"), names)
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), "the notebook", "eval"), names)
    outputs: list[dict[str, Any]] = []
    if printed.getvalue():
        outputs.append(
            {"name": "stdout", "output_type": "stream", "text": printed.getvalue().splitlines(keepends=True)}
        )
    if value is not None:
        shown = {"data": _shown(value), "execution_count": count, "metadata": {}, "output_type": "execute_result"}
        outputs.append(shown)
    return outputs


def _shown(value: Any) -> dict[str, Any]:
    """A value as a notebook keeps it: as HTML or a picture, and as text."""
    shown: dict[str, Any] = {"text/plain": [repr(value)]}
    if hasattr(value, "savefig"):
        import matplotlib

        picture = io.StringIO()
        # Names of parts in the picture come from this word, not from chance.
        with matplotlib.rc_context({"svg.hashsalt": "kitrobot"}):
            value.savefig(picture, format="svg", metadata={"Date": None})
        shown = {"image/svg+xml": picture.getvalue().splitlines(keepends=True), "text/plain": ["<Figure>"]}
    elif hasattr(value, "_repr_html_"):
        shown["text/html"] = [value._repr_html_()]
    return shown


def page_of(notebook: Mapping[str, Any]) -> tuple[str, dict[str, str]]:
    """The page that says what a notebook says, and its figures by their places."""
    pieces: list[str] = []
    figures: dict[str, str] = {}
    for cell in notebook["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            pieces.append(source)
            continue
        pieces.append(f"```python\n{source}\n```")
        for output in cell["outputs"]:
            pieces.extend(_piece(output, figures))
    pieces.append("[Experiments](experiments.md) says what else can vary, be measured and be done on several machines.")
    return "\n\n".join(pieces) + "\n", figures


def _piece(output: Mapping[str, Any], figures: dict[str, str]) -> Iterator[str]:
    if output["output_type"] == "stream":
        yield f"```text\n{''.join(output['text'])}```"
        return
    data = output["data"]
    if "image/svg+xml" in data:
        place = FIGURE.format(number=len(figures) + 1)
        figures[place] = "".join(data["image/svg+xml"])
        yield f"![The shares of runs that are done, with their intervals, for one, two and three loaders]({place})"
    elif "text/html" in data:
        yield from _tables("".join(data["text/html"]))
    else:
        yield f"```text\n{''.join(data['text/plain'])}\n```"


def _tables(text: str) -> Iterator[str]:
    """A table of HTML and the lines below it, as Markdown."""
    rows = [re.findall(r"<t[hd]>(.*?)</t[hd]>", row) for row in re.findall(r"<tr>(.*?)</tr>", text)]
    head, *body = [[html.unescape(cell) for cell in row] for row in rows]
    lines = [head, ["---"] * len(head), *body]
    yield "\n".join(f"| {' | '.join(line)} |" for line in lines)
    notes = [html.unescape(note) for note in re.findall(r"<p>(.*?)</p>", text)]
    if notes:
        yield "; ".join(notes) + "."


def main(arguments: list[str]) -> int:
    """Status 1 if something is not current."""
    if arguments == ["--check"]:
        page, figures = page_of(json.loads(NOTEBOOK.read_text(encoding="utf-8")))
        current = PAGE.read_text(encoding="utf-8") == page and all(
            (DOCS / place).read_text(encoding="utf-8") == text for place, text in figures.items()
        )
        if not current:
            print(f"{PAGE.name} is not what {NOTEBOOK.name} says: python -m tools.worked_study")
        return 0 if current else 1
    notebook = do_study()
    page, figures = page_of(notebook)
    NOTEBOOK.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    PAGE.write_text(page, encoding="utf-8")
    for place, text in figures.items():
        (DOCS / place).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
