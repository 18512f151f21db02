"""An image: a compiled program, ready for a robot; and its file, the `.kri`.

Cells are numbered fault flag (0), inputs, variables, loop counters, temporaries, constants; the first four are state.
Slots are threads: 0 the program, then one a branch in reading order; `end` is the slot after a slot's last descendant.
An image keeps no names: those of its cells and commands come from the robot's definition, to which `fingerprint`
ties it.
The layout of the file is written down in `kitrobot_onboard.image`, which reads it on every host.
"""

from __future__ import annotations

import struct
import zlib
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence
from kitrobot_onboard import image as onboard
from kitrobot_onboard.arrays import NO_PARALLEL

MOST_CELLS = 256
MOST_SLOTS = 256
MOST_PARALLELS = 256
MOST_STOPS = 256
MOST_COMMANDS = 256
MOST_ARGUMENTS = 255
MOST_INSTRUCTIONS = 65536
LARGEST_VALUE = 2**29 - 1
"""The largest magnitude of a cell's value: sums of two still fit a word of the smallest board."""


class ImageError(KitRobotError):
    """An image (or a listing of one) that cannot be used, and why."""


class SlotRecord(NamedTuple):
    """A thread: the parallel it is a branch of (None: the program), where it starts, whether it is marked."""

    parallel: int | None
    entry: int
    marked: bool
    end: int


class ParallelRecord(NamedTuple):
    """A parallel: the slot it stands in, its first branch's slot, and the slot after its last descendant."""

    parent: int
    first: int
    end: int


class StopRecord(NamedTuple):
    """A marked action with an effect that lasts: the slot it stands in and the command that ends it."""

    slot: int
    command: int


@dataclass(frozen=True)
class Image:
    """A compiled program. `cells` holds first values; `commands` gives each command's actuator; `code` 4 bytes each."""

    fingerprint: bytes
    tick_ms: int
    wait_unit_ms: int
    inputs: int
    variables: int
    counters: int
    temporaries: int
    constants: int
    cells: tuple[int, ...]
    slots: tuple[SlotRecord, ...]
    parallels: tuple[ParallelRecord, ...]
    stops: tuple[StopRecord, ...]
    commands: tuple[int, ...]
    actuators: int
    most_arguments: int
    code: bytes = field(repr=False)

    @property
    def instructions(self) -> int:
        """How many instructions the program has."""
        return len(self.code) // 4

    @property
    def first_constant(self) -> int:
        """The cell of the first constant; nothing writes there or after."""
        return 1 + self.inputs + self.variables + self.counters + self.temporaries

    def to_bytes(self) -> bytes:
        """The file. Raises ImageError when a number does not fit its field."""
        try:
            body = struct.pack(
                onboard.HEADER,
                b"KRI\0",
                onboard.FORMAT,
                0,
                self.fingerprint,
                self.tick_ms,
                self.wait_unit_ms,
                self.inputs,
                self.variables,
                self.counters,
                self.temporaries,
                self.constants,
                len(self.slots),
                len(self.parallels),
                len(self.stops),
                len(self.commands),
                self.actuators,
                self.most_arguments,
                self.instructions,
            )
            body += struct.pack(f"<{len(self.cells)}i", *self.cells)
            for slot in self.slots:
                parallel = NO_PARALLEL if slot.parallel is None else slot.parallel
                body += struct.pack("<4H", parallel, slot.entry, slot.marked, slot.end)
            for record in self.parallels:
                body += struct.pack("<3H", *record)
            for stop in self.stops:
                body += struct.pack("<2H", *stop)
            body += struct.pack(f"<{len(self.commands)}H", *self.commands)
        except struct.error as error:
            raise ImageError(
                Sentence("this image does not fit its file"), Sentence("a size or value is too large: {error}", error)
            ) from error
        body += self.code
        return body + struct.pack("<I", zlib.crc32(body))

    @classmethod
    def from_bytes(cls, data: bytes) -> Image:
        """Reads the file; raises ImageError when it is damaged or of another format. Does not verify what it says."""
        fields = checked_header(data)
        count = 1 + sum(fields[6:11])
        at = onboard.HEADER_SIZE

        def numbers(kind: str, count: int) -> tuple[int, ...]:
            nonlocal at
            size = struct.calcsize(f"<{count}{kind}")
            at += size
            return struct.unpack(f"<{count}{kind}", data[at - size : at])

        cells = numbers("i", count)
        slots = numbers("H", 4 * fields[11])
        parallels = numbers("H", 3 * fields[12])
        stops = numbers("H", 2 * fields[13])
        commands = numbers("H", fields[14])
        if any(marked > 1 for marked in slots[2::4]):
            raise ImageError(Sentence("this image is damaged: a slot is marked in a way we do not know"))
        return cls(
            fingerprint=fields[3],
            tick_ms=fields[4],
            wait_unit_ms=fields[5],
            inputs=fields[6],
            variables=fields[7],
            counters=fields[8],
            temporaries=fields[9],
            constants=fields[10],
            cells=cells,
            slots=tuple(
                SlotRecord(None if p == NO_PARALLEL else p, entry, marked == 1, end)
                for p, entry, marked, end in zip(*(slots[i::4] for i in range(4)), strict=True)
            ),
            parallels=tuple(ParallelRecord(*row) for row in zip(*(parallels[i::3] for i in range(3)), strict=True)),
            stops=tuple(StopRecord(*row) for row in zip(*(stops[i::2] for i in range(2)), strict=True)),
            commands=commands,
            actuators=fields[15],
            most_arguments=fields[16],
            code=data[at:-4],
        )


def checked_header(data: bytes) -> tuple[Any, ...]:
    """The header's fields of a file whose length and checksum are right; raises ImageError otherwise."""
    try:
        fields = onboard.header(data)
    except ValueError as error:
        raise ImageError(Sentence(str(error)), Sentence("make it again with `kitrobot convert`")) from None
    size = onboard.HEADER_SIZE + onboard.body_size(fields)
    if len(data) != size + 4:
        raise ImageError(
            Sentence("this image is damaged: it has {count} bytes where {size} belong", len(data), size + 4),
            Sentence("make it again with `kitrobot convert`"),
        )
    if zlib.crc32(data[:size]) != struct.unpack("<I", data[size:])[0]:
        raise ImageError(
            Sentence("this image is damaged: its checksum does not fit"),
            Sentence("make it again with `kitrobot convert`"),
        )
    return fields
