"""`kitrobot team`: a mission whose agents are processes, with the world of their bodies."""

from __future__ import annotations

import math
import signal
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.agent import (
    Boards,
    FleetName,
    KeyFile,
    Listen,
    Router,
    Tls,
    check_agent,
    check_wait,
    log_event,
    prepare_team_run,
)
from kitrobot.cli.options import WATCH_HELP, MissionFile, ResultAsJson, RunSeconds
from kitrobot.cli.output import INTERRUPTED, json_text, print_data, print_diagnostics
from kitrobot.cli.ros import STOPPED_BY_ROS, RosDomain, RosListen, RosRouter, ros_bridge, ros_network
from kitrobot.cli.run import watched_properties
from kitrobot.diagnostics.read_files import note_read
from kitrobot.text.sentences import Sentence

if TYPE_CHECKING:
    from kitrobot.fleet.team_process import FleetRun
    from kitrobot.judges.fleet_watch import FleetWatch
    from kitrobot.judges.judgement import Judgement
    from kitrobot.live.ros_bridge import RosBridge
    from kitrobot.sim.recorder import Recorder
    from kitrobot.sim.simulation import Simulation
    from kitrobot.trace.model import TickRecord, TraceHeader
    from kitrobot.workspace.fleets import FleetPlan
    from kitrobot.workspace.mission_run import PreparedRun


Elsewhere = Annotated[
    list[str] | None,
    typer.Option("--elsewhere", metavar="AGENT", help="Do not start it: `kitrobot agent` does, wherever."),
]
Seed = Annotated[int, typer.Option(min=0, help="Chance in the world begins here.")]
Pace = Annotated[float, typer.Option(metavar="N", help="Simulated seconds in a real one; 0: as fast as agents answer.")]
Lease = Annotated[
    int, typer.Option(metavar="MS", help="Silence after which an agent is missed; more than a network's delay.")
]
Wait = Annotated[
    float | None,
    typer.Option(metavar="SECONDS", help="How long agents may take to come; without it, until you end it."),
]
TraceFile = Annotated[Path | None, typer.Option(metavar="FILE.krtrace", help="Record the run.")]
Watch = Annotated[
    list[str] | None,
    typer.Option(
        "--watch",
        metavar="[PROPERTY]",
        help=WATCH_HELP,
        show_default=False,
    ),
]
StopOnBroken = Annotated[
    bool, typer.Option("--stop-on-broken", help="A watched property that breaks is the emergency stop.")
]


def run_team(
    file: MissionFile,
    elsewhere: Elsewhere = None,
    board: Boards = None,
    listen: Listen = None,
    router: Router = None,
    key: KeyFile = None,
    tls: Tls = None,
    fleet: FleetName = "",
    seed: Seed = 1,
    seconds: RunSeconds = 600.0,
    pace: Pace = 1.0,
    lease: Lease = 500,
    wait: Wait = None,
    trace: TraceFile = None,
    as_json: ResultAsJson = False,
    watched: Watch = None,
    stop_on_broken: StopOnBroken = False,
    ros: RosDomain = None,
    ros_listen: RosListen = None,
    ros_router: RosRouter = None,
) -> None:
    """Run a mission whose agents are processes of their own and meet over the network.

    Ctrl-C is the emergency stop: all robots stand still, then everything ends. The exit status is 0 when the mission
    was done, and no watched property broke.
    """
    from kitrobot.fleet.identity import identity_of
    from kitrobot.fleet.transport import Network
    from kitrobot.workspace.fleets import FleetPlan, free_endpoint
    from kitrobot.workspace.mission_run import RunOptions

    _check_numbers(seed, seconds, pace, lease, wait)
    if stop_on_broken and not watched:
        raise typer.BadParameter("it is of properties that are watched: --watch", param_hint="'--stop-on-broken'")
    there = ros_network(ros, ros_listen, ros_router)
    for secret in (key, *(tls.glob("*.pem") if tls is not None else ())):
        if secret is not None:
            note_read(secret)
    prepared = prepare_team_run(file, RunOptions(seed, seconds, 0.0, trace))
    print_diagnostics(prepared.problems, prepared.sources)
    simulation = prepared.simulation
    _check_pace(pace, lease, simulation.tick_ms)
    names = [agent.name for agent in simulation.members]
    for name in elsewhere or ():
        check_agent(name, names)
    boards = _boards_of(board, names)
    _check_elsewhere(elsewhere or (), boards, key)
    endpoints = tuple(router or listen or (free_endpoint(tls is not None),))
    network = Network(
        fleet or identity_of(simulation), () if router else endpoints, endpoints if router else (), bool(router), tls
    )
    here = [name for name in names if name not in (elsewhere or ())]
    plan = FleetPlan(file, here, network, key, boards, lease, pace, wait)
    with ros_bridge(simulation, there) as bridge:
        _run_to_end(prepared, plan, watched or [], stop_on_broken, as_json, bridge)


