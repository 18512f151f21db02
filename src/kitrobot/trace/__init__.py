"""What happened in a run, tick by tick: recorded, read, sought."""

from kitrobot.trace.drawing import MOST_COLOUR as MOST_PEN_COLOUR
from kitrobot.trace.drawing import MOST_WIDTH_MM as MOST_PEN_WIDTH_MM
from kitrobot.trace.drawing import PEN, Drawing, DrawingReader, Mark, News, Pen, Stroke, marks_of
from kitrobot.trace.drawing_svg import drawing_svg
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
    Inner,
    Place,
    Threads,
    TickRecord,
    TraceAgent,
    TraceCommand,
    TraceError,
    TraceEvent,
    TraceHeader,
    TracePart,
    TracePlan,
    TracePoint,
)
from kitrobot.trace.reading import TraceReader
from kitrobot.trace.source import Ability, AbilityError, NewEvents, RecordingSource, RunSource, UnchangeableSource
from kitrobot.trace.writing import TraceWriter

__all__ = [
    "CHANCE",
    "ENDING",
    "LINK",
    "MISSION",
    "MOST_PEN_COLOUR",
    "MOST_PEN_WIDTH_MM",
    "PEN",
    "PERSON",
    "POSE_WORDS",
    "PROGRAM",
    "ROBOT",
    "TEAM",
    "WORLD",
    "Ability",
    "AbilityError",
    "Column",
    "Drawing",
    "DrawingReader",
    "Inner",
    "Mark",
    "NewEvents",
    "News",
    "Pen",
    "Place",
    "RecordingSource",
    "RunSource",
    "Stroke",
    "Threads",
    "TickRecord",
    "TraceAgent",
    "TraceCommand",
    "TraceError",
    "TraceEvent",
    "TraceHeader",
    "TracePart",
    "TracePlan",
    "TracePoint",
    "TraceReader",
    "TraceWriter",
    "UnchangeableSource",
    "drawing_svg",
    "marks_of",
]
