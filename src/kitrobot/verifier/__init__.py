"""Checks missions: explores a discrete model of agents and world, and decides properties on its states.

Programs are tables that the interpreter itself fills (`programs`). The discrete world (`roads`, `motion`, `traffic`) is
made from the numbers of a run (`abstraction`). Every verdict names the assumption about time that it was found under
(`timing`).
"""

from kitrobot.verifier.abstraction import Abstraction, abstract_run
from kitrobot.verifier.budget import Budget, CutReason
from kitrobot.verifier.conditions import AgentCondition, Member, PropertyError, parse_condition
from kitrobot.verifier.counterexample_text import describe_run, free_readings
from kitrobot.verifier.custom_properties import build_custom_properties, property_variables
from kitrobot.verifier.model import Model
from kitrobot.verifier.programs import AbstractionError
from kitrobot.verifier.properties import Property, ready_properties
from kitrobot.verifier.replay import ConfirmedRun, InjectedFault, confirm, injected_faults
from kitrobot.verifier.table_builder import KINDS, USUAL_KINDS
from kitrobot.verifier.timing import Timing
from kitrobot.verifier.verdicts import Answer, CheckResult, Counterexample, Verdict, check_properties

__all__ = [
    "KINDS",
    "USUAL_KINDS",
    "Abstraction",
    "AbstractionError",
    "AgentCondition",
    "Answer",
    "Budget",
    "CheckResult",
    "ConfirmedRun",
    "Counterexample",
    "CutReason",
    "InjectedFault",
    "Member",
    "Model",
    "Property",
    "PropertyError",
    "Timing",
    "Verdict",
    "abstract_run",
    "build_custom_properties",
    "check_properties",
    "confirm",
    "describe_run",
    "free_readings",
    "injected_faults",
    "parse_condition",
    "property_variables",
    "ready_properties",
]
