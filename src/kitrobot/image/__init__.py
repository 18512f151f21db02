"""Images: the compiled form of a program, its file, its listing, its verification, and the machine that runs it."""

from kitrobot.image.debug import DebugMap, Origin
from kitrobot.image.devices import Command, Devices, Readings
from kitrobot.image.listing import assemble, disassemble
from kitrobot.image.machine import Layout, Machine
from kitrobot.image.model import (
    LARGEST_VALUE,
    MOST_ARGUMENTS,
    MOST_CELLS,
    MOST_COMMANDS,
    MOST_INSTRUCTIONS,
    MOST_PARALLELS,
    MOST_SLOTS,
    MOST_STOPS,
    Image,
    ImageError,
    ParallelRecord,
    SlotRecord,
    StopRecord,
)
from kitrobot.image.verification import most_instructions_a_tick, verify

__all__ = [
    "LARGEST_VALUE",
    "MOST_ARGUMENTS",
    "MOST_CELLS",
    "MOST_COMMANDS",
    "MOST_INSTRUCTIONS",
    "MOST_PARALLELS",
    "MOST_SLOTS",
    "MOST_STOPS",
    "Command",
    "DebugMap",
    "Devices",
    "Image",
    "ImageError",
    "Layout",
    "Machine",
    "Origin",
    "ParallelRecord",
    "Readings",
    "SlotRecord",
    "StopRecord",
    "assemble",
    "disassemble",
    "most_instructions_a_tick",
    "verify",
]
