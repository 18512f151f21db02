"""Real robots: the line to a board, what is put onto it, and the link to the robot that runs there."""

from kitrobot.deploy.board import Board, Hello, Step, is_slow
from kitrobot.deploy.driver_fit import refuse_misfits, refuse_what_fits_no_board
from kitrobot.deploy.errors import (
    BoardError,
    BrokenOffError,
    DeployError,
    FirmwareError,
    ForeignError,
    FullError,
    LineError,
    NoMemoryError,
    PackageError,
    ResetError,
    SilentError,
)
from kitrobot.deploy.firmware import EVERYWHERE, FirmwareRequirements
from kitrobot.deploy.handshake import connect
from kitrobot.deploy.installation import DeployResult, Progress, RobotContext, deploy
from kitrobot.deploy.kits import (
    PartOnKit,
    fit_to_kit,
    kit_problems,
    parts_on_kit,
    parts_used,
    refuse_what_is_missing,
)
from kitrobot.deploy.line import Line
from kitrobot.deploy.news import FAULTS, Fault, News, Text
from kitrobot.deploy.package import FAMILIES, OWN_SUFFIX, Package
from kitrobot.deploy.ports import BOARDS_VARIABLE, Port, list_ports
from kitrobot.deploy.program_file import ProgramFile, make_program_file, program_name, read_program_file
from kitrobot.deploy.receiver import Receiver
from kitrobot.deploy.repl import RawRepl
from kitrobot.deploy.script import board_file

__all__ = [
    "BOARDS_VARIABLE",
    "EVERYWHERE",
    "FAMILIES",
    "FAULTS",
    "OWN_SUFFIX",
    "Board",
    "BoardError",
    "BrokenOffError",
    "DeployError",
    "DeployResult",
    "Fault",
    "FirmwareError",
    "FirmwareRequirements",
    "ForeignError",
    "FullError",
    "Hello",
    "Line",
    "LineError",
    "News",
    "NoMemoryError",
    "Package",
    "PackageError",
    "PartOnKit",
    "Port",
    "ProgramFile",
    "Progress",
    "RawRepl",
    "Receiver",
    "ResetError",
    "RobotContext",
    "SilentError",
    "Step",
    "Text",
    "board_file",
    "connect",
    "deploy",
    "fit_to_kit",
    "is_slow",
    "kit_problems",
    "list_ports",
    "make_program_file",
    "parts_on_kit",
    "parts_used",
    "program_name",
    "read_program_file",
    "refuse_misfits",
    "refuse_what_fits_no_board",
    "refuse_what_is_missing",
]
