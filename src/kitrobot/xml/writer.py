"""Writing XML: text and attribute values so that reading gives them back.

XML cannot hold most control characters, lone surrogates, U+FFFE and U+FFFF in any form. They are replaced by U+FFFD,
the replacement character, because saving must never fail over a pasted character. Everything else comes back as it
was: line breaks and tabs are written as numbers, so a value never breaks its line.
"""

from __future__ import annotations

import re

_CANNOT = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
_SPECIAL = re.compile("[&<>\n\r]")
_SPECIAL_IN_VALUE = re.compile('[&<>"\n\r\t]')
_WRITTEN = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "\n": "&#10;", "\r": "&#13;", "\t": "&#9;"}


def plain_characters(text: str) -> str:
    """A text with U+FFFD for each character that XML cannot hold."""
    return _CANNOT.sub("\ufffd", text)


def escape_text(text: str) -> str:
    """Text between tags."""
    return _SPECIAL.sub(lambda match: _WRITTEN[match.group()], plain_characters(text))


def escape_value(text: str) -> str:
    """Text between the double quotes of an attribute."""
    return _SPECIAL_IN_VALUE.sub(lambda match: _WRITTEN[match.group()], plain_characters(text))


def attributes(*pairs: tuple[str, str | int | None]) -> str:
    """` name="value"` for each pair in the order given, without those whose value is None."""
    return "".join(f' {name}="{escape_value(str(value))}"' for name, value in pairs if value is not None)


def text_element(name: str, language: str, text: str) -> str:
    """A text for people in one language ("" for English), as an element."""
    return f"<{name}{attributes(('xml:lang', language or None))}>{escape_text(text)}</{name}>"
