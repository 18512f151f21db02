"""A `.krt` file as a whole: programs, team and world together."""

from kitrobot.mission.model import ALL, VERSION, Agent, Goal, Mission, Team
from kitrobot.mission.reading import read_mission
from kitrobot.mission.rules import NO_PROGRAM
from kitrobot.mission.trial import Breakpoint, Failure, FailureKind
from kitrobot.mission.writing import SaveError, save, write_mission

__all__ = [
    "ALL",
    "NO_PROGRAM",
    "VERSION",
    "Agent",
    "Breakpoint",
    "Failure",
    "FailureKind",
    "Goal",
    "Mission",
    "SaveError",
    "Team",
    "read_mission",
    "save",
    "write_mission",
]
