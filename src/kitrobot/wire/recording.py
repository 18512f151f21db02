"""Recordings on the wire."""

from __future__ import annotations

from pydantic import BaseModel

from kitrobot.wire.files import MissionFileShape
from kitrobot.wire.sentences import Spoken


class RecordingEntryShape(BaseModel):
    """A recording of the folder; `modified` is a moment in UTC (ISO 8601), `problem` why it cannot be opened."""

    path: str
    name: str
    modified: str
    problem: Spoken


class RecordingShape(BaseModel):
    """A recording that was opened: its name, by which it is played, and the mission that it brought along.

    `cut`: its file ends before its run did. `fail_rate` is the probability that an agent failed by chance within a
    minute. `real`: it is of real robots.
    """

    recording: str
    seed: int
    fail_rate: float
    cut: bool
    real: bool
    file: MissionFileShape
