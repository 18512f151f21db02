"""What a property remembers of a run of the model, state by state: the one place that follows a single run.

A memory is what the history of the property comes to (see `properties.History`), and for each condition that a run may
wait under for ever whether it waits now. Searches of a whole state space do the same for all states at once
(`fair_cycles`, `histories`).
"""

from __future__ import annotations

from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.properties.properties import (
    BROKEN,
    KEPT,
    AgentFact,
    Condition,
    Fact,
    Property,
    SensedCondition,
    SharedFact,
)
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.state_decoding import decode, sense_key

Memory = tuple[int, ...]
"""What the history comes to, and 1 for each condition of waiting under which the run waits, else 0."""


class PropertyMemory:
    """Follows a property along runs of a model; `after` returns None where a step breaks it.

    A standstill and a wait in vain are no matter of one step: a run that only comes to one is not broken here.
    """

    def __init__(self, model: Model, one: Property) -> None:
        self._model = model
        self._one = one
        self._kinds = sum(1 << kind for kind in one.broken_by)
        self._waits = () if one.waits is None else (one.waits, *one.also_waits)
        self._known: dict[tuple[int, State], bool] = {}
        self._sensed: dict[tuple[int, tuple[int, ...]], bool] = {}

    @property
    def waits(self) -> int:
        """The number of conditions of waiting."""
        return len(self._waits)

    def first(self, state: State) -> Memory | None:
        """The memory in the first state; None if that breaks the property."""
        one = self._one
        if one.never is not None and self.holds(one.never, state):
            return None
        history = self._history(0, None, state)
        if history == BROKEN:
            return None
        waits = (
            self.holds(wait, state) and (one.since is None or self.holds(one.since, state)) for wait in self._waits
        )
        return history, *map(int, waits)

    def after(self, memory: Memory, before: State, kinds: int, state: State) -> Memory | None:
        """The memory after a step; None if the step breaks the property.

        Args:
            memory: the memory before the step.
            before: the state before it.
            kinds: the kinds of its events, as bits.
            state: the state after it.
        """
        one = self._one
        if kinds & self._kinds or (one.never is not None and self.holds(one.never, state)):
            return None
        if one.breaks is not None and self.holds(one.breaks[0], before) and self.holds(one.breaks[1], state):
            return None
        history = self._history(memory[0], before, state)
        if history == BROKEN:
            return None
        return history, *(
            int(self.holds(wait, state) and (bool(was) or self._begins(state)))
            for wait, was in zip(self._waits, memory[1:], strict=True)
        )

    def _begins(self, state: State) -> bool:
        """Whether waiting that begins in a state counts."""
        one = self._one
        return not one.from_start and (one.since is None or self.holds(one.since, state))

    def _history(self, memory: int, before: State | None, state: State) -> int:
        history = self._one.history
        if history is None or memory == KEPT:
            return memory
        now = tuple(self.holds(condition, state) for condition in history.conditions)
        was = now if before is None else tuple(self.holds(condition, before) for condition in history.conditions)
        comes = now if before is None else tuple(one and not had for one, had in zip(now, was, strict=True))
        return history.step(memory, now, comes)

    def holds(self, condition: Condition, state: State) -> bool:
        """Whether a condition holds in a state."""
        key = id(condition), state
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = self._decide(condition, state)
        return found

    def _decide(self, condition: Condition, state: State) -> bool:
        if not isinstance(condition, SensedCondition):
            return any(all(self._is_true(fact, state) for fact in clause) for clause in condition)
        model = self._model
        decode(model.t, *model.layout.key(state))
        keys = [int(sense_key(model.t, i)) for i in condition.agents]
        sensed = (*keys, state[0]) if condition.reads_shared else tuple(keys)
        found = self._sensed.get((id(condition), sensed))
        if found is None:
            found = self._sensed[id(condition), sensed] = condition.test(sensed)
        return found

    def _is_true(self, fact: Fact, state: State) -> bool:
        model = self._model
        if isinstance(fact, SharedFact):
            return fact.test(model.shareds()[state[0]])
        if isinstance(fact, AgentFact):
            return fact.test(model.inside(fact.agent, state[1 + fact.agent]))
        road, fixed = model.roads.of[fact.agent], model.t.fixed
        row = state[1 + model.count + road] * int(fixed[v.CONF_WIDTH])
        return any(
            bool(int(model.t.confs[row + v.C_STAND + dock]) >> fact.agent & 1)
            for dock in fact.docks
            if model.roads.of_dock[dock] == road
        )
