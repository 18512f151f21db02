"""A walk by hand through the states that *Check* explores of a mission."""

from __future__ import annotations

from collections.abc import Collection

from kitrobot.checking.verification import require_failures
from kitrobot.mission.trial import FailureKind
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.table_builder import USUAL_KINDS
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.custom_properties import build_custom_properties, property_variables
from kitrobot.verifier.properties.properties import ready_properties
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
    asked = run.mission.properties
    model = Model(run, abstract_run(run, property_variables(run, asked)), failures, timing, kinds)
    own, _ = build_custom_properties(model, asked)
    return StateWalk(model, [*ready_properties(model), *own])
