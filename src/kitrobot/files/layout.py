"""LLL files in the one true layout."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from kitrobot.diagnostics.model import Diagnostic, Source
from kitrobot.files.disk import decode, read_bytes, write_atomic
from kitrobot.lll.formatter import format_text


@dataclass(frozen=True)
class Layout:
    """An LLL text laid out anew: `text` is None when the text has mistakes, then `diagnostics` says which."""

    path: Path
    source: Source
    text: str | None
    diagnostics: tuple[Diagnostic, ...]
    changed: bool
    before: bytes | None = None
    """What the file held when it was read."""

    def write(self) -> bool:
        """Puts the new text in the file's place; tells whether that was needed.

        Raises:
            FileError: it cannot be written, or somebody changed the file since it was read.
        """
        if self.text is None or not self.changed:
            return False
        write_atomic(self.path, self.text.encode(), self.before)
        return True


def lay_out(data: bytes, path: Path) -> Layout:
    """The content of an LLL file laid out anew; asks nothing of a robot.

    Raises:
        FileError: it is not text in UTF-8.
    """
    source = Source(str(path), decode(data, path))
    text, diagnostics = format_text(source.text, source.name)
    changed = text is not None and text.encode() != data
    return Layout(path, source, text, tuple(diagnostics), changed, data)


def lay_out_file(path: Path) -> Layout:
    """An LLL file laid out anew; the file stays as it is until `Layout.write`.

    Raises:
        FileError: the file cannot be read or is not text in UTF-8.
    """
    return lay_out(read_bytes(path), path)
