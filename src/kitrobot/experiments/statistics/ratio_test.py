"""At least so often, yes or no: Wald's sequential probability ratio test (SPRT)."""

from __future__ import annotations

import math

from kitrobot.experiments.statistics.interval import USUAL_CONFIDENCE, StatisticsError, check_confidence
from kitrobot.text.sentences import Sentence


class RatioTest:
    """Decides, run by run, whether a share is at least `threshold`.

    It compares how probable the runs are with the shares `threshold` + and - `margin`, and ends once one makes them
    1 / (1 - confidence) times as probable as the other. So a share of `threshold` + `margin` or more is called too
    small with a probability of at most 1 - confidence, and one of `threshold` - `margin` or less large enough no more
    often (Wald 1945; the bounds are Ville's, which no overshoot breaks). Between the two either answer may come.

    Args:
        threshold: the share that is asked for; `margin` < threshold < 1 - `margin`.
        margin: how much more or less makes no difference to whoever asks; more than 0.
        confidence: how often the answer is right, between 0 and 1.

    Raises:
        StatisticsError: a number makes no sense.

    Examples:
        >>> test = RatioTest(0.9, 0.05, 0.95)
        >>> while test.decision is None:
        ...     test.add(True)
        >>> test.decision, test.runs
        (True, 27)
    """

    def __init__(self, threshold: float, margin: float, confidence: float = USUAL_CONFIDENCE) -> None:
        check_confidence(confidence)
        if not 0 < threshold < 1:
            raise StatisticsError(
                Sentence("expected a share between 0 and 1 to compare with, found {found}", f"{threshold:g}"),
                Sentence("no number of runs shows that something always holds; `kitrobot verify` may"),
            )
        if not (margin > 0 and margin < threshold < 1 - margin):
            raise StatisticsError(
                Sentence(
                    "{threshold} cannot be told from {threshold} ± {margin}: that must lie between 0 and 1",
                    f"{threshold:g}",
                    f"{margin:g}",
                ),
                Sentence("choose a precision smaller than {most}", f"{min(threshold, 1 - threshold):g}"),
            )
        upper, lower = threshold + margin, threshold - margin
        self._success, self._failure = math.log(upper / lower), math.log((1 - upper) / (1 - lower))
        self._bound = math.log(1 / (1 - confidence))
        self.runs = 0
        self.successes = 0
        self.decision: bool | None = None
        """Whether the share is at least the threshold; None while that is open."""

    def add(self, success: bool) -> None:
        """Counts the next run."""
        assert self.decision is None, "no run is counted after the decision"
        self.runs += 1
        self.successes += success
        ratio = self.successes * self._success + (self.runs - self.successes) * self._failure
        if abs(ratio) >= self._bound:
            self.decision = ratio > 0
