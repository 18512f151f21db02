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


lines(
    "pdf",
    {
        "objects": ("%PDF-1.7\n", "# 0 obj\n<< /Type /X >>\nendobj\n", "%%EOF"),
        "beginnings of objects": ("%PDF-1.7\n", "1 0 obj <<", "%%EOF"),
        "beginnings of dictionaries": ("%PDF-1.7\n1 0 obj ", "<<", "%%EOF"),
        "beginnings of arrays": ("%PDF-1.7\n1 0 obj ", "[", "%%EOF"),
        "beginnings of texts": ("%PDF-1.7\n1 0 obj ", "(", "%%EOF"),
        "streams": ("%PDF-1.7\n", "# 0 obj\n<< /Length 1 >>\nstream\nx\nendstream\nendobj\n", "%%EOF"),
        "streams that do not end": ("%PDF-1.7\n", "# 0 obj\n<< /Length 99 >>\nstream\n", "%%EOF"),
        "streams of compressed objects": (
            "%PDF-1.7\n",
            "# 0 obj\n<< /Type /ObjStm /N 1 /First 4 /Length 9 >>\nstream\n1 0 <<>> \nendstream\nendobj\n",
            "%%EOF",
        ),
        "ends": ("%PDF-1.7\n", "startxref\n9\n%%EOF\n", ""),
        "references": ("%PDF-1.7\n", "trailer << /Root # 0 R /Prev 9 >>\n", "%%EOF"),
        "embedded files": (
            "%PDF-1.7\n",
            "# 0 obj\n<< /Type /Filespec /F (a.krt) /EF << /F # 0 R >> >>\nendobj\n",
            "%%EOF",
        ),
        "comments": ("%PDF-1.7\n", "% x\n", "%%EOF"),
        "line feeds": ("%PDF-1.7\n", "\n", "%%EOF"),
    },
)
