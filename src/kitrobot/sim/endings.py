"""How a run ends, and why, in a sentence.

*done*: every program has ended and every goal holds. *failed*: every program has ended and a goal does not hold.
*time*: the time given ran out. *stuck*: nothing can ever change again; said only when it is certain, which it is when
the whole state of the run (machines, wires, nothing moving, nothing on its way) comes back as it was and nothing in
it is left to chance: from the same state follows the same future. States are compared with one that is kept and taken
anew at ever longer distances (Brent's way to find a cycle), so a program that only polls is found out too, whatever
its period.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from kitrobot.mission import ALL, Goal
from kitrobot.sim.agents import Agent
from kitrobot.sim.devices import Stage

QUIET_STEPS = 50
"""Steps without motion or command before it is worth while to look for a standstill."""


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


class Standstill:
    """Finds out that nothing can ever change again."""

    def __init__(self, agents: Sequence[Agent]) -> None:
        self._agents = agents
        self._cycle = math.lcm(*(agent.period for agent in agents))
        self._quiet = 0
        self._kept: list[Any] | None = None
        self._distance = 0
        self._until = 1
        self._chance: bool | None = None

    def stirred(self) -> None:
        """Something moved or was said: the search begins anew."""
        self._quiet = 0
        self._kept = None
        self._chance = None

    def is_certain(self, step: int) -> bool:
        """Called once a step in which nothing stirred: whether the state has come back."""
        self._quiet += 1
        if self._quiet < QUIET_STEPS or step % self._cycle:
            return False
        if self._chance is None:
            self._chance = any(wire.noisy for agent in self._agents for wire in agent.sensors)
        if self._chance:
            return False
        state = self._state()
        if self._kept is None or self._distance >= self._until:
            self._until = 1 if self._kept is None else 2 * self._until
            self._distance = 0
            self._kept = state
            return False
        self._distance += 1
        return state == self._kept

    def _state(self) -> list[Any]:
        agents = [agent for agent in self._agents if not agent.ended]
        return [(agent.machine.snapshot(), [wire.state() for wire in agent.sensors]) for agent in agents]
