"""The command line as a whole: its commands, and how errors end it.

`kitrobot FILE` without a command's name opens the studio: such arguments are read as `kitrobot studio FILE`. The studio
itself is another door, a stranger to this one, so whoever starts the command line hands it in (`kitrobot.__main__`).
Whatever goes wrong ends in a sentence and an exit status, never in a traceback: 1 for what was asked and could not be
done, 2 for a command that cannot be read, 70 for a mistake of ours, 130 for Ctrl-C, 141 when nobody reads any more,
143 for SIGTERM. Whoever asked for `--json` gets an object of what went wrong when the command gave no data.
"""

from __future__ import annotations

import os
import re
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from copy import copy
from functools import cache
from typing import Annotated, Any, Final

import typer

import kitrobot
from kitrobot.cli.agent import run_agent
from kitrobot.cli.bench import try_parts
from kitrobot.cli.boards import list_boards
from kitrobot.cli.calibrate import calibrate_robot
from kitrobot.cli.check import check_files
from kitrobot.cli.classroom import Classroom, open_class
from kitrobot.cli.convert import convert_file
from kitrobot.cli.deploy import deploy_program
from kitrobot.cli.desktop import desktop_entry
from kitrobot.cli.diff import diff_files
from kitrobot.cli.exec import execute_program
from kitrobot.cli.experiments import sweep_missions
from kitrobot.cli.flash import flash_board
from kitrobot.cli.format import format_files
from kitrobot.cli.grade import grade_submissions
from kitrobot.cli.judge import judge_files
from kitrobot.cli.log import show_log
from kitrobot.cli.maze import give_maze
from kitrobot.cli.merge import merge_missions_of_files
from kitrobot.cli.output import (
    INTERRUPTED,
    OutputClosedError,
    failure_json,
    print_data,
    print_error,
    print_message,
    record_error,
    redirect_to_devnull,
    reset_output_state,
    standard_streams,
)
from kitrobot.cli.probability import estimate_probability
from kitrobot.cli.replay import replay_trace
from kitrobot.cli.run import run_mission
from kitrobot.cli.site import FirstMissions, write_site
from kitrobot.cli.start import start_boards, stop_boards
from kitrobot.cli.studio import Studio, open_studio
from kitrobot.cli.sweep import with_values
from kitrobot.cli.team import run_team
from kitrobot.cli.verify import verify_mission
from kitrobot.cli.walk import walk_states
from kitrobot.cli.watch import watch_board
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.read_files import recording_reads
from kitrobot.text.forms import name_form, number_form
from kitrobot.text.sentences import Sentence

DEBUG_VARIABLE = "KITROBOT_DEBUG"
COMPLETION_VARIABLE = "_KITROBOT_COMPLETE"
INTERNAL_ERROR: Final = 70
OUTPUT_CLOSED: Final = 141
TERMINATED: Final = 143
FAILED: Final = 1
FAILURE_STATUS: Final = {"diff": 2, "merge": 2}
"""Of commands whose 1 means something else, as it does in the tools of the same name."""
LONG_RUNNING: Final = ("studio", "class")
"""Commands that read and write the same files as long as they are open."""

# Typer brings its own Click, whose errors it does not name.
_ClickError: Any = next(base for base in typer.BadParameter.__mro__ if base.__name__ == "ClickException")


class _InterruptedError(Exception):
    """Ctrl-C, with its message."""


