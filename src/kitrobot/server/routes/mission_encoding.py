"""Missions that a page sent as the bytes of a file: what is written opens again, or is not written at all."""

from __future__ import annotations

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.text.sentences import Sentence


class UnsavableError(KitRobotError):
    """What would be written is no mission that opens."""


def mission_bytes(mission: Mission, name: str) -> bytes:
    """The file of a mission.

    Raises:
        UnsavableError: the studio could not open it: its verbatim XML is invalid, or it has no program.
    """
    data = write_mission(mission)
    # What is on the disk is worth more than what cannot be read.
    read, _ = read_mission(data, name)
    if read is None or not any(program.vertices for program in read.programs):
        raise UnsavableError(
            Sentence("this mission would not open again, so it was not saved"), Sentence("load the page again")
        )
    return data
