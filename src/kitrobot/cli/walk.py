"""`kitrobot walk`: the states of a mission step by step, each step chosen by hand."""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.options import MissionFile, ResultAsJson
from kitrobot.cli.output import json_text, print_data, print_diagnostics, print_message, sanitize
from kitrobot.cli.verify import FailureKinds, MostFailures, read_kinds
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.forms import number_form

if TYPE_CHECKING:
    from kitrobot.verifier.report.state_walk import PossibleStep, StateWalk

_WIDTH = 100
_HELP = """\
  a number    take that step
  Enter       go on while only one step is possible, failures aside
  b, b 5      go back a step, or five
  a           begin anew
  q           leave
"""

Taken = Annotated[
    str,
    typer.Option(
        "--take",
        metavar="N,N,…",
        help="Take these steps first, by their numbers in each list; `on` goes on while only one is possible.",
        show_default=False,
    ),
]
WalkTiming = Annotated[
    str,
    typer.Option(
        "--timing",
        metavar="free|prompt|lockstep",
        help="When agents tick: whenever, each between two events, or all at once.",
    ),
]


def walk_states(
    file: MissionFile,
    timing: WalkTiming = "free",
    failures: MostFailures = 0,
    kinds: FailureKinds = None,
    taken: Taken = "",
    as_json: ResultAsJson = False,
) -> None:
    """Walk through the states of a mission by hand: see every step that is possible, and take one.

    The states are those that `kitrobot verify` explores, with the same properties. With --json the state after --take
    is given, and nothing is asked.
    """
    from kitrobot.checking.mission_walk import begin_walk
    from kitrobot.mission.model import DEFAULT_RUN_S, DEFAULT_SEED
    from kitrobot.verifier.model.timing import Timing
    from kitrobot.workspace.mission_loader import open_mission
    from kitrobot.workspace.mission_run import RunOptions

    if timing not in {one.value for one in Timing}:
        raise typer.BadParameter(f"expected one of {', '.join(one.value for one in Timing)}", param_hint="'--timing'")
    wanted = read_kinds(failures, kinds)
    prepared = open_mission(file).prepare(RunOptions(DEFAULT_SEED, DEFAULT_RUN_S))
    print_diagnostics(prepared.problems, prepared.sources)
    walk = begin_walk(prepared, Timing(timing), failures, wanted)
    for word in filter(None, taken.replace(",", " ").split()):
        _take_named_step(walk, word)
    if as_json:
        print_data(json_text(_state_json(walk)) + "\n")
    else:
        _walk_by_hand(walk)


def _take_named_step(walk: StateWalk, word: str) -> None:
    """Takes a step by its number from 1, or goes on.

    Raises:
        StateWalkError: there is no such step.
    """
    if word == "on":
        walk.go_on()
        return
    number = _read_number(word)
    if number is None:
        raise typer.BadParameter(f"expected numbers and `on`, not {word!r}", param_hint="'--take'")
    walk.take_step(number - 1)


def _read_number(word: str) -> int | None:
    plain = number_form(word)
    return int(plain) if plain.isascii() and plain.isdigit() and len(plain) < 7 else None


def _walk_by_hand(walk: StateWalk) -> None:
    """Shows the state and does what is typed, until the input ends."""
    asks = sys.stdin is not None and sys.stdin.isatty()
    if asks:
        print_message("a number takes a step, Enter goes on, b goes back, ? shows more, q leaves")
    shows = True
    while True:
        if shows:
            print_data("\n".join(_state_lines(walk)) + "\n")
        shows = True
        if asks:
            print_data("> ")
            sys.stdout.flush()
        typed = "" if sys.stdin is None else sys.stdin.readline()
        words = typed.split()
        if not typed or words[:1] in (["q"], ["quit"]):
            return
        shows = _do_typed(walk, words)


def _do_typed(walk: StateWalk, words: list[str]) -> bool:
    """Does one command; returns whether the state is to be shown."""
    first, count = (words or [""])[0], _read_number(words[1]) if len(words) == 2 else 1
    if not words:
        if walk.go_on() == 0:
            print_message("there is no single step to go on with: type the number of one")
            return False
    elif first == "a" and len(words) == 1:
        walk.go_back(len(walk.places))
    elif first == "b" and count is not None:
        walk.go_back(count)
    elif (number := _read_number(first)) is not None and len(words) == 1:
        try:
            walk.take_step(number - 1)
        except KitRobotError as error:
            print_message(str(error.message))
            return False
    else:
        if first != "?":
            print_message(f"`{sanitize(' '.join(words))[:40]}` is no command")
        print_data(_HELP)
        return False
    return True


def _state_lines(walk: StateWalk) -> Iterator[str]:
    yield ""
    said = "; ".join(str(one) for one in walk.describe_last_step())
    yield f"state {len(walk.places)}" + (f": {said}" if said else "")
    robots = walk.describe_robots()
    names = max((len(one.agent) for one in robots), default=0)
    places = max((len(one.place) for one in robots), default=0)
    for robot in robots:
        at = "at " + ", ".join(f"{vertex}" for _, vertex in robot.at) if robot.at else ""
        facts = ", ".join([*filter(None, [at]), *map(str, robot.facts)])
        yield sanitize(f"  {robot.agent.ljust(names)}  {robot.place.ljust(places)}  {facts}").rstrip()
    if shared := walk.describe_shared():
        yield from textwrap.wrap(
            sanitize("   ".join(map(str, shared))), _WIDTH, initial_indent="  ", subsequent_indent="  "
        )
    yield from (f"  ! {sanitize(str(one))}" for one in walk.describe_situation())
    steps = walk.list_steps()
    if not steps:
        yield "no step is possible any more"
        return
    yield "possible steps:"
    yield from (f"{step.place + 1:>5}  {sanitize(_step_text(step))}" for step in steps)
    if more := walk.count_steps() - len(steps):
        yield f"       … and {more} more"


def _step_text(step: PossibleStep) -> str:
    notes = [f"breaks {name}" for name in step.breaks]
    if step.returns_to >= 0:
        notes.append(f"back to state {step.returns_to}")
    return "; ".join(map(str, step.sentences)) + (f"  ({', '.join(notes)})" if notes else "")


def _state_json(walk: StateWalk) -> dict[str, Any]:
    steps = walk.list_steps()
    return {
        "state": len(walk.places),
        "taken": [place + 1 for place in walk.places],
        "happened": [str(one) for one in walk.describe_last_step()],
        "robots": [
            {
                "agent": robot.agent,
                "place": robot.place or None,
                "vertices": [{"program": program, "vertex": vertex} for program, vertex in robot.at],
                "facts": [str(one) for one in robot.facts],
            }
            for robot in walk.describe_robots()
        ],
        "shared": [str(one) for one in walk.describe_shared()],
        "situation": [str(one) for one in walk.describe_situation()],
        "possible": [
            {
                "number": step.place + 1,
                "text": [str(one) for one in step.sentences],
                "failure": step.is_failure,
                "returns_to": step.returns_to if step.returns_to >= 0 else None,
                "breaks": list(step.breaks),
            }
            for step in steps
        ],
        "more": walk.count_steps() - len(steps),
    }
