"""What judges say, as people read it, or JSON."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

import typer

from kitrobot.cli.output import json_text, print_data, sanitize

if TYPE_CHECKING:
    from kitrobot.judges.judgement import Judgement


def print_judgements(judgements: Iterable[Judgement], as_json: bool) -> None:
    """Gives judgements, and ends with their status."""
    from kitrobot.judges.judgement import exit_status

    found = list(judgements)
    if as_json:
        print_data(json_text({"judgements": [one.to_json() for one in found]}) + "\n")
    else:
        print_data("\n".join(judgement_lines(found)) + "\n")
    status = exit_status(found)
    if status:
        raise typer.Exit(status)


def judgement_lines(found: Sequence[Judgement]) -> Iterator[str]:
    """Judgements as people read them: each property, and under it what each judge says."""
    if not found:
        yield "the mission has no properties of its own; ask with --property"
    subject: tuple[str, str] | None = None
    heads = [_head(one, found) for one in found]
    width = max(map(len, heads), default=0)
    for one, head in zip(found, heads, strict=True):
        if (one.subject, one.question) != subject:
            if subject:
                yield ""
            subject = one.subject, one.question
            yield sanitize(f"{one.question}: {one.words}" if one.question != one.words else one.words)
        yield f"  {head:<{width}}  {one.ruling.value:<11}  {sanitize(one.reason)}"
        for sentence in one.why:
            yield f"  {'':<{width}}  {'':<11}  {sanitize(sentence)}"
        for tick, agent, what in one.faults:
            yield f"  {'':<{width}}  {'':<11}  {sanitize(agent)}: {what} at {tick * one.tick_ms / 1000:.2f} s"


def _head(one: Judgement, found: Sequence[Judgement]) -> str:
    """Who says it: the judge; of several recordings, which one."""
    return (
        sanitize(one.subject)
        if one.judge.value == "recording" and len({it.subject for it in found}) > 1
        else one.judge.value
    )
