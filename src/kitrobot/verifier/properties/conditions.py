"""Conditions over several agents: LLL in which each test names its agents, `any carrier-1 (Sign.EqualTo(3))`.

`any`, `all` and `most` are those of team programs. A name is an agent's, a program's (all agents that run it), a role's
or a group's (all agents that play it or belong to it at that moment). The interpreter evaluates the test in the
brackets on what that agent reads and stores (`sim.breakpoints.Condition`); this module evaluates *and*, *or*, *not* and
counting.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.lll.parse_results import parse_team
from kitrobot.lll.tree import And, Call, Condition, Conditional, Hole, Joint, Not, Or
from kitrobot.lll.walk import nodes
from kitrobot.mission.model import Team
from kitrobot.primitives.robot import Robot
from kitrobot.sim.breakpoints import Condition as Test
from kitrobot.sim.breakpoints import ConditionError
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import did_you_mean


class PropertyError(KitRobotError):
    """A condition of a property cannot be parsed, or names something that does not exist."""


class Member(NamedTuple):
    """An agent as conditions name it."""

    name: str
    program: str
    robot: Robot


Truth = Callable[[int, str], bool]
"""Whether a test, as text, holds for the agent of that number."""
Members = Callable[[str], Collection[int]]
"""The numbers of the agents that are in a role or a group."""


class _TestedAgents(NamedTuple):
    """The agents that a test names: agents by number, roles and groups (`sets`) by name.

    `own` are the agents that the declaration allows in those sets; `others` may join them, since a robot may be moved
    from one group to another.
    """

    agents: tuple[int, ...]
    sets: tuple[str, ...]
    own: tuple[int, ...]
    others: tuple[int, ...]


def _nobody(name: str) -> Collection[int]:
    return ()


@dataclass(frozen=True)
class AgentCondition:
    """A parsed condition whose names are resolved to agents.

    Attributes:
        text: the condition.
        tests: for each test, as text, the numbers of the agents that it is evaluated for.
        names: for each test, the parts of the robot that it names.
        sets: the roles and groups that it names.
    """

    text: str
    tests: dict[str, tuple[int, ...]]
    names: dict[str, frozenset[str]]
    _condition: Condition
    _tested: dict[int, _TestedAgents]

    @property
    def sets(self) -> frozenset[str]:
        return frozenset(name for named in self._tested.values() for name in named.sets)

    def holds(self, truth: Truth, members: Members = _nobody) -> bool:
        """Whether the condition holds."""
        return self._holds(self._condition, truth, members)

    def is_concerned(self, truth: Truth, members: Members = _nobody) -> bool:
        """Whether the condition is relevant: one of several conjuncts holds; a single one always is."""
        parts = list(_conjuncts(self._condition))
        return len(parts) == 1 or any(self._holds(part, truth, members) for part in parts)

    def _holds(self, one: Condition, truth: Truth, members: Members) -> bool:
        match one:
            case And():
                return self._holds(one.left, truth, members) and self._holds(one.right, truth, members)
            case Or():
                return self._holds(one.left, truth, members) or self._holds(one.right, truth, members)
            case Not():
                return not self._holds(one.condition, truth, members)
            case Joint():
                named, test = self._tested[one.start], _test_of(self.text, one)
                agents = dict.fromkeys([*named.agents, *(agent for name in named.sets for agent in members(name))])
                if one.quantifier == "all":
                    return all(truth(agent, test) for agent in agents)
                if one.quantifier == "any":
                    return any(truth(agent, test) for agent in agents)
                return 2 * sum(truth(agent, test) for agent in agents) > len(agents)
        raise AssertionError("other conditions were refused")


def parse_condition(text: str, team: Sequence[Member], declared: Team | None = None) -> AgentCondition:
    """Parses a condition and resolves its names.

    Args:
        text: the condition.
        team: the agents.
        declared: the mission's team, if its robots run a team program: its roles and groups can be named too.

    Raises:
        PropertyError: the text is no condition, a test names no agent, or a name does not exist.
    """
    whole = f"[{text}](WAIT(1));"
    parsed = parse_team(whole, "condition")
    items = parsed.program.seq.items
    first = next((item for item in parsed.diagnostics if item.is_error), None)
    if first is not None:
        raise PropertyError(first.message, first.help or _USUAL)
    if not text.strip() or len(items) != 1 or not isinstance(items[0], Conditional) or items[0].orelse is not None:
        raise PropertyError(Sentence("`{condition}` is no condition", text), _USUAL)
    condition = items[0].condition
    bound = AgentCondition(text, {}, {}, condition, {})
    for joint in _joints(condition):
        named, test = _named(joint, team, declared), _test_of(text, joint)
        for robot in {team[agent].robot.name: team[agent].robot for agent in (*named.agents, *named.own)}.values():
            try:
                Test(test, robot)
            except ConditionError as error:
                raise PropertyError(error.message, error.help) from None
        others = [agent for agent in named.others if _understands(team[agent].robot, test)]
        bound._tested[joint.start] = named
        agents = (*bound.tests.get(test, ()), *named.agents, *named.own, *others)
        bound.tests[test] = tuple(dict.fromkeys(agents))
        bound.names[test] = frozenset(node.object for node in nodes(joint.condition) if isinstance(node, Call))
    return bound


_USUAL = Sentence("write one like any carrier-1 (Cargo.IsPressed()) & any carrier-2 (Sign.EqualTo(3))")


def _test_of(text: str, joint: Joint) -> str:
    """The text between the brackets of a test; the condition was read with one sign before it."""
    return text[joint.condition.start - 1 : joint.condition.end - 1]


def _conjuncts(one: Condition) -> Iterator[Condition]:
    if isinstance(one, And):
        yield from _conjuncts(one.left)
        yield from _conjuncts(one.right)
    else:
        yield one


def _joints(one: Condition) -> Iterator[Joint]:
    match one:
        case And() | Or():
            yield from _joints(one.left)
            yield from _joints(one.right)
        case Not():
            yield from _joints(one.condition)
        case Joint():
            if any(isinstance(node, Joint) for node in nodes(one.condition)):
                raise PropertyError(Sentence("a test of agents stands inside another one"), _USUAL)
            yield one
        case Call():
            message = Sentence("`{object}.{method}` does not say whose it is", one.object, one.method)
            raise PropertyError(message, Sentence("write any carrier-1 (…) around it, with the agent that is meant"))
        case Hole():
            raise PropertyError(Sentence("a condition has no holes"), _USUAL)


def _understands(robot: Robot, test: str) -> bool:
    try:
        Test(test, robot)
    except ConditionError:
        return False
    return True


def _named(joint: Joint, team: Sequence[Member], declared: Team | None) -> _TestedAgents:
    """The agents that a test names."""
    assert not isinstance(joint.members, Hole), "a program has no holes"
    found: dict[int, None] = {}
    own: dict[int, None] = {}
    others: dict[int, None] = {}
    sets: dict[str, None] = {}
    roles = {role.name: role.robot for role in declared.roles} if declared is not None else {}
    groups = {group.name for group in declared.groups} if declared is not None else set()
    for name in joint.members.names:
        agents = [at for at, one in enumerate(team) if one.name == name]
        agents = agents or [at for at, one in enumerate(team) if one.program == name]
        if agents:
            found.update(dict.fromkeys(agents))
        elif declared is not None and (name in roles or name in groups):
            sets[name] = None
            own.update(dict.fromkeys(_declared(name, team, declared)))
            # A role is a group too where somebody is moved into it.
            others.update({at: None for role in roles for at in _declared(role, team, declared)})
        else:
            known = dict.fromkeys(
                [*(one.name for one in team), *(one.program for one in team), *roles, *sorted(groups)]
            )
            help: Help = did_you_mean(name, known) or Sentence("it has: {names}", listed(known))
            raise PropertyError(Sentence("`{name}` is no agent of this team, and no program of one", name), help)
    return _TestedAgents(tuple(found), tuple(sets), tuple(own), tuple(others))


def _declared(name: str, team: Sequence[Member], declared: Team) -> set[int]:
    """The agents that may play a role, or be in a group as declared."""
    found: set[int] = set()
    waiting, seen = [name], set()
    while waiting:
        one = waiting.pop()
        if one in seen:
            continue
        seen.add(one)
        found |= {at for at, member in enumerate(team) if member.name == one}
        kinds = {role.robot for role in declared.roles if role.name == one}
        found |= {at for at, member in enumerate(team) if member.robot.name in kinds}
        for group in declared.groups:
            if group.name == one:
                waiting += group.members.names
    return found
