"""Pictures that carry a mission."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterable

from tests.growth.shapes.registry import lines, shape

lines(
    "svg",
    {
        "shapes": ("<svg>", "<path/>", "</svg>"),
        "comments": ("<svg>", "<!-- x -->", "</svg>"),
        "beginnings of a mission": ("<svg>", "<metadata>", "</svg>"),
        "missions": ("<svg>", '<metadata><kitrobot version="1"/></metadata>', "</svg>"),
    },
)


def _png(chunks: Iterable[tuple[bytes, bytes]]) -> bytes:
    found = b"\x89PNG\r\n\x1a\n"
    for kind, data in chunks:
        found += struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return found


@shape("png chunks")
def _chunks(n: int) -> bytes:
    one = _png([(b"tEXt", b"a\0b")])[8:]
    return _png([(b"IHDR", bytes(13))]) + one * n + _png([(b"IEND", b"")])[8:]


@shape("png bytes of a text")
def _text_chunk(n: int) -> bytes:
    return _png([(b"IHDR", bytes(13)), (b"iTXt", b"kitrobot\0" + b"a" * n), (b"IEND", b"")])


_ATTACHED = "<< /Type /EmbeddedFile /Subtype /application#2Fxml /Params << /Size 1 >> /Filter /FlateDecode /Length"
lines(
    "pdf",
    {
        "objects": ("%PDF-1.7\n", "# 0 obj\n<< /Type /X >>\nendobj\n", "%%EOF"),
        "embedded files": ("%PDF-1.7\n", f"{_ATTACHED} 9 >>\nstream\nx\nendstream\n", "%%EOF"),
        "beginnings of embedded files": ("%PDF-1.7\n", f"{_ATTACHED} ", "%%EOF"),
        "line feeds": ("%PDF-1.7\n", "\n", "%%EOF"),
    },
)
