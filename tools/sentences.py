"""Finds every sentence that the program says to people, and holds the translations against them.

    python tools/sentences.py            lists what has no French or no Urdu yet, and what is translated for nothing
    python tools/sentences.py --write    adds those to the tables with an empty translation, and takes the others out

A sentence is a string or an f-string of a room that speaks to the page: two words or more, which is what tells it from
a name. What an f-string fills in becomes a hole, numbered in reading order: "the robot `{1}` has no `{2}`". It goes
under "sentences" in the tables, or by hand under "phrases" when it is never said alone. Single words that fill holes
cannot be told from names; they stand under "words" and are kept by hand.
"""

from __future__ import annotations

import ast
import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "src" / "kitrobot"
TABLES = SOURCES / "translation"
LANGUAGES = ("fr", "ur")

ELSEWHERE = (
    "__init__.py",
    "cli/",
    "diagnostics/",
    "deploy/builtin_names.py",
    "files/forms.py",
    "image/",
    "primitives/automatic.py",
    "robots/carried.py",
    "robots/view.py",
    "server/pages.py",
    "server/start.py",
    "sim/dispatch.py",
    "sim/recording.py",
    "translation/",
    "versions/merging.py",
    "workspace/checking.py",
    "workspace/conversion.py",
    "workspace/executables.py",
    "workspace/execution.py",
    "workspace/inputs.py",
    "workspace/watching.py",
)
"""What speaks only in a terminal or a file, or brings its languages along."""

NOT_SAID = frozenset(
    {
        # What the XML parser says, and is never repeated.
        "no element found",
        "unclosed token",
        "unclosed CDATA section",
        "partial character",
        "junk after document element",
        "syntax error",
        "duplicate attribute",
        "XML or text declaration not at start of entity",
        "mismatched tag",
        "undefined entity",
        "not well-formed",
        # A folder's name, and texts for chips.
        "Application Support",
        "{object} {1}",
        # In several languages already.
        "My parts",
        "Mes pièces",
        # What is told to a board, what is looked for in errors of systems, and errors that are told in other words.
        "s=''.join(t[i]for i in range({1}))",
        "the receiver",
        "exclusively lock",
        "Access is denied",
        "the board starts something else",
        # Names of boards.
        "Raspberry Pi Pico",
        "MicroPython board",
        "Adafruit board",
        "Arduino board",
        "USB serial",
        # Names joined; the lists in a sentence are translated as lists.
        "{1} or {2}",
        # A state that travels as a word.
        "no program",
    }
)

_SILENT_CALLS = frozenset({"compile", "debug", "error", "exception", "info", "warning", "AttributeError", "TypeError"})
"""Regular expressions, logs, and errors of programmers."""


def sentences() -> dict[str, str]:
    """Every sentence with numbered holes, and the first place that says it."""
    found: dict[str, str] = {}
    for path in sorted(SOURCES.rglob("*.py")):
        name = path.relative_to(SOURCES).as_posix()
        if name.startswith(ELSEWHERE):
            continue
        for sentence, line in _said(ast.parse(path.read_text(encoding="utf-8"))):
            letters = re.search(r"[a-z]{2}", _HOLE.sub("", sentence))
            if letters and " " in sentence.strip() and sentence not in NOT_SAID and not _HEADER.search(sentence):
                found.setdefault(sentence, f"{name}:{line}")
    return found


_HOLE = re.compile(r"\{[0-9]+\}")
_HEADER = re.compile(
    r"=\(\)|-src '|charset=|HttpOnly|max-age=|^not allowed$|^Literal\[|^<constructors |^from kitrobot"
    r"|\$[a-z]|^import [a-z,]+;|^import \{|^from (machine|array) import"
)
"""Of HTTP, for browsers; types and code; what is told to a board."""


def _said(tree: ast.AST) -> Iterator[tuple[str, int]]:
    """Strings of a tree that are values of the program: no docstrings, assertions, logs or regular expressions."""
    stack = [tree]
    while stack:
        node = stack.pop()
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            continue
        if isinstance(node, ast.Assert):
            continue
        if isinstance(node, ast.Call):
            name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            if name in _SILENT_CALLS:
                continue
            if (
                name == "rule" and len(node.args) == 4
            ):  # the title is for the documents; the explanation is the help of last resort
                stack += [node.args[3]]
                continue
        if isinstance(node, ast.keyword) and node.arg == "about":  # for schemas
            continue
        if isinstance(node, ast.Dict):
            kept = [
                value
                for key, value in zip(node.keys, node.values, strict=True)
                if not (isinstance(key, ast.Constant) and key.value == "description")
            ]
            stack += [*reversed(kept), *(key for key in node.keys if key is not None)]
            continue
        text = _text(node)
        if text is None:
            stack += reversed(list(ast.iter_child_nodes(node)))
            continue
        first, *others = text.split("\0")
        numbered = "".join(f"{{{number}}}{other}" for number, other in enumerate(others, 1))
        yield first + numbered, getattr(node, "lineno", 0)
        stack += _holes(node)


def _text(node: ast.AST) -> str | None:
    """The text of a string, an f-string or a sum of them, with NUL for what is filled in; None for anything else."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else None
    if isinstance(node, ast.JoinedStr):
        return "".join(str(part.value) if isinstance(part, ast.Constant) else "\0" for part in node.values)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        left, right = _text(node.left), _text(node.right)
        if left is not None or right is not None:
            return ("\0" if left is None else left) + ("\0" if right is None else right)
    return None


def _holes(node: ast.AST) -> list[ast.AST]:
    """What is filled in: sentences may stand there too."""
    if isinstance(node, ast.JoinedStr):
        return [part.value for part in node.values if isinstance(part, ast.FormattedValue)]
    if isinstance(node, ast.BinOp):
        sides = (node.left, node.right)
        return [hole for side in sides for hole in ([side] if _text(side) is None else _holes(side))]
    return []


def table(language: str) -> dict[str, dict[str, str]]:
    """A language's table as it is in its file."""
    loaded: dict[str, dict[str, str]] = json.loads((TABLES / f"{language}.json").read_text(encoding="utf-8"))
    return loaded


def faults(language: str, said: dict[str, str]) -> tuple[list[str], list[str]]:
    """What lacks a translation, and what is translated and said by nobody."""
    known = table(language)
    lacking = [one for one in said if not (known["sentences"].get(one) or known["phrases"].get(one))]
    return lacking, [one for one in known["sentences"] if one not in said]


def _write(language: str, said: dict[str, str]) -> None:
    old = table(language)
    kept = {sentence: old["sentences"].get(sentence, "") for sentence in said if sentence not in old["phrases"]}
    new = {**old, "sentences": kept}
    text = json.dumps(new, ensure_ascii=False, indent=1)
    (TABLES / f"{language}.json").write_text(text + "\n", encoding="utf-8")


def main() -> int:
    said = sentences()
    missing = 0
    for language in LANGUAGES:
        lacking, idle = faults(language, said)
        missing += len(lacking) + len(idle)
        for sentence in lacking:
            print(f"{language}: {said[sentence]}: {sentence}")
        for sentence in idle:
            print(f"{language}: nobody says any more: {sentence}")
        if "--write" in sys.argv[1:]:
            _write(language, said)
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
