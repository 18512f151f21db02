"""Values of a class's TOML file: read with a reason why one makes no sense, and written as strings."""

from __future__ import annotations

import json
from typing import Any

from kitrobot.text.sentences import Sentence


def toml_string(text: str) -> str:
    """A basic string of TOML: JSON's, but for the one sign that JSON lets stand."""
    text = text.encode(errors="replace").decode()
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def text_of(table: dict[str, Any], key: str) -> str:
    """A text, "" where there is none.

    Raises:
        TypeError: it is no text.
    """
    value = table.get(key, "")
    if not isinstance(value, str):
        raise TypeError(Sentence("`{key}` is no text", key))
    return value


def list_of(table: dict[str, Any], key: str) -> list[Any]:
    """A list, empty where there is none.

    Raises:
        TypeError: it is no list.
    """
    value = table.get(key, [])
    if not isinstance(value, list):
        raise TypeError(Sentence("`{key}` is no list", key))
    return value


def count_of(table: dict[str, Any], key: str, usual: int) -> int:
    """A whole number from 0, `usual` where there is none.

    Raises:
        ValueError: it is none.
    """
    found = table.get(key, usual)
    if not isinstance(found, int) or isinstance(found, bool) or found < 0:
        raise ValueError(Sentence("`{key}` makes no sense", key))
    return found
