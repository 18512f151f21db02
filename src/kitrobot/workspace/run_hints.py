"""Hints on a run that is over: a program that ended before time passed, with the part that mends it; missing Numba."""

from __future__ import annotations

from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.diagnostics.model import Diagnostic, Fix, FixKind, KitRobotError
from kitrobot.graph.model import START, STOP
from kitrobot.lll.parse_results import parse
from kitrobot.sim.setup import rules as sim_rules
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Help, Sentence
from kitrobot.workspace.mission_loader import OpenMission

PAUSE = "WAIT(10);"
"""LLL of the part that is put before the end: which constructor draws it is up to the catalogue."""


LONG = Sentence("this run was long, and Numba, which makes such runs many times as fast, is not installed")
FASTER = Sentence("Numba makes this many times as fast: {command}", '`pip install "kitrobot[fast]"`')


def advice(opened: OpenMission, simulation: Simulation) -> list[Diagnostic]:
    """For a run whose programs all ended at once: one hint for each of them. For a long one without Numba: that."""
    if not simulation.ended_at_once:
        return [sim_rules.SLOW(LONG, help=FASTER)] if simulation.would_gain else []
    programs = dict.fromkeys(agent.program for agent in simulation.members if not agent.image_name.robot)
    return [_pause_before_the_end(opened, simulation, name) for name in programs]


def _pause_before_the_end(opened: OpenMission, simulation: Simulation, name: str) -> Diagnostic:
    program = opened.mission.program(name)
    robot = opened.catalogue.robots.get(program.target) if program is not None else None
    assert program is not None, "it has run"
    assert robot is not None, "it has run"
    stop = next((vertex.id for vertex in program.vertices if vertex.element == STOP), "")
    try:
        drawn = lll_to_graph(parse(PAUSE).program, robot, opened.catalogue, name)
    except KitRobotError:
        drawn = None  # A catalogue without a constructor for it.
    element = next((one.element for one in drawn.vertices if one.element not in (START, STOP)), "") if drawn else ""
    fix = Fix(PAUSE, FixKind.BEFORE, element) if element and stop else None
    help: Help = Sentence("put a part that takes time before its end, such as `{element}`", element) if element else ""
    message = Sentence("the program `{program}` came to its end at once, without a part that takes time", name)
    return sim_rules.AT_ONCE(message, help=help, program=name, vertices=(stop,) if stop else (), fix=fix)
