"""`kitrobot verify`: what can go wrong in a mission, whatever the order of events; a table, or JSON."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.judge import JudgedFiles, judge_recordings, split_files
from kitrobot.cli.judgements import print_judgements
from kitrobot.cli.options import IsApproximate, ResultAsJson
from kitrobot.cli.output import json_text, print_data, print_diagnostics, print_message
from kitrobot.text.sentences import Sentence

if TYPE_CHECKING:
    from kitrobot.checking.run_explanation import RunExplanation
    from kitrobot.checking.verification import Progress
    from kitrobot.checking.verification_result import Finding, Verification
    from kitrobot.mission.property_forms import AskedProperty
    from kitrobot.mission.trial import FailureKind
    from kitrobot.verifier.exploration.budget import CutReason
    from kitrobot.verifier.model.timing import Timing
    from kitrobot.verifier.report.kept_run import KeptRun
    from kitrobot.verifier.report.replay import ConfirmedRun

_MEGA = 1_000_000
_ELSEWHERE = Sentence("ask it of runs (`kitrobot judge --by runs`), of failures or of a recording")
_FIRST, _LAST = 6, 24
"""Events of one run that are shown: the first and the last ones."""

_WORTHLESS = 0.5
"""Odds of a state to be missed from which on an approximate search says next to nothing."""

_OTHER = 5
"""Events of another way that are shown."""

PropertyNames = Annotated[
    list[str] | None,
    typer.Option(
        "--property",
        metavar="PROPERTY",
        help="Check this one only: a name, or a property as text; may be given again.",
        show_default=False,
    ),
]
TimingNames = Annotated[
    list[str] | None,
    typer.Option(
        "--timing",
        metavar="lockstep|prompt|free",
        help="When agents tick: all at once, each between two events, or whenever; may be given again. Else all.",
        show_default=False,
    ),
]
MostFailures = Annotated[int, typer.Option(metavar="K", help="Up to so many failures at any moment, 0 to 3.")]
FailureKinds = Annotated[
    list[str] | None,
    typer.Option(
        "--kind",
        metavar="fail|stall|mute",
        help="What a failure is: a robot stops for good, misses its ticks for a while, or loses its radio; may be "
        "given again. Else fail and stall.",
        show_default=False,
    ),
]
MostStates = Annotated[
    int | None,
    typer.Option(
        "--max-states",
        metavar="N",
        min=1,
        help="Explore at most so many states of each. Else as many as there is time and memory for.",
        show_default=False,
    ),
]
MostMemory = Annotated[
    int,
    typer.Option("--max-memory", metavar="MB", min=1, help="Let its process take at most so much memory."),
]
Cores = Annotated[
    int | None,
    typer.Option(
        min=1,
        metavar="N",
        help="Let at most so many cores explore a large mission together. Else all that there are.",
        show_default=False,
    ),
]
Seconds = Annotated[float, typer.Option(metavar="S", help="Take at most so long, together.")]


def verify_mission(
    files: JudgedFiles,
    properties: PropertyNames = None,
    timings: TimingNames = None,
    failures: MostFailures = 0,
    kinds: FailureKinds = None,
    most_states: MostStates = None,
    most_memory: MostMemory = 2_000,
    seconds: Seconds = 60.0,
    cores: Cores = None,
    approximate: IsApproximate = False,
    as_json: ResultAsJson = False,
) -> None:
    """Check what can go wrong in a mission, whatever the order of events; or whether recordings keep its properties.

    A broken property is shown as a run without the events that it does not need, with the moment that decided it and
    another way from there.

    The exit status is 0 when every property holds wherever it was checked, 1 when one is broken, and 3 when none is
    and a search was not finished, or approximate.
    """
    if not (math.isfinite(seconds) and seconds > 0):
        raise typer.BadParameter("a check takes more than 0 seconds", param_hint="'--seconds'")
    recordings, file = split_files(files)
    if recordings:
        print_judgements(judge_recordings(recordings, properties or (), file), as_json)
        return
    assert file is not None, "there is a file"
    from kitrobot.checking.verification import VerificationOptions, verify
    from kitrobot.mission.model import DEFAULT_RUN_S, DEFAULT_SEED
    from kitrobot.verifier.model.timing import Timing
    from kitrobot.workspace.mission_loader import open_mission
    from kitrobot.workspace.mission_run import RunOptions
    from kitrobot.workspace.run_hints import FASTER

    known = [one.value for one in Timing]
    _check_names(timings, known, "--timing")
    wanted = read_kinds(failures, kinds)
    chosen = tuple(one for one in Timing if not timings or one.value in timings)
    names, asked = _read_properties(properties or ())
    prepared = open_mission(file).prepare(RunOptions(DEFAULT_SEED, DEFAULT_RUN_S))
    print_diagnostics(prepared.problems, prepared.sources)
    options = VerificationOptions(
        *(names, chosen, failures, wanted, most_states, seconds),
        memory=most_memory * _MEGA,
        explains=True,
        asked=asked,
        cores=cores,
        approximate=approximate,
    )
    with _progress() as progress:
        made = verify(prepared, options, progress)
    print_data(json_text(made.to_json()) + "\n" if as_json else _table(made))
    if made.would_gain and not as_json:
        print_message(FASTER)
    if status := _status(made):
        raise typer.Exit(status)


def _status(made: Verification) -> int:
    """The exit status of a check."""
    from kitrobot.verifier.properties.verdicts import Answer

    if Answer.BROKEN in made.answers:
        return 1
    return 0 if {Answer.HOLDS, Answer.VACUOUS}.issuperset(made.answers) else 3


def read_kinds(failures: int, kinds: Collection[str] | None) -> tuple[FailureKind, ...]:
    """What a failure may be: the named kinds, else the usual ones.

    Raises:
        BadParameter: there are too many failures, none to be of a kind, or there is no such kind.
    """
    from kitrobot.checking.verification import MOST_FAILURES
    from kitrobot.verifier.model.table_builder import KINDS, USUAL_KINDS

    if not 0 <= failures <= MOST_FAILURES:
        raise typer.BadParameter(f"a check takes 0 to {MOST_FAILURES} failures", param_hint="'--failures'")
    if kinds and not failures:
        raise typer.BadParameter("say with --failures how many there may be", param_hint="'--kind'")
    befalls = {one.value: one for one in KINDS}
    _check_names(kinds, befalls, "--kind")
    return tuple(one for name, one in befalls.items() if name in kinds) if kinds else USUAL_KINDS


def _read_properties(texts: Sequence[str]) -> tuple[tuple[str, ...], tuple[AskedProperty, ...]]:
    """The names among properties, and those that are asked as text: `asked`, `asked-2`, …"""
    from kitrobot.mission.property_text import QuestionError, read_property

    names: list[str] = []
    asked: list[AskedProperty] = []
    for text in texts:
        found = read_property(text)
        if found.within_s is not None:
            raise QuestionError(Sentence("it counts seconds, and the states of a check have none"), _ELSEWHERE)
        if found.asked is None:
            names.append(found.name)
        else:
            name = "asked" if not asked else f"asked-{len(asked) + 1}"
            asked.append(replace(found.asked, name=name))
    return tuple(names), tuple(asked)


def _check_names(names: Iterable[str] | None, known: Collection[str], option: str) -> None:
    """Refuses what an option does not know."""
    if any(name not in known for name in names or ()):
        raise typer.BadParameter(f"expected one of {', '.join(known)}", param_hint=f"'{option}'")


@contextmanager
def _progress() -> Iterator[Progress | None]:
    """A line on standard error while a person watches."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress as Bar
    from rich.progress import SpinnerColumn, TextColumn, TimeElapsedColumn

    from kitrobot.checking.background_check import memory_taken

    begun: dict[str, float] = {}

    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    with Bar(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=None)

        def update(timing: Timing, failures: int, states: int, depth: int) -> None:
            head, now = _head(timing.value, failures), time.monotonic()
            since = now - begun.setdefault(head, now)
            bar.update(task, description=progress_words(head, states, depth, since, memory_taken()))

        yield update


