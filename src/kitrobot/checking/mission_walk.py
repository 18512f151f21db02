"""A walk by hand through the states that *Check* explores of a mission."""

from __future__ import annotations

from collections.abc import Collection

from kitrobot.checking.checked_model import abstract_asked, build_checked_model
from kitrobot.checking.verification import require_failures
from kitrobot.mission.trial import FailureKind
from kitrobot.verifier.model.table_builder import USUAL_KINDS
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.report.state_walk import StateWalk
from kitrobot.workspace.mission_run import PreparedRun


def begin_walk(
    prepared: PreparedRun,
    timing: Timing = Timing.FREE,
    failures: int = 0,
    kinds: Collection[FailureKind] = USUAL_KINDS,
) -> StateWalk:
    """A walk that stands in the first state of a mission.

    Args:
        prepared: the mission; its properties and the ready ones are followed.
        timing: when agents tick.
        failures: up to how many failures there may be, 0 to `MOST_FAILURES`.
        kinds: what a failure may be; of `verifier.KINDS`.

    Raises:
        VerificationError: there are too many failures.
        AbstractionError: the mission cannot be checked, so it has no states.
        StateWalkError: the mission is too large for a model.
    """
    require_failures(failures)
    run = prepared.spec.simulation(prepared.options.seed)
    made = build_checked_model(run, abstract_asked(run), failures, timing, kinds)
    return StateWalk(made.model, made.properties)
