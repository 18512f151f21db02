"""A three-way merge of two people's edits of one mission, by programs, named parts and values.

Changes of only one side are taken; the programs of both are merged by `program_merge`. Where both changed the same part
differently, ours stays unless theirs was chosen, and a sentence reports it. A part that one side renamed keeps the new
name in the other side's edits (`renames`). So the result is always a mission that opens. Left to others: whether its
parts fit together (workspace), where the sentences are written.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

from kitrobot.graph.model import Program
from kitrobot.mission.model import Agent, Goal, Mission, Team
from kitrobot.mission.trial import Breakpoint, Failure
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.own_xml import OwnVariable
from kitrobot.text.sentences import Sentence, Word
from kitrobot.versions.conflicts import Conflict, Decisions
from kitrobot.versions.lists import merged_by_name, merged_nameless, merged_order, merged_values
from kitrobot.versions.own_parts import breakpoint_title, failure_title
from kitrobot.versions.own_worlds import merge_places
from kitrobot.versions.program_merge import merge_programs
from kitrobot.versions.renames import with_one_name


@dataclass(frozen=True)
class MergeResult:
    """What became of it, and what both changed differently."""

    mission: Mission
    clashes: tuple[Conflict, ...] = ()

    @property
    def conflicts(self) -> tuple[str, ...]:
        """A sentence for each."""
        return tuple(one.sentence for one in self.clashes)


def merge_missions(base: Mission, ours: Mission, theirs: Mission, taken: Collection[str] = ()) -> MergeResult:
    """The mission with both sides' edits of `base`; `taken` are the names of conflicts in which theirs is taken."""
    if theirs in (base, ours):
        return MergeResult(ours)
    if ours == base:
        return MergeResult(theirs)
    decisions = Decisions(taken)
    choose = decisions.choose
    base, ours, theirs = with_one_name(base, ours, theirs, decisions)
    fresh: dict[tuple[str, str], str] = {}
    programs = _programs(base, ours, theirs, decisions, fresh)
    theirs = replace(theirs, breakpoints=[_at_fresh(one, fresh) for one in theirs.breakpoints])
    sides = (base, ours, theirs)
    teams = tuple(side.team for side in sides)
    agents = merged_by_name(*_lists(teams, "agents"), _agent_name, Sentence("the agent"), choose)
    _bring_back(programs, agents, (ours, theirs), decisions)
    goals = merged_by_name(*_lists(teams, "goals"), _goal_name, Sentence("the goal of"), choose)
    own = _named_parts(sides, decisions)
    for what in ("unknown", "prolog"):
        own[what] = list(merged_nameless(*_lists(sides, what)))
    own["attributes"] = merged_values(
        Sentence("the mission"), base.attributes, ours.attributes, theirs.attributes, choose
    )
    rest = {
        field.name: choose(
            Sentence("the {field} of the mission", Word(field.name)),
            getattr(base, field.name),
            getattr(ours, field.name),
            getattr(theirs, field.name),
        )
        for field in fields(Mission)
        if field.name not in ("programs", "team", "world_href", "own_world", *own)
    }
    href, own["own_world"] = merge_places(base, ours, theirs, choose)
    team = Team(agents, goals)
    for what, word in (
        ("roles", Sentence("the role")),
        ("groups", Sentence("the group")),
        ("works", Sentence("the work")),
    ):
        setattr(team, what, merged_by_name(*_lists(teams, what), _declared, word, choose))
    mission = Mission(programs=programs, team=team, world_href=href, **own, **rest)
    _report_lost_breakpoints(mission, (ours, theirs), decisions)
    return MergeResult(mission, tuple(decisions.found))


def _lists(sides: Iterable[Any], what: str) -> tuple[Any, Any, Any]:
    """A list of `base`, `ours` and `theirs`."""
    base, ours, theirs = (getattr(side, what) for side in sides)
    return base, ours, theirs


def _named_parts(sides: Iterable[Mission], decisions: Decisions) -> dict[str, Any]:
    """What a mission has beside programs, team and world, and that has names."""
    named: tuple[tuple[str, Callable[[Any], Hashable], Sentence, Callable[[Any], Sentence] | None], ...] = (
        ("constructors", _own_name, Sentence("the own part"), None),
        ("breakpoints", _breakpoint_name, Sentence("the breakpoint at"), breakpoint_title),
        ("failures", _failure_name, Sentence("the failure of"), failure_title),
        ("properties", _declared, Sentence("the property"), None),
        ("variables", _own_name, Sentence("the variable"), None),
    )
    return {
        what: merged_by_name(*_lists(sides, what), name_of, word, decisions.choose, title_of)
        for what, name_of, word, title_of in named
    }


