"""The worked study of the documents: its page is its notebook, and its cells do what they say."""

from __future__ import annotations

import pytest

from tools import worked_study


def test_the_page_and_its_figures_are_made_of_the_notebook():
    assert worked_study.main(["--check"]) == 0


def test_every_cell_runs_one_after_another():
    pytest.importorskip("matplotlib")
    fewer = [
        cell.replace(worked_study.SEEDS, "range(1, 4)").replace("precision=0.05", "precision=0.4")
        for cell in worked_study.CELLS
    ]
    notebook = worked_study.do_study(fewer)
    outputs = [output for cell in notebook["cells"] for output in cell.get("outputs", ())]
    assert [output["output_type"] for output in outputs][:2] == ["execute_result", "execute_result"]
    page, figures = worked_study.page_of(notebook)
    assert "| agents.loader | runs | done | delivered | seconds |" in page
    assert [text.count("<svg") for text in figures.values()] == [1]
    published = worked_study.NOTEBOOK.read_text(encoding="utf-8")
    assert "1 instead of 2 loaders" in page
    assert "1 instead of 2 loaders" in published
