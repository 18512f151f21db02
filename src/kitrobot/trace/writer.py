"""Writing a `.krtrace` as a run goes."""

from __future__ import annotations

import sys
import zlib
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO

from kitrobot.diagnostics.read_files import expect_output
from kitrobot.diagnostics.regular import expect_regular, lock_handle
from kitrobot.text.sentences import Sentence, Word
from kitrobot.trace import layout
from kitrobot.trace.codec import Encoder
from kitrobot.trace.header import header_to_json
from kitrobot.trace.model import TickRecord, TraceError, TraceHeader


class TraceWriter:
    """Writes a trace as the run goes; a context manager. Each full chunk is written before the next begins.

    Where it cannot be written any further, the file ends behind what was written whole: it opens as one that was cut.

    Raises:
        TraceError: the file cannot be made or written, or another run is writing it.
        OutputPlaceError: it is a file that this command has read.
    """

    def __init__(self, path: Path, header: TraceHeader) -> None:
        self.path = path
        self._encoder = Encoder(len(header.columns), len(header.agents))
        self._outcome: dict[str, Any] = {}
        self._bytes = 0
        self._broken = False
        text = layout.as_json(header_to_json(header))
        packed = zlib.compress(text, 6)
        head = layout.VERSION_HEAD.pack(layout.VERSION) + layout.HEAD.pack(len(text), len(packed), zlib.crc32(packed))
        expect_output(path)
        try:
            expect_regular(path)
            self._file: BinaryIO = path.open("ab", buffering=0)
        except OSError as error:
            raise TraceError(
                Sentence("the trace {path} cannot be written: {reason}", path.name, Word(error.strerror))
            ) from error
        try:
            self._begin()
            self._write(layout.MAGIC + head + packed)
        except TraceError:
            self._file.close()
            raise

    def _begin(self) -> None:
        """Empties the file, once no other run writes into it."""
        free = True
        # There a lock keeps readers away too. A file system without locks has none to wait for.
        if sys.platform != "win32":
            with suppress(OSError):
                free = lock_handle(self._file.fileno())
        if not free:
            raise TraceError(Sentence("the trace {path} is being written by another run", self.path.name))
        self._file.truncate(0)

    def record(self, record: TickRecord) -> None:
        """Takes one record; ticks must grow."""
        self._encoder.add(record)
        if self._encoder.records >= layout.CHUNK_RECORDS or self._encoder.size >= layout.CHUNK_BYTES:
            self._write_chunk()

    def _write_chunk(self) -> None:
        encoder = self._encoder
        if encoder.records == 0:
            return
        ticks, records = (encoder.first_tick, encoder.last_tick), encoder.records
        raw = encoder.take()
        packed = zlib.compress(raw[0], 6), zlib.compress(raw[1], 6)
        self._write(layout.chunk_head(ticks, records, raw, packed) + packed[0] + packed[1])

    def settle(self) -> None:
        """Writes what it has taken so far, though the chunk is not full: after that it is safe whatever happens."""
        self._write_chunk()

    def _write(self, data: bytes) -> None:
        """Adds something whole to the file, or nothing of it."""
        if self._broken:
            raise TraceError(Sentence("the trace {path} is not written any more", self.path.name))
        left = memoryview(data)
        try:
            while left:
                left = left[self._file.write(left) :]
        except OSError as error:
            self._broken = True
            with suppress(OSError):
                self._file.truncate(self._bytes)
            raise TraceError(
                Sentence("the trace {path} cannot be written: {reason}", self.path.name, Word(error.strerror))
            ) from error
        self._bytes += len(data)

    def finish(self, outcome: dict[str, Any]) -> None:
        """Says how the run ended; `close` writes it last."""
        self._outcome = outcome

    def close(self) -> None:
        """Writes what is left and closes the file; again does nothing."""
        if self._file.closed:
            return
        try:
            if self._broken:
                return
            self._write_chunk()
            self._write(_end(self._outcome))
        finally:
            self._file.close()

    @staticmethod
    def end(path: Path, outcome: dict[str, Any]) -> None:
        """Ends a copy of the file of a trace that is still written: it is whole then. May raise OSError."""
        with path.open("ab") as file:
            file.write(_end(outcome))

    def __enter__(self) -> TraceWriter:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


def _end(outcome: dict[str, Any]) -> bytes:
    text = layout.as_json(outcome)
    return layout.END.pack(layout.END_MARK, len(text), zlib.crc32(text)) + text
