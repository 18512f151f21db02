"""The `.krt` attached to a PDF.

A PDF is a heap of numbered objects, and a table at the end that says where each is. The table is not trusted: the file
is read once from front to back, object by object, so a table that lies, or is missing, changes nothing, and the time
is that of the file's length. Objects that other programs packed together are unpacked. What is sought are file
specifications whose name ends with `.krt`; the attachment they lead to is unpacked up to a bound.

Strings of PDF 32000-1: dictionaries and arrays (7.3), streams (7.3.8), object streams (7.5.7), file specifications
(7.11.3). Left to others: reading the mission.
"""

from __future__ import annotations

import re
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from kitrobot.xml.decoder import MAX_BYTES

MAGIC = b"%PDF-"
MOST_OBJECTS = 300_000
MOST_UNPACKED_BYTES = MAX_BYTES
"""Of all packed objects together."""
_DEEPEST = 40
_LONGEST_STRING = 10_000

_SPACE = re.compile(rb"(?:[\0\t\n\f\r ]|%[^\r\n]*)*+")
_OBJECT = re.compile(rb"(?<![0-9])([0-9]{1,10})[\0\t\n\f\r ]{1,20}[0-9]{1,5}[\0\t\n\f\r ]{1,20}obj(?![a-z])|trailer")
_REFERENCE = re.compile(rb"([0-9]{1,10})[\0\t\n\f\r ]{1,20}[0-9]{1,5}[\0\t\n\f\r ]{1,20}R(?![A-Za-z])")
_NUMBER = re.compile(rb"[-+]?(?:[0-9]{1,20}(?:\.[0-9]{0,40}+)?|\.[0-9]{1,40})")
_NAME = re.compile(rb"/([^\0\t\n\f\r ()<>\[\]{}/%]{0,200})")
_WORD = re.compile(rb"[a-zA-Z]{1,40}")
_HEX = re.compile(rb"<([0-9A-Fa-f\0\t\n\f\r ]*+)>")
_STRING_PART = re.compile(rb"[^()\\]*+")
_NAME_ESCAPE = re.compile(rb"#([0-9A-Fa-f]{2})")


class PdfError(Exception):
    """Why there is no mission to be had; `kind` is one of `damaged`, `locked`, `large`."""

    def __init__(self, kind: str) -> None:
        super().__init__(kind)
        self.kind = kind


class _DamagedPdfError(Exception):
    """What stands at `at` is no object."""

    def __init__(self, at: int) -> None:
        super().__init__(at)
        self.at = at


@dataclass(frozen=True)
class _Ref:
    number: int


@dataclass(frozen=True)
class _Stream:
    entries: dict[str, Any]
    start: int
    end: int


@dataclass
class _PdfObjects:
    """What the file holds of interest, by object number; what comes later in the file replaces what came before."""

    streams: dict[int, _Stream] = field(default_factory=dict)
    specifications: dict[int, dict[str, Any]] = field(default_factory=dict)
    numbers: dict[int, int] = field(default_factory=dict)


def mission_in_pdf(data: bytes) -> bytes:
    """The mission attached to a PDF; b"" when there is none.

    Raises:
        PdfError: it is damaged, locked with a password, or holds too much.
    """
    found = _read(data)
    for specification in _missions(found):
        place = specification["EF"].get("UF") or specification["EF"].get("F")
        stream = found.streams.get(place.number) if isinstance(place, _Ref) else None
        if stream is None:
            raise PdfError("damaged")
        mission = _unpacked(data, stream, MAX_BYTES)
        if mission is None:
            raise PdfError("damaged")
        return mission
    if b"%%EOF" not in data[-2048:]:
        raise PdfError("damaged")
    return b""


def _missions(found: _PdfObjects) -> list[dict[str, Any]]:
    """The specifications of missions: ours, which says that it is the source, before what people attached."""
    missions = [one for one in found.specifications.values() if _file_name(one).lower().endswith(".krt")]
    return sorted(missions, key=lambda one: one.get("AFRelationship") != "/Source")


def _file_name(specification: dict[str, Any]) -> str:
    for key in ("UF", "F"):
        value = specification.get(key)
        if isinstance(value, bytes):
            if value.startswith(b"\xfe\xff"):
                return value[2:].decode("utf-16-be", errors="replace")
            return value.removeprefix(b"\xef\xbb\xbf").decode("utf-8", errors="replace")
    return ""