def _at_fresh(breakpoint: Breakpoint, fresh: Mapping[tuple[str, str], str]) -> Breakpoint:
    """A breakpoint where its vertex is, by the program and the id that it had: that may be another now."""
    id = fresh.get((breakpoint.program, breakpoint.vertex))
    return breakpoint if id is None else replace(breakpoint, vertex=id)


def _report_lost_breakpoints(mission: Mission, sides: Iterable[Mission], decisions: Decisions) -> None:
    """Breakpoints of programs that are gone, which they were not where the breakpoint comes from."""
    have = {program.name for program in mission.programs}
    lost = [one for one in mission.breakpoints if one.program not in have]
    known = [({program.name for program in side.programs}, set(side.breakpoints)) for side in sides]
    for one in lost:
        if not any(one in breakpoints and one.program not in programs for programs, breakpoints in known):
            title = breakpoint_title(one)
            words = Sentence("{what} was set in one, and the other removed the program: nothing pauses there", title)
            decisions.report(title, words)


def _bring_back(
    programs: list[Program], agents: Sequence[Agent], sides: Iterable[Mission], decisions: Decisions
) -> None:
    """Programs that one side removed and that the other's agents run."""
    have = {program.name for program in programs}
    for side in sides:
        known = {program.name: program for program in reversed(side.programs)}
        for name in dict.fromkeys(agent.program for agent in agents):
            found = known.get(name)
            if found is not None and name not in have:
                programs.append(found)
                have.add(name)
                words = Sentence(
                    "the program {program} was removed in one and runs on an agent of the other: it is kept", name
                )
                decisions.report(Sentence("the program {program}", name), words)


def _agent_name(agent: Agent) -> Hashable:
    return agent.name


def _goal_name(goal: Goal) -> Hashable:
    return goal.storehouse


def _declared(declaration: Any) -> Hashable:
    name: str = declaration.name
    return name


def _breakpoint_name(breakpoint: Breakpoint) -> Hashable:
    return (breakpoint.program, breakpoint.vertex, breakpoint.agents)


def _failure_name(failure: Failure) -> Hashable:
    return (failure.agent, failure.at_s)


def _own_name(own: Constructor | OwnVariable) -> str:
    return own.name if isinstance(own, Constructor) else f"{own.robot}.{own.variable.name}"


def _programs(
    base: Mission, ours: Mission, theirs: Mission, decisions: Decisions, fresh: dict[tuple[str, str], str]
) -> list[Program]:
    """The programs; `fresh` is told, by program and id, which of their vertices have another id now."""
    old, mine, other = ({program.name: program for program in side.programs} for side in (base, ours, theirs))
    found: list[Program] = []
    for name in merged_order(old, mine, other):
        one, two, three = old.get(name), mine.get(name), other.get(name)
        if two is not None and three is not None:
            start = one or Program(two.name, two.target, level=two.level)
            found.append(merge_programs(start, two, three, decisions, fresh))
        elif two is not None:
            if two != one and (one is None or not _goes(two.name, decisions)):
                found.append(two)
        elif three is not None and three != one and (one is None or _comes_back(name, decisions)):
            found.append(three)
    return list({program.name: program for program in reversed(found)}.values())[::-1]


def _goes(name: str, decisions: Decisions) -> bool:
    """Whether a program goes that they removed and we changed."""
    return decisions.takes(
        Sentence("the program {program}", name),
        Sentence("the program {program} was removed by them and changed by us: ours is kept", name),
        Sentence("the program {program} was removed by them and changed by us: it is removed", name),
    )


def _comes_back(name: str, decisions: Decisions) -> bool:
    """Whether a program is back that we removed and they changed."""
    return decisions.takes(
        Sentence("the program {program}", name),
        Sentence("the program {program} was removed by us and changed by them: ours is kept", name),
        Sentence("the program {program} was removed by us and changed by them: theirs is taken", name),
    )
