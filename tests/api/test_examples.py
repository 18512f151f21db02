"""The examples of the Python API: those in docstrings, and those of pages in their order."""

from __future__ import annotations

import contextlib
import doctest
import importlib
import io
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SECTION = re.compile(r"^## (.+)\n", re.MULTILINE)
EXAMPLE = re.compile(r"```python\n(?P<code>.*?)```\n(?:\n```text\n(?P<printed>.*?)```\n)?", re.DOTALL)


@pytest.mark.parametrize(
    "module", ["api", "graph.model", "mission.model", "sim.simulation", "workspace.mission_run", "world.model"]
)
def test_the_examples_in_docstrings_are_right(module: str) -> None:
    found = doctest.testmod(importlib.import_module(f"kitrobot.{module}"))
    assert found.attempted
    assert not found.failed


@pytest.mark.parametrize("name", ["python", "experiments"])
def test_the_examples_of_a_page_run_in_their_order_and_print_what_it_shows(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "page"}
    page = (ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8")
    examples = list(EXAMPLE.finditer(page))
    assert len(examples) == page.count("```python")
    for example in examples:
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(example["code"], f"docs/{name}.md", "exec"), names)
        assert out.getvalue() == (example["printed"] or ""), example["code"]
