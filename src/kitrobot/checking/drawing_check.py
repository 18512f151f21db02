"""A quick check of a mission while it is drawn: waits and loops that may last for ever, and parts that never run.

It explores all orders of events in lockstep for `EXPLORE_S`, in its own process at the lowest priority. It reports
nothing for a mission that is too large, has no discrete form, or has errors. A trap that the model finds is reported
only if a run of the simulator shows it too: while drawing, there must be no false alarm.

Left to others: finding (`verifier.properties.trap_detection`), a check of properties (`background_check`).
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from kitrobot.checking.verification import VerificationError
from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Severity, rule
from kitrobot.mission.breakdown import BreakdownRule
from kitrobot.mission.model import Mission
from kitrobot.sim.run_spec import RunSpec
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.abstraction import Abstraction, abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.report.replay import ConfirmedRun
from kitrobot.workspace.child_processes import end_with_parent, has_processes
from kitrobot.workspace.mission_run import PreparedRun

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

EXPLORE_S = 10.0
"""Seconds for going through the states, most of which need less than one; a mission that needs longer is left to
Check."""
MOST_STATES = 600_000
SHOW_S = 6.0
"""Seconds for finding runs of the simulator that show what was found."""
RUN_S = 120.0
"""Simulated seconds of such a run."""
PATIENCE_S = 30.0
"""Seconds after which the process is ended, whatever it does."""
_LOOK_S = 0.05
_SHARE_HERE = 0.03
"""Of these seconds, where there are no processes: whoever draws may have to wait for it."""

WAITS = rule(
    "waits-for-ever",
    Severity.WARNING,
    "A wait that nothing can end",
    "In some order of events a robot comes to wait here, and from then on nothing that can happen ends it, though the"
    " mission is not done. A run of the simulator shows it.",
)
GOES_ROUND = rule(
    "loops-for-ever",
    Severity.WARNING,
    "A loop that never lets go",
    "In some order of events a robot comes into this loop, and from then on nothing that can happen leads out of it,"
    " though it has a way out and the mission is not done. A run of the simulator shows it.",
)
NEVER_REACHED = rule(
    "never-reached",
    Severity.HINT,
    "Parts that no run comes to",
    "All orders of events were gone through as long as no robot fails, with the boxes that there are and with none, and"
    " these parts ran in none of them.",
)


@dataclass(frozen=True)
class DrawingFinding:
    """A problem that was found while drawing, and the run of the simulator that shows it, if it is one that a run
    shows; `ConfirmedRun.tick` is the step from which on it is so.
    """

    problem: Diagnostic
    shown: ConfirmedRun | None = None


class _TrapRow(NamedTuple):
    program: str
    vertex: str
    agent: str
    waits: bool
    seed: int
    tick: int


class _DrawingResult(NamedTuple):
    """What the process found: traps, and by the program the vertices that never run."""

    traps: tuple[_TrapRow, ...] = ()
    idle: tuple[tuple[str, tuple[str, ...]], ...] = ()


def check_drawing(
    prepared: PreparedRun, stop: Callable[[], bool], explore_s: float | None = EXPLORE_S
) -> list[DrawingFinding]:
    """What a mission that is being drawn may do for ever, and what no run comes to; nothing where `stop` says so, or
    where it is not known in time; `explore_s` of None: however long it takes.

    Raises:
        VerificationError: the process died.
    """
    found = (
        _explore_in_process(prepared, stop, explore_s) if has_processes() else _explore_here(prepared, stop, explore_s)
    )
    known = {(one.program, vertex) for one in prepared.opened.before_setup for vertex in one.vertices}
    return [
        *map(_trap, found.traps),
        *(one for row in found.idle for one in _idle(prepared.opened.mission, *row, known)),
    ]


def _explore_here(prepared: PreparedRun, stop: Callable[[], bool], explore_s: float | None) -> _DrawingResult:
    """Where there are no processes: shorter."""
    short = None if explore_s is None else explore_s * _SHARE_HERE
    try:
        return explore_drawing(prepared.spec.simulation, prepared.options.seed, short, stop)
    except KitRobotError:
        return _DrawingResult()


def _explore_in_process(prepared: PreparedRun, stop: Callable[[], bool], explore_s: float | None) -> _DrawingResult:
    import multiprocessing

    context = multiprocessing.get_context("spawn")
    mine, its = context.Pipe(duplex=False)
    process = context.Process(
        target=_serve_exploration, args=(prepared.spec, prepared.options.seed, explore_s, its), daemon=True
    )
    process.start()
    its.close()
    until = time.monotonic() + PATIENCE_S
    try:
        while not mine.poll(_LOOK_S):
            if stop() or (explore_s is not None and time.monotonic() > until):
                return _DrawingResult()
        found: _DrawingResult = mine.recv()
        return found
    except (EOFError, OSError) as error:
        raise VerificationError(Sentence("the process of the check died"), "") from error
    finally:
        mine.close()
        process.kill()
        process.join()


def _trap(one: _TrapRow) -> DrawingFinding:
    if one.waits:
        message = Sentence("`{agent}` can come to wait here for ever", one.agent)
        help = Sentence("nothing that can happen from then on ends it: wait for something that comes for sure")
        problem = WAITS(message, help=help, program=one.program, vertices=(one.vertex,))
    else:
        message = Sentence("`{agent}` can come into this loop and never leave it", one.agent)
        help = Sentence("nothing that can happen from then on leads out of it: look at its condition")
        problem = GOES_ROUND(message, help=help, program=one.program, vertices=(one.vertex,))
    return DrawingFinding(problem, ConfirmedRun(one.seed, (), one.tick))


def _idle(mission: Mission, name: str, vertices: tuple[str, ...], known: set[tuple[str, str]]) -> list[DrawingFinding]:
    program = mission.program(name)
    order = [vertex.id for vertex in program.vertices] if program is not None else []
    unreached = tuple(one for one in order if one in vertices and (name, one) not in known)
    if not unreached:
        return []
    message = Sentence.counted(
        "{count} part of `{program}` never runs", "{count} parts of `{program}` never run", len(unreached), name
    )
    help = Sentence("no order of events leads there, as long as no robot fails")
    return [DrawingFinding(NEVER_REACHED(message, help=help, program=name, vertices=unreached))]


def _serve_exploration(spec: RunSpec, seed: int, explore_s: float | None, out: Connection) -> None:
    """In the process."""
    end_with_parent()
    with suppress(OSError, AttributeError):  # Windows has no nice
        os.nice(19)
    try:
        found = explore_drawing(spec.simulation, seed, explore_s)
    except KitRobotError:
        found = _DrawingResult()
    with suppress(OSError):
        out.send(found)
    out.close()


def explore_drawing(
    runs: Callable[[int], Simulation],
    seed: int,
    explore_s: float | None = EXPLORE_S,
    stop: Callable[[], bool] = lambda: False,
) -> _DrawingResult:
    """Explores the model in this process; gives the result of `check_drawing` as plain values.

    Raises:
        AbstractionError: the mission cannot be checked.
    """
    from kitrobot.verifier.exploration.engines import PLAIN
    from kitrobot.verifier.exploration.exploration import explore
    from kitrobot.verifier.exploration.numba_engine import engine
    from kitrobot.verifier.properties.trap_detection import find_trap_run, find_traps, record_coverage

    run = runs(seed)
    parts = abstract_run(run)
    record_coverage(parts)
    # Compiling takes longer than drawing goes on: only what is kept is loaded.
    plain = None if engine.is_kept() else PLAIN
    made = explore(Model(run, parts, 0, Timing.LOCKSTEP), Budget(MOST_STATES, explore_s, stop=stop), True, plain)
    if not made.complete:
        return _DrawingResult()
    until = time.monotonic() + (SHOW_S if has_processes() else SHOW_S * _SHARE_HERE)

    def late() -> bool:
        return stop() or (explore_s is not None and time.monotonic() > until)

    found: dict[tuple[str, str], _TrapRow] = {}
    for trap in find_traps(made, late):
        agent = run.members[trap.agent]
        debug = run.debug[agent.image_name]
        origin = debug.origins[trap.loop.head]
        shown = find_trap_run(trap, runs, late)
        if origin.vertex and shown is not None:
            waits = len({debug.vertex(pc) for pc in trap.standing}) == 1
            one = _TrapRow(origin.program or agent.program, origin.vertex, agent.name, waits, shown.seed, shown.tick)
            found.setdefault((one.program, one.vertex), one)
    idle = _never_run(run, [parts]) if _is_model_complete(run.mission, parts) else ()
    if idle and run.world.storehouses:
        # A program may be made for any stock: what runs where there are no boxes is no mistake.
        empty = runs(seed)
        for house in range(len(run.world.storehouses)):
            empty.state.docks.stock[house] = 0
        others = abstract_run(empty)
        record_coverage(others)
        made = explore(
            Model(empty, others, 0, Timing.LOCKSTEP), Budget(MOST_STATES, explore_s, stop=stop), False, plain
        )
        idle = _never_run(run, [parts, others]) if made.complete else ()
    return _DrawingResult(tuple(found.values()), idle)


def _never_run(run: Simulation, looked_at: Sequence[Abstraction]) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """By the program the vertices that ran in no robot; a program of a team is another one in each kind of robot."""
    from kitrobot.verifier.properties.trap_detection import unexecuted_instructions

    programs = {agent.image_name: agent.program for agent in run.members}
    there: dict[str, set[str]] = {}
    ran: dict[str, set[str]] = {}
    for name, never in (row for parts in looked_at for row in unexecuted_instructions(parts).items()):
        program = programs[name]
        for pc, vertex in enumerate(run.debug[name].vertices_of(program)):
            if vertex is not None:
                there.setdefault(program, set()).add(vertex)
                if pc not in never:
                    ran.setdefault(program, set()).add(vertex)
    left = {program: vertices - ran.get(program, set()) for program, vertices in there.items()}
    return tuple((program, tuple(sorted(vertices))) for program, vertices in left.items() if vertices)


def _is_model_complete(mission: Mission, parts: Abstraction) -> bool:
    """Whether all that a run can do is in the model: failures on schedule, towing, a radio, leases of work and contacts
    between roads are not.
    """
    roads = {part.road for part in parts.parts}
    is_plain = not mission.failures and mission.radio is None and mission.breakdown.rule is BreakdownRule.STAY
    return is_plain and len(roads - {-1}) <= 1 and not any(work.lease for work in mission.team.works)