def _run_to_end(
    prepared: PreparedRun, plan: FleetPlan, watched: list[str], stops: bool, as_json: bool, bridge: RosBridge | None
) -> None:
    """Runs a fleet, gives what came of it, and ends with its status; `stops`: a property that breaks stops it."""
    from kitrobot.fleet.processes import Agents
    from kitrobot.fleet.team_process import FleetCallbacks
    from kitrobot.sim.recorder import Recorder
    from kitrobot.workspace.fleets import run_fleet
    from kitrobot.workspace.traces import parts_of

    simulation = prepared.simulation
    recorder = Recorder(simulation, parts_of(prepared.opened))
    watch = _watch_of(prepared, recorder.header, watched)
    stop = watch if stops else None
    told = bridge.stopped if bridge is not None else threading.Event()
    with Agents() as agents, emergency_stop() as pressed, recording(prepared, recorder, watch) as record:

        def on_step(simulation: Simulation) -> None:
            record(simulation)
            if bridge is not None:
                bridge.publish()

        callbacks = FleetCallbacks(
            log_event,
            lambda: told.is_set() or _is_over(pressed, stop),
            on_step,
            stop_sentence=lambda: STOPPED_BY_ROS if told.is_set() else _stop_sentence(pressed, stop),
        )
        run = run_fleet(simulation, plan, agents, callbacks)
    _print_result(simulation, run, watch.judgements() if watch is not None else [], as_json)
    if (pressed.is_set() or told.is_set()) and run.outcome == "stopped":
        raise typer.Exit(INTERRUPTED)
    if run.outcome != "done" or (watch is not None and watch.broken):
        raise typer.Exit(1)


def _watch_of(prepared: PreparedRun, header: TraceHeader, watched: list[str]) -> FleetWatch | None:
    """What watches for properties; None where none is watched."""
    if not watched:
        return None
    from kitrobot.judges.fleet_watch import FleetWatch

    questions = watched_properties(prepared, watched)
    return FleetWatch(header, prepared.opened, questions, lambda sentence: log_event("", sentence))


def _is_over(pressed: threading.Event, stop: FleetWatch | None) -> bool:
    """Whether everything is to stop: Ctrl-C was pressed, or a property broke that stops the team."""
    return pressed.is_set() or (stop is not None and bool(stop.broken))


def _stop_sentence(pressed: threading.Event, stop: FleetWatch | None) -> Sentence:
    """Why everything was stopped."""
    if stop is None or not stop.broken or pressed.is_set():
        return Sentence("Stopped by the emergency stop.")
    return Sentence("Stopped, since the property `{name}` is broken.", stop.broken[0].question)


def _print_result(simulation: Simulation, run: FleetRun, judgements: list[Judgement], as_json: bool) -> None:
    """Gives what came of it, and of what was watched."""
    from kitrobot.cli.judgements import judgement_lines

    result = result_of(simulation, run)
    if as_json:
        more = {"watched": [one.to_json() for one in judgements]} if judgements else {}
        print_data(json_text(result | more) + "\n")
    else:
        watched = "".join(f"{line}\n" for line in ("", *judgement_lines(judgements))) if judgements else ""
        print_data(_summary(result) + watched)


def _boards_of(given: list[str] | None, names: list[str]) -> Mapping[str, str]:
    """The ports of agents, by name. What knows boards is imported only where there are some."""
    if not given:
        return {}
    from kitrobot.boards.teams import boards_of

    return boards_of(given, names)


