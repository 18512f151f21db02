"""The parser under all reading of XML: expat, which refuses documents with a document type.

Without a document type there are no entities of one's own, so none that grow and none that name other files.
"""

from __future__ import annotations

from typing import NoReturn
from xml.parsers.expat import ErrorString, ExpatError, ParserCreate, XMLParserType

__all__ = ["DoctypeError", "ExpatError", "error_text", "new_parser"]


class DoctypeError(Exception):
    """The document has a document type."""


def new_parser(encoding: str | None = None, *, namespaces: bool = False) -> XMLParserType:
    """A parser without handlers of elements and text; `encoding` overrules what the document declares.

    With `namespaces` it refuses prefixes that nobody declares, as most programs do.

    Its `Parse` raises `ExpatError` for what is not well-formed and `DoctypeError` for a document type.
    """
    parser = ParserCreate(encoding, " ") if namespaces else ParserCreate(encoding)
    parser.StartDoctypeDeclHandler = _refuse
    return parser


def _refuse(*_: object) -> NoReturn:
    raise DoctypeError


def error_text(error: ExpatError) -> str:
    """The parser's own words for an error."""
    return ErrorString(error.code)
