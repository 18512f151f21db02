"""At most eight parameters a function, but for commands of the command line: `docs/decisions/code.md`."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

SOURCES = Path(__file__).parents[2] / "src"
MOST = 8


HEAD = re.compile(r"\bdef \w+(?:\[[^\n]*\])?\(((?:[^()]|\((?:[^()]|\([^()]*\))*\))*)\)")


def too_many(path: Path) -> Iterator[str]:
    text = path.read_text(encoding="utf-8")
    # More parameters have as many commas between them, and what those name otherwise is looked at below.
    if all(head.count(",") < MOST for head in HEAD.findall(text)):
        return
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            given = node.args
            count = len(given.posonlyargs) + len(given.args) + len(given.kwonlyargs)
            own = given.args[:1] and given.args[0].arg in ("self", "cls")
            if count - bool(own) > MOST:
                yield node.name


def test_only_commands_have_more_than_eight_parameters() -> None:
    found = {path: names for path in sorted(SOURCES.rglob("*.py")) if (names := list(too_many(path)))}
    assert [str(path) for path in found if path.parent.name != "cli"] == []