def _read(data: bytes) -> _PdfObjects:
    """All objects of the file, once, in their order."""
    found = _PdfObjects()
    packed: list[_Stream] = []
    at = count = 0
    while (match := _OBJECT.search(data, at)) is not None:
        count += 1
        if count > MOST_OBJECTS:
            raise PdfError("large")
        try:
            value, at = _value(data, match.end())
            if match[1] is None:
                _refuse_locked(value)
                continue
            number = int(match[1])
            stream, at = _stream(data, at, value)
        except _DamagedPdfError as broken:
            # From where it broke: nothing is looked at twice.
            at = max(broken.at, match.end())
            continue
        if stream is not None:
            found.streams[number] = stream
            if stream.entries.get("Type") == "/ObjStm":
                packed.append(stream)
            elif stream.entries.get("Type") == "/XRef":
                _refuse_locked(stream.entries)
        else:
            _keep(found, number, value)
    _unpack(data, packed, found)
    return found


def _keep(found: _PdfObjects, number: int, value: object) -> None:
    if isinstance(value, dict) and isinstance(value.get("EF"), dict):
        found.specifications[number] = value
    elif isinstance(value, int):
        found.numbers[number] = value


def _refuse_locked(entries: object) -> None:
    if isinstance(entries, dict) and "Encrypt" in entries:
        raise PdfError("locked")


def _stream(data: bytes, at: int, value: object) -> tuple[_Stream | None, int]:
    """The stream behind a dictionary, if there is one, and where to go on."""
    at = _skip(data, at)
    if not isinstance(value, dict) or not data.startswith(b"stream", at):
        return None, at
    start = at + 6
    start += 2 if data.startswith(b"\r\n", start) else 1
    length = value.get("Length")
    if isinstance(length, int) and 0 <= length <= len(data) - start:
        end = start + length
        if data[end : end + 20].lstrip(b"\0\t\n\f\r ").startswith(b"endstream"):
            return _Stream(value, start, end), end
    # Its length stands elsewhere, or is wrong. Line ends before the word are harmless to what we unpack.
    end = data.find(b"endstream", start)
    if end < 0:
        raise PdfError("damaged")
    return _Stream(value, start, end), end


def _unpack(data: bytes, packed: list[_Stream], found: _PdfObjects) -> None:
    """Objects that were packed together into streams."""
    left = MOST_UNPACKED_BYTES
    for stream in packed:
        body = _unpacked(data, stream, left)
        if body is None:
            continue
        left -= len(body)
        first, count = stream.entries.get("First"), stream.entries.get("N")
        if not isinstance(first, int) or not isinstance(count, int) or not 0 <= first <= len(body):
            continue
        heads = re.findall(rb"[0-9]{1,10}", body[:first])[: 2 * min(count, MOST_OBJECTS)]
        broken_to = 0
        for number, offset in zip(heads[::2], heads[1::2], strict=False):
            at = first + int(offset)
            if at < broken_to or at > len(body):
                continue
            try:
                value, broken_to = _value(body, at)
            except _DamagedPdfError as broken:
                broken_to = broken.at
                continue
            # An object that stands in the open was written after the packing.
            if int(number) not in found.specifications:
                _keep(found, int(number), value)


def _unpacked(data: bytes, stream: _Stream, most: int) -> bytes | None:
    """The content of a stream; None when it is packed in a way that we do not know.

    Raises:
        PdfError: it is damaged, or more than `most` bytes.
    """
    filters = stream.entries.get("Filter", [])
    filters = filters if isinstance(filters, list) else [filters]
    parameters = stream.entries.get("DecodeParms")
    predicted = isinstance(parameters, dict) and parameters.get("Predictor", 1) != 1
    body = memoryview(data)[stream.start : stream.end]
    if not filters:
        if len(body) > most:
            raise PdfError("large")
        return bytes(body)
    if filters != ["/FlateDecode"] or predicted:
        return None
    unpacker = zlib.decompressobj()
    try:
        content = unpacker.decompress(body, most + 1)
    except zlib.error:
        raise PdfError("damaged") from None
    if len(content) > most:
        raise PdfError("large")
    if not unpacker.eof:
        raise PdfError("damaged")
    return content


