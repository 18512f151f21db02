"""Styles of the page are there wherever they are used: in a class's own room, or in one that is always there."""

from __future__ import annotations

import re
from collections import defaultdict
from pathlib import Path

import pytest

SOURCES = Path(__file__).resolve().parents[2] / "web" / "src"
ALWAYS = {"app", "ui", "theme", "features/accessibility"}
"""Rooms whose styles come with the page; those of another feature come with it, of a component with its module."""


def room(path: Path) -> str:
    """`features/canvas`, `ui`, …"""
    parts = path.relative_to(SOURCES).parts
    return "/".join(parts[:2]) if parts[0] == "features" else parts[0]


@pytest.fixture(scope="module")
def styled() -> dict[str, set[str]]:
    """Class → the rooms with styles for it."""
    found: defaultdict[str, set[str]] = defaultdict(set)
    for path in SOURCES.rglob("*.css"):
        text = re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        for name in re.findall(r"\.([a-z][\w-]*)", text):
            found[name].add(room(path))
    return found


def classes(text: str) -> set[str]:
    """The classes that a module writes down as such."""
    found = set()
    for plain, made in re.findall(r'className=(?:"([^"]*)"|\{`([^`]*)`)', text):
        found.update(f"{plain} {re.sub(r'[$][{][^}]*[}]', ' ', made)}".split())
    return found


def test_a_class_is_styled_by_its_own_room_or_one_that_is_always_there(styled: dict[str, set[str]]) -> None:
    assert styled["vertex"] >= {"features/canvas"}
    strangers = {}
    for path in sorted(SOURCES.rglob("*.tsx")):
        near = {room(path), "components", *ALWAYS}
        far = [name for name in classes(path.read_text(encoding="utf-8")) if name in styled and not styled[name] & near]
        if far:
            strangers[str(path.relative_to(SOURCES))] = {name: styled[name] for name in sorted(far)}
    assert strangers == {}
