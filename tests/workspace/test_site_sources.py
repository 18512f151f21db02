"""Sources of a static site: texts are gone, and the program is the same, line by line; no needed module is left out."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

import kitrobot
from kitrobot.packaging.site_sources import NOT_IMPORTED, in_library, without_texts

SOURCE = b'''"""About it,
in two lines."""
# A comment.
TEXT = """# no comment
# none either
  """  # one
class Thing:
    """Only a text."""
def say(word: str = "#") -> Annotated[str, Doc("""What it
says.""")]:  # \xc3\xa9
    "A text."
    return "\xc3\xa9", word  # \xc3\xa9
'''


IMPORTED = re.compile(r"^\s*(?:import|from)\s+([a-zA-Z_][\w.]*)", re.MULTILINE)
OF_PROCESSES = {"multiprocessing", "multiprocessing.connection", "concurrent.futures.process"}
"""Imported where there are processes only; a page has none (`server/in_page_scenario.py` holds that)."""


def test_docstrings_and_lines_of_comments_go_and_every_statement_keeps_its_line() -> None:
    made = without_texts(SOURCE)
    assert made.splitlines() == [
        b'""',
        b"",
        b"",
        b'TEXT = """# no comment',
        b"# none either",
        b'  """  # one',
        b"class Thing:",
        b'    ""',
        b'def say(word: str = "#") -> Annotated[str, Doc("")]:  # \xc3\xa9',
        b"",
        b'    ""',
        b'    return "\xc3\xa9", word  # \xc3\xa9',
    ]
    lines = [node.lineno for node in ast.walk(ast.parse(SOURCE)) if isinstance(node, ast.stmt)]
    assert lines == [node.lineno for node in ast.walk(ast.parse(made)) if isinstance(node, ast.stmt)]
    assert without_texts(made) == made


@pytest.mark.parametrize("source", [b"", b"except A, B in the middle", b"\x00", b"\xff\xfe", b"x = ("])
def test_what_cannot_be_read_or_would_change_stays_as_it_is(source: bytes) -> None:
    assert without_texts(source) == source


def test_the_library_has_what_the_package_imports() -> None:
    for path in Path(kitrobot.__file__).parent.rglob("*.py"):
        if "cli" in path.parts or path.name == "__main__.py":
            continue
        for name in set(IMPORTED.findall(path.read_text(encoding="utf-8"))) - OF_PROCESSES:
            assert name.partition(".")[0] not in NOT_IMPORTED, path
            assert in_library(name.replace(".", "/") + ".py"), path


def test_the_library_has_the_encodings_of_today_and_not_those_of_other_machines() -> None:
    kept = ["utf_8", "utf_8_sig", "utf_16", "latin_1", "ascii", "idna", "cp1252", "aliases"]
    assert all(in_library(f"encodings/{name}.py") for name in kept)
    assert not any(in_library(f"encodings/{name}.py") for name in ("cp1140", "mac_greek", "big5"))
