"""Links, anchors and code blocks of the documents are right, and the tool that says so finds those that are not."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import kitrobot
from tools.documents import ROOT, anchors, broken_links, left_out, problems, wrong_code


def test_the_documents_are_right() -> None:
    assert list(problems()) == []


def test_every_name_of_the_package_is_on_the_page_of_the_api() -> None:
    page = (ROOT / "docs" / "reference" / "api.md").read_text(encoding="utf-8")
    shown = set(re.findall(r"^::: [\w.]+\.(\w+)$", page, flags=re.MULTILINE)) | set(re.findall(r"`(\w+)`", page))
    assert set(kitrobot.__all__) - shown == {"__version__"}


def test_links_that_lead_nowhere_are_found(tmp_path: Path) -> None:
    (tmp_path / "other.md").write_text("# Other\n## The `one` way, twice\n## The one way twice\n")
    page = tmp_path / "page.md"
    page.write_text(
        "# Page\n[a](other.md#the-one-way-twice-1) [b](#page) [c](https://example.org/x) `[d](none.md)`\n"
        "```\n[e](none.md)\n```\n![f](none.png) [g](other.md#none) [h](#none)\n"
    )
    found = list(broken_links(page))
    assert found == [
        "none.png is not there",
        "other.md#none has no such heading",
        "#none has no such heading",
    ]


def test_the_same_heading_twice_has_two_anchors() -> None:
    assert anchors("# A b\n## A b\n```\n# none\n```\n## [Link](x.md): `code`\n") == {"a-b", "a-b-1", "link-code"}


@pytest.mark.parametrize(
    ("block", "wrong"),
    [
        ("```python\nx = 1\n```\n", False),
        ("```python\nx = \n```\n", True),
        ('```json\n{"a": 1}\n{"a": 2}\n```\n', False),
        ('```json\n{"a": }\n```\n', True),
        ('```xml\n<?xml version="1.0"?>\n<a/>\n<b/>\n```\n', False),
        ("```xml\n<a>\n```\n", True),
        ("```\nkitrobot run transport\nkitrobot transport\nmake check\n```\n", False),
        ("1. First\n\n    ```\n    kitrobot runn transport\n    ```\n", True),
        ("```\nmake nothing\n```\n", True),
    ],
)
def test_code_that_does_not_parse_and_commands_that_are_not_there_are_found(
    tmp_path: Path, block: str, wrong: bool
) -> None:
    page = tmp_path / "page.md"
    page.write_text(block)
    assert bool(list(wrong_code(page))) == wrong


def test_a_page_that_the_site_does_not_lead_to_is_found(tmp_path: Path) -> None:
    (tmp_path / "docs" / "diagnostics").mkdir(parents=True)
    (tmp_path / "mkdocs.yml").write_text("nav:\n  - index.md\n")
    for name in ("index.md", "lost.md", "diagnostics/syntax.md"):
        (tmp_path / "docs" / name).write_text("# A page\n")
    assert left_out(tmp_path) == ["lost.md"]
