"""Checks missions: explores a discrete model of agents and world, and decides properties on its states.

Programs are tables that the interpreter itself fills (`programs`). The discrete world (`roads`, `motion`, `traffic`) is
made from the numbers of a run (`abstraction`). Every verdict names the assumption about time that it was found under
(`timing`).
"""

from kitrobot.verifier.abstraction import Parts, take_apart
from kitrobot.verifier.budget import Budget, Cut
from kitrobot.verifier.conditions import Asked, Member, PropertyError, ask
from kitrobot.verifier.counterexample_text import free_readings, told
from kitrobot.verifier.custom_properties import asked_properties, variables_asked
from kitrobot.verifier.model import Model
from kitrobot.verifier.programs import AbstractionError
from kitrobot.verifier.properties import Property, ready_properties
from kitrobot.verifier.replay import Confirmed, Harm, befell, confirm
from kitrobot.verifier.table_builder import KINDS, USUAL_KINDS
from kitrobot.verifier.timing import Timing
from kitrobot.verifier.verdicts import Answer, Judged, Verdict, Way, judge

__all__ = [
    "KINDS",
    "USUAL_KINDS",
    "AbstractionError",
    "Answer",
    "Asked",
    "Budget",
    "Confirmed",
    "Cut",
    "Harm",
    "Judged",
    "Member",
    "Model",
    "Parts",
    "Property",
    "PropertyError",
    "Timing",
    "Verdict",
    "Way",
    "ask",
    "asked_properties",
    "befell",
    "confirm",
    "free_readings",
    "judge",
    "ready_properties",
    "take_apart",
    "told",
    "variables_asked",
]