def _check_numbers(seed: int, seconds: float, pace: float, lease: int, wait: float | None) -> None:
    """Refuses numbers that a run cannot have."""
    from kitrobot.fleet.charter import LEAST_LEASE_MS, MOST_LEASE_MS
    from kitrobot.sim.setup.limits import MAX_SECONDS, MAX_SEED

    if not 0 < seconds <= MAX_SECONDS or seed > MAX_SEED:
        words = f"a run takes at most {MAX_SECONDS:.0f} seconds, and a seed is at most {MAX_SEED}"
        raise typer.BadParameter(words, param_hint="'--seconds' or '--seed'")
    if not (math.isfinite(pace) and 0 <= pace <= 1000):
        raise typer.BadParameter("a pace is a number from 0 to 1000", param_hint="'--pace'")
    check_wait(wait)
    if not LEAST_LEASE_MS <= lease <= MOST_LEASE_MS:
        words = f"a lease is {LEAST_LEASE_MS} to {MOST_LEASE_MS} ms"
        raise typer.BadParameter(words, param_hint="'--lease'")


def _check_pace(pace: float, lease: int, tick_ms: int) -> None:
    """Refuses a pace at which an agent that is there would be missed."""
    from kitrobot.fleet.charter import FleetError

    if pace and tick_ms / pace > lease / 2:
        raise FleetError(
            Sentence(
                "at a pace of {pace} a step takes {ms} ms, and silence is borne for {lease} ms only",
                pace,
                round(tick_ms / pace),
                lease,
            ),
            Sentence("take a greater --pace, or a --lease of twice the step or more"),
        )


def _check_elsewhere(elsewhere: Sequence[str], boards: Iterable[str], key: Path | None) -> None:
    """Refuses agents that are started elsewhere without what they need there."""
    from kitrobot.fleet.charter import FleetError

    for name in boards:
        if name in elsewhere:
            raise FleetError(
                Sentence("`{agent}` is started elsewhere, and its board with it", name),
                Sentence("give --board to the `kitrobot agent` that is started there"),
            )
    if elsewhere and key is None:
        raise FleetError(
            Sentence("agents that are started elsewhere need the key of this team"),
            Sentence("write a long random text into a file and give it to all with --key"),
        )


@contextmanager
def emergency_stop() -> Iterator[threading.Event]:
    """An event that the first Ctrl-C sets; a second one ends everything at once."""
    pressed = threading.Event()

    def press(*_: object) -> None:
        if pressed.is_set():
            raise KeyboardInterrupt
        pressed.set()

    if threading.current_thread() is not threading.main_thread():
        yield pressed
        return
    usual = signal.signal(signal.SIGINT, press)
    try:
        yield pressed
    finally:
        signal.signal(signal.SIGINT, usual)


@contextmanager
def recording(
    prepared: PreparedRun, recorder: Recorder, watch: FleetWatch | None
) -> Iterator[Callable[[Simulation], None]]:
    """Records each step and looks at it, where that is wanted; what breaks is recorded too."""
    from kitrobot.sim.recorder import outcome_of
    from kitrobot.trace.writer import TraceWriter

    def record(simulation: Simulation) -> TickRecord:
        found = recorder.record()
        if watch is not None:
            watch.after_step(found, simulation.outcome)
        return found

    def look(simulation: Simulation) -> None:
        if watch is not None:
            record(simulation)

    if prepared.options.trace is None:
        yield look
        return
    with TraceWriter(prepared.options.trace, recorder.header) as writer:
        yield lambda simulation: writer.record(record(simulation))
        writer.finish(outcome_of(prepared.simulation))


def result_of(simulation: Simulation, run: FleetRun) -> dict[str, Any]:
    """What came of it as plain values."""
    return {
        "outcome": run.outcome,
        "sentence": run.sentence,
        "ticks": simulation.tick,
        "seconds": simulation.seconds,
        "delivered": simulation.delivered,
        "total": simulation.total,
        "collisions": simulation.collisions,
        "units": run.units,
        "decisions": run.slots,
        "stopped_ms": run.stopped_ms,
    }


def _summary(result: dict[str, Any]) -> str:
    """The result as people read it."""
    lines = [
        result["sentence"],
        "",
        f"  outcome     {result['outcome']}",
        *([f"  delivered   {sum(result['delivered'].values())} of {result['total']}"] if result["total"] else []),
        f"  collisions  {result['collisions']}",
        f"  simulated   {result['seconds']:.2f} s in {result['ticks']} ticks",
        f"  decisions   {result['decisions']}",
    ]
    if result["stopped_ms"]:
        lines.append(f"  stopped     all within {max(result['stopped_ms'].values())} ms")
    return "\n".join(lines) + "\n"
