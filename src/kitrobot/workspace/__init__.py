"""The use cases that the command line, the studio and Python share: open, check, convert, execute, lay out, run.

The door opens lazily: a use case is imported when it is first asked for, so that laying out a text does not wait for
the simulator.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kitrobot.lazy import lazy_names

if TYPE_CHECKING:
    from kitrobot.workspace.compile_cache import CompileCache
    from kitrobot.workspace.conversion import ConversionError, Converted, convert
    from kitrobot.workspace.example_list import shipped_examples
    from kitrobot.workspace.executables import Executable, load_executable
    from kitrobot.workspace.execution import Executed, execute
    from kitrobot.workspace.exercises import Exercises, FoundExercise, handed_in
    from kitrobot.workspace.file_check import FileReport, check_file
    from kitrobot.workspace.file_merge import merge_checked, merge_files
    from kitrobot.workspace.fleets import FleetPlan, files_for_agents, free_endpoint, run_fleet
    from kitrobot.workspace.inputs import Change, Inputs, read_inputs
    from kitrobot.workspace.kit_files import find_kit, kit_named, kits_at_hand
    from kitrobot.workspace.kit_pictures import body_picture, wiring_picture
    from kitrobot.workspace.kits import KitFit, ProgramOnKit, mission_on_kit, program_on_kits
    from kitrobot.workspace.mission_loader import (
        NoProgramError,
        OpenMission,
        Report,
        new_mission,
        open_mission,
        read_mission_data,
        with_mission,
    )
    from kitrobot.workspace.mission_run import PreparedRun, Run, RunOptions, Timing
    from kitrobot.workspace.new_mission_choices import (
        FoundPlace,
        NewMissionChoices,
        NoBeginningError,
        RobotSet,
        Starter,
    )
    from kitrobot.workspace.part_imports import AddedParts, PartsFileError, add_parts, part_differences
    from kitrobot.workspace.previews import Preview, Previews
    from kitrobot.workspace.program_report import ProgramReport
    from kitrobot.workspace.replay import state_at, summary_of
    from kitrobot.workspace.robot_programs import board_program, load_board_program, scan_boards, send_program
    from kitrobot.workspace.robots import find_robot
    from kitrobot.workspace.run_hints import advice
    from kitrobot.workspace.search_path import SearchPath
    from kitrobot.workspace.team_boards import agent_program, boards_of, check_boards, send_team
    from kitrobot.workspace.traces import OpenTrace, is_trace, open_trace, parts_of, unpack
    from kitrobot.workspace.tutorials import FoundTutorial, Tutorials, watched
    from kitrobot.workspace.variables import VariableError, WantedVariable, make_variable
    from kitrobot.workspace.worlds import FoundWorld, read_world_file, worlds_at_hand
else:
    # Hidden from mypy, which would take every name for one that there is.
    __getattr__ = lazy_names(
        __name__,
        {
            "part_imports": ("AddedParts", "PartsFileError", "add_parts", "part_differences"),
            "file_check": ("FileReport", "check_file"),
            "conversion": ("ConversionError", "Converted", "convert"),
            "executables": ("Executable", "load_executable"),
            "execution": ("Executed", "execute"),
            "fleets": ("FleetPlan", "files_for_agents", "free_endpoint", "run_fleet"),
            "inputs": ("Change", "Inputs", "read_inputs"),
            "compile_cache": ("CompileCache",),
            "kit_files": ("find_kit", "kit_named", "kits_at_hand"),
            "kit_pictures": ("body_picture", "wiring_picture"),
            "kits": ("KitFit", "ProgramOnKit", "mission_on_kit", "program_on_kits"),
            "file_merge": ("merge_checked", "merge_files"),
            "mission_loader": (
                "NoProgramError",
                "OpenMission",
                "Report",
                "new_mission",
                "open_mission",
                "read_mission_data",
                "with_mission",
            ),
            "new_mission_choices": ("NewMissionChoices", "FoundPlace", "NoBeginningError", "RobotSet", "Starter"),
            "previews": ("Preview", "Previews"),
            "program_report": ("ProgramReport",),
            "replay": ("state_at", "summary_of"),
            "robot_programs": ("board_program", "load_board_program", "scan_boards", "send_program"),
            "robots": ("find_robot",),
            "run_hints": ("advice",),
            "search_path": ("SearchPath",),
            "example_list": ("shipped_examples",),
            "mission_run": ("PreparedRun", "Run", "RunOptions", "Timing"),
            "variables": ("VariableError", "WantedVariable", "make_variable"),
            "worlds": ("FoundWorld", "read_world_file", "worlds_at_hand"),
            "team_boards": ("agent_program", "boards_of", "check_boards", "send_team"),
            "traces": ("OpenTrace", "is_trace", "open_trace", "parts_of", "unpack"),
            "exercises": ("Exercises", "FoundExercise", "handed_in"),
            "tutorials": ("FoundTutorial", "Tutorials", "watched"),
        },
    )

__all__ = [
    "AddedParts",
    "Change",
    "CompileCache",
    "ConversionError",
    "Converted",
    "Executable",
    "Executed",
    "Exercises",
    "FileReport",
    "FleetPlan",
    "FoundExercise",
    "FoundPlace",
    "FoundTutorial",
    "FoundWorld",
    "Inputs",
    "KitFit",
    "NewMissionChoices",
    "NoBeginningError",
    "NoProgramError",
    "OpenMission",
    "OpenTrace",
    "PartsFileError",
    "PreparedRun",
    "Preview",
    "Previews",
    "ProgramOnKit",
    "ProgramReport",
    "Report",
    "RobotSet",
    "Run",
    "RunOptions",
    "SearchPath",
    "Starter",
    "Timing",
    "Tutorials",
    "VariableError",
    "WantedVariable",
    "add_parts",
    "advice",
    "agent_program",
    "board_program",
    "boards_of",
    "body_picture",
    "check_boards",
    "check_file",
    "convert",
    "execute",
    "files_for_agents",
    "find_kit",
    "find_robot",
    "free_endpoint",
    "handed_in",
    "is_trace",
    "kit_named",
    "kits_at_hand",
    "load_board_program",
    "load_executable",
    "make_variable",
    "merge_checked",
    "merge_files",
    "mission_on_kit",
    "new_mission",
    "open_mission",
    "open_trace",
    "part_differences",
    "parts_of",
    "program_on_kits",
    "read_inputs",
    "read_mission_data",
    "read_world_file",
    "run_fleet",
    "scan_boards",
    "send_program",
    "send_team",
    "shipped_examples",
    "state_at",
    "summary_of",
    "unpack",
    "watched",
    "wiring_picture",
    "with_mission",
    "worlds_at_hand",
]
