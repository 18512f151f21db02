"""From the bytes of a file to its text: UTF-8, or UTF-16 with a byte order mark, and nothing else.

Line breaks of all systems become line feeds, as XML asks of every reader.
"""

from __future__ import annotations

import codecs
import re

from kitrobot.diagnostics.model import Diagnostic, Place
from kitrobot.text.forms import line_feeds, no_text, older_copy
from kitrobot.text.sentences import Sentence
from kitrobot.xml import rules

MAX_BYTES = 64 * 1024 * 1024
"""The size of a file, at most."""

_DECLARED = re.compile(rb"""\s*<\?xml[^>]*?\sencoding\s*=\s*["']([^"']*)["']""")
_UTF_8 = ("utf-8", "utf8", "us-ascii", "ascii")


def decode(data: bytes, name: str) -> str | Diagnostic:
    """The text of a file, or what is wrong with its bytes."""
    if len(data) > MAX_BYTES:
        return rules.TOO_LARGE(
            Sentence("expected at most {most} bytes, found {found}", MAX_BYTES, len(data)), Place(name)
        )
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return _decoded(data, "utf-16", name)
    if data and not data.strip(b"\0"):
        return rules.NOT_WELL_FORMED(no_text(len(data)), Place(name), help=older_copy(name))
    if b"\0" in data[:2]:
        return _refusal(
            Sentence("expected UTF-8, found what looks like UTF-16 without its byte order mark"), Place(name)
        )
    declared = _DECLARED.match(data[:200].removeprefix(codecs.BOM_UTF8))
    encoding = declared.group(1).decode("ascii", "replace") if declared else "utf-8"
    if declared and encoding.casefold() not in _UTF_8:
        column = declared.start(1) + 1
        place = Place(name, 1, column, 1, column + max(1, len(encoding)))
        return _refusal(Sentence("expected UTF-8, found a file that says “{encoding}”", encoding), place)
    return _decoded(data, "utf-8-sig", name)


def _decoded(data: bytes, encoding: str, name: str) -> str | Diagnostic:
    try:
        return line_feeds(data.decode(encoding))
    except UnicodeDecodeError as error:
        before = line_feeds(data[: error.start].decode(encoding, "replace"))
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        wanted = encoding.removesuffix("-sig").upper()
        return _refusal(
            Sentence("expected {wanted}, found bytes that are not", wanted), Place(name, line, column, line, column + 1)
        )


def _refusal(message: Sentence, place: Place) -> Diagnostic:
    return rules.ENCODING(message, place, help=Sentence("save the file as UTF-8"))
