"""The examples of the Python API: those in docstrings, and those of docs/python.md in their order."""

from __future__ import annotations

import contextlib
import doctest
import importlib
import io
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
SECTION = re.compile(r"^## (.+)\n", re.MULTILINE)
EXAMPLE = re.compile(r"```python\n(?P<code>.*?)```\n(?:\n```text\n(?P<printed>.*?)```\n)?", re.DOTALL)


@pytest.mark.parametrize(
    "module", ["api", "graph.model", "mission.model", "sim.simulation", "workspace.mission_run", "world.model"]
)
def test_the_examples_in_docstrings_are_right(module: str) -> None:
    found = doctest.testmod(importlib.import_module(f"kitrobot.{module}"))
    assert found.attempted
    assert not found.failed


def test_the_examples_of_the_page_run_in_their_order_and_print_what_it_shows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "page"}
    examples = list(EXAMPLE.finditer(PAGE))
    assert len(examples) == PAGE.count("```python")
    for example in examples:
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(example["code"], "docs/python.md", "exec"), names)
        assert out.getvalue() == (example["printed"] or ""), example["code"]