def progress_words(head: str, states: int, depth: int, seconds: float, memory: int) -> str:
    """How far a check is: states, how many a second, how deep, and the memory of its process, where it is known."""
    words = f"{head}: {states:,} states"
    if seconds > 0:
        words += f", {states / seconds:,.0f} a second"
    words += f", {depth} deep"
    return f"{words}, {memory / 1e6:,.0f} MB" if memory else words


def _head(timing: str, failures: int, kinds: str = "") -> str:
    return timing if failures == 0 else f"{timing}, {failures} failure{'' if failures == 1 else 's'}{kinds}"


def _table(made: Verification) -> str:
    """The result as people read it: a row for each property, a column for each assumption, then what is broken."""
    from kitrobot.verifier.model.table_builder import USUAL_KINDS

    kinds = "" if made.kinds == USUAL_KINDS else f" ({', '.join(kind.value for kind in made.kinds)})"
    heads = [_head(column.judged.timing.value, column.judged.failures, kinds) for column in made.columns]
    rows: dict[str, list[str]] = {}
    for column in made.columns:
        for finding in column.findings:
            rows.setdefault(finding.verdict.property.name, []).append(_answer_text(finding))
    names = max((len(name) for name in rows), default=0)
    widths = [max(len(head), 13) for head in heads]
    lines = ["  ".join([" " * names, *(head.ljust(width) for head, width in zip(heads, widths, strict=True))]).rstrip()]
    for name, answers in rows.items():
        cells = (answer.ljust(width) for answer, width in zip(answers, widths, strict=False))
        lines.append("  ".join([name.ljust(names), *cells]).rstrip())
    explored = (f"{column.judged.states:,}" for column in made.columns)
    cells = (text.ljust(width) for text, width in zip(explored, widths, strict=True))
    lines += ["", "  ".join(["states".ljust(names), *cells]).rstrip()]
    cuts: dict[tuple[CutReason, bool], list[str]] = {}
    for column, head in zip(made.columns, heads, strict=True):
        if column.judged.cut is not None:
            cuts.setdefault((column.judged.cut, column.judged.is_approximate), []).append(head)
    lines += [f"  not finished: {_cut_sentence(*cut, '; '.join(heads))}" for cut, heads in cuts.items()]
    lines += _approximate_lines(made, heads)
    lines += [f"  taken for granted: {limit}" for limit in made.limits]
    told: set[str] = set()
    for column, head in zip(made.columns, heads, strict=True):
        for finding in column.findings:
            name = finding.verdict.property.name
            if finding.verdict.counterexample is None or name in told:
                continue
            if not told:
                lines += ["", *_counterexample_lines(finding, head, made.tick_ms)]
            else:
                lines += ["", f"{name} ({head}): see its run with --property {name}"]
            told.add(name)
    return "\n".join(lines) + "\n"


