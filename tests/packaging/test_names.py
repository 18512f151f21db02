"""Modules and types are nouns (CONTRIBUTING.md, Names)."""

from __future__ import annotations

from pathlib import Path

import pytest

from tools.names import EXCEPTIONS, is_noun, names, problems


def test_every_module_and_type_is_a_noun() -> None:
    assert problems() == []


def test_every_exception_is_a_name_that_there_is() -> None:
    assert set(EXCEPTIONS) <= {name for name, _ in names()}


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
