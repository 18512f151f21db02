"""What happened in a run, tick by tick: recorded, read, sought."""

from kitrobot.trace.file import TraceReader, TraceWriter
from kitrobot.trace.model import (
    TEAM,
    Column,
    Threads,
    TickRecord,
    TraceAgent,
    TraceCommand,
    TraceError,
    TraceEvent,
    TraceHeader,
)

__all__ = [
    "TEAM",
    "Column",
    "Threads",
    "TickRecord",
    "TraceAgent",
    "TraceCommand",
    "TraceError",
    "TraceEvent",
    "TraceHeader",
    "TraceReader",
    "TraceWriter",
]