def _approximate_lines(made: Verification, heads: Sequence[str]) -> Iterator[str]:
    """How far an approximate search is to be trusted, and what it cannot decide."""
    for column, head in zip(made.columns, heads, strict=True):
        if column.judged.odds is not None:
            yield f"  approximate: {head}: {odds_words(column.judged.odds)}"
    if any(answer.value == "not decided" for answer in made.answers):
        yield (
            "  not decided: what waits, or depends on what came before, needs all steps; leave out --approximate, "
            "let fewer robots take part, or ask runs (kitrobot judge --by runs)"
        )


def odds_words(odds: float) -> str:
    """How many of the states that steps lead to may have been missed, of so many."""
    if odds > _WORTHLESS:
        return "its memory was full: most states were missed; --max-memory gives it more"
    share = "fewer than 1 in 1,000,000,000" if odds < 1e-9 else f"at most 1 in {math.floor(1 / odds):,}"
    return f"{share} states that steps lead to may have been missed, and what only they lead to"


def _cut_sentence(cut: CutReason, is_approximate: bool, where: str) -> str:
    """The sentence on why a search was not finished under these assumptions, and what helps."""
    more = "" if is_approximate else "; --approximate looks at more, and does not say that anything holds"
    return {
        "states": f"{where} came to the limit of states; --max-states sets another{more}",
        "memory": f"{where} came to the limit of memory; --max-memory sets another{more}",
        "time": f"{where} ran out of time; --seconds gives it more",
        "stopped": f"{where} was stopped",
        "size": f"{where} has a step that goes in too many ways to be kept",
    }[cut.value]


