"""`kitrobot agent`: one agent of a team, as a process of its own."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.options import MissionFile
from kitrobot.cli.output import json_text, print_data, print_message
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean

if TYPE_CHECKING:
    from kitrobot.fleet.agent_process import AgentBoard
    from kitrobot.fleet.transport import Network
    from kitrobot.sim.simulation import Simulation
    from kitrobot.workspace.mission_run import PreparedRun, RunOptions

KeyFile = Annotated[
    Path | None, typer.Option("--key", metavar="FILE", help="A file with the key of the team: a long random text.")
]
Listen = Annotated[
    list[str] | None, typer.Option("--listen", metavar="ENDPOINT", help="Where others reach it: tcp/HOST:PORT.")
]
Router = Annotated[
    list[str] | None,
    typer.Option("--router", metavar="ENDPOINT", help="A Zenoh router through which everything goes."),
]
Tls = Annotated[Path | None, typer.Option("--tls", metavar="FOLDER", help="TLS with its ca.pem, cert.pem and key.pem.")]
Boards = Annotated[
    list[str] | None,
    typer.Option("--board", metavar="AGENT=PORT|URL", help="The real robot of an agent; may be given several times."),
]
FleetName = Annotated[str, typer.Option("--fleet", metavar="NAME", help="Keeps teams on one network apart.")]
AgentName = Annotated[str, typer.Option("--as", metavar="NAME", help="Which agent of the mission it is.")]
TeamEndpoints = Annotated[
    list[str] | None, typer.Option("--connect", metavar="ENDPOINT", help="Where its team listens: tcp/HOST:PORT.")
]
Board = Annotated[
    str | None,
    typer.Option("--board", metavar="PORT|URL", help="A real robot that has its program: `kitrobot deploy --team`."),
]
Wait = Annotated[
    float | None,
    typer.Option(metavar="SECONDS", help="How long it waits for the run to begin; without it, until you end it."),
]
WithInput = Annotated[bool, typer.Option("--with-input", hidden=True, help="Ends when its standard input does.")]
ReportsToParent = Annotated[bool, typer.Option("--told", hidden=True, help="Says it to who started it.")]
EndAsJson = Annotated[bool, typer.Option("--json", help="Give how it ended as one JSON object.")]


def prepare_team_run(file: Path, options: RunOptions) -> PreparedRun:
    """Prepares a mission whose agents are processes: the network is their radio, instead of the mission's."""
    from kitrobot.workspace.mission_loader import open_mission

    opened = open_mission(file)
    opened.mission.radio = None
    return opened.prepare(options)


def run_agent(
    file: MissionFile,
    name: AgentName,
    connect: TeamEndpoints = None,
    listen: Listen = None,
    router: Router = None,
    key: KeyFile = None,
    tls: Tls = None,
    fleet: FleetName = "",
    board: Board = None,
    wait: Wait = None,
    with_input: WithInput = False,
    told: ReportsToParent = False,
    as_json: EndAsJson = False,
) -> None:
    """Take part in a team as one of its agents, with a simulated body in the world of `kitrobot team`, or a real one.

    The exit status is 0 when the mission was done, and 1 when it was not.
    """
    from kitrobot.fleet.agent_process import AgentProcess
    from kitrobot.fleet.processes import end_of_input
    from kitrobot.fleet.transport import Channel
    from kitrobot.workspace.mission_run import RunOptions

    check_wait(wait)
    over = end_of_input() if with_input else None
    with ExitStack() as stack:
        log = stack.enter_context(_agent_log(name, told))
        prepared = prepare_team_run(file, RunOptions())
        simulation = prepared.simulation
        names = [agent.name for agent in simulation.members]
        check_agent(name, names)
        secret = _key(key)
        network = _network(simulation, connect, listen, router, tls, fleet)
        body = None if board is None else stack.enter_context(_agent_board(prepared, file, name, board))
        channel = Channel(network, names.index(name), secret)
        stack.callback(channel.close)
        if not with_input:
            log(Sentence("looks for its team at {endpoints}", ", ".join(network.connect)))
        ended = AgentProcess(
            *(simulation, names.index(name), channel, log),
            *(lambda: over is not None and over.is_set(), body, wait),
            (lambda sentence: None) if with_input else log,
        ).run()
    if as_json:
        print_data(json_text({"agent": name, "outcome": ended.outcome, "sentence": ended.sentence}) + "\n")
    elif not with_input:
        sys.stdout.write(f"{ended.sentence}\n")
    if ended.outcome != "done" and not with_input:
        raise typer.Exit(1)


