"""Check the documents: links and their anchors, pictures, code blocks, and that the site has every page.

    python -m tools.documents      print what is wrong; status 1 if anything is

`make docs` has the site's builder look at links between its pages too. This looks at what lies outside the site as well
(README, CHANGELOG, …), and reads code: a block of Python, JSON or XML parses, and a command line names a command.
"""

from __future__ import annotations

import ast
import json
import re
import sys
import textwrap
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from kitrobot.cli.app import app

ROOT = Path(__file__).resolve().parents[1]
FENCED = re.compile(r"^(?P<indent> *)```(?P<language>\w*)\n(?P<code>.*?)^(?P=indent)```$", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"\]\(([^()\s]+)\)")
GENERATED = ("diagnostics", "teachers")
"""Folders of which the site's navigation names the first page only: that page lists the others."""


def pages(root: Path = ROOT) -> list[Path]:
    """Every document of the repository."""
    return sorted([*root.glob("*.md"), *(root / "docs").rglob("*.md"), *(root / "benchmarks").glob("*.md")])


def anchors(text: str) -> set[str]:
    """What links may name in a page, as GitHub and the site's builder make it of the headings."""
    found: Counter[str] = Counter()
    names = set()
    for heading in re.findall(r"^#+ (.+)$", FENCED.sub("", text), flags=re.MULTILINE):
        words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
        slug = re.sub(r"[^\w\- ]", "", words.lower()).strip().replace(" ", "-")
        names.add(f"{slug}-{found[slug]}" if found[slug] else slug)
        found[slug] += 1
    return names


def broken_links(page: Path) -> Iterator[str]:
    """The links of a page that lead nowhere."""
    prose = re.sub(r"`[^`\n]*`", "", FENCED.sub("", page.read_text(encoding="utf-8")))
    for target in LINK.findall(prose):
        if re.match(r"https?:|mailto:", target):
            continue
        name, _, anchor = target.partition("#")
        path = (page.parent / name).resolve() if name else page
        if not path.exists():
            yield f"{target} is not there"
        elif anchor and anchor not in anchors(path.read_text(encoding="utf-8")):
            yield f"{target} has no such heading"


def wrong_code(page: Path) -> Iterator[str]:
    """The code blocks of a page that do not parse, and command lines whose command does not exist."""
    for block in FENCED.finditer(page.read_text(encoding="utf-8")):
        language, code = block["language"], textwrap.dedent(block["code"])
        first = code.partition("\n")[0]
        try:
            if language == "python":
                ast.parse(code)
            elif language == "json":
                _read_values(code)
            elif language == "xml":
                ElementTree.fromstring(f"<block>{re.sub(r'<[?!].*?[?>]>', '', code)}</block>")
        except (SyntaxError, ValueError, ElementTree.ParseError) as error:
            yield f"the block that begins with {first!r} is no {language}: {error}"
        if ROOT / "docs" in page.parents and block["indent"] in (" ", "  ", "   "):
            yield f"the block that begins with {first!r} has less than the four spaces of a block in a list"
        if not language:
            for tool, word in re.findall(r"^(kitrobot|make) ([a-z]+)(?=\s|$)", code, flags=re.MULTILINE):
                if word not in (commands() if tool == "kitrobot" else tasks()) and not _is_mission(word):
                    yield f"{tool} has no {word!r}"


def commands() -> set[str]:
    """The words of the command line."""
    return {command.name or "" for command in app.registered_commands}


def tasks() -> set[str]:
    """The tasks of the Makefile."""
    return set(re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), flags=re.MULTILINE))


def _read_values(code: str) -> None:
    """Reads JSON values one after another; a page may break a line within a text."""
    decoder = json.JSONDecoder(strict=False)
    while code := code.strip():
        code = code[decoder.raw_decode(code)[1] :]


def _is_mission(word: str) -> bool:
    return (ROOT / "examples" / word).is_dir()


def left_out(root: Path = ROOT) -> list[str]:
    """The pages of docs that the site's navigation does not lead to."""
    listed = set(re.findall(r"[\w./-]+\.md", (root / "mkdocs.yml").read_text(encoding="utf-8")))
    found = {path.relative_to(root / "docs") for path in (root / "docs").rglob("*.md")}
    return sorted(str(path) for path in found if str(path) not in listed and path.parts[0] not in GENERATED)


def problems() -> Iterator[str]:
    """Everything that is wrong with the documents, a line each."""
    for page in pages():
        for problem in [*broken_links(page), *wrong_code(page)]:
            yield f"{page.relative_to(ROOT)}: {problem}"
    for name in left_out():
        yield f"mkdocs.yml: docs/{name} is not in the navigation"


def main() -> int:
    found = list(problems())
    print("\n".join(found) or f"{len(pages())} documents: links, anchors and code blocks are right")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
