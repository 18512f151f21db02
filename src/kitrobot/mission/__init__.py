"""A `.krt` file as a whole: programs, team and world together."""

from kitrobot.mission.breakdown import Breakdown, BreakdownRule
from kitrobot.mission.model import ALL, DEFAULT_SEED, VERSION, Agent, Goal, Mission, Team, image_name
from kitrobot.mission.property_xml import AskedProperty, Form
from kitrobot.mission.radio import Radio
from kitrobot.mission.reader import read_mission
from kitrobot.mission.rules import AGENT_ROBOT, NO_PROGRAM, PROPERTY
from kitrobot.mission.trial import Breakpoint, Failure, FailureKind
from kitrobot.mission.writer import SaveError, save, write_mission

__all__ = [
    "AGENT_ROBOT",
    "ALL",
    "DEFAULT_SEED",
    "NO_PROGRAM",
    "PROPERTY",
    "VERSION",
    "Agent",
    "AskedProperty",
    "Breakdown",
    "BreakdownRule",
    "Breakpoint",
    "Failure",
    "FailureKind",
    "Form",
    "Goal",
    "Mission",
    "Radio",
    "SaveError",
    "Team",
    "image_name",
    "read_mission",
    "save",
    "write_mission",
]
