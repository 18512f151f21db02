"""Draw a program as a graph and run it on small robots, alone or as a team.

    import kitrobot

    run = kitrobot.open_mission("transport").run(seed=1)
    print(run.outcome, run.delivered)

    simulation = kitrobot.open_mission("transport").simulation(seed=1)
    while simulation.outcome is None:
        simulation.step()

The package is a door like the command line: what it gives is what that gives, as objects. `docs/python.md` shows how a
mission is built, stepped, intervened in, snapshotted and saved. What is wrong with a mission is `Diagnostic`s,
collected and never raised; an operation that failed raises a `KitRobotError`. What is not asked for is not imported.
"""

from __future__ import annotations

TYPE_CHECKING = False
"""As that of `typing`, which takes longer to import than a command may be deaf to Ctrl-C."""
if TYPE_CHECKING:
    from kitrobot.api import (
        compile,
        compile_program,
        judge,
        open,
        open_mission,
        parse,
        probability,
        rare_probability,
        read_program,
        robot,
        save_mission,
        sweep,
        walk,
    )
    from kitrobot.classroom.mission_grade import grade_mission
    from kitrobot.compiler.compilation import CompiledProgram
    from kitrobot.diagnostics.model import Diagnostic, KitRobotError
    from kitrobot.diagnostics.problems import ProblemsError
    from kitrobot.experiments.study import Study
    from kitrobot.graph.model import Arc, Program, Vertex
    from kitrobot.lll.parse_results import ParseResult
    from kitrobot.mission.model import Agent, Goal, Mission, Team
    from kitrobot.mission.trial import Failure, FailureKind
    from kitrobot.primitives.robot import Robot
    from kitrobot.sim.agent_views import AgentView
    from kitrobot.sim.event_text import Event
    from kitrobot.sim.simulation import Simulation
    from kitrobot.workspace.behaviour_trees import read_behaviour_tree, save_behaviour_tree
    from kitrobot.workspace.execution import ExecutionTick, execute
    from kitrobot.workspace.inputs import Change, Inputs
    from kitrobot.workspace.mission_loader import OpenMission
    from kitrobot.workspace.mission_run import Run, RunOptions, Timing
    from kitrobot.workspace.program_report import Report
    from kitrobot.world.geometry import Corner, Pose
    from kitrobot.world.model import (
        Ball,
        Box,
        ColouredLine,
        Dock,
        Floor,
        Road,
        Section,
        Start,
        Storehouse,
        Wall,
        World,
        Zone,
    )
else:
    # Hidden from type checkers, which would take every name for one that there is.
    _MODULES = {
        "api": (
            "compile",
            "compile_program",
            "judge",
            "open",
            "open_mission",
            "parse",
            "probability",
            "rare_probability",
            "read_program",
            "robot",
            "save_mission",
            "sweep",
            "walk",
        ),
        "classroom.mission_grade": ("grade_mission",),
        "compiler.compilation": ("CompiledProgram",),
        "diagnostics.model": (
            "Diagnostic",
            "KitRobotError",
        ),
        "diagnostics.problems": ("ProblemsError",),
        "experiments.study": ("Study",),
        "graph.model": (
            "Arc",
            "Program",
            "Vertex",
        ),
        "lll.parse_results": ("ParseResult",),
        "mission.model": (
            "Agent",
            "Goal",
            "Mission",
            "Team",
        ),
        "mission.trial": (
            "Failure",
            "FailureKind",
        ),
        "primitives.robot": ("Robot",),
        "sim.agent_views": ("AgentView",),
        "sim.event_text": ("Event",),
        "sim.simulation": ("Simulation",),
        "workspace.behaviour_trees": (
            "read_behaviour_tree",
            "save_behaviour_tree",
        ),
        "workspace.execution": (
            "ExecutionTick",
            "execute",
        ),
        "workspace.inputs": (
            "Change",
            "Inputs",
        ),
        "workspace.mission_loader": ("OpenMission",),
        "workspace.mission_run": (
            "Run",
            "RunOptions",
            "Timing",
        ),
        "workspace.program_report": ("Report",),
        "world.geometry": (
            "Corner",
            "Pose",
        ),
        "world.model": (
            "Ball",
            "Box",
            "ColouredLine",
            "Dock",
            "Floor",
            "Road",
            "Section",
            "Start",
            "Storehouse",
            "Wall",
            "World",
            "Zone",
        ),
    }

    def __getattr__(name):
        for module, names in _MODULES.items():
            if name in names:
                from importlib import import_module

                return getattr(import_module(f"{__name__}.{module}"), name)
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__version__ = "0.1.0"

__all__ = [
    "Agent",
    "AgentView",
    "Arc",
    "Ball",
    "Box",
    "Change",
    "ColouredLine",
    "CompiledProgram",
    "Corner",
    "Diagnostic",
    "Dock",
    "Event",
    "ExecutionTick",
    "Failure",
    "FailureKind",
    "Floor",
    "Goal",
    "Inputs",
    "KitRobotError",
    "Mission",
    "OpenMission",
    "ParseResult",
    "Pose",
    "ProblemsError",
    "Program",
    "Report",
    "Road",
    "Robot",
    "Run",
    "RunOptions",
    "Section",
    "Simulation",
    "Start",
    "Storehouse",
    "Study",
    "Team",
    "Timing",
    "Vertex",
    "Wall",
    "World",
    "Zone",
    "__version__",
    "compile",
    "compile_program",
    "execute",
    "grade_mission",
    "judge",
    "open",
    "open_mission",
    "parse",
    "probability",
    "rare_probability",
    "read_behaviour_tree",
    "read_program",
    "robot",
    "save_behaviour_tree",
    "save_mission",
    "sweep",
    "walk",
]


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
