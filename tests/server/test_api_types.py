"""The page's types are those of the models."""

from __future__ import annotations

import pytest

from tools import api_types


@pytest.fixture(scope="module")
def text() -> str:
    return api_types.types()


def test_the_committed_types_are_what_the_models_say_and_another_process_wrote(text: str):
    assert api_types.TARGET.read_text(encoding="utf-8") == text, "run `python tools/api_types.py`"


def test_every_message_says_its_type(text: str):
    assert 'type: "started";' in text
    assert "type?:" not in text


def test_only_types_that_the_page_uses_are_written():
    declared = {"Used": "export type Used = { inner: Inner };", "Inner": "/** Not Other. */", "Other": ""}
    assert api_types.reached_types(declared, ["const used: Used[] = [];"]) == {"Used", "Inner"}
