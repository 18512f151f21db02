"""Real robots as runs: the session with each, its state from what it sends, recordings, and sending programs."""

from kitrobot.robots.carried import Carried, carried_by
from kitrobot.robots.link import Link
from kitrobot.robots.names import NAME_ON_ROBOT, BoardNames, NoNameError, names_of
from kitrobot.robots.program import BoardProgram, program_of
from kitrobot.robots.recording import RobotRecorder
from kitrobot.robots.records import NoRecordingError, RecordedBoard
from kitrobot.robots.run import RobotsRun
from kitrobot.robots.sending import (
    NoBoardError,
    Progress,
    Seen,
    Sent,
    Waits,
    at_boards,
    chosen_boards,
    look_at_boards,
    send_program,
    send_programs,
)
from kitrobot.robots.session import Known, NotConnectedError, RobotSession, held_event
from kitrobot.robots.sharing import warn_of_sharing
from kitrobot.robots.state import Change, Doing, Happening, RobotEvent, RobotState
from kitrobot.robots.view import WatchedRobot, fault_object, fault_sentence

__all__ = [
    "NAME_ON_ROBOT",
    "BoardNames",
    "BoardProgram",
    "Carried",
    "Change",
    "Doing",
    "Happening",
    "Known",
    "Link",
    "NoBoardError",
    "NoNameError",
    "NoRecordingError",
    "NotConnectedError",
    "Progress",
    "RecordedBoard",
    "RobotEvent",
    "RobotRecorder",
    "RobotSession",
    "RobotState",
    "RobotsRun",
    "Seen",
    "Sent",
    "Waits",
    "WatchedRobot",
    "at_boards",
    "carried_by",
    "chosen_boards",
    "fault_object",
    "fault_sentence",
    "held_event",
    "look_at_boards",
    "names_of",
    "program_of",
    "send_program",
    "send_programs",
    "warn_of_sharing",
]