def _answer_text(finding: Finding) -> str:
    if finding.verdict.counterexample is None:
        return finding.verdict.answer.value
    return "broken" if finding.confirmed is not None else "broken?"


def _counterexample_lines(finding: Finding, head: str, tick_ms: int) -> Sequence[str]:
    """The lines of one broken property: its demand, the counterexample, whether the simulator confirms it, and why."""
    verdict, counterexample = finding.verdict, finding.verdict.counterexample
    assert counterexample is not None
    lines = [f"{verdict.property.name} ({head}): not always: {verdict.property.sentence}"]
    why = finding.why
    decided = -1 if why is None else why.step
    story = [f"{'>' if step == decided else ' '} {step:>4}  {text}" for step, text in finding.story]
    left_out = len(story) - _FIRST - _LAST
    if left_out > 1:
        story[_FIRST:-_LAST] = [f"        … {left_out} events …"]
    lines += story
    if counterexample.repeats_from >= 0:
        whole = counterexample.repeats_from >= len(counterexample.steps)
        lines.append(
            "        and so it stays"
            if whole
            else f"        from step {counterexample.repeats_from} on again and again"
        )
    lines.append(_confirmed_line(finding.confirmed, tick_ms))
    if why is not None:
        lines += _why_lines(why, tick_ms)
    return lines


def _confirmed_line(confirmed: ConfirmedRun | None, tick_ms: int) -> str:
    """Whether the simulator shows it too."""
    if confirmed is None:
        return "  not reproduced in the simulator"
    harms = [f"{harm.agent}: {harm.kind} at {harm.tick * tick_ms / 1000:.2f} s" for harm in confirmed.faults]
    words = f"  confirmed in the simulator: seed {confirmed.seed}, at {confirmed.tick * tick_ms / 1000:.2f} s"
    return f"{words} ({', '.join(harms)})" if harms else words


def _why_lines(why: RunExplanation, tick_ms: int) -> Iterator[str]:
    """Why it is broken, and another way from the moment that decided it."""
    if why.left_out:
        yield f"  {why.left_out} event{'' if why.left_out == 1 else 's'} left out that it does not need"
    for number, sentence in enumerate(why.sentences):
        yield f"  {'why:' if number == 0 else '    '}  {sentence}"
    if why.other is not None and why.other.story:
        yield f"  another way from step {why.step} on{', to a good end' if why.other.ends_well else ''}:"
        yield from (f"  {step:>4}  {text}" for step, text in why.other.story[:_OTHER])
        if len(why.other.story) > _OTHER:
            yield f"        … {len(why.other.story) - _OTHER} events …"
    if why.tick >= 0:
        yield f"  decided in the simulator at {why.tick * tick_ms / 1000:.2f} s"
    if why.kept is not None:
        yield f"  {_kept_line(why.kept, tick_ms)}"


def _kept_line(kept: KeptRun, tick_ms: int) -> str:
    """The run of the simulator that keeps the property."""
    seconds = kept.tick * tick_ms / 1000
    if not kept.delayed:
        return f"kept there without the failure at {seconds:.2f} s"
    return f"kept there if {kept.delayed} waits {kept.delay * tick_ms / 1000:.2f} s at {seconds:.2f} s"