@contextmanager
def _agent_board(prepared: PreparedRun, file: Path, name: str, port: str) -> Iterator[AgentBoard]:
    """The board of an agent, while its line is open. What knows boards is imported by nobody else."""
    from kitrobot.boards.teams import agent_program
    from kitrobot.fleet.agent_process import AgentBoard
    from kitrobot.fleet.board_line import open_board

    program = agent_program(prepared.opened, name)
    line = open_board(port, program, name, str(file))
    try:
        yield AgentBoard(line, program.file.used_actuators)
    finally:
        line.close()


def check_agent(name: str, names: Sequence[str]) -> None:
    """Refuses an agent that a mission does not have.

    Raises:
        KitRobotError: it has none of that name.
    """
    if name not in names:
        raise KitRobotError(
            Sentence("this mission has no agent `{agent}`", name),
            did_you_mean(name, names) or Sentence("its agents: {names}", listed(names)),
        )


def _key(file: Path | None) -> bytes:
    """The key of the team."""
    from kitrobot.fleet.charter import FleetError
    from kitrobot.fleet.keys import find_key

    secret = find_key(file)
    if secret is None:
        raise FleetError(
            Sentence("an agent needs the key of its team"),
            Sentence("give it with --key, the same file as that of `kitrobot team`"),
        )
    return secret


def _network(
    simulation: Simulation,
    connect: list[str] | None,
    listen: list[str] | None,
    router: list[str] | None,
    tls: Path | None,
    fleet: str,
) -> Network:
    """Where the agent finds its team."""
    from kitrobot.fleet.charter import FleetError
    from kitrobot.fleet.identity import identity_of
    from kitrobot.fleet.transport import Network

    if not connect and not router:
        raise FleetError(
            Sentence("an agent needs to know where its team is"),
            Sentence("give it with --connect, or with --router: what `kitrobot team` says it listens on"),
        )
    return Network(
        fleet or identity_of(simulation),
        tuple(listen or own_endpoint(tls)),
        tuple(router or connect or ()),
        bool(router),
        tls,
    )


def check_wait(wait: float | None) -> None:
    """Refuses an invalid limit."""
    if wait is not None and not (math.isfinite(wait) and wait >= 0):
        raise typer.BadParameter("a limit is a number of seconds from 0", param_hint="'--wait'")


def log_event(name: str, sentence: str) -> None:
    """Prints a line of the log: the time of day, the agent ("": the whole team), and what happened."""
    print_message(f"{datetime.now():%H:%M:%S.%f}"[:-3] + f"  {f'{name}: ' if name else ''}{sentence}")


@contextmanager
def _agent_log(name: str, told: bool) -> Iterator[Callable[[str], None]]:
    """How an agent reports events: to people, or (`told`) to the process that started it, with why it failed."""
    if not told:
        yield lambda sentence: log_event(name, sentence)
        return
    from kitrobot.fleet.status_reports import StatusReport, encode_report

    def write(one: StatusReport) -> None:
        with suppress(OSError):
            sys.stdout.buffer.write(encode_report(one))
            sys.stdout.buffer.flush()

    try:
        yield lambda sentence: write(StatusReport(sentence))
    except KitRobotError as error:
        write(StatusReport(error.message, error.help, failed=True))
        raise


def own_endpoint(tls: Path | None) -> tuple[str, ...]:
    """Any port of this machine alone."""
    return ("tls/127.0.0.1:0",) if tls is not None else ("tcp/127.0.0.1:0",)
