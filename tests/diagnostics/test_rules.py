"""Rules: registered where they are made, each with a page that says what it says."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from kitrobot.diagnostics.model import Fix, KitRobotError, Place, Severity, rule, rules
from kitrobot.lll.rules import SYNTAX
from kitrobot.text.sentences import Sentence
from tools import diagnostic_pages


def test_the_pages_are_current() -> None:
    assert diagnostic_pages.stale() == [], "run: python tools/diagnostic_pages.py"


def test_every_rule_has_a_page_and_a_line_in_the_list() -> None:
    pages = diagnostic_pages.pages()
    assert {f"{code}.md" for code in rules()} | {"README.md"} == set(pages)
    for code, made in rules().items():
        assert pages[f"{code}.md"].startswith(f"# {made.title}\n\n`{code}` · ")
        assert pages["README.md"].count(f"({code}.md)") == 1


def test_pages_are_written_once_and_taken_away_with_their_rule(tmp_path: Path) -> None:
    (tmp_path / "gone.md").write_text("old", encoding="utf-8")
    (tmp_path / "syntax.md").write_text("old", encoding="utf-8")
    touched = diagnostic_pages.write(tmp_path)
    assert "gone.md" in touched
    assert not (tmp_path / "gone.md").exists()
    assert "`syntax` · An error" in (tmp_path / "syntax.md").read_text(encoding="utf-8")
    assert diagnostic_pages.write(tmp_path) == []
    assert diagnostic_pages.stale(tmp_path) == []


def test_every_code_title_and_explanation_keeps_the_house_s_form() -> None:
    diagnostic_pages.pages()
    for code, made in rules().items():
        assert re.fullmatch(r"[a-z]+(-[a-z]+)*", code), code
        assert made.code == code
        assert made.title[0].isupper() or made.title[0] == "`", code
        assert not made.title.endswith("."), code
        assert made.explanation.endswith((".", ")")), code
        assert len(made.explanation) > 20, code


def test_titles_are_told_apart() -> None:
    titles = [made.title for made in rules().values()]
    assert sorted(title for title in titles if titles.count(title) > 1) == []


def test_a_code_is_used_once() -> None:
    with pytest.raises(AssertionError, match="the code syntax is taken"):
        rule("syntax", Severity.HINT, "Again", "Once more.")


def test_a_rule_makes_diagnostics_of_itself() -> None:
    place = Place("f.lll", 1, 2, 1, 3)
    arc = ("a", "b", "c", "d")
    made = SYNTAX(
        Sentence("wrong"), place, help=Sentence("mend it"), program="p", vertices=["v1"], arcs=[arc], fix=Fix("x")
    )
    assert (made.code, made.severity, made.message, made.place) == ("syntax", Severity.ERROR, "wrong", place)
    assert (made.help, made.program, made.vertices, made.arcs) == ("mend it", "p", ("v1",), (("a", "b", "c", "d"),))
    assert made.fix == Fix("x")
    assert made.is_error


def test_a_raised_error_says_its_sentence_and_its_way_out() -> None:
    told = SYNTAX(Sentence("wrong"))
    error = KitRobotError(Sentence("it failed"), Sentence("try again"), (told,))
    assert str(error) == "it failed\nhelp: try again"
    assert str(KitRobotError(Sentence("it failed"))) == "it failed"
    assert error.diagnostics == (told,)
    assert len({error, KitRobotError(Sentence("it failed"), Sentence("try again"), (told,))}) == 2
