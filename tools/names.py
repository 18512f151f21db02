"""Names of modules and types that are no nouns: participles and bare verbs.

    python tools/names.py            lists them; exits with 1 when there is one

A name is judged by its last word. Words that look like a participle and are nouns of the field are in `NOUNS`; names
that stay for another reason are in `EXCEPTIONS`, each with that reason.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ROOMS = ("src", "tools", "benchmarks")

NOUNS = frozenset(
    {
        "drawing",
        "encoding",
        "feed",
        "decoding",
        "finding",
        "grading",
        "inlining",
        "led",
        "listing",
        "lowering",
        "meaning",
        "meeting",
        "recording",
        "sampling",
        "seed",
        "setting",
        "shaking",
        "string",
        "timing",
        "wiring",
    }
)
"""What a compiler, a trace or a lamp is called."""

EXCEPTIONS = {
    "Accepted": "Paxos calls this message so",
    "Denied": "the answer to it",
    "WorkLeft": "the device `work-left` of robots' XML",
    "work_left": "the same",
    "Recorded": "goes when a trace records templates",
    "recorded": "the same",
    "counting": "a driver's file name on boards",
    **dict.fromkeys(
        ("interpreting", "tracing", "compiling", "parsing", "editing", "starting", "simulating", "checking"),
        "a word of the command line: `python -m benchmarks NAME`, or a room",
    ),
}

_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z0-9]+")
_PARTICIPLE = re.compile(r".{2,}(?:ed|ing)$")
_IRREGULAR = frozenset(
    {
        "told",
        "kept",
        "left",
        "begun",
        "sent",
        "seen",
        "made",
        "done",
        "given",
        "taken",
        "found",
        "held",
        "shown",
        "asked",
    }
)


def is_noun(name: str) -> bool:
    """Whether the last word of a module's or type's name may be a noun."""
    words = _WORD.findall(name)
    last = words[-1].lower() if words else ""
    return last in NOUNS or not (_PARTICIPLE.match(last) or last in _IRREGULAR)


def names(root: Path = ROOT) -> Iterator[tuple[str, str]]:
    """Every module and type: its name, and where it is as `path` or `path:line`."""
    for room in ROOMS:
        for path in sorted((root / room).rglob("*.py")):
            where = path.relative_to(root).as_posix()
            yield path.stem, where
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.ClassDef):
                    yield node.name, f"{where}:{node.lineno}"


def problems(root: Path = ROOT) -> list[str]:
    """A sentence for each name that is no noun, and for each exception that nothing is called."""
    there = list(names(root))
    missing = EXCEPTIONS.keys() - {name for name, _ in there} if root == ROOT else set()
    return [
        *(
            f"{where}: `{name}` is no noun; CONTRIBUTING.md, Names"
            for name, where in there
            if name not in EXCEPTIONS and not is_noun(name)
        ),
        *(f"`{name}` is an exception, and nothing is called so" for name in sorted(missing)),
    ]


if __name__ == "__main__":
    found = problems()
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)
