"""Removal of hidden parts from an exercise's file before pupils get it; comments are removed too."""

from __future__ import annotations

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.xml.decoder import decode
from kitrobot.xml.expat_parser import DoctypeError, ExpatError, new_parser


def remove_hidden_parts(data: bytes, name: str) -> bytes:
    """The file in UTF-8, of which nothing is left but what a pupil may read.

    Args:
        data: an exercise that can be used.
        name: what people call it.

    Raises:
        ValueError: it is no XML.
    """
    text = decode(data, name)
    if isinstance(text, Diagnostic):
        raise ValueError(text.message)
    whole = text.encode()
    gone: list[tuple[int, int]] = []
    hidden: list[int | None] = []
    parser = new_parser("utf-8")

    opened = 0

    def start(_: str, attributes: dict[str, str]) -> None:
        nonlocal opened
        opened = parser.CurrentByteIndex
        hidden.append(opened if len(hidden) == 1 and attributes.get("hidden") == "yes" else None)

    def end(_: str) -> None:
        start, at = hidden.pop(), parser.CurrentByteIndex
        if start is not None:
            # An element without an end tag ends where its only tag does.
            is_whole = opened == start and whole.endswith(b"/>", start, at)
            gone.append((start, at if is_whole else whole.index(b">", at) + 1))

    def remark(begins: bytes, ends: bytes) -> None:
        at = parser.CurrentByteIndex
        gone.append((at, whole.index(ends, at + len(begins)) + len(ends)))

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CommentHandler = lambda _: remark(b"<!--", b"-->")
    parser.ProcessingInstructionHandler = lambda *_: remark(b"<?", b"?>")
    try:
        parser.Parse(whole, True)
    except (ExpatError, DoctypeError) as error:
        raise ValueError(str(error)) from error
    pieces, done = [], 0
    for start_at, end_at in sorted(gone):
        if start_at >= done:  # what is inside of something hidden is gone already
            pieces.append(whole[done:start_at])
            done = end_at
    return b"".join([*pieces, whole[done:]])
