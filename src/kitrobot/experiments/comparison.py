"""One value of what varies against another: by how much a measure differs, and how probable that is by chance alone.

Points have the same seeds, so comparisons are paired: run by run, with all else and the seed in common. Unpaired, all
runs of a value are set against all of the first one, as if their seeds had nothing to do with each other: for measures
that many runs do not have. The statistics are those of `experiments.statistics`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.statistics.interval import USUAL_CONFIDENCE, Interval
from kitrobot.experiments.study_rows import StudyRows
from kitrobot.experiments.tables import text_lines
from kitrobot.experiments.variant import Value
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean

_Key = tuple[tuple[tuple[str, Value], ...], int]
"""All that a run has in common with its like: the values of the other addresses, and the seed."""
_Numbers = Mapping[_Key, float]


@dataclass(frozen=True)
class Comparison:
    """The difference of a measure, `other` minus `first`.

    Attributes:
        measure: of what.
        first, other: values of what varies.
        pairs: how many runs were compared with their like; None of an unpaired comparison.
        first_runs, other_runs: how many runs of each gave a number that counts.
        interval: for the difference of the means; its `method` says how it was computed.
        p_value: Holm's over all comparisons of the address.
        test: how the p-value was computed.
    """

    measure: str
    first: Value
    other: Value
    pairs: int | None
    first_runs: int
    other_runs: int
    interval: Interval
    p_value: float
    test: Sentence


def compare(
    study: StudyRows, address: str, measure: str, confidence: float = USUAL_CONFIDENCE, paired: bool = True
) -> list[Comparison]:
    """Each value of an address against its first one, in the order of the plan.

    Raises:
        ExperimentError: nothing of that name varies, or was measured.
        StatisticsError: there are too few runs, or the confidence is none.
    """
    from kitrobot.experiments.statistics.multiple_comparisons import holm

    first, *others = found = _numbers(study, address, measure)
    both = [_numbers_of_two(found[first], found[other], paired) for other in others]
    test, difference, words = _method(measure, paired)
    p_values = holm([test(ours, theirs) for ours, theirs in both])
    return [
        Comparison(
            measure,
            first,
            other,
            len(ours) if paired else None,
            len(ours),
            len(theirs),
            difference(ours, theirs, confidence),
            p_value,
            words,
        )
        for other, (ours, theirs), p_value in zip(others, both, p_values, strict=True)
    ]


def _numbers(study: StudyRows, address: str, measure: str) -> dict[Value, dict[_Key, float]]:
    """Of each value of an address the numbers of its runs."""
    if address not in study.plan.addresses:
        near = did_you_mean(address, study.plan.addresses)
        raise ExperimentError(Sentence("`{address}` does not vary in this study", address), near)
    if measure not in study.plan.measured:
        near = did_you_mean(measure, study.plan.measured)
        raise ExperimentError(Sentence("no row of the study has the measure `{name}`", measure), near)
    found: dict[Value, dict[_Key, float]] = {}
    for row in study.rows:
        number = row.measures.get(measure)
        if number is not None:
            rest = tuple((name, value) for name, value in row.point.items() if name != address)
            found.setdefault(row.point[address], {})[rest, row.seed] = number
    if not found:
        raise ExperimentError(Sentence("no row of the study has the measure `{name}`", measure))
    return found


def _numbers_of_two(first: _Numbers, other: _Numbers, paired: bool) -> tuple[list[float], list[float]]:
    if not paired:
        return list(first.values()), list(other.values())
    both = [key for key in first if key in other]
    return [first[key] for key in both], [other[key] for key in both]


def _method(measure: str, paired: bool) -> tuple[Any, Any, Sentence]:
    """The test, the interval of the difference, and the name of the test; `done` is a share."""
    from kitrobot.experiments.statistics import means, shares

    if paired:
        return means.paired_test, means.paired_difference, Sentence("paired t test, p-values by Holm")
    if measure == "done":
        return shares.share_test, shares.share_difference, Sentence("Fisher's exact test, p-values by Holm")
    return means.unpaired_test, means.unpaired_difference, Sentence("Welch's t test, p-values by Holm")


def comparison_json(found: Sequence[Comparison]) -> list[dict[str, Any]]:
    """As plain values, in the published shape."""
    return [
        {
            "measure": one.measure,
            "first": one.first,
            "other": one.other,
            "pairs": one.pairs,
            "first_runs": one.first_runs,
            "other_runs": one.other_runs,
            "estimate": one.interval.estimate,
            "low": one.interval.low,
            "high": one.interval.high,
            "confidence": one.interval.confidence,
            "method": str(one.interval.method),
            "p_value": one.p_value,
            "test": str(one.test),
        }
        for one in found
    ]


def comparison_text(address: str, found: Sequence[Comparison]) -> str:
    """As people read it: a line for each value but the first, and the methods below."""
    first, interval = found[0], found[0].interval
    rows = [[address, "pairs" if first.pairs is not None else "runs", f"{first.measure} more than {first.first}", "p"]]
    for one in found:
        runs = str(one.pairs) if one.pairs is not None else f"{one.other_runs} and {one.first_runs}"
        low, high = one.interval.low, one.interval.high
        difference = f"{one.interval.estimate:.5g} ({low:.5g} … {high:.5g})"
        rows.append([str(one.other), runs, difference, f"{one.p_value:.2g}"])
    lines = [*text_lines(rows), "", f"  {interval.confidence:.4g}: {interval.method}", f"  p: {first.test}"]
    return "\n".join(lines) + "\n"
