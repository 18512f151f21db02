"""`kitrobot probability --splitting`: how probable something is that hardly ever happens; text, or JSON."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import typer

from kitrobot.cli.output import INTERRUPTED, json_text, print_data, print_message
from kitrobot.cli.progress import counted_progress

if TYPE_CHECKING:
    from kitrobot.experiments.rare_probability import RareProbability
    from kitrobot.workspace.mission_run import PreparedRun

UNKNOWN = 3


def split_runs(
    prepared: PreparedRun,
    question: str,
    counts: str,
    confidence: float,
    branches: int | None,
    jobs: int | None,
    as_json: bool,
) -> None:
    """Prints what splitting the runs at a count finds; the status is 3 where too few branches found what is asked."""
    from kitrobot.experiments.rare_probability import USUAL_BRANCHES, SplittingOptions, find_rare_probability

    options = SplittingOptions(counts, branches or USUAL_BRANCHES, confidence=confidence, jobs=jobs)
    with counted_progress("repetitions") as progress:
        found = find_rare_probability(prepared, question, options, progress)
    print_data(json_text(found.to_json()) + "\n" if as_json else _summary(found))
    if not found.complete:
        print_message(f"broken off after {len(found.repetitions)} of {options.repetitions} repetitions")
        raise typer.Exit(INTERRUPTED)
    if found.interval is None:
        raise typer.Exit(UNKNOWN)


def _summary(found: RareProbability) -> str:
    rows = list(_rows(found))
    return f"{found.words}\n\n" + "".join(f"  {name:<11}  {text}\n" for name, text in rows)


def _rows(found: RareProbability) -> Iterator[tuple[str, str]]:
    interval, count = found.interval, len(found.repetitions)
    if interval is None:
        some = sum(one > 0 for one in found.repetitions)
        yield "probability", f"not known: {some} of {count} repetitions found it; let there be more `--runs`"
    else:
        sure = f"with a confidence of {100 * interval.confidence:g} %"
        yield "probability", f"{interval.estimate:.2g}, between {interval.low:.2g} and {interval.high:.2g} {sure}"
        yield "method", str(interval.method)
    passed = (f"{level:g} by {100 * share:.2g} %" for level, share in zip(found.levels, found.passed, strict=True))
    yield "levels", f"{found.options.counts}: {', '.join(passed)}"
    yield "branches", f"{found.branches} in {count} repetitions, with the seed {found.seed}"
    yield "real time", f"{found.real_seconds:.2f} s"
