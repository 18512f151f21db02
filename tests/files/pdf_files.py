"""PDFs made by hand for tests: objects in the open, or packed together as other programs rewrite them."""

from __future__ import annotations

import zlib
from collections.abc import Iterable

Numbered = tuple[int, bytes]


def stream(number: int, body: bytes, entries: bytes = b"", packed: bool = True, length: int | None = None) -> Numbered:
    """A stream, packed by zlib unless it is not; `length` is what it claims, where that is not the truth."""
    body = zlib.compress(body) if packed else body
    filters = b" /Filter /FlateDecode" if packed else b""
    claimed = len(body) if length is None else length
    return number, b"<< %s%s /Length %d >>\nstream\n%s\nendstream" % (entries, filters, claimed, body)


def attached(krt: bytes, name: bytes = b"m.krt", first: int = 1, more: bytes = b"") -> list[Numbered]:
    """A mission attached, as objects `first` and the one after it."""
    specification = b"<< /Type /Filespec /F (%s) /UF (%s) %s /EF << /F %d 0 R /UF %d 0 R >> >>"
    return [
        stream(first, krt, b"/Type /EmbeddedFile"),
        (first + 1, specification % (name, name, more, first, first)),
    ]


def pdf(objects: Iterable[Numbered], trailer: bytes = b"/Root 9 0 R") -> bytes:
    """The objects in the open, and a table that says nothing."""
    body = b"".join(b"%d 0 obj\n%s\nendobj\n" % one for one in objects)
    return b"%%PDF-1.7\n%%\xe2\xe3\xcf\xd3\n%strailer\n<< %s >>\nstartxref\n0\n%%%%EOF\n" % (body, trailer)


def packed(number: int, objects: Iterable[Numbered]) -> Numbered:
    """Objects without streams, packed together into one."""
    heads, bodies, at = [], [], 0
    for inner, body in objects:
        heads.append(b"%d %d" % (inner, at))
        bodies.append(body)
        at += len(body) + 1
    head = b" ".join(heads) + b"\n"
    entries = b"/Type /ObjStm /N %d /First %d" % (len(heads), len(head))
    return stream(number, head + b"\n".join(bodies), entries)
