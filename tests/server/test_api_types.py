"""The page's types are those of the models."""

from __future__ import annotations

from tools import api_types


def test_the_committed_types_are_what_the_models_say():
    assert api_types.TARGET.read_text(encoding="utf-8") == api_types.types(), "run `python tools/api_types.py`"


def test_writing_the_types_twice_gives_the_same_text():
    assert api_types.types() == api_types.types()


def test_every_message_says_its_type():
    text = api_types.types()
    assert 'type: "started";' in text
    assert "type?:" not in text
