"""Draw a program as a graph and run it on small robots, alone or as a team.

    import kitrobot

    run = kitrobot.open("transport.krt").run(seed=1)
    print(run.outcome, run.delivered)

    compiled = kitrobot.compile("Wheel.Advance(50); WAIT(10); Wheel.Stop();", "mini-robot")
    for tick in kitrobot.execute(compiled.image, kitrobot.robot("mini-robot"), ticks=60):
        print(tick.commands)

The package is a door like the command line: what it gives is what that gives, as objects. Types: `OpenMission`,
`Report`, `Run` and `Timing` of missions; `Parsed` and `Compiled` of programs; `Executed` of ticks; `Diagnostic` for
what is wrong, collected and never raised; `KitRobotError` for what failed. What is not asked for is not imported.
"""

from __future__ import annotations

TYPE_CHECKING = False
"""As that of `typing`, which takes longer to import than a command may be deaf to Ctrl-C."""
if TYPE_CHECKING:
    from os import PathLike
    from typing import Any

    from kitrobot.compiler.compilation import Compiled
    from kitrobot.diagnostics.model import Diagnostic, KitRobotError
    from kitrobot.graph.model import Program
    from kitrobot.lll.parse_results import Parsed
    from kitrobot.lll.tree import Seq
    from kitrobot.primitives.robot import Robot
    from kitrobot.workspace.execution import Executed, execute
    from kitrobot.workspace.mission_loader import OpenMission, Report
    from kitrobot.workspace.mission_run import Run, Timing


__version__ = "0.1.0"

__all__ = [
    "Compiled",
    "Diagnostic",
    "Executed",
    "KitRobotError",
    "OpenMission",
    "Parsed",
    "Report",
    "Run",
    "Timing",
    "__version__",
    "compile",
    "execute",
    "open",
    "parse",
    "robot",
]

_HOME = {
    "Compiled": "compiler.compilation",
    "Diagnostic": "diagnostics.model",
    "Executed": "workspace.execution",
    "KitRobotError": "diagnostics.model",
    "OpenMission": "workspace.mission_loader",
    "Parsed": "lll.parse_results",
    "Report": "workspace.mission_loader",
    "Run": "workspace.mission_run",
    "Timing": "workspace.mission_run",
    "execute": "workspace.execution",
}


def open(path: str | PathLike[str]) -> OpenMission:
    """Opens a mission, a `.krt` file, with the robots, constructors and the world that lie beside it.

    Then `.check()` gives a `Report` with all that is wrong, `.run(seed=1)` runs it in the simulator and gives a `Run`.

    Raises:
        KitRobotError: the file cannot be read, or nothing of it can be used; `diagnostics` says why.
    """
    from pathlib import Path

    from kitrobot.workspace.mission_loader import open_mission

    return open_mission(Path(path))


def parse(text: str, name: str = "program.lll") -> Parsed:
    """Reads an LLL text: the tree of what could be understood, and the mistakes. `name` is the file that they show."""
    from kitrobot.lll.parse_results import parse as parse_lll

    return parse_lll(text, name)


def compile(program: str | Seq | Program, robot: str | PathLike[str] | Robot, name: str = "program.lll") -> Compiled:
    """Compiles a program for a robot: LLL, image, debug map, and everything there is to say about it.

    Args:
        program: an LLL text, a tree as `parse` gives it, or a graph.
        robot: a robot, the name of one that is at hand, or the path of a `.robot.xml`.
        name: the file name that the mistakes of a text show.

    Raises:
        KitRobotError: there is no such robot.
    """
    from dataclasses import replace

    from kitrobot.compiler.compilation import compile_lll, compile_program, compile_text
    from kitrobot.graph.model import Program as Graph
    from kitrobot.primitives.catalogue import load_catalogue

    meant = _robot(robot)
    if isinstance(program, str):
        return compile_text(program, meant, name)
    if isinstance(program, Graph):
        catalogue = load_catalogue()
        catalogue.robots[meant.name] = meant
        return compile_program(replace(program, target=meant.name), catalogue)
    return compile_lll(program, meant)


def robot(word: str | PathLike[str]) -> Robot:
    """The robot of that name, or of that `.robot.xml`.

    Raises:
        KitRobotError: there is none, or its file is wrong; then `diagnostics` says why.
    """
    from os import fspath

    from kitrobot.workspace.robots import find_robot

    return find_robot(fspath(word))


def _robot(given: str | PathLike[str] | Robot) -> Robot:
    from kitrobot.primitives.robot import Robot as RobotType

    return given if isinstance(given, RobotType) else robot(given)


def __getattr__(name: str) -> Any:
    home = _HOME.get(name)
    if home is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{home}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
