"""The properties that a check decides: the ready ones that fit a mission's devices.

A property of *safety* is broken by one event or one state. A property of *liveness* is broken by a run that goes on for
ever, or stands still for ever, without the expected event.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from kitrobot.mission.breakdown import BreakdownRule
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.sim.tables.team_columns import HAS_UNIT
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.model import Model, SharedState
from kitrobot.verifier.properties.ready_monitors import (
    ENDS_IN_VAIN,
    RunMonitor,
    loose_action_monitor,
    loss_monitor,
    meeting_monitor,
    service_monitor,
)
from kitrobot.verifier.tables.bodies import FAILED, RUNS, Inside
from kitrobot.verifier.tables.events import SWINGS, EventKind
from kitrobot.verifier.tables.motion import Move


@dataclass(frozen=True)
class SharedFact:
    """A condition on the shared state: boxes, shared variables and failures."""

    test: Callable[[SharedState], bool]


@dataclass(frozen=True)
class AgentFact:
    """A condition on the state of an agent except its motion."""

    agent: int
    test: Callable[[Inside], bool]


@dataclass(frozen=True)
class DockFact:
    """The condition that an agent with a bed stands in one of these docks."""

    agent: int
    docks: tuple[int, ...]


@dataclass(frozen=True)
class SensedCondition:
    """A condition on a state by what some agents read and store there, as their keys (`state_decoding.sense_key`).

    If it `reads_shared`, the number of the shared state follows the keys.
    """

    agents: tuple[int, ...]
    test: Callable[[tuple[int, ...]], bool]
    reads_shared: bool = False


Fact = SharedFact | AgentFact | DockFact
"""A condition on one component of a state."""
Condition = tuple[tuple[Fact, ...], ...] | SensedCondition
"""A condition on a state: all facts of one of these clauses, or a condition on sensed values."""


BROKEN, KEPT = -1, -2
"""What a history comes to that breaks a property, and one that no step can break any more."""


@dataclass(frozen=True)
class History:
    """A property of safety that depends on what came before.

    Attributes:
        conditions: what it is about.
        size: how many memories there are; the first one, before any state, is 0.
        step: the memory after a state, `BROKEN` or `KEPT`; of the memory before it, of which conditions hold in it, and
            of which of them did not hold in the state before.
    """

    conditions: tuple[Condition, ...]
    size: int
    step: Callable[[int, tuple[bool, ...], tuple[bool, ...]], int]


@dataclass(frozen=True)
class Property:
    """One property.

    Attributes:
        name: its name on the command line, in lower-case letters with hyphens.
        sentence: what it demands.
        broken_by: the events that break it.
        is_wrong: whether a state breaks it that nothing leaves, or from which on nothing happens (see `standstill`);
            None for one that no state breaks.
        waits: whether a state waits for what is to come; of liveness only. A run that waits for ever breaks it.
        also_waits: more such conditions, each by itself.
        from_start: whether only waiting since the first state counts.
        about, concerned: the events, or states, that the property is about; where none comes up, it is vacuous. Without
            both it always is in question.
        never: what breaks it in any state.
        breaks: what must hold before, and after, a step that breaks it.
        history: what breaks it by what came before.
        since: from which states on waiting counts; of liveness only. None: from any, but see `from_start`.
        monitor: starts a monitor of a run of the simulator, which is before its first step, if its events do not decide
            whether it breaks the property.
        seen_as: the events of the simulator (see `sim.tables.columns`) that break it.
        ends_as: the outcomes of a run of the simulator that break it; with a monitor, those with which it may break it.
        spares_teams: whether the end of a team that gave up, and says why, does not break it.
    """

    name: str
    sentence: Sentence
    broken_by: frozenset[Move | EventKind] = frozenset()
    is_wrong: Condition | None = None
    waits: Condition | None = None
    also_waits: tuple[Condition, ...] = ()
    from_start: bool = False
    about: frozenset[Move | EventKind] = frozenset()
    concerned: Condition | None = None
    never: Condition | None = None
    breaks: tuple[Condition, Condition] | None = None
    history: History | None = None
    since: Condition | None = None
    monitor: Callable[[Simulation], RunMonitor] | None = None
    seen_as: tuple[int, ...] = ()
    ends_as: tuple[str, ...] = ()
    spares_teams: bool = False

    @property
    def keeps_steps(self) -> bool:
        """Whether judging it needs the steps between states."""
        return any(one is not None for one in (self.waits, self.breaks, self.is_wrong, self.history))


_CONTACT = Property(
    "contact",
    Sentence("no robot drives into another one on its road"),
    broken_by=frozenset({Move.TOUCH}),
    seen_as=(c.COLLISION,),
    about=frozenset({Move.CLOSER, Move.TOUCH}),
)
_EMPTY_STOREHOUSE = Property(
    "empty-storehouse",
    Sentence("no arm reaches into an empty storehouse"),
    broken_by=frozenset({EventKind.NO_BOX}),
    seen_as=(c.NO_BOX,),
    about=frozenset(SWINGS),
)
_EMPTY_SWING = Property(
    "empty-swing",
    Sentence("no arm moves without a carrier that it can load or unload"),
    broken_by=frozenset({EventKind.NO_EMPTY_CARRIER, EventKind.NO_LOADED_CARRIER}),
    seen_as=(c.NO_EMPTY_CARRIER, c.NO_LOADED_CARRIER),
    about=frozenset(SWINGS),
)


def ready_properties(model: Model) -> list[Property]:
    """The properties that fit a mission."""
    found = []
    if any(len(agents) > 1 for agents in model.roads.agents):
        found.append(_CONTACT)
    if any(act.is_arm for part in model.parts for act in part.acts):
        found += [_EMPTY_STOREHOUSE, _EMPTY_SWING]
    found += _stock(model)
    found.append(
        Property(
            "deadlock",
            Sentence("the mission never comes to a standstill before it is done"),
            is_wrong=_not_done(model),
            ends_as=("stuck", "failed"),
            spares_teams=True,
        )
    )
    if model.goals:
        found.append(
            Property(
                "delivered",
                Sentence("in the end every goal is reached"),
                waits=_goals_missed(model),
                from_start=True,
                ends_as=("stuck", "failed", "time"),
            )
        )
    found += [_served(model, i) for i in _carriers(model)]
    found += _meetings(model)
    found += _stopped(model)
    if model.goals and all(part.table.may_end or part.is_spare for part in model.parts):
        found.append(
            Property(
                "end",
                Sentence("in the end every program ends"),
                waits=_somebody_goes_on(model),
                from_start=True,
                ends_as=ENDS_IN_VAIN,
            )
        )
    return found


def _carriers(model: Model) -> list[int]:
    """The agents that can stand in a dock with an arm."""
    arms = {act.dock for part in model.parts for act in part.acts if act.is_arm}
    return [i for beds in model.roads.beds for i in beds] if arms else []


def _served(model: Model, i: int) -> Property:
    """The property that agent i, once in a dock, is loaded or unloaded, drives on, or ends."""
    arms = tuple(sorted({act.dock for part in model.parts for act in part.acts if act.is_arm}))
    name = model.parts[i].agent.name
    stands: Condition = ((AgentFact(i, lambda inside: not model.has_ended(i, inside)), DockFact(i, arms)),)
    return Property(
        f"served-{name}",
        Sentence("{agent} does not wait in a dock for ever", name),
        waits=stands,
        concerned=stands,
        monitor=lambda run: service_monitor(run, name, arms),
        ends_as=ENDS_IN_VAIN,
    )


def _stock(model: Model) -> list[Property]:
    """The property that no program loses a box or a unit of work: a robot that failed still holds what it held.

    An arm moves a box from a storehouse to a carrier in one moment, or back, so no program can lose one. Where robots
    that fail are towed, which is not in the model, their boxes go back, if there is room.
    """
    carriers, agreement = _carriers(model), model.agreement
    if model.failures and model.run.mission.breakdown.rule is BreakdownRule.TOW:
        carriers = []
    units = (
        [] if agreement is None else [(i, at) for i in range(model.count) for at in agreement.units(_robot(model, i))]
    )
    if not carriers and not units:
        return []
    in_question: list[tuple[Fact, ...]] = [(AgentFact(i, lambda inside: inside.load > 0),) for i in carriers]
    in_question += [(_has_unit(model, at),) for _, at in units]
    return [
        Property(
            "stock",
            Sentence("no box and no unit of work is lost or appears twice"),
            never=tuple((_has_ended(model, i), _has_unit(model, at)) for i, at in units) or None,
            concerned=tuple(in_question),
            monitor=loss_monitor,
        )
    ]


def _meetings(model: Model) -> list[Property]:
    """The properties that each member of a team that waits at a point of its program continues eventually."""
    agreement = model.agreement
    if agreement is None or not agreement.has_meetings:
        return []
    members = [
        i for i, part in enumerate(model.parts) if part.is_member and not (part.is_spare and model.absence is None)
    ]
    return [_meets(model, i) for i in members]


def _meets(model: Model, i: int) -> Property:
    assert model.agreement is not None
    name, at = model.parts[i].agent.name, model.agreement.waits(_robot(model, i))
    runs = AgentFact(i, lambda inside: inside.down == RUNS and not model.has_ended(i, inside))
    waits = (runs, SharedFact(lambda shared: model.agreed(shared)[at] >= 0), *_needed(model, i))
    return Property(
        f"meets-{name}",
        Sentence("{agent} does not wait for its team for ever", name),
        waits=(waits,),
        concerned=(waits,),
        monitor=lambda run: meeting_monitor(run, name),
    )


def _stopped(model: Model) -> list[Property]:
    """The property that everything a marked action started has stopped when its program ends (see `stops`)."""
    agents = [i for i, part in enumerate(model.parts) if part.table.machine.image.stops and part.table.may_end]
    if not agents:
        return []
    return [
        Property(
            "stopped",
            Sentence("what a marked action started stands when its program has ended"),
            never=tuple((_has_ended(model, i), AgentFact(i, lambda inside: inside.loose > 0)) for i in agents),
            concerned=tuple((_has_ended(model, i),) for i in agents),
            monitor=loose_action_monitor,
        )
    ]


def _robot(model: Model, i: int) -> int:
    """The number of agent i in the run."""
    return model.parts[i].agent.index


def _has_ended(model: Model, i: int) -> AgentFact:
    """That the program of agent i has ended, and the agent has not failed."""
    return AgentFact(i, lambda inside: inside.down != FAILED and model.has_ended(i, inside))


def _has_unit(model: Model, at: int) -> SharedFact:
    return SharedFact(lambda shared: model.agreed(shared)[at] == HAS_UNIT)


def _goals_missed(model: Model) -> Condition:
    return ((SharedFact(lambda shared: not model.goals_hold(shared)),),)


def _somebody_goes_on(model: Model) -> Condition:
    """That the program of an agent has not ended, which its team, if it misses members, still needs."""
    return tuple((_goes_on(model, i), *_needed(model, i)) for i in range(model.count))


def _needed(model: Model, i: int) -> list[Fact]:
    """That the team has not given up, and agent i plays a role if it is of the team; nothing where nobody is missed."""
    absence, robot = model.absence, model.parts[i].agent.index
    if absence is None:
        return []
    return [
        _has_not_given_up(model),
        SharedFact(lambda shared: not absence.takes_no_part(model.agreed(shared), robot)),
    ]


def _has_not_given_up(model: Model) -> SharedFact:
    absence = model.absence
    return SharedFact(lambda shared: absence is None or not absence.gave_up(model.agreed(shared)))


def _goes_on(model: Model, i: int) -> AgentFact:
    return AgentFact(i, lambda inside: not model.has_ended(i, inside))


def _not_done(model: Model) -> Condition:
    """That a state which nothing leaves is not one that the mission was to come to."""
    if not model.goals:
        return _somebody_goes_on(model)
    missed = SharedFact(lambda shared: not model.goals_hold(shared))
    return ((missed,),) if model.absence is None else ((missed, _has_not_given_up(model)),)
