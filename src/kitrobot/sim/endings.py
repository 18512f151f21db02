"""How a run ends, and why, in a sentence.

*done*: every program has ended and every goal holds. *failed*: every program has ended and a goal does not hold; or
nobody is left to go on. When there are goals and they hold, a robot that failed on the way does not matter: what was
to be done is done. The sentence names who failed or stalled.
*time*: the time given ran out. *stuck*: nothing can ever change again; said only when it is certain (standstill).
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.mission import ALL, Goal
from kitrobot.sim.agents import Agent
from kitrobot.sim.bodies import Stage
from kitrobot.sim.columns import WELL

SHOWN = 5
"""Agents that a sentence names."""


class Goals:
    """The mission's goals against the stock."""

    def __init__(self, goals: Sequence[Goal], stage: Stage) -> None:
        self._stage = stage
        names = [house.name for house in stage.world.storehouses]
        self._goals = [
            (goal.storehouse, names.index(goal.storehouse), stage.total if goal.stock == ALL else int(goal.stock))
            for goal in goals
        ]

    def __bool__(self) -> bool:
        return bool(self._goals)

    def hold(self) -> bool:
        """Whether every goal is reached."""
        return all(self._stage.stock[house] == wanted for _, house, wanted in self._goals)

    def say(self) -> str:
        """`B holds 7 of 12 boxes` for each goal; "" without goals."""
        parts = []
        for name, house, wanted in self._goals:
            stock = self._stage.stock[house]
            boxes = "box" if wanted == 1 else "boxes"
            if stock == wanted:
                parts.append(f"{name} holds {'all ' if wanted == self._stage.total else ''}{wanted} {boxes}")
            else:
                parts.append(f"{name} holds {stock} of {wanted} {boxes}")
        return " and ".join(parts)


def say_done(goals: Goals, seconds: float, agents: Sequence[Agent]) -> str:
    """Every program that could has ended and every goal holds."""
    what, lost = goals.say() or "every program has ended", _casualties(agents)
    return f"Done after {seconds:.1f} s, although {lost}: {what}." if lost else f"Done after {seconds:.1f} s: {what}."


def say_failed(goals: Goals, agents: Sequence[Agent]) -> str:
    """Every program that could has ended, and some goal does not hold or somebody failed."""
    lost, rest = _casualties(agents), goals.say()
    if not lost:
        return f"Every program has ended, but {rest}."
    if any(agent.ended for agent in agents):
        if rest:
            return f"Every other program has ended, but {lost}; {rest}."
        return f"Every other program has ended, but {lost}."
    return f"Nobody is left to go on: {lost}; {rest}." if rest else f"Nobody is left to go on: {lost}."


def say_time(goals: Goals, seconds: float, agents: Sequence[Agent]) -> str:
    """The time ran out."""
    running = sum(not agent.ended for agent in agents)
    rest = goals.say() or f"{running} of {len(agents)} programs had not ended"
    lost = _casualties(agents)
    if lost:
        return f"The time of {seconds:g} s ran out: {rest}; {lost}."
    return f"The time of {seconds:g} s ran out: {rest}."


def say_stuck(goals: Goals, agents: Sequence[Agent]) -> str:
    """Nothing can change any more."""
    waiting = _listed([agent.name for agent in agents if not agent.ended and agent.down == WELL])
    lost, goal = _casualties(agents), goals.say()
    if not lost:
        rest = f" {goal}." if goal else ""
        return f"Nothing can change any more: {waiting} wait for something that will not come.{rest}"
    if not waiting:
        return f"Nothing can change any more: {lost}; {goal}." if goal else f"Nothing can change any more: {lost}."
    if goal:
        return f"Nothing can change any more: {waiting} wait for something that will not come; {lost}; {goal}."
    return f"Nothing can change any more: {waiting} wait for something that will not come; {lost}."


def _casualties(agents: Sequence[Agent]) -> str:
    """Who failed or stalled before its program had ended, when and why; "" for nobody."""
    return _listed([agent.downfall for agent in agents if agent.down != WELL and not agent.ended])


def _listed(names: Sequence[str]) -> str:
    """The first few of them."""
    return ", ".join(names[:SHOWN]) + (f" and {len(names) - SHOWN} more" if len(names) > SHOWN else "")
