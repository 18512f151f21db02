"""Writing a `.krtrace` as a run goes."""

from __future__ import annotations

import zlib
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO

from kitrobot.trace import layout
from kitrobot.trace.coding import Encoder
from kitrobot.trace.header import header_to_json
from kitrobot.trace.model import TickRecord, TraceError, TraceHeader


class TraceWriter:
    """Writes a trace as the run goes; a context manager. Each full chunk is written before the next begins.

    Raises:
        TraceError: the file cannot be made or written.
    """

    def __init__(self, path: Path, header: TraceHeader) -> None:
        self.path = path
        self._encoder = Encoder(len(header.columns), len(header.agents))
        self._outcome: dict[str, Any] = {}
        text = layout.as_json(header_to_json(header))
        packed = zlib.compress(text, 6)
        head = layout.VERSION_HEAD.pack(layout.VERSION) + layout.HEAD.pack(len(text), len(packed), zlib.crc32(packed))
        try:
            self._file: BinaryIO = path.open("wb")
        except OSError as error:
            raise TraceError(f"the trace {path.name} cannot be written: {error.strerror}") from error
        self._write(layout.MAGIC + head + packed)

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

    def _write(self, data: bytes) -> None:
        try:
            self._file.write(data)
            self._file.flush()
        except OSError as error:
            raise TraceError(f"the trace {self.path.name} cannot be written: {error.strerror}") from error

    def finish(self, outcome: dict[str, Any]) -> None:
        """Says how the run ended; `close` writes it last."""
        self._outcome = outcome

    def close(self) -> None:
        """Writes what is left and closes the file; again does nothing."""
        if self._file.closed:
            return
        try:
            self._write_chunk()
            text = layout.as_json(self._outcome)
            self._write(layout.END.pack(layout.END_MARK, len(text), zlib.crc32(text)) + text)
        finally:
            self._file.close()

    def __enter__(self) -> TraceWriter:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
