"""What happened in a run, tick by tick: recorded, read, sought."""

from kitrobot.trace.layout import ENDING
from kitrobot.trace.model import (
    CHANCE,
    LINK,
    MISSION,
    PERSON,
    POSE_WORDS,
    PROGRAM,
    ROBOT,
    TEAM,
    WORLD,
    Column,
    Threads,
    TickRecord,
    TraceAgent,
    TraceCommand,
    TraceError,
    TraceEvent,
    TraceHeader,
    TracePart,
)
from kitrobot.trace.reading import TraceReader
from kitrobot.trace.source import Ability, AbilityError, NewEvents, RecordingSource, RunSource
from kitrobot.trace.writing import TraceWriter

__all__ = [
    "CHANCE",
    "ENDING",
    "LINK",
    "MISSION",
    "PERSON",
    "POSE_WORDS",
    "PROGRAM",
    "ROBOT",
    "TEAM",
    "WORLD",
    "Ability",
    "AbilityError",
    "Column",
    "NewEvents",
    "RecordingSource",
    "RunSource",
    "Threads",
    "TickRecord",
    "TraceAgent",
    "TraceCommand",
    "TraceError",
    "TraceEvent",
    "TraceHeader",
    "TracePart",
    "TraceReader",
    "TraceWriter",
]
