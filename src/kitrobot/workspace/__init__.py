"""The use cases that the command line, the studio and Python share: open, check, convert, execute, lay out, run.

The door opens lazily: a use case is imported when it is first asked for, so that laying out a text does not wait for
the simulator.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kitrobot.workspace.adding import AddedParts, PartsFileError, add_parts
    from kitrobot.workspace.advising import advice
    from kitrobot.workspace.board_names import BoardNames, NoNameError, keep_names, kept_names, names_of
    from kitrobot.workspace.boards import (
        BoardProgram,
        NoBoardError,
        Seen,
        Sent,
        at_boards,
        board_program,
        chosen_boards,
        load_board_program,
        look_at_boards,
        send_program,
    )
    from kitrobot.workspace.carried import CarriedError, carried_mission, is_picture
    from kitrobot.workspace.checking import FileReport, check_file
    from kitrobot.workspace.comparison import CompareError, Difference, compare_files, differences, text_differences
    from kitrobot.workspace.conversion import ConversionError, Converted, convert
    from kitrobot.workspace.examples import examples_folder, first_example
    from kitrobot.workspace.executables import Executable, load_executable
    from kitrobot.workspace.execution import Executed, execute
    from kitrobot.workspace.files import FileError, look_alike
    from kitrobot.workspace.folder import (
        ConflictError,
        MissionEntry,
        MissionFolder,
        MissionNameError,
        ReadOnlyError,
        revision_of,
    )
    from kitrobot.workspace.forms import Form, FormError
    from kitrobot.workspace.inputs import Change, Inputs, read_inputs
    from kitrobot.workspace.journal import Journal, JournalError, read_journal, write_journal
    from kitrobot.workspace.journals import Claimed, Journals, Left, News, state_folder
    from kitrobot.workspace.kept import KeptPrograms
    from kitrobot.workspace.layout import Layout, lay_out, lay_out_file
    from kitrobot.workspace.merging import Merged, merge_files, merge_missions
    from kitrobot.workspace.opening import (
        NoProgramError,
        OpenMission,
        Report,
        new_mission,
        open_mission,
        read_carried,
        read_mission_data,
        with_mission,
        world_file,
    )
    from kitrobot.workspace.problems import ProblemsError, with_help, written_out
    from kitrobot.workspace.program_report import ProgramReport, Span
    from kitrobot.workspace.replay import state_at, summary_of
    from kitrobot.workspace.robots import find_robot
    from kitrobot.workspace.running import Run, Timing, once_more
    from kitrobot.workspace.traces import OpenTrace, is_trace, open_trace, parts_of, unpack
    from kitrobot.workspace.tutorials import FoundTutorial, Tutorials, watched
    from kitrobot.workspace.variables import VariableError, WantedVariable, make_variable
    from kitrobot.workspace.worlds import FoundWorld, read_world_file, worlds_at_hand

_ROOMS = {
    "adding": ("AddedParts", "PartsFileError", "add_parts"),
    "board_names": ("BoardNames", "NoNameError", "keep_names", "kept_names", "names_of"),
    "boards": (
        "BoardProgram",
        "NoBoardError",
        "Seen",
        "Sent",
        "at_boards",
        "board_program",
        "chosen_boards",
        "load_board_program",
        "look_at_boards",
        "send_program",
    ),
    "carried": ("CarriedError", "carried_mission", "is_picture"),
    "checking": ("FileReport", "check_file"),
    "conversion": ("ConversionError", "Converted", "convert"),
    "comparison": ("CompareError", "Difference", "compare_files", "differences", "text_differences"),
    "examples": ("examples_folder", "first_example"),
    "executables": ("Executable", "load_executable"),
    "execution": ("Executed", "execute"),
    "files": ("FileError", "look_alike"),
    "folder": ("ConflictError", "MissionEntry", "MissionFolder", "MissionNameError", "ReadOnlyError", "revision_of"),
    "forms": ("Form", "FormError"),
    "inputs": ("Change", "Inputs", "read_inputs"),
    "journal": ("Journal", "JournalError", "read_journal", "write_journal"),
    "journals": ("Claimed", "Journals", "Left", "News", "state_folder"),
    "kept": ("KeptPrograms",),
    "layout": ("Layout", "lay_out", "lay_out_file"),
    "merging": ("Merged", "merge_files", "merge_missions"),
    "opening": (
        "NoProgramError",
        "OpenMission",
        "Report",
        "new_mission",
        "open_mission",
        "read_carried",
        "read_mission_data",
        "with_mission",
        "world_file",
    ),
    "problems": ("ProblemsError", "with_help", "written_out"),
    "program_report": ("ProgramReport", "Span"),
    "replay": ("state_at", "summary_of"),
    "robots": ("find_robot",),
    "advising": ("advice",),
    "running": ("Run", "Timing", "once_more"),
    "variables": ("VariableError", "WantedVariable", "make_variable"),
    "worlds": ("FoundWorld", "read_world_file", "worlds_at_hand"),
    "traces": ("OpenTrace", "is_trace", "open_trace", "parts_of", "unpack"),
    "tutorials": ("FoundTutorial", "Tutorials", "watched"),
}
_ROOM_OF = {name: room for room, names in _ROOMS.items() for name in names}

__all__ = [
    "AddedParts",
    "BoardNames",
    "BoardProgram",
    "CarriedError",
    "Change",
    "Claimed",
    "CompareError",
    "ConflictError",
    "ConversionError",
    "Converted",
    "Difference",
    "Executable",
    "Executed",
    "FileError",
    "FileReport",
    "Form",
    "FormError",
    "FoundTutorial",
    "FoundWorld",
    "Inputs",
    "Journal",
    "JournalError",
    "Journals",
    "KeptPrograms",
    "Layout",
    "Left",
    "Merged",
    "MissionEntry",
    "MissionFolder",
    "MissionNameError",
    "News",
    "NoBoardError",
    "NoNameError",
    "NoProgramError",
    "OpenMission",
    "OpenTrace",
    "PartsFileError",
    "ProblemsError",
    "ProgramReport",
    "ReadOnlyError",
    "Report",
    "Run",
    "Seen",
    "Sent",
    "Span",
    "Timing",
    "Tutorials",
    "VariableError",
    "WantedVariable",
    "add_parts",
    "advice",
    "at_boards",
    "board_program",
    "carried_mission",
    "check_file",
    "chosen_boards",
    "compare_files",
    "convert",
    "differences",
    "examples_folder",
    "execute",
    "find_robot",
    "first_example",
    "is_picture",
    "is_trace",
    "keep_names",
    "kept_names",
    "lay_out",
    "lay_out_file",
    "load_board_program",
    "load_executable",
    "look_alike",
    "look_at_boards",
    "make_variable",
    "merge_files",
    "merge_missions",
    "names_of",
    "new_mission",
    "once_more",
    "open_mission",
    "open_trace",
    "parts_of",
    "read_carried",
    "read_inputs",
    "read_journal",
    "read_mission_data",
    "read_world_file",
    "revision_of",
    "send_program",
    "state_at",
    "state_folder",
    "summary_of",
    "text_differences",
    "unpack",
    "watched",
    "with_help",
    "with_mission",
    "world_file",
    "worlds_at_hand",
    "write_journal",
    "written_out",
]


def __getattr__(name: str) -> Any:
    room = _ROOM_OF.get(name)
    if room is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{room}"), name)
