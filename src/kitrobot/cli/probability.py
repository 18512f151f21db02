"""`kitrobot probability`: how probable it is that a run has a property, with an interval that holds; text, or JSON."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.options import Jobs, MissionFile, ResultAsJson
from kitrobot.cli.output import INTERRUPTED, json_text, print_data, print_diagnostics, print_message
from kitrobot.cli.progress import counted_progress
from kitrobot.cli.rare_probability import split_runs
from kitrobot.cli.run import FailRate, check_run_numbers

if TYPE_CHECKING:
    from kitrobot.experiments.probability import Probability
    from kitrobot.workspace.mission_run import PreparedRun

Question = Annotated[
    str,
    typer.Argument(
        metavar="PROPERTY",
        help="What is asked of each run: `delivered within 120`, `done`, `never any carrier (Collision.IsPressed())`.",
        show_default=False,
    ),
]
Precision = Annotated[
    float, typer.Option(metavar="E", help="The probability is at most so far from the estimate; less than 0.5.")
]
Confidence = Annotated[float, typer.Option(metavar="C", help="How often such an answer is right; between 0 and 1.")]
AtLeast = Annotated[
    float | None,
    typer.Option(
        metavar="P",
        help="Only decide whether the probability is at least P; within the precision either answer may come.",
        show_default=False,
    ),
]
FirstSeed = Annotated[int, typer.Option(min=0, help="The seed of the first run; each next one has the next seed.")]
RunSeconds = Annotated[
    float, typer.Option(help="Simulated seconds after which a run is out of time, where the property sets none.")
]
MostRuns = Annotated[
    int | None,
    typer.Option("--runs", metavar="N", min=1, help="At most so many runs; else as many as it takes."),
]
Splitting = Annotated[
    str | None,
    typer.Option(
        metavar="COUNT",
        help="Of what hardly ever happens: branch runs where `delivered`, `failed` or `collisions` counts one more.",
        show_default=False,
    ),
]


def estimate_probability(
    file: MissionFile,
    question: Question,
    fail_rate: FailRate = 0.0,
    precision: Precision = 0.05,
    confidence: Confidence = 0.95,
    at_least: AtLeast = None,
    seed: FirstSeed = 1,
    seconds: RunSeconds = 600.0,
    most_runs: MostRuns = None,
    jobs: Jobs = None,
    splitting: Splitting = None,
    as_json: ResultAsJson = False,
) -> None:
    """Estimate how probable it is that a run of a mission has a property.

    Each run has another seed. Their number is as large as the precision needs. The exit status is 0 when the
    probability is known; with `--at-least` it is 0 for yes, 1 for no, and 3 where `--runs` were too few for a decision.
    """
    from kitrobot.experiments.probability import ProbabilityOptions, find_probability
    from kitrobot.workspace.mission_loader import open_mission
    from kitrobot.workspace.mission_run import RunOptions

    check_run_numbers(seed, seconds, fail_rate)
    prepared = open_mission(file).prepare(RunOptions(seed, seconds, fail_rate))
    print_diagnostics(prepared.problems, prepared.sources)
    if splitting is not None:
        if at_least is not None:
            raise typer.BadParameter("split runs give an estimate, no decision", param_hint="'--at-least'")
        split_runs(prepared, question, splitting, confidence, most_runs, jobs, as_json)
        return
    options = ProbabilityOptions(precision, confidence, at_least, most_runs, jobs)
    with counted_progress("runs") as progress:
        found = find_probability(prepared, question, options, progress)
    print_data(json_text(found.to_json()) + "\n" if as_json else _summary(found) + _advice(found, prepared))
    is_broken_off = not found.complete and found.runs != most_runs
    if is_broken_off:
        print_message(f"broken off after {_counted(found.runs)}")
        raise typer.Exit(INTERRUPTED)
    if at_least is not None and not found.decision:
        raise typer.Exit(3 if found.decision is None else 1)


def _counted(runs: int) -> str:
    return f"{runs} run{'' if runs == 1 else 's'}"


def _summary(found: Probability) -> str:
    """The result as people read it."""
    rows = dict(_rows(found))
    width = max(map(len, rows))
    lines = [str(found.words), "", *(f"  {name:<{width}}  {text}" for name, text in rows.items())]
    few = found.counterexamples if 2 * found.holds >= found.runs else found.examples
    if few:
        negation = "does not hold" if few is found.counterexamples else "holds"
        lines += ["", f"  the first runs in which it {negation}:"]
        lines += [
            f"    seed {one.seed}, {one.tick * found.tick_ms / 1000:.1f} s  {one.sentence}".rstrip() for one in few
        ]
    return "\n".join(lines) + "\n"


def _advice(found: Probability, prepared: PreparedRun) -> str:
    """The command line option that says more of what hardly ever happens; "" where there is none."""
    from kitrobot.experiments.rare_probability import likely_count

    count = likely_count(prepared) if found.is_rare else None
    if count is None:
        return ""
    return f"\n  it holds in {found.holds} of {_counted(found.runs)}: `--splitting {count}` tells more of the rare\n"


def _rows(found: Probability) -> Iterator[tuple[str, str]]:
    options, interval = found.options, found.interval
    sure = f"with a confidence of {100 * options.confidence:g} %"
    if options.at_least is not None:
        answer = {True: f"yes, {sure}", False: f"no, {sure}", None: "not decided"}[found.decision]
        yield f"at least {options.at_least:g}", answer
    elif interval is None:
        yield "probability", "not known: no run has ended"
    else:
        digits = max(2, 1 - math.floor(math.log10(options.precision)))
        low, high = _rounded_outwards(interval.low, interval.high, digits)
        after = f", after {_counted(found.looked_at)}" if found.looked_at < found.runs else ""
        yield "probability", f"{interval.estimate:.{digits}f}, between {low} and {high} {sure}{after}"
    yield "method", str(found.method)
    seeds = f", with the seeds {found.seed} to {found.seed + found.runs - 1}; it holds in {found.holds}"
    yield "runs", f"{found.runs}{seeds if found.runs else ''}"
    if found.planned_runs is not None:
        yield (
            "planned",
            f"at most {_counted(found.planned_runs)}; a fixed number takes {found.hoeffding_runs} (Chernoff-Hoeffding)",
        )
    yield "real time", f"{found.real_seconds:.2f} s"


def _rounded_outwards(low: float, high: float, digits: int) -> tuple[str, str]:
    scale = 10**digits
    return f"{math.floor(low * scale) / scale:.{digits}f}", f"{math.ceil(high * scale) / scale:.{digits}f}"
