"""`kitrobot replay`: a recording as text, without a page."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any

import typer

from kitrobot.cli.output import json_text, print_data, sanitize


def replay_trace(
    file: Annotated[Path, typer.Argument(metavar="FILE.krtrace", help="The recording.", show_default=False)],
    at: Annotated[
        float | None,
        typer.Option("--at", metavar="SECONDS", help="How all stood at that moment, instead of the events."),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Give the same as one JSON object.")] = False,
) -> None:
    """Play a recorded run as text: whose it is, everything that happened and why, how it ended.

    The studio plays it on the graph and in the arena: `kitrobot FILE.krtrace`.
    """
    if at is not None and not (math.isfinite(at) and at >= 0):
        raise typer.BadParameter("a moment of a run is 0 seconds or later", param_hint="'--at'")
    from kitrobot.workspace.replay import state_at, summary_of
    from kitrobot.workspace.traces import open_trace

    trace = open_trace(file)
    with trace.reader:
        found = summary_of(trace) if at is None else state_at(trace, at)
    if as_json:
        print_data(json_text(found) + "\n")
    else:
        print_data("\n".join(_story(found) if at is None else _moment(found)) + "\n")


def _time(seconds: float) -> str:
    return f"{int(seconds) // 60:02}:{seconds % 60:05.2f}"


def _story(found: dict[str, Any]) -> Iterator[str]:
    many = len(found["agents"])
    yield (
        f"{_time(found['seconds'])} of {many} real robot{'' if many == 1 else 's'}"
        if found["real"]
        else f"{_time(found['seconds'])} of {many} robot{'' if many == 1 else 's'} in {sanitize(found['world'])},"
        f" seed {found['seed']}"
    )
    yield ""
    events = found["events"]
    widths = [max((len(sanitize(event[name])) for event in events), default=0) for name in ("agent", "kind")]
    for event in events:
        who, kind = (sanitize(event[name]).ljust(width) for name, width in zip(("agent", "kind"), widths, strict=True))
        cause = "" if event["cause"] == "program" or "(" in event["text"] else f" ({sanitize(event['cause'])})"
        yield f"  {_time(event['seconds'])}  {who}  {kind}  {sanitize(event['text'])}{cause}"
    if events:
        yield ""
    if found["cut"]:
        yield "The recording was cut off here."
    elif found["outcome"] == "stopped":
        yield "The recording ends here; the run was still on."
    else:
        yield sanitize(found["sentence"]) or sanitize(found["outcome"])


def _moment(found: dict[str, Any]) -> Iterator[str]:
    yield f"{_time(found['seconds'])} (tick {found['tick']})"
    for name, agent in found["agents"].items():
        stands = ", ".join(sanitize(f"{one['element']} ({one['vertex']})") for one in agent["vertices"]) or "nowhere"
        yield ""
        yield f"  {sanitize(name)}: {agent['state']}, {_place(agent)}"
        yield f"    stands at {stands}"
        for word, values in (("variables", agent["values"]), ("inputs", agent["inputs"])):
            if values:
                shown = (
                    f"{sanitize(one)} = {value:g}{' (held)' if one in agent['forced'] and word == 'inputs' else ''}"
                    for one, value in values.items()
                )
                yield f"    {word}: " + ", ".join(shown)
    if found["real"]:
        return
    counts = [f"{sanitize(house)} holds {count:g}" for house, count in found["stock"].items()]
    yield ""
    yield "  " + ", ".join([*counts, f"collisions: {found['collisions']:g}"])


def _place(agent: dict[str, Any]) -> str:
    x, y, heading = agent["x_mm"], agent["y_mm"], agent["heading_rad"]
    if x is None or y is None or heading is None:
        return "a real robot: nobody knows where it was"
    return f"at {x:.1f}, {y:.1f} mm, heading {math.degrees(heading):.1f}°"
