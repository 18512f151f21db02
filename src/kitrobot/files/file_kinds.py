"""The kind of a file that is no mission, by its first bytes, so that a user who drops a photo is told so."""

from __future__ import annotations

from kitrobot.text.sentences import Sentence

LOOKED_AT = 16
"""Bytes at the beginning that say it."""
_KINDS = (
    (0, b"\xff\xd8\xff", Sentence("a photo (JPEG)")),
    (0, b"\x89PNG\r\n\x1a\n", Sentence("a picture (PNG)")),
    (0, b"GIF8", Sentence("a picture (GIF)")),
    (8, b"WEBP", Sentence("a picture (WebP)")),
    (0, b"II*\0", Sentence("a picture (TIFF)")),
    (0, b"MM\0*", Sentence("a picture (TIFF)")),
    (6, b"\0\0\0\0", Sentence("a picture (BMP)")),
    (4, b"ftypheic", Sentence("a photo (HEIC)")),
    (4, b"ftypmif1", Sentence("a photo (HEIC)")),
    (4, b"ftypavif", Sentence("a picture (AVIF)")),
    (4, b"ftypM4A", Sentence("a sound (MP4)")),
    (4, b"ftyp", Sentence("a film (MP4)")),
    (0, b"\x1a\x45\xdf\xa3", Sentence("a film (WebM)")),
    (8, b"AVI ", Sentence("a film (AVI)")),
    (8, b"WAVE", Sentence("a sound (WAV)")),
    (0, b"ID3", Sentence("a sound (MP3)")),
    (0, b"OggS", Sentence("a sound (Ogg)")),
    (0, b"%PDF-", Sentence("a document (PDF)")),
    (0, b"\xd0\xcf\x11\xe0", Sentence("a document of an office program")),
    (0, b"{\\rtf", Sentence("a document (RTF)")),
    (0, b"PK\x03\x04", Sentence("a packed file (ZIP)")),
    (0, b"PK\x05\x06", Sentence("a packed file (ZIP)")),
    (0, b"\x1f\x8b", Sentence("a packed file (gzip)")),
    (0, b"7z\xbc\xaf", Sentence("a packed file (7z)")),
    (0, b"Rar!", Sentence("a packed file (RAR)")),
    (0, b"\x7fELF", Sentence("a program of this computer")),
    (0, b"MZ", Sentence("a program of this computer")),
    (0, b"KRTRACE\n", Sentence("a recording of a run (`.krtrace`)")),
)
_BEGIN_WITH = {8: b"RIFF", 6: b"BM"}
"""What stands at the beginning of those whose own mark comes later."""


def identify_file_kind(data: bytes) -> str | None:
    """What the bytes are, with an article; None for text and for what is not known."""
    head = data[:LOOKED_AT]
    for at, mark, words in _KINDS:
        if head.startswith(mark, at) and head.startswith(_BEGIN_WITH.get(at, b"")):
            return words
    return None
