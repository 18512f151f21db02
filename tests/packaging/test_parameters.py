"""At most eight parameters a function, but for commands of the command line: `docs/decisions/code.md`."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

SOURCES = Path(__file__).parents[2] / "src"
MOST = 8


def too_many(path: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            given = node.args
            count = len(given.posonlyargs) + len(given.args) + len(given.kwonlyargs)
            own = given.args[:1] and given.args[0].arg in ("self", "cls")
            if count - bool(own) > MOST:
                yield node.name


def test_only_commands_have_more_than_eight_parameters() -> None:
    found = {path: names for path in sorted(SOURCES.rglob("*.py")) if (names := list(too_many(path)))}
    assert [str(path) for path in found if path.parent.name != "cli"] == []
