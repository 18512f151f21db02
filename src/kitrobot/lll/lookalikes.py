"""Characters that look like signs and digits of the language, or replace them on other keyboards."""

from __future__ import annotations

import unicodedata

_OTHERS = str.maketrans({"×": "*", "∗": "*", "؛": ";", "،": ",", "、": ",", "。": ".", "∧": "&", "∨": "|", "−": "-"})

_LEFT = frozenset(" #<=>\"'")
"""What could be said only twice: as a character, and as the mistake that it is."""


def plain(text: str) -> str:
    """The text in the signs and digits of the language, character by character; letters stay what they are."""
    return text if text.isascii() else "".join(map(_plain, text.translate(_OTHERS)))


def _plain(character: str) -> str:
    if character.isascii() or character.isalpha():
        return character
    digit = unicodedata.decimal(character, None)
    if digit is not None:
        return str(digit)
    usual = unicodedata.normalize("NFKC", character)
    return usual if len(usual) == 1 and usual.isascii() and usual not in _LEFT else character
