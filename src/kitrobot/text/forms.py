"""The one form in which text is compared: names in Unicode's form NFC, lines that end with a line feed.

A keyboard types é as one character, another, and some file systems, as e with a mark: it is one name. Lines end as on
any system: LF, CR LF or CR, and nothing else (neither U+0085 nor U+2028, which the studio's editor keeps in the line).
"""

from __future__ import annotations

import re
import unicodedata

from kitrobot.text.sentences import Sentence

_OURS = re.compile(r"^<{7}(?=[ \r\n]|\Z)", re.MULTILINE)
_BETWEEN = re.compile(r"^={7}\r?$", re.MULTILINE)
_THEIRS = re.compile(r"^>{7} ", re.MULTILINE)
"""The lines that git leaves around the two sides of a conflict."""

UNFINISHED_MERGE = Sentence("a merge was not finished here")
FINISH_MERGE = Sentence(
    "leave what is right and take the lines with `<<<<<<<`, `=======` and `>>>>>>>` away; `kitrobot merge` is git's"
    " driver for missions and leaves none"
)


def no_text(count: int) -> Sentence:
    """What is said of a file of zero bytes alone, so many."""
    return Sentence("this file holds no text, only {count} bytes that are zero", count)


def older_copy(name: object) -> Sentence:
    """A way out for a file of that name which was not written to its end."""
    return Sentence(
        "as the power leaves it when it goes while a file is written; the one before is `{copy}`, if there is one",
        f"{name}~",
    )


def name_form(name: str) -> str:
    """The form of a name in which two that are the same text are equal."""
    return name if name.isascii() else unicodedata.normalize("NFC", name)


def number_form(text: str) -> str:
    """A number as a person types it, in ASCII: digits of any script, and the decimal sign of Urdu and Arabic keyboards.

    What is no digit stays as it is.
    """
    if text.isascii():
        return text
    return "".join("." if one == "\u066b" else str(unicodedata.decimal(one, one)) for one in text)


def line_feeds(text: str) -> str:
    """The text with a line feed at the end of each line."""
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def conflict_mark(text: str) -> int | None:
    """Where a text has the first mark of a merge that was not finished, as git leaves it; None without."""
    found = _OURS.search(text)
    if found is None and _THEIRS.search(text) is not None:
        found = _BETWEEN.search(text)
    return None if found is None else found.start()