app = typer.Typer(
    name="kitrobot",
    no_args_is_help=False,
    pretty_exceptions_enable=False,
    rich_markup_mode="markdown",
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
app.command("studio")(open_studio)
app.command("class")(open_class)
app.command("run")(run_mission)
app.command("sweep")(sweep_missions)
app.command("verify")(verify_mission)
app.command("walk")(walk_states)
app.command("judge")(judge_files)
app.command("probability")(estimate_probability)
app.command("grade")(grade_submissions)
app.command("team")(run_team)
app.command("agent")(run_agent)
app.command("replay")(replay_trace)
app.command("deploy")(deploy_program)
app.command("boards")(list_boards)
app.command("bench")(try_parts)
app.command("calibrate")(calibrate_robot)
app.command("flash")(flash_board)
app.command("start")(start_boards)
app.command("stop")(stop_boards)
app.command("watch")(watch_board)
app.command("log")(show_log)
app.command("convert")(convert_file)
app.command("exec")(execute_program)
app.command("check")(check_files)
app.command("format")(format_files)
app.command("maze")(give_maze)
app.command("diff")(diff_files)
app.command("merge")(merge_missions_of_files)
app.command("site")(write_site)
app.command("desktop")(desktop_entry)


def _print_version(wanted: bool) -> None:
    if wanted:
        print(f"kitrobot {kitrobot.__version__}")
        raise typer.Exit


@app.callback()
def _kitrobot(
    version: Annotated[
        bool, typer.Option("--version", help="Say the version.", is_eager=True, callback=_print_version)
    ] = False,
) -> None:
    """Draw a program as a graph and run it on small robots, alone or as a team.

    `kitrobot [FILE.krt | FILE.krtrace | FOLDER]` opens the studio in the browser, with an example when nothing is
    named; its options are those of `kitrobot studio`. With KITROBOT_DEBUG=1 in the environment an unexpected error
    shows where it happened.
    """


def main(
    arguments: Sequence[str] | None = None,
    *,
    studio: Studio | None = None,
    classroom: Classroom | None = None,
    first: FirstMissions | None = None,
) -> None:
    """Runs the command line and exits with its status. `studio` and `classroom` are what opens those, `first` what a
    site begins with.

    Raises:
        SystemExit: always.
    """
    reset_output_state()
    given = [_normalise_argument(one) for one in (sys.argv[1:] if arguments is None else arguments)]
    words = with_values(_with_default_command(given))
    failed = FAILURE_STATUS.get(words[0], FAILED)
    with standard_streams(), _termination(), nullcontext() if words[0] in LONG_RUNNING else recording_reads():
        status = _exit_status(
            lambda: _run_command(words, {"class": classroom, "site": first}.get(words[0], studio)), failed
        )
        if status not in (0, INTERRUPTED, OUTPUT_CLOSED) and _wants_json(given):
            status = _exit_status(lambda: _print_failure_json(status), failed) or status
    sys.exit(status)


_NUMBER = re.compile(r"[+-]?\d+\u066b\d+")
"""With the decimal sign of an Urdu keyboard, which Python does not read; it reads the digits."""


def _normalise_argument(argument: str) -> str:
    """An argument in the one form of names; the name of a file that is there stays as it is.

    Terminals type é in one form, and file systems give it back in another.
    """
    if argument.isascii() or any(os.path.lexists(one) for one in (argument, argument.partition("=")[2]) if one):
        return argument
    return number_form(argument) if _NUMBER.fullmatch(argument) else name_form(argument)


def _exit_status(act: Callable[[], int], failed: int) -> int:
    """Runs `act`, flushes the output and prints errors; `failed`: the status after an error."""
    try:
        status = act()
        if sys.stdout is not None:
            sys.stdout.flush()
    except KitRobotError as error:
        print_error(error)
        return failed
    except (KeyboardInterrupt, _InterruptedError) as error:
        print_message(str(error) or "broken off")
        return INTERRUPTED
    except (BrokenPipeError, OutputClosedError):
        _discard_output()
        return OUTPUT_CLOSED
    except OSError as error:
        print_error(
            KitRobotError(Sentence(f"{error.strerror or error}{f': `{error.filename}`' if error.filename else ''}"))
        )
        if not error.filename:
            _discard_output()
        return failed
    except Exception as error:
        return _report_internal_error(error)
    return status


@cache
def _command(name: str) -> Any:
    """The command of that name as Typer's Click has it; all of them, which takes much longer, where none has it."""
    made = copy(app)
    made.registered_commands = [one for one in app.registered_commands if one.name == name] or app.registered_commands
    command: Any = typer.main.get_command(made)
    invoke = command.invoke

    def invoke_interruptibly(context: Any) -> Any:
        try:
            return invoke(context)
        except KeyboardInterrupt as error:  # of which Typer would make a status without a word
            raise _InterruptedError(*error.args) from None

    command.invoke = invoke_interruptibly
    return command


def _run_command(arguments: list[str], door: Studio | Classroom | FirstMissions | None) -> int:
    # What a shell asks to have completed is not in the arguments; the studio tells which commands there are.
    name = "" if COMPLETION_VARIABLE in os.environ or arguments[0] == "studio" else arguments[0]
    try:
        status = _command(name).main(arguments, prog_name="kitrobot", obj=door, standalone_mode=False)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    except _ClickError as error:
        record_error(error.format_message())
        from typer.rich_utils import rich_format_error

        rich_format_error(error)
        return int(error.exit_code)
    return status if isinstance(status, int) else 0


def _wants_json(arguments: Sequence[str]) -> bool:
    """Whether `--json` is among the arguments, whatever else they say."""
    return "--json" in (arguments[: arguments.index("--")] if "--" in arguments else arguments)


def _print_failure_json(status: int) -> int:
    text = failure_json()
    if text and sys.stdout is not None:
        print_data(text)
    return status


@contextmanager
def _termination() -> Iterator[None]:
    """A signal to end (SIGTERM) ends as Ctrl-C does: what is open is closed, the terminal is as it was."""

    def end(*_: object) -> None:
        raise SystemExit(TERMINATED)

    usual = threading.current_thread() is threading.main_thread() and signal.getsignal(signal.SIGTERM) == signal.SIG_DFL
    if usual:
        signal.signal(signal.SIGTERM, end)
    try:
        yield
    finally:
        if usual:
            signal.signal(signal.SIGTERM, signal.SIG_DFL)


def _with_default_command(arguments: list[str]) -> list[str]:
    """The arguments with `studio` before them when they name no command and ask for no help."""
    first = arguments[0] if arguments else ""
    names = {command.name for command in app.registered_commands}
    if first in names or first in ("-h", "--help", "--version") or first.startswith(("--install-", "--show-")):
        return arguments
    if first and not first.startswith("-") and not os.path.lexists(first):
        # A command that there is not; what follows was meant for that.
        return ["studio", first]
    return ["studio", *arguments]


def _discard_output() -> None:
    """Discards all further output, without an error: nobody reads it any more."""
    for stream in (sys.stdout, sys.stderr):
        redirect_to_devnull(stream)


def _report_internal_error(error: Exception) -> int:
    if os.environ.get(DEBUG_VARIABLE):
        import traceback

        traceback.print_exception(error)
    kind = type(error).__name__
    first_line = str(error).strip().partition("\n")[0][:200]
    record_error(f"KitRobot itself went wrong ({kind}{f': {first_line}' if first_line else ''})")
    print_message(f"error: KitRobot itself went wrong ({kind}{f': {first_line}' if first_line else ''})")
    print_message(
        f"  help: this is our mistake; run the command again with {DEBUG_VARIABLE}=1 and report all that it says"
    )
    return INTERNAL_ERROR
