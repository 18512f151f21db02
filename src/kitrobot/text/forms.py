"""The one form in which text is compared: names in Unicode's form NFC, lines that end with a line feed.

A keyboard types é as one character, another, and some file systems, as e with a mark: it is one name. Lines end as on
any system: LF, CR LF or CR, and nothing else (neither U+0085 nor U+2028, which the studio's editor keeps in the line).
"""

from __future__ import annotations

import unicodedata


def name_form(name: str) -> str:
    """The form of a name in which two that are the same text are equal."""
    return name if name.isascii() else unicodedata.normalize("NFC", name)


def line_feeds(text: str) -> str:
    """The text with a line feed at the end of each line."""
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text
