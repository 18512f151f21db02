"""Real robots as runs: the session with each, its state from what it sends, recordings, and sending programs."""

from kitrobot.robots.board_operations import (
    BoardContents,
    NoBoardError,
    Progress,
    SendResult,
    WaitListener,
    choose_boards,
    run_on_boards,
    scan_boards,
    send_program,
    send_programs,
)
from kitrobot.robots.link import Link
from kitrobot.robots.names import NAME_ON_ROBOT, BoardNames, NoNameError, names_of
from kitrobot.robots.program import BoardProgram, program_of
from kitrobot.robots.recording import RobotRecorder
from kitrobot.robots.recording_context import RecordingContext, recording_context_of
from kitrobot.robots.records import NoRecordingError, RecordedBoard
from kitrobot.robots.run import RobotsRun
from kitrobot.robots.session import InstalledProgram, NotConnectedError, RobotSession, held_event
from kitrobot.robots.shared_variable_check import warn_of_shared_variables
from kitrobot.robots.state import Activity, Change, ChangeKind, RobotEvent, RobotState
from kitrobot.robots.view import WatchedRobot, fault_object, fault_sentence

__all__ = [
    "NAME_ON_ROBOT",
    "Activity",
    "BoardContents",
    "BoardNames",
    "BoardProgram",
    "Change",
    "ChangeKind",
    "InstalledProgram",
    "Link",
    "NoBoardError",
    "NoNameError",
    "NoRecordingError",
    "NotConnectedError",
    "Progress",
    "RecordedBoard",
    "RecordingContext",
    "RobotEvent",
    "RobotRecorder",
    "RobotSession",
    "RobotState",
    "RobotsRun",
    "SendResult",
    "WaitListener",
    "WatchedRobot",
    "choose_boards",
    "fault_object",
    "fault_sentence",
    "held_event",
    "names_of",
    "program_of",
    "recording_context_of",
    "run_on_boards",
    "scan_boards",
    "send_program",
    "send_programs",
    "warn_of_shared_variables",
]
