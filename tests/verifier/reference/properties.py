"""What is asked of a mission: ready properties that fit its devices.

A property of *safety* is broken by one event or one state. A property of *liveness* is broken by a run that goes on for
ever, or stands still for ever, without what was to come.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from kitrobot.sim.tables import columns as c
from kitrobot.text.sentences import Sentence
from tests.verifier.reference.events import SWINGS, EventKind
from tests.verifier.reference.model import Model, State
from tests.verifier.reference.motion import Move


@dataclass(frozen=True)
class Property:
    """One property.

    Attributes:
        name: its name on the command line, in lower-case letters with hyphens.
        sentence: what it demands.
        broken_by: the events that break it.
        is_wrong: whether a state, which nothing leaves, breaks it; None for one that no state breaks.
        waits: whether a state waits for what is to come; of liveness only. A run that waits for ever breaks it.
        from_start: whether only waiting since the first state counts.
        about, concerned: the events, or states, that the property is about; where none comes up, it is vacuous. Without
            both it always is in question.
        seen_as: the events of the simulator (see `sim.tables.columns`) that break it.
        ends_as: the outcomes of a run of the simulator that break it.
    """

    name: str
    sentence: Sentence
    broken_by: frozenset[Move | EventKind] = frozenset()
    is_wrong: Callable[[State], bool] | None = None
    waits: Callable[[State], bool] | None = None
    from_start: bool = False
    about: frozenset[Move | EventKind] = frozenset()
    concerned: Callable[[State], bool] | None = None
    seen_as: tuple[int, ...] = ()
    ends_as: tuple[str, ...] = ()


def ready_properties(model: Model) -> list[Property]:
    """The properties that fit a mission."""
    found = []
    if any(len(road.agents) > 1 for road in model.traffic):
        found.append(
            Property(
                "contact",
                Sentence("no robot drives into another one on its road"),
                broken_by=frozenset({Move.TOUCH}),
                seen_as=(c.COLLISION,),
                about=frozenset({Move.CLOSER, Move.TOUCH}),
            )
        )
    if any(act.is_arm for part in model.parts for act in part.acts):
        found.append(
            Property(
                "empty-storehouse",
                Sentence("no arm reaches into an empty storehouse"),
                broken_by=frozenset({EventKind.NO_BOX}),
                seen_as=(c.NO_BOX,),
                about=frozenset(SWINGS),
            )
        )
        found.append(
            Property(
                "empty-swing",
                Sentence("no arm moves without a carrier that it can load or unload"),
                broken_by=frozenset({EventKind.NO_EMPTY_CARRIER, EventKind.NO_LOADED_CARRIER}),
                seen_as=(c.NO_EMPTY_CARRIER, c.NO_LOADED_CARRIER),
                about=frozenset(SWINGS),
            )
        )
    found.append(
        Property(
            "deadlock",
            Sentence("the mission never comes to a standstill before it is done"),
            is_wrong=lambda state: not _is_done(model, state),
            ends_as=("stuck", "failed"),
        )
    )
    if model.goals:
        found.append(
            Property(
                "delivered",
                Sentence("in the end every goal is reached"),
                waits=lambda state: not model.goals_hold(state),
                from_start=True,
                ends_as=("stuck", "failed", "time"),
            )
        )
    found += [_served(model, i) for i in _carriers(model)]
    if model.goals and all(part.table.may_end for part in model.parts):
        found.append(
            Property(
                "end",
                Sentence("in the end every program ends"),
                waits=lambda state: not _all_ended(model, state),
                from_start=True,
                ends_as=("stuck", "time"),
            )
        )
    return found


def _carriers(model: Model) -> list[int]:
    """The agents that can stand in a dock with an arm."""
    arms = {act.dock for part in model.parts for act in part.acts if act.is_arm}
    return [i for road in model.traffic for i in road.beds] if arms else []


def _served(model: Model, i: int) -> Property:
    """That agent i, where it stands in a dock, is loaded or unloaded, drives on, or ends."""
    arms = sorted({act.dock for part in model.parts for act in part.acts if act.is_arm})
    name = model.parts[i].agent.name

    def stands(state: State) -> bool:
        return not model.ended(state, i) and any(i in model.standing_in(state, dock) for dock in arms)

    return Property(
        f"served-{name}",
        Sentence("{agent} does not wait in a dock for ever", name),
        waits=stands,
        concerned=stands,
        ends_as=("stuck", "time"),
    )


def _all_ended(model: Model, state: State) -> bool:
    return all(model.ended(state, i) for i in range(model.count))


def _is_done(model: Model, state: State) -> bool:
    """Whether a state that nothing leaves is one that the mission was to come to."""
    return model.goals_hold(state) if model.goals else _all_ended(model, state)
