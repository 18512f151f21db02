"""`kitrobot deploy`: a program onto real robots."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.options import ProgramName, Replace, RobotName
from kitrobot.cli.output import json_text, print_data, print_diagnostics, print_error, print_message, sanitize
from kitrobot.cli.result_json import AsJson, board_result, deployed_result
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence

if TYPE_CHECKING:
    from kitrobot.robots.board_operations import SendResult
    from kitrobot.robots.program import BoardProgram

STAGES = {
    "connect": "connecting",
    "reset": "it says nothing: press its reset button now",
    "compare": "comparing",
    "send": "sending",
    "start": "starting",
}
"""What is said of each step of a deploy."""

KitOrBoards = Annotated[
    list[str] | None,
    typer.Option(
        "--board",
        metavar="NAME|FILE.board.xml|AGENT=PORT",
        help="The kit that the robot is built of, or those of the team; with --team also the port of each agent.",
    ),
]

Addresses = Annotated[
    list[str] | None,
    typer.Option(
        "--to",
        metavar="PORT|URL",
        help="The robot: a serial port or a URL such as `socket://HOST:PORT`; may be given several times.",
        show_default="the only one that is there",
    ),
]


MissionOrList = Annotated[
    Path,
    typer.Argument(
        metavar="MISSION",
        help="A `.krt`, a picture that carries one, or an `.lll`; with --set a list (`.csv`) or a folder.",
        show_default=False,
    ),
]
Fresh = Annotated[
    bool,
    typer.Option("--fresh", help="First remove what KitRobot put there; when there is no room for old and new."),
]
Team = Annotated[
    bool, typer.Option("--team", help="The programs of a team's agents, each to its --board, for `kitrobot team`.")
]
BoardSet = Annotated[
    bool, typer.Option("--set", help="To each of many boards what a list, or a folder, names for the label on it.")
]
BoardFile = Annotated[
    Path | None,
    typer.Option(
        "--file",
        metavar="FILE.hex|FILE.uf2",
        help="To no board, but into a file that is copied onto a board's drive: `.hex` for a micro:bit, of 2016 or V2; "
        "`.uf2` for a board such as a Raspberry Pi Pico.",
        show_default=False,
    ),
]
FirmwareFile = Annotated[
    Path | None,
    typer.Option(
        "--firmware",
        metavar="MICROPYTHON.uf2",
        help="With `--file FILE.uf2`: MicroPython for the board, from its maker; it comes along in the file.",
        show_default=False,
    ),
]


def deploy_program(
    mission: MissionOrList,
    program: ProgramName = None,
    to: Addresses = None,
    robot: RobotName = None,
    replace: Replace = False,
    fresh: Fresh = False,
    team: Team = False,
    board: KitOrBoards = None,
    many: BoardSet = False,
    file: BoardFile = None,
    firmware: FirmwareFile = None,
    as_json: AsJson = False,
) -> None:
    """Put a program onto real robots and start it there; from then on it starts by itself when the power comes on.

    With --board NAME the robot's parts are wired as a kit's file says, and not as the robot's own. With --team every
    agent's program goes to its board and waits there: `kitrobot team` starts all of them. With --set the MISSION is a
    table with the columns `label` and `mission`, or a folder with a mission NAME.krt for the board with the label NAME;
    `kitrobot boards --label` gives labels. With --file the board is not there: its drive takes the file later, from any
    computer, and the file opens in the studio as the mission.

    Only what is new is sent, and it is read back. Until all of it is there the robot keeps what it had. The exit status
    is 1 when the program has errors, or when one of the robots could not be brought to run it.
    """
    from kitrobot.boards.board_files import expect_board_file
    from kitrobot.boards.programs import load_board_program

    if many:
        if to or program or robot or team or board or file or firmware:
            words = "with --set the list says programs, kits and ports, and nothing goes into a file"
            raise typer.BadParameter(words, param_hint="'--set'")
        from kitrobot.cli.deploy_set import deploy_set

        deploy_set(mission, _bars, replace=replace, fresh=fresh, as_json=as_json)
        return
    _refuse_beside_a_file(file, firmware, goes_to_a_board=bool(to or team or fresh or replace))
    if team:
        if board is None or not any("=" in one for one in board):
            raise typer.BadParameter("--team and --board AGENT=PORT belong together", param_hint="'--team'")
        if to or program or robot:
            words = "with --team the mission says programs and robots, and --board says the ports"
            raise typer.BadParameter(words, param_hint="'--team'")
        _deploy_team(mission, board, replace=replace, fresh=fresh, as_json=as_json)
        return
    if board and (len(board) > 1 or "=" in board[0]):
        words = "without --team it is one kit: a name or a .board.xml; --board AGENT=PORT belongs to --team"
        raise typer.BadParameter(words, param_hint="'--board'")
    if file is not None:
        expect_board_file(file)
    ready = load_board_program(mission, robot=robot, program=program, kit=board[0] if board else None)
    print_diagnostics(ready.diagnostics, ready.sources)
    if file is not None:
        _save_file(ready, mission, file, firmware, as_json)
    else:
        _send(ready, to or [], as_json, replace=replace, fresh=fresh)


def _refuse_beside_a_file(file: Path | None, firmware: Path | None, *, goes_to_a_board: bool) -> None:
    """Raises a BadParameter when options do not go together with a file, or with none."""
    if file is not None and goes_to_a_board:
        words = "a file goes to no board yet: --file goes without --to, --team, --fresh and --replace"
        raise typer.BadParameter(words, param_hint="'--file'")
    if firmware is not None and file is None:
        words = "the firmware comes along in a file: it goes with --file FILE.uf2; `kitrobot flash` puts it on a board"
        raise typer.BadParameter(words, param_hint="'--firmware'")


def _send(ready: BoardProgram, to: Sequence[str], as_json: bool, *, replace: bool, fresh: bool) -> None:
    """Sends a program to robots, and says of each what became of it."""
    from kitrobot.boards.programs import send_program
    from kitrobot.robots.board_operations import choose_boards

    addresses = choose_boards(to)
    with _bars(addresses) as progress:
        sent = send_program(ready, addresses, progress, replace=replace, fresh=fresh)
    if as_json:
        print_data(json_text([_object(one) for one in sent], 2) + "\n")
    for one in sent:
        _print_result(one, one.address, as_json, ready.names.program)
    if any(one.error is not None for one in sent):
        raise typer.Exit(1)


def _save_file(program: BoardProgram, mission: Path, target: Path, firmware: Path | None, as_json: bool) -> None:
    """Writes the file, and says for which boards it is and what is done with it."""
    from kitrobot.boards.board_files import save_board_file

    made = save_board_file(program, mission, target, firmware)
    if as_json:
        reasons = {str(board): str(error.message) for board, error in made.reasons}
        print_data(json_text({"file": str(target), "bytes": len(made.data), "left_out": reasons}, 2) + "\n")
    for board, error in made.reasons:
        print_message(Sentence("it is not for {board}: {reason}", board, error.message))
        print_message(f"  help: {error.help}")
    print_message(Sentence("{file}: written for {boards}", target, made.boards))
    print_message(made.steps)


def _deploy_team(mission: Path, board: Sequence[str], *, replace: bool, fresh: bool, as_json: bool) -> None:
    from kitrobot.boards.teams import boards_of, send_team
    from kitrobot.workspace.kit_files import find_kit
    from kitrobot.workspace.mission_loader import open_mission

    opened = open_mission(mission)
    kits = [one for one in board if "=" not in one]
    if len(kits) > 1:
        raise typer.BadParameter("one kit is meant for all robots of the team", param_hint="'--board'")
    kit = find_kit(kits[0], mission.parent) if kits else None
    boards = boards_of([one for one in board if "=" in one], [agent.name for agent in opened.mission.team.agents])
    names = {port: name for name, port in boards.items()}
    with _bars(list(names)) as progress:
        sent = send_team(opened, boards, progress, replace=replace, fresh=fresh, kit=kit)
    print_diagnostics(opened.before_setup, opened.sources)
    if as_json:
        print_data(json_text([{**_object(one), "agent": names[one.address]} for one in sent], 2) + "\n")
    for one in sent:
        name = names[one.address]
        _print_result(one, f"{name} ({one.address})", as_json, name, "has its program")
    failed = [names[one.address] for one in sent if one.error is not None]
    if failed:
        print_message(
            Sentence(
                "no robot of the team is started; mend what is said above of {names}, then send again", listed(failed)
            )
        )
        if has := [names[one.address] for one in sent if one.error is None]:
            print_message(
                Sentence("the new program is already on the boards of these, where it waits: {names}", listed(has))
            )
        raise typer.Exit(1)


def _print_result(sent: SendResult, robot: str, as_json: bool, program: str, does: str = "runs") -> None:
    """What became of one robot: an error, or the sentence unless it is given as JSON."""
    if sent.error is not None:
        print_message(f"{robot}:")
        print_error(sent.error)
    elif not as_json:
        print_data(_sentence(sent, program, does))


def _sentence(sent: SendResult, program: str, does: str) -> str:
    done = sent.deployed
    assert done is not None
    files = len(done.sent_files)
    news = f"{files} file{'s' if files != 1 else ''} sent ({done.bytes_sent} bytes)" if files else "nothing to send"
    return (
        f"{sanitize(sent.address)}: {sanitize(program)} {does}; {done.free} bytes of memory are left\n"
        f"  {news}, {len(done.kept_files)} kept, {done.seconds:.1f} s; program {done.program},"
        f" KitRobot {done.package}, generation {done.generation}, MicroPython {done.micropython}\n"
    )


def _object(sent: SendResult) -> dict[str, Any]:
    done = sent.deployed
    if done is None:
        return board_result(sent.address, sent.error)
    return board_result(
        sent.address, None, **deployed_result(done), sent=list(done.sent_files), kept=list(done.kept_files)
    )


def _print_reset(address: str, stage: str, done: int, total: int) -> None:
    """Where nobody watches bars: only what a person has to do."""
    if stage == "reset":
        print_message(f"{address}: {STAGES[stage]}")


@contextmanager
def _bars(addresses: Sequence[str]) -> Iterator[Callable[[str, str, int, int], None]]:
    """A bar for each robot on standard error while a person watches."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield _print_reset
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        TextColumn("{task.fields[stage]}"),
        TimeElapsedColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        tasks = {address: bar.add_task(sanitize(address), total=None, stage="") for address in addresses}

        def progress(address: str, stage: str, done: int, total: int) -> None:
            bar.update(tasks[address], completed=done, total=total or None, stage=STAGES.get(stage, stage))

        yield progress
