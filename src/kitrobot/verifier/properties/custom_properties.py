"""Custom properties of a mission, in the forms of its `<property>` elements.

A condition holds in a state if it holds for the values that the agents would read and store there. The same values come
up in many states, so each answer of the interpreter is cached. In a run of the simulator the values are those of the
agents' last tick, or of its beginning (`run_conditions`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from copy import deepcopy
from dataclasses import replace

from kitrobot.mission.model import Team
from kitrobot.mission.property_forms import LISTS, AskedProperty, Form, VisitOrder
from kitrobot.mission.property_text import list_mistake
from kitrobot.sim.breakpoints import Condition as Test
from kitrobot.sim.devices.base import Discrete
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.properties.conditions import (
    AgentCondition,
    Member,
    Members,
    PropertyError,
    Truth,
    parse_condition,
)
from kitrobot.verifier.properties.properties import BROKEN, KEPT, History, Property, SensedCondition
from kitrobot.verifier.properties.property_automaton import (
    PropertyAutomaton,
    PropertyState,
    visit_in_order,
    visit_in_turn,
)
from kitrobot.verifier.properties.ready_monitors import waited_long_enough
from kitrobot.verifier.properties.run_conditions import (
    AgentValuation,
    declared_of,
    members_in_set,
    simulated_conditions,
    team_of,
)


def property_variables(run: Simulation, properties: Iterable[AskedProperty]) -> set[str]:
    """The names of the variables in properties; see `abstract_run`."""
    found: set[str] = set()
    for one in properties:
        # One that cannot be understood names nothing; whoever builds it says why.
        with suppress(PropertyError):
            for condition in parse_conditions(one, team_of(run), declared_of(run)):
                found.update(*condition.names.values())
    return found


def build_custom_properties(model: Model, properties: Sequence[AskedProperty]) -> tuple[list[Property], list[Sentence]]:
    """Builds the custom properties of a mission; also returns why some of them are left out."""
    found: list[Property] = []
    left_out: list[Sentence] = []
    for one in properties:
        try:
            found.append(build_custom_property(model, one))
        except PropertyError as wrong:
            left_out.append(Sentence("the property {name} is left out: {reason}", one.name, wrong.message))
    return found, left_out


def build_custom_property(model: Model, one: AskedProperty) -> Property:
    """Builds a custom property.

    Raises:
        PropertyError: a check cannot decide it, a condition cannot be parsed, or names something that does not exist.
    """
    return _property(model, one, parse_conditions(one, team_of(model.run), declared_of(model.run)))


class _ModelCondition:
    """Evaluates a condition on states of a model."""

    def __init__(self, model: Model, condition: AgentCondition) -> None:
        self._model = model
        self._condition = condition
        self._tests = {
            (agent, test): Test(test, model.parts[agent].agent.robot)
            for test, agents in condition.tests.items()
            for agent in agents
        }
        self._known: dict[tuple[int, str, int], bool] = {}
        self._sets: dict[tuple[str, int], tuple[int, ...]] = {}
        for test, agents in condition.tests.items():
            for agent in agents:
                self._expect_known(agent, condition.names[test])

    def _expect_known(self, agent: int, names: Iterable[str]) -> None:
        part = self._model.parts[agent]
        for sensor, sense in zip(part.agent.robot.sensors, part.senses, strict=False):
            if sensor.name in names and sense.discrete is Discrete.ANY:
                raise PropertyError(
                    Sentence("{sensor} of {agent} may read anything at any time", sensor.name, part.agent.name),
                    Sentence("ask for what a robot reads of roads, docks and storehouses, or for a variable"),
                )

    def when(self, wanted: Callable[[Truth, Members], bool]) -> SensedCondition:
        """The states in which a predicate over the tests of agents holds."""
        agents = tuple(sorted({agent for agents in self._condition.tests.values() for agent in agents}))

        def holds(keys: tuple[int, ...]) -> bool:
            return wanted(
                self._truths(dict(zip(agents, keys, strict=False))), lambda name: self._in_set(name, keys[-1])
            )

        return SensedCondition(agents, holds, bool(self._condition.sets))

    def _in_set(self, name: str, shared: int) -> tuple[int, ...]:
        """The agents that are in a role or a group in a shared state."""
        known = self._sets.get((name, shared))
        if known is None:
            model = self._model
            assert model.agreement is not None, "only a team has roles and groups"
            tables = model.agreement.tables(model.agreed(model.shareds()[shared]))
            known = self._sets[name, shared] = members_in_set(model.run, tables, name)
        return known

    @property
    def holds(self) -> SensedCondition:
        """The states in which the condition holds."""
        return self.when(self._condition.holds)

    def _truths(self, keys: Mapping[int, int]) -> Truth:
        return lambda agent, test: self._truth(agent, test, keys.get(agent, 0))

    def _truth(self, agent: int, test: str, key: int) -> bool:
        if (agent, test) not in self._tests:
            return False  # It lacks a part that other members of its group have.
        known = self._known.get((agent, test, key))
        if known is None:
            mind = AgentValuation(self._model.cells(agent, key))
            known = self._known[agent, test, key] = self._tests[agent, test].holds(mind)
        return known


def _property(model: Model, one: AskedProperty, parsed: Sequence[AgentCondition]) -> Property:
    if one.counts_seconds:
        raise PropertyError(
            Sentence("it counts seconds, and the states of a check have none"),
            Sentence("ask it of runs (`kitrobot judge --by runs`), of failures or of a recording"),
        )
    conditions = [_ModelCondition(model, condition) for condition in parsed]
    holds = [condition.holds for condition in conditions]
    first, second = holds[0], holds[-1]
    asked = Property(one.name, one.words, monitor=lambda run: _ConditionMonitor(one, parsed, run))
    match one.form:
        case Form.NEVER if one.second:
            return replace(asked, never=_both(first, second), concerned=_either(first, second))
        case Form.NEVER:
            return replace(asked, never=first, concerned=conditions[0].when(parsed[0].is_concerned))
        case Form.EVENTUALLY:
            return replace(asked, waits=_not(first), from_start=True)
        case Form.AFTER:
            return replace(asked, waits=_not(second), since=first, concerned=first)
        case Form.STAYS:
            closed = _not(second)
            return replace(asked, breaks=(_both(first, closed), _both(_not(first), closed)), concerned=first)
        case Form.AT_MOST:
            return replace(asked, history=History((first,), one.times + 1, _counts(one.times)), concerned=first)
        case Form.BEFORE:
            return replace(asked, history=History((first, second), 1, _comes_first), concerned=_either(first, second))
        case Form.AGAIN:
            return replace(asked, waits=_not(first), also_waits=tuple(map(_not, holds[1:])))
        case Form.VISIT:
            visits = replace(asked, waits=_not(first), also_waits=tuple(map(_not, holds[1:])), from_start=True)
            if one.order is VisitOrder.ANY:
                return visits
            step = _in_order if one.order is VisitOrder.GIVEN else _in_turn
            return replace(visits, history=History(tuple(holds), len(holds), step))
    raise AssertionError("the form of a property with seconds was refused")


def _counts(times: int) -> Callable[[int, tuple[bool, ...], tuple[bool, ...]], int]:
    """The step of a history in which the condition comes at most so many times."""

    def step(memory: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> int:
        return BROKEN if memory + comes[0] > times else memory + comes[0]

    return step


def _comes_first(memory: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> int:
    return KEPT if now[0] else BROKEN if now[1] else memory


def _in_order(memory: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> int:
    visited = visit_in_order(memory, now)
    return KEPT if visited == len(now) else visited if visited >= 0 else BROKEN


def _in_turn(memory: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> int:
    following, _ = visit_in_turn(memory, comes)
    return following if following >= 0 else BROKEN


def build_run_property(one: AskedProperty, run: Simulation) -> Property:
    """Builds a property that is judged by its `monitor` alone, on runs of this mission with any seed.

    Sensors may be free, since a run reads them.

    Args:
        one: the property.
        run: a run of the mission.

    Raises:
        PropertyError: a condition cannot be parsed, or names something that does not exist.
    """
    parsed = parse_conditions(one, team_of(run), declared_of(run))
    return Property(one.name, one.words, monitor=lambda run: _ConditionMonitor(one, parsed, run))


def parse_conditions(one: AskedProperty, team: Sequence[Member], declared: Team | None) -> list[AgentCondition]:
    """The conditions of a property, in their order.

    Raises:
        PropertyError: its list has a mistake, a condition cannot be parsed, or names something that does not exist.
    """
    mistake = list_mistake(one) if one.form in LISTS else None
    if mistake is not None:
        raise PropertyError(*mistake)
    return [parse_condition(text, team, declared) for _, text in one.conditions]


def _not(one: SensedCondition) -> SensedCondition:
    return SensedCondition(one.agents, lambda keys: not one.test(keys), one.reads_shared)


def _both(one: SensedCondition, other: SensedCondition) -> SensedCondition:
    size = len(one.agents)

    def holds(keys: tuple[int, ...]) -> bool:
        # The last key is what is shared, where that is conditions for; else nobody looks at it.
        return one.test((*keys[:size], *keys[-1:])) and other.test(keys[size:])

    return SensedCondition((*one.agents, *other.agents), holds, one.reads_shared or other.reads_shared)


def _either(one: SensedCondition, other: SensedCondition) -> SensedCondition:
    return _not(_both(_not(one), _not(other)))


class _ConditionMonitor:
    """Monitors a custom property in a run of the simulator, which is before its first step."""

    def __init__(self, one: AskedProperty, conditions: Sequence[AgentCondition], run: Simulation) -> None:
        self._conditions = conditions
        self._run = run
        self._decided = simulated_conditions(conditions, run)
        self._decided.keep_beginning()
        self._automaton = PropertyAutomaton(one, run.tick_ms)

    @property
    def is_kept(self) -> bool:
        return self._automaton.standing is PropertyState.KEPT

    @property
    def is_decided_at_beginning(self) -> bool:
        return self._automaton.decided_at == 0

    @property
    def is_vacuous(self) -> bool:
        return not self._automaton.came_up

    def after_step(self) -> bool:
        if self._run.tick == 1:
            self._automaton.read(0, [self._decided.held_at_beginning(condition) for condition in self._conditions])
        truths = [self._decided.holds(condition) for condition in self._conditions]
        return self._automaton.read(self._run.tick, truths) is PropertyState.BROKEN

    def at_end(self, outcome: str) -> bool:
        automaton = self._automaton
        if not automaton.is_broken_by_end() or (automaton.deadline is not None and outcome == "time"):
            return False
        return waited_long_enough(outcome, self._run.tick, automaton.waits_since)

    def memory(self) -> PropertyAutomaton:
        return deepcopy(self._automaton)

    def remember(self, memory: PropertyAutomaton) -> None:
        self._automaton = deepcopy(memory)
