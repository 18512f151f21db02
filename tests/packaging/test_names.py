"""Modules and types are nouns (CONTRIBUTING.md, Names)."""

from __future__ import annotations

from pathlib import Path

import pytest

from tools import names
from tools.names import is_noun, problems


def test_every_module_and_type_is_a_noun_and_every_exception_is_a_name_that_there_is(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(names.EXCEPTIONS, "NoSuchType", "for this test")
    assert problems() == ["`NoSuchType` is an exception, and nothing is called so"]


@pytest.mark.parametrize("name", ["Told", "Kept", "looking", "_Watched", "team_told", "RunSeen", "JSONParsed"])
def test_participles_are_found(name: str) -> None:
    assert not is_noun(name)


@pytest.mark.parametrize(
    "name", ["RetryTimer", "Drawing", "class_room", "Seed", "led", "WatchedRun", "__init__", "XML"]
)
def test_nouns_pass(name: str) -> None:
    assert is_noun(name)


def test_a_mistake_is_told_with_its_place(tmp_path: Path) -> None:
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "looking.py").write_text("class Told:\n    pass\n")
    assert [line.partition(";")[0] for line in problems(tmp_path)] == [
        "src/looking.py: `looking` is no noun",
        "src/looking.py:1: `Told` is no noun",
    ]
