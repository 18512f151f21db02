"""Checks missions: explores what can happen in a discrete model of agents and world, and judges properties by it.

The model's programs are tables that the interpreter itself fills (`programs`). The world is made discrete (`roads`,
`motion`, `traffic`) from the numbers of a run (`parts`). Every verdict names the assumption about time under which it
was found (`timing`).
"""

from kitrobot.verifier.asked import asked_properties, variables_asked
from kitrobot.verifier.budget import Budget, Cut
from kitrobot.verifier.building import KINDS, USUAL_KINDS
from kitrobot.verifier.conditions import Asked, Member, PropertyError, ask
from kitrobot.verifier.judging import Answer, Judged, Verdict, Way, judge
from kitrobot.verifier.model import Model
from kitrobot.verifier.parts import Parts, take_apart
from kitrobot.verifier.programs import AbstractionError
from kitrobot.verifier.properties import Property, ready_properties
from kitrobot.verifier.replay import Confirmed, Harm, befell, confirm
from kitrobot.verifier.telling import free_readings, told
from kitrobot.verifier.timing import Timing

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