def _skip(data: bytes, at: int) -> int:
    match = _SPACE.match(data, at)
    assert match is not None
    return match.end()


def _value(data: bytes, at: int, depth: int = 0) -> tuple[Any, int]:
    """The object at `at`, and where it ends. A name comes with its `/`, a string as bytes.

    Raises:
        _DamagedPdfError: there is none, or it is nested too deep.
    """
    at = _skip(data, at)
    if depth > _DEEPEST:
        raise _DamagedPdfError(at)
    first = data[at : at + 1]
    if data.startswith(b"<<", at):
        return _dictionary(data, at + 2, depth)
    if first == b"[":
        return _array(data, at + 1, depth)
    if first == b"(":
        return _string(data, at + 1)
    if first == b"<" and (match := _HEX.match(data, at)) is not None:
        digits = match[1].translate(None, b"\0\t\n\f\r ")[: 2 * _LONGEST_STRING]
        return bytes.fromhex((digits + b"0" * (len(digits) % 2)).decode()), match.end()
    if (match := _NAME.match(data, at)) is not None:
        name = _NAME_ESCAPE.sub(lambda escape: bytes([int(escape[1], 16)]), match[1])
        return "/" + name.decode("latin-1"), match.end()
    if (match := _REFERENCE.match(data, at)) is not None:
        return _Ref(int(match[1])), match.end()
    if (match := _NUMBER.match(data, at)) is not None:
        text = match[0]
        return (float(text) if b"." in text else int(text)), match.end()
    if (match := _WORD.match(data, at)) is not None and match[0] in (b"true", b"false", b"null"):
        return {b"true": True, b"false": False}.get(match[0]), match.end()
    raise _DamagedPdfError(at)


def _dictionary(data: bytes, at: int, depth: int) -> tuple[dict[str, Any], int]:
    entries: dict[str, Any] = {}
    while True:
        at = _skip(data, at)
        if data.startswith(b">>", at):
            return entries, at + 2
        key, at = _value(data, at, depth + 1)
        if not isinstance(key, str):
            raise _DamagedPdfError(at)
        entries[key[1:]], at = _value(data, at, depth + 1)


def _array(data: bytes, at: int, depth: int) -> tuple[list[Any], int]:
    items: list[Any] = []
    while True:
        at = _skip(data, at)
        if data.startswith(b"]", at):
            return items, at + 1
        item, at = _value(data, at, depth + 1)
        items.append(item)


def _string(data: bytes, at: int) -> tuple[bytes, int]:
    """A string in parentheses, which may stand inside of it in pairs; kept up to a length."""
    pieces: list[bytes] = []
    kept, inner = 0, 1
    for piece, end in _pieces(data, at):
        if piece == b"(":
            inner += 1
        elif piece == b")":
            inner -= 1
            if inner == 0:
                return b"".join(pieces)[:_LONGEST_STRING], end
        if kept < _LONGEST_STRING:
            pieces.append(piece)
            kept += len(piece)
    raise _DamagedPdfError(len(data))


_ESCAPES = {b"n": b"\n", b"r": b"\r", b"t": b"\t", b"b": b"\b", b"f": b"\f", b"\n": b"", b"\r": b""}
_OCTAL = re.compile(rb"[0-7]{1,3}")


def _pieces(data: bytes, at: int) -> Iterator[tuple[bytes, int]]:
    """Stretches of a string and where each ends: plain text, a parenthesis, what an escape stands for."""
    while at < len(data):
        match = _STRING_PART.match(data, at)
        assert match is not None
        if match.end() > at:
            at = match.end()
            yield match[0], at
        elif data[at : at + 1] != b"\\":
            at += 1
            yield data[at - 1 : at], at
        elif (octal := _OCTAL.match(data, at + 1)) is not None:
            at = octal.end()
            # Never a parenthesis of ours: an escaped one is text.
            yield bytes([int(octal[0], 8) & 255]).replace(b"(", b"_").replace(b")", b"_"), at
        else:
            after = data[at + 1 : at + 2]
            at += 2
            yield _ESCAPES.get(after, b"_" if after in (b"(", b")") else after), at
