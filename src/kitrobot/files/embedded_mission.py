"""A mission carried inside a picture: the studio's SVG and PNG of a graph hold the whole `.krt` and open like it.

SVG: the text of `<metadata id="kitrobot-mission">`. PNG: an iTXt chunk, uncompressed, with the keyword
`kitrobot-mission`. PDF: studios up to 0.1 wrote PDF themselves, with the mission attached in the open, packed by zlib;
such a file opens, as long as no other program has written it anew. Files for boards (`.hex`, `.uf2`): in records or
blocks that boards skip, packed by zlib. Pictures come from anywhere: what is taken out is bounded, checked as far as
the picture's own form can be checked, and read as carefully as any `.krt` after that. Left to others: reading the
mission.
"""

from __future__ import annotations

import re
import zlib
from collections.abc import Callable
from pathlib import Path, PurePath

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import FileError, read_bytes
from kitrobot.files.file_kinds import identify_file_kind
from kitrobot.files.intel_hex import HexError, read_hex
from kitrobot.files.uf2_file import MAGIC, Uf2Error, read_uf2
from kitrobot.text.sentences import Sentence
from kitrobot.xml.decoder import MAX_BYTES
from kitrobot.xml.expat_parser import DoctypeError, ExpatError, new_parser

KEYWORD = "kitrobot-mission"
PICTURES = (".pdf", ".png", ".svg")
"""Endings of the pictures that the studio makes, or made."""
FOR_BOARDS = (".hex", ".uf2")
"""Endings of files that boards take from their drives."""
CARRIERS = (*PICTURES, *FOR_BOARDS)
"""Endings of all files beside `.krt` that may have a mission inside."""
_PACKED = KEYWORD.encode() + b"\0"
_PNG = b"\x89PNG\r\n\x1a\n"
_ATTACHED = re.compile(
    rb"<< /Type /EmbeddedFile /Subtype /application#2Fxml /Params << /Size [0-9]{1,10} >>"
    rb" /Filter /FlateDecode /Length ([0-9]{1,10}) >>\nstream\n"
)
_SVG = re.compile(
    rb"\A(?:\xef\xbb\xbf)?(?>\s+|<\?.*?\?>|<!--.*?-->|<!DOCTYPE[^>\[]*(?:\[.*?\]\s*)?>)*<svg[\s>/]", re.DOTALL
)
"""Atomic, so that a hostile file cannot make it try every way to split its comments."""
_OURS = Sentence("an SVG or PNG that KitRobot exported has its mission inside; so has a `.krt`")
_LOOKED_AT = 4096
"""Bytes at the beginning in which an SVG shows that it is one."""


class CarriedError(KitRobotError):
    """A picture or another file that holds no mission, or is damaged."""


def is_picture(name: str) -> bool:
    """Whether a file's name says that it is a picture which can carry a mission."""
    return PurePath(name).suffix.lower() in PICTURES


def may_carry_mission(name: str) -> bool:
    """Whether a file's name says that it is a picture, or a file for a board, which may have a mission inside."""
    return PurePath(name).suffix.lower() in CARRIERS


def carried_mission(data: bytes, name: str) -> tuple[bytes, str]:
    """The `.krt` inside a picture, and its name as a mission; what may be a mission comes back as it is.

    Raises:
        CarriedError: it is a picture or of another kind that is known, and there is no mission to be had from it.
    """
    if data.startswith(_PNG):
        found = _in_png(data, name)
    elif data.startswith(b"%PDF-") and (attached := _ATTACHED.search(data)) is not None:
        found = _in_pdf(data, attached, name)
    elif _SVG.match(data[:_LOOKED_AT]):
        found = _in_svg(data, name)
    elif data.startswith(b":") and PurePath(name).suffix.lower() == ".hex":
        found = _in_board_file(lambda: read_hex(data, name).other, name)
    elif data.startswith(MAGIC):
        found = _in_board_file(lambda: read_uf2(data, name).other, name)
    elif (kind := identify_file_kind(data)) is not None:
        raise CarriedError(Sentence("`{name}` is {kind}: there is no mission inside", name, kind), _OURS)
    elif may_carry_mission(name):
        raise CarriedError(
            Sentence("`{name}` is not the picture that its name promises", name)
            if is_picture(name) and data
            else Sentence("`{name}` is not the file for a board that its name promises", name)
            if data
            else Sentence("`{name}` is empty", name),
            Sentence("get the file once more, or open the mission's own `.krt`"),
        )
    else:
        return data, name
    if not found:
        raise CarriedError(Sentence("`{name}` is a picture without a mission inside", name), _OURS)
    return found, PurePath(name).stem + ".krt"


