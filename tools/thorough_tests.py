"""Write docs/thorough-tests.md: what only the thorough profile tests, and where the usual profile holds the same fact.

python tools/thorough_tests.py            write it
python tools/thorough_tests.py --check    only say whether it is current; status 1 if it is not

Each `@pytest.mark.thorough("...")` names the test of the usual profile that holds the fact, as its only argument. A
test of the page that it names has to be there.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
TESTS = ROOT / "tests"
PAGE = ROOT / "docs" / "thorough-tests.md"
PAGE_TEST = re.compile(r"web/src/[\w/.-]+\.test\.tsx?")

HEAD = """# Tests of the thorough profile

`make thorough` runs what `make test` leaves out for the time it takes. It also tries more random examples, and further
cases of tests that `make test` tries on a few (`examples` and `cases` in `tests/effort.py`). For each test that is left
out, the right column says what holds the same fact in `make test`. This page is written by
`python tools/thorough_tests.py`.
"""


class SkippedTest(NamedTuple):
    """A test that only the thorough profile runs."""

    file: str
    test: str
    held_by: str


def _is_mark(node: ast.expr) -> bool:
    return isinstance(node, ast.Attribute) and node.attr == "thorough" and ast.unparse(node.value) == "pytest.mark"


def _marks(node: ast.AST) -> Iterator[str]:
    """What each mark at that node says; a `ValueError` for one that says nothing."""
    calls = [one for one in ast.walk(node) if isinstance(one, ast.Call) and _is_mark(one.func)]
    uses = [one for one in ast.walk(node) if isinstance(one, ast.expr) and _is_mark(one)]
    for call in calls:
        match call.args:
            case [ast.Constant(value=str(text))] if text.strip():
                for name in PAGE_TEST.findall(text):
                    if not (ROOT / name).exists():
                        raise ValueError(f"line {call.lineno}: there is no {name}")
                yield text
            case _:
                raise ValueError(f"line {call.lineno}: `thorough` takes one sentence: what holds the fact usually")
    if len(uses) != len(calls):
        raise ValueError(f"line {uses[-1].lineno}: `thorough` needs a sentence: what holds the fact usually")


def find_skipped_tests(source: str, file: str) -> list[SkippedTest]:
    """The tests of a file that are left out; a `ValueError` with the place of a mark without its sentence."""
    found = []
    try:
        for node in ast.parse(source).body:
            match node:
                case ast.FunctionDef(name=name, decorator_list=decorators):
                    found += [SkippedTest(file, name, text) for one in decorators for text in _marks(one)]
                case ast.Assign() | ast.AnnAssign():
                    found += [SkippedTest(file, "all of it", text) for text in _marks(node)]
    except ValueError as error:
        raise ValueError(f"{file}, {error}") from None
    return found


def all_skipped_tests() -> list[SkippedTest]:
    files = sorted(TESTS.rglob("test_*.py"))
    return [
        left
        for file in files
        for left in find_skipped_tests(file.read_text("utf-8"), file.relative_to(ROOT).as_posix())
    ]


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|")


def page(skipped: list[SkippedTest]) -> str:
    """The page in Markdown."""
    parts = [HEAD]
    for folder, rows in groupby(skipped, key=lambda left: left.file.split("/")[1]):
        parts.append(f"\n## {folder}\n\n| test | what holds the fact in `make test` |\n|---|---|\n")
        for file, test, held_by in rows:
            name = "/".join(file.split("/")[2:])
            fact = test.removeprefix("test_").replace("_", " ")
            parts.append(f"| `{name}`: {fact} | {_cell(held_by)} |\n")
    return "".join(parts)


def main(arguments: list[str]) -> int:
    try:
        text = page(all_skipped_tests())
    except ValueError as error:
        print(error)
        return 1
    if arguments == ["--check"]:
        current = PAGE.exists() and PAGE.read_text("utf-8") == text
        if not current:
            print("docs/thorough-tests.md is stale; run `python tools/thorough_tests.py`")
        return 0 if current else 1
    PAGE.write_text(text, "utf-8", newline="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
