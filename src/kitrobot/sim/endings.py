"""How a run ends, and why, in a sentence.

*done*: every program has ended and every goal holds. *failed*: every program has ended and a goal does not hold.
*time*: the time given ran out. *stuck*: nothing can ever change again; said only when it is certain (standstill).
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.mission import ALL, Goal
from kitrobot.sim.agents import Agent
from kitrobot.sim.bodies import Stage


class Goals:
    """The mission's goals against the stock."""

    def __init__(self, goals: Sequence[Goal], stage: Stage) -> None:
        self._stage = stage
        names = [house.name for house in stage.world.storehouses]
        self._goals = [
            (goal.storehouse, names.index(goal.storehouse), stage.total if goal.stock == ALL else int(goal.stock))
            for goal in goals
        ]

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


def say_done(goals: Goals, seconds: float) -> str:
    """Every program has ended and every goal holds."""
    return f"Done after {seconds:.1f} s: {goals.say() or 'every program has ended'}."


def say_failed(goals: Goals) -> str:
    """Every program has ended and some goal does not hold."""
    return f"Every program has ended, but {goals.say()}."


def say_time(goals: Goals, seconds: float, agents: Sequence[Agent]) -> str:
    """The time ran out."""
    running = sum(not agent.ended for agent in agents)
    rest = goals.say() or f"{running} of {len(agents)} programs had not ended"
    return f"The time of {seconds:g} s ran out: {rest}."


def say_stuck(goals: Goals, agents: Sequence[Agent]) -> str:
    """Nothing can change any more."""
    waiting = [agent.name for agent in agents if not agent.ended]
    shown = ", ".join(waiting[:5]) + (f" and {len(waiting) - 5} more" if len(waiting) > 5 else "")
    rest = f" {goals.say()}." if goals.say() else ""
    return f"Nothing can change any more: {shown} wait for something that will not come.{rest}"
