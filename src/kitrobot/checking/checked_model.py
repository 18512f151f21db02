"""The model of a mission under one assumption, with the properties that a check, or a walk, judges on it."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NamedTuple

from kitrobot.mission.property_forms import AskedProperty
from kitrobot.mission.trial import FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.abstraction import Abstraction, abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.custom_properties import (
    build_custom_properties,
    build_custom_property,
    property_variables,
)
from kitrobot.verifier.properties.properties import Property, ready_properties


class CheckedModel(NamedTuple):
    """A model, the ready properties and those of the mission, and why some of the mission's are left out."""

    model: Model
    properties: list[Property]
    left_out: list[Sentence]


def abstract_asked(run: Simulation, asked: Sequence[AskedProperty] = ()) -> Abstraction:
    """The parts of a mission's model: with what its properties speak of, and those that are asked besides.

    Raises:
        AbstractionError: the mission cannot be checked.
    """
    return abstract_run(run, property_variables(run, (*run.mission.properties, *asked)))


def build_checked_model(
    run: Simulation,
    parts: Abstraction,
    failures: int,
    timing: Timing,
    kinds: Collection[FailureKind],
    asked: Sequence[AskedProperty] = (),
) -> CheckedModel:
    """The model of a run that is before its first step, of the parts of `abstract_asked`.

    Raises:
        PropertyError: a check cannot decide one of the properties that are asked besides.
    """
    model = Model(run, parts, failures, timing, kinds)
    own, left_out = build_custom_properties(model, run.mission.properties)
    own += [build_custom_property(model, one) for one in asked]
    return CheckedModel(model, [*ready_properties(model), *own], left_out)
