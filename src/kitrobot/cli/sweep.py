"""`kitrobot run --fail-sweep`: every agent, or every two of them, fail at many moments; table, JSON, heat map."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from kitrobot.cli.output import INTERRUPTED, json_text, print_data, print_message
from kitrobot.cli.progress import counted_progress

if TYPE_CHECKING:
    from kitrobot.sim.sweep import Field
    from kitrobot.workspace.mission_run import PreparedRun
    from kitrobot.workspace.sweep import Sweep, SweepOptions

MISSION = ".krt"
MOMENTS, MOMENTS_OF_PAIRS = 100, 20
"""At how many moments agents fail, when nothing is said: one at a time, and two."""
MOST_REASONS = 10


def with_values(arguments: Sequence[str]) -> list[str]:
    """The arguments with a value behind each `--fail-sweep` and `--watch`.

    Where there is no number behind the first one it is 0, which stands for the usual one. Where nothing is behind the
    second one, another option, or a mission, it is "", which stands for the properties of the mission.
    """
    made: list[str] = []
    for at, word in enumerate(arguments):
        made.append(word)
        if word == "--":
            return [*made, *arguments[at + 1 :]]
        following = arguments[at + 1] if at + 1 < len(arguments) else ""
        if word == "--fail-sweep" and not following.lstrip("-").isdigit():
            made.append("0")
        if word == "--watch" and (not following or following.startswith("-") or following.endswith(MISSION)):
            made.append("")
    return made


def sweep_mission(prepared: PreparedRun, options: SweepOptions, picture: Path | None, as_json: bool) -> None:
    """Runs a sweep, gives what came of it, and ends with its status."""
    from kitrobot.files.disk import replace_whole
    from kitrobot.workspace.run_hints import FASTER
    from kitrobot.workspace.sweep import run_sweep
    from kitrobot.workspace.sweep_map import heat_map

    with counted_progress("fields") as progress:
        sweep = run_sweep(prepared, options, progress)
    if picture is not None:
        name = prepared.opened.mission.label.get("") or prepared.opened.name
        what = "two agents fail" if sweep.pairs else "an agent fails"
        replace_whole(picture, heat_map(sweep, f"{name}: {what}").encode())
    print_data(json_text(sweep.to_json()) + "\n" if as_json else _table(sweep))
    if sweep.would_gain and not as_json:
        print_message(FASTER)
    if not sweep.complete:
        print_message(f"broken off after {len(sweep.fields)} of {sweep.total} fields")
        raise typer.Exit(INTERRUPTED)
    if not sweep.holds:
        raise typer.Exit(1)


def _table(sweep: Sweep) -> str:
    """The result as people read it."""
    from kitrobot.workspace.sweep import OUTCOMES

    who = {field: _agent_names(sweep, field) for field in sweep.fields}
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for field, names in who.items():
        counts[names][field.outcome] += 1
        counts["all"][field.outcome] += 1
    rows = [
        *sorted((names for names in counts if names != "all"), key=_team_order(sweep)),
        *(["all"] if counts else []),
    ]
    width = max((len(names) for names in rows), default=0)
    head = "".join(f"{outcome:>8}" for outcome in OUTCOMES)
    lines = [f"Without these failures: {sweep.baseline.sentence}", "", f"  {'':<{width}}{head}"]
    for names in rows:
        lines.append(f"  {names:<{width}}" + "".join(f"{counts[names][outcome]:>8}" for outcome in OUTCOMES))
    reasons = list(_reasons(sweep, who))
    if reasons:
        lines += ["", *reasons[:MOST_REASONS]]
        lines += [f"  … and {len(reasons) - MOST_REASONS} more"] * (len(reasons) > MOST_REASONS)
    lines += [
        "",
        f"  fields      {len(sweep.fields)} of {sweep.total}, at {len(sweep.moments)} moments",
        f"  real time   {sweep.real_seconds:.2f} s",
    ]
    return "\n".join(lines) + "\n"


def _agent_names(sweep: Sweep, field: Field) -> str:
    return " + ".join(sweep.agents[agent] for agent in sorted(fault.agent for fault in field.faults))


def _team_order(sweep: Sweep) -> Callable[[str], list[int]]:
    places = {name: place for place, name in enumerate(sweep.agents)}
    return lambda names: [places[name] for name in names.split(" + ") if name in places]


def _reasons(sweep: Sweep, who: dict[Field, str]) -> Iterator[str]:
    """Of each agent (or two) and outcome but done: how many fields, when the first of them was, and its sentence."""
    found: dict[tuple[str, str], list[Field]] = defaultdict(list)
    for field, names in who.items():
        if field.outcome != "done":
            found[names, field.outcome].append(field)
    for (names, outcome), fields in found.items():
        when = " and ".join(f"{sweep.seconds(fault.tick):.1f} s" for fault in fields[0].faults)
        yield f"  {outcome}, {names}, {len(fields)} in all, at {when}: {fields[0].sentence}"
