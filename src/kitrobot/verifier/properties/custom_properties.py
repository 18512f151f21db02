"""Custom properties of a mission, in the four forms of its `<property>` elements.

A condition holds in a state if it holds for the values that the agents would read and store there. The same values come
up in many states, so each answer of the interpreter is cached. In a run of the simulator the values are those of the
agents' last tick.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from kitrobot.mission.model import Team
from kitrobot.mission.property_forms import AskedProperty, Form
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
from kitrobot.verifier.properties.properties import Property, SensedCondition
from kitrobot.verifier.properties.ready_monitors import RunMonitor, waited_long_enough
from kitrobot.verifier.properties.run_conditions import (
    AgentValuation,
    RunConditions,
    declared_of,
    members_in_set,
    team_of,
)


def property_variables(run: Simulation, properties: Iterable[AskedProperty]) -> set[str]:
    """The names of the variables in properties; see `abstract_run`."""
    team = team_of(run)
    found: set[str] = set()
    for _, conditions, _ in _understood(properties, team, declared_of(run)):
        for one in conditions:
            found.update(*one.names.values())
    return found


def build_custom_properties(model: Model, properties: Sequence[AskedProperty]) -> tuple[list[Property], list[Sentence]]:
    """Builds the custom properties of a mission; also returns why some of them are left out."""
    found: list[Property] = []
    left_out: list[Sentence] = []
    for one, conditions, error in _understood(properties, team_of(model.run), declared_of(model.run)):
        try:
            if error is not None:
                raise error
            found.append(_property(model, one, conditions))
        except PropertyError as wrong:
            left_out.append(Sentence("the property {name} is left out: {reason}", one.name, wrong.message))
    return found, left_out


def _understood(
    properties: Iterable[AskedProperty], team: Sequence[Member], declared: Team | None
) -> Iterator[tuple[AskedProperty, list[AgentCondition], PropertyError | None]]:
    for one in properties:
        try:
            yield one, [parse_condition(text, team, declared) for _, text in one.conditions], None
        except PropertyError as error:
            yield one, [], error


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
    conditions = [_ModelCondition(model, condition) for condition in parsed]
    first, second = conditions[0], conditions[-1]

    def monitor(run: Simulation) -> RunMonitor:
        return _ConditionMonitor(one.form, parsed, run)

    match one.form:
        case Form.NEVER:
            return Property(
                one.name, one.words, never=first.holds, concerned=first.when(parsed[0].is_concerned), monitor=monitor
            )
        case Form.EVENTUALLY:
            return Property(one.name, one.words, waits=_not(first.holds), from_start=True, monitor=monitor)
        case Form.AFTER:
            return Property(
                one.name, one.words, waits=_not(second.holds), since=first.holds, concerned=first.holds, monitor=monitor
            )
        case Form.STAYS:
            closed = _not(second.holds)
            return Property(
                one.name,
                one.words,
                breaks=(_both(first.holds, closed), _both(_not(first.holds), closed)),
                concerned=first.holds,
                monitor=monitor,
            )


def build_run_property(one: AskedProperty, run: Simulation, within_s: float | None = None) -> Property:
    """Builds a property that is judged by its `monitor` alone, on runs of this mission with any seed.

    Sensors may be free, since a run reads them.

    Args:
        one: the property.
        run: a run of the mission.
        within_s: in how many simulated seconds the second condition is to follow the first one (*after … eventually*);
            None: for any, judged as `waited_long_enough` says.

    Raises:
        PropertyError: a condition cannot be parsed, or names something that does not exist.
    """
    parsed = [parse_condition(text, team_of(run), declared_of(run)) for _, text in one.conditions]
    within = None if within_s is None else int(within_s * 1000 / run.tick_ms + 1e-9)
    return Property(one.name, one.words, monitor=lambda run: _ConditionMonitor(one.form, parsed, run, within))


def _not(one: SensedCondition) -> SensedCondition:
    return SensedCondition(one.agents, lambda keys: not one.test(keys), one.reads_shared)


def _both(one: SensedCondition, other: SensedCondition) -> SensedCondition:
    size = len(one.agents)

    def holds(keys: tuple[int, ...]) -> bool:
        # The last key is what is shared, where that is conditions for; else nobody looks at it.
        return one.test((*keys[:size], *keys[-1:])) and other.test(keys[size:])

    return SensedCondition((*one.agents, *other.agents), holds, one.reads_shared or other.reads_shared)


class _ConditionMonitor:
    """Monitors a custom property in a run of the simulator; `within` how many steps a second condition is to follow."""

    def __init__(
        self, form: Form, conditions: Sequence[AgentCondition], run: Simulation, within: int | None = None
    ) -> None:
        self._form = form
        self._conditions = conditions
        self._run = run
        self._decided = RunConditions(conditions, run)
        self._waits_since = 0 if form is Form.EVENTUALLY else -1
        self._stayed = False
        self._within = within

    def after_step(self) -> bool:
        first, second = self._holds(self._conditions[0]), self._holds(self._conditions[-1])
        match self._form:
            case Form.NEVER:
                return first
            case Form.EVENTUALLY:
                self._waits_since = -1 if first or self._waits_since < 0 else self._waits_since
            case Form.AFTER:
                if second:
                    self._waits_since = -1
                elif first and self._waits_since < 0:
                    self._waits_since = self._run.tick
                return self._is_late()
            case Form.STAYS:
                broken = self._stayed and not first and not second
                self._stayed = first and not second
                return broken
        return False

    def _is_late(self) -> bool:
        return self._within is not None and 0 <= self._waits_since < self._run.tick - self._within

    def at_end(self) -> bool:
        if self._waits_since < 0 or (self._within is not None and self._run.outcome == "time"):
            return False
        return waited_long_enough(self._run, self._waits_since)

    def _holds(self, condition: AgentCondition) -> bool:
        return self._decided.holds(condition)
