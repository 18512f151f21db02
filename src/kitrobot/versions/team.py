"""What is different between two teams, in words."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import fields

from kitrobot.lll.printer import print_declaration
from kitrobot.mission.model import Agent, Goal, Team
from kitrobot.text.sentences import Sentence, Word


def team_differences(before: Team, after: Team) -> Iterator[tuple[str, Sentence]]:
    """The kind of each difference, and its words."""
    yield from _agents(before.agents, after.agents)
    yield from _goals(before.goals, after.goals)
    yield from _declarations(before, after)


def _agents(before: Sequence[Agent], after: Sequence[Agent]) -> Iterator[tuple[str, Sentence]]:
    old, new = {agent.name: agent for agent in before}, {agent.name: agent for agent in after}
    for name in old:
        if name not in new:
            yield ("agent-removed", Sentence("the team: {agent} removed", name))
    for name, agent in new.items():
        was = old.get(name)
        if was is None:
            yield ("agent-added", Sentence("the team: {agent} added, runs {program}", name, agent.program))
            continue
        for field in fields(Agent):
            one, other = getattr(was, field.name), getattr(agent, field.name)
            if one != other:
                yield (
                    "agent",
                    Sentence(
                        "the team: the {field} of {agent}: {before} → {after}",
                        Word(field.name),
                        name,
                        one or Word("none"),
                        other or Word("none"),
                    ),
                )
    if list(before) != list(after) and old == new:
        yield ("order", Sentence("the team: its agents stand in another order"))


def _goals(before: Sequence[Goal], after: Sequence[Goal]) -> Iterator[tuple[str, Sentence]]:
    had, has = {(goal.storehouse, goal.stock) for goal in before}, {(goal.storehouse, goal.stock) for goal in after}
    for goal in before:
        if (goal.storehouse, goal.stock) not in has:
            yield (
                "goal-removed",
                Sentence("the goals: {storehouse} holds {stock} removed", goal.storehouse, goal.stock),
            )
    for goal in after:
        if (goal.storehouse, goal.stock) not in had:
            yield ("goal-added", Sentence("the goals: {storehouse} holds {stock} added", goal.storehouse, goal.stock))
    if list(before) != list(after) and had == has:
        yield ("order", Sentence("the goals stand in another order"))


def _declarations(before: Team, after: Team) -> Iterator[tuple[str, Sentence]]:
    """Roles, groups and works: each as the line that a team's program declares it by."""
    for what in ("roles", "groups", "works"):
        rows = [{one.name: one for one in getattr(team, what)} for team in (before, after)]
        old, new = rows
        for name in old:
            if name not in new:
                yield ("declaration-removed", Sentence("the team: `{line}` removed", print_declaration(old[name])))
        for name, one in new.items():
            if name not in old:
                yield ("declaration-added", Sentence("the team: `{line}` added", print_declaration(one)))
            elif one != old[name]:
                lines = print_declaration(old[name]), print_declaration(one)
                if lines[0] == lines[1]:
                    yield ("note", Sentence("the team: the comment of `{line}` changed", lines[0]))
                else:
                    yield ("declaration", Sentence("the team: `{before}` → `{after}`", *lines))
        if old == new and list(old) != list(new):
            yield ("order", Sentence("the team: its {parts} stand in another order", Word(what)))
