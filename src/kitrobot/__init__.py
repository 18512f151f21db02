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
        open,
        open_mission,
        parse,
        read_program,
        robot,
        save_mission,
    )
    from kitrobot.compiler import Compiled
    from kitrobot.diagnostics import Diagnostic, KitRobotError, ProblemsError
    from kitrobot.graph import Arc, Program, Vertex
    from kitrobot.lll import Parsed
    from kitrobot.mission import Agent, Failure, FailureKind, Goal, Mission, Team
    from kitrobot.primitives import Robot
    from kitrobot.sim import AgentView, Event, Simulation
    from kitrobot.workspace import Change, Executed, Inputs, OpenMission, Report, Run, RunOptions, Timing, execute
    from kitrobot.world import (
        Ball,
        Box,
        ColouredLine,
        Corner,
        Dock,
        Floor,
        Pose,
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
    _NAMES = {
        "api": (
            "compile",
            "compile_program",
            "open",
            "open_mission",
            "parse",
            "read_program",
            "robot",
            "save_mission",
        ),
        "compiler": ("Compiled",),
        "diagnostics": ("Diagnostic", "KitRobotError", "ProblemsError"),
        "graph": ("Arc", "Program", "Vertex"),
        "lll": ("Parsed",),
        "mission": ("Agent", "Failure", "FailureKind", "Goal", "Mission", "Team"),
        "primitives": ("Robot",),
        "sim": ("AgentView", "Event", "Simulation"),
        "workspace": (
            "Change",
            "Executed",
            "Inputs",
            "OpenMission",
            "Report",
            "Run",
            "RunOptions",
            "Timing",
            "execute",
        ),
        "world": (
            "Ball",
            "Box",
            "ColouredLine",
            "Corner",
            "Dock",
            "Floor",
            "Pose",
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
        from kitrobot.lazy import lazy_names

        return lazy_names(__name__, _NAMES)(name)


__version__ = "0.1.0"

__all__ = [
    "Agent",
    "AgentView",
    "Arc",
    "Ball",
    "Box",
    "Change",
    "ColouredLine",
    "Compiled",
    "Corner",
    "Diagnostic",
    "Dock",
    "Event",
    "Executed",
    "Failure",
    "FailureKind",
    "Floor",
    "Goal",
    "Inputs",
    "KitRobotError",
    "Mission",
    "OpenMission",
    "Parsed",
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
    "open",
    "open_mission",
    "parse",
    "read_program",
    "robot",
    "save_mission",
]


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