def read_carried(path: Path) -> bytes:
    """The bytes of a `.krt`: the file's own, or those that a picture carries.

    Raises:
        FileError: the file cannot be read, or is a picture without a mission.
    """
    try:
        return carried_mission(read_bytes(path), str(path))[0]
    except CarriedError as error:
        raise FileError(error.message, error.help, path=path) from None


def _damaged(name: str) -> CarriedError:
    return CarriedError(
        Sentence("`{name}` is damaged, so no mission can be taken out of it", name),
        Sentence("get the file once more"),
    )


def _in_png(data: bytes, name: str) -> bytes:
    damaged = _damaged(name)
    at = len(_PNG)
    while True:
        head = data[at : at + 8]
        if len(head) < 8:
            raise damaged
        length, kind = int.from_bytes(head[:4]), head[4:]
        body, check = data[at + 8 : at + 8 + length], data[at + 8 + length : at + 12 + length]
        if len(body) != length or int.from_bytes(check) != zlib.crc32(kind + body) or len(check) != 4:
            raise damaged
        if kind == b"IEND":
            return b""
        # keyword, 0, compressed 0, method 0, language, 0, translated keyword, 0, text
        start = KEYWORD.encode() + b"\0\0\0\0\0"
        if kind == b"iTXt" and body.startswith(start):
            return body[len(start) :]
        at += 12 + length


def _in_pdf(data: bytes, attached: re.Match[bytes], name: str) -> bytes:
    return _unpacked(data[attached.end() : attached.end() + int(attached[1])], name)


def _unpacked(packed: bytes, name: str) -> bytes:
    unpacker = zlib.decompressobj()
    try:
        mission = unpacker.decompress(packed, MAX_BYTES + 1)
    except zlib.error:
        mission = b""
    if not unpacker.eof or len(mission) > MAX_BYTES:
        raise _damaged(name)
    return mission


def packed_mission(mission: bytes) -> bytes:
    """What a file for a board has in what boards skip, so that the mission is inside."""
    return _PACKED + zlib.compress(mission, 9)


def _in_board_file(skipped: Callable[[], bytes], name: str) -> bytes:
    try:
        other = skipped()
    except (HexError, Uf2Error) as error:
        raise CarriedError(error.message, error.help) from None
    if not other.startswith(_PACKED):
        raise CarriedError(
            Sentence("`{name}` is a file for a board without a mission of KitRobot inside", name),
            Sentence("a `.hex` or `.uf2` that KitRobot saved has its mission inside; so has a `.krt`"),
        )
    return _unpacked(other[len(_PACKED) :], name)


class _Metadata:
    """Keeps the text of the metadata that is ours."""

    def __init__(self) -> None:
        self.pieces: list[str] = []
        self._inside = False

    def start(self, name: str, attributes: dict[str, str]) -> None:
        self._inside = name == "metadata" and attributes.get("id") == KEYWORD

    def end(self, name: str) -> None:
        self._inside = False

    def characters(self, content: str) -> None:
        if self._inside:
            self.pieces.append(content)


def _in_svg(data: bytes, name: str) -> bytes:
    if len(data) > 4 * MAX_BYTES:
        raise CarriedError(
            Sentence("`{name}` is too large for a picture of the studio", name),
            Sentence("open the mission's own `.krt`"),
        )
    metadata, parser = _Metadata(), new_parser()
    parser.StartElementHandler = metadata.start
    parser.EndElementHandler = metadata.end
    parser.CharacterDataHandler = metadata.characters
    try:
        parser.Parse(data, True)
    except (ExpatError, DoctypeError, LookupError, ValueError):
        raise _damaged(name) from None
    return "".join(metadata.pieces).strip().encode()
