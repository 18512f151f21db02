"""How a run ends, and why, in a sentence.

*done*: all goals of the mission hold, whoever failed on the way; without goals, every program has ended. *failed*:
every program has ended and a goal does not hold; or nobody is left to go on. *time*: the time given ran out. *stuck*:
nothing can ever change again; said only when it is certain (deadlock_detection).

Goals are judged when the run comes to an end of its own: every program has ended, nobody is left to go on, nothing can
change any more, the time is over, or every program has ended but those of robots that failed, stalled or lost their
radio. They are not judged before, for a goal may hold for a moment on the way to another stock. A sentence names who
failed, stalled or lost its radio.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from kitrobot.sim.physics.bodies import WorldState
from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables.columns import DOWN, ENDED, LEFT, MUTED, ORIGIN, WELL
from kitrobot.sim.tables.state import numbers
from kitrobot.sim.tables.team_columns import T_SILENT
from kitrobot.text.phrases import all_of
from kitrobot.text.sentences import SEMICOLON, Recorded, Series

Outcome = Literal["done", "failed", "stuck", "time"]

AT_ONCE_S = 0.1
"""A run that ends before this came to its end at once."""

SHOWN = 5
"""Agents that a sentence names."""


class Goals:
    """The mission's goals against the stock; `rows`: the numbers of storehouses, and how many boxes each is to hold."""

    def __init__(self, rows: Sequence[Sequence[int]], stage: WorldState) -> None:
        self._stage = stage
        self._names = [house.name for house in stage.world.storehouses]
        self._goals = [(self._names[house], int(house), int(wanted)) for house, wanted in zip(*rows, strict=True)]

    def __bool__(self) -> bool:
        return bool(self._goals)

    def hold(self) -> bool:
        """Whether every goal is reached."""
        return all(self._stage.stock[house] == wanted for _, house, wanted in self._goals)

    def say(self) -> str:
        """`B holds 7 of 12 boxes` for each goal; "" without goals."""
        return list_names([self._said(name, self._stage.stock[house], wanted) for name, house, wanted in self._goals])

    def describe_full_storehouses(self, agents: Sequence[Agent]) -> str:
        """The storehouses in which arms wait for room; "" for none."""
        if not self._names:
            return ""
        waited_for = dict.fromkeys(agent.full_house for agent in agents)
        return list_names(
            [Recorded("storehouse {storehouse} is full", self._names[house]) for house in waited_for if house >= 0]
        )

    def _said(self, name: str, stock: int, wanted: int) -> str:
        if stock > wanted:
            return Recorded.counted(
                "{name} holds {count} box instead of {wanted}",
                "{name} holds {count} boxes instead of {wanted}",
                name,
                stock,
                wanted,
            )
        if wanted == 1 and stock < wanted:
            return Recorded("{name} does not hold its box", name)
        if stock < wanted:
            return Recorded("{name} holds {stock} of {wanted} boxes", name, stock, wanted)
        if 1 < wanted == self._stage.total:
            return Recorded("{name} holds all {wanted} boxes", name, wanted)
        return Recorded.counted("{name} holds {count} box", "{name} holds {count} boxes", name, stock)


def describe_done(goals: Goals, seconds: float, agents: Sequence[Agent]) -> str:
    """All goals hold; or there are none, and every program has ended."""
    ending = goals.say() or _all_ended(seconds, agents)
    what = _joined(ending, _lost_boxes(agents), _driving(agents), _left(agents))
    lost = _casualties(agents)
    if not lost and not all(agent.ended for agent in agents):
        lost = _unfinished(agents)
    return (
        Recorded("Done after {seconds} s, although {lost}: {what}.", f"{seconds:.1f}", lost, what)
        if lost
        else Recorded("Done after {seconds} s: {what}.", f"{seconds:.1f}", what)
    )


def _all_ended(seconds: float, agents: Sequence[Agent]) -> str:
    if is_at_once(seconds, agents):
        return _at_once(agents)
    if all(agent.ended for agent in agents):
        return Recorded("every program has ended")
    return Recorded("every other program has ended")


def describe_failed(goals: Goals, agents: Sequence[Agent]) -> str:
    """Every program that could has ended, and some goal does not hold or somebody failed."""
    why = _joined(
        _casualties(agents), goals.say(), goals.describe_full_storehouses(agents), _lost_boxes(agents), _left(agents)
    )
    if all(agent.ended for agent in agents):
        return Recorded("Every program has ended, but {why}.", _joined(why, _driving(agents)))
    if any(agent.ended for agent in agents):
        return Recorded("Every other program has ended, but {why}.", why)
    return Recorded("Nobody is left to go on: {why}.", why)


def describe_team_over(why: str, goals: Goals, agents: Sequence[Agent]) -> str:
    """The team cannot go on; `why` says for what reason."""
    return Recorded(
        "The team cannot go on: {why}.",
        _joined(why, _casualties(agents), goals.say(), _lost_boxes(agents), _left(agents)),
    )


def describe_timeout(goals: Goals, seconds: float, agents: Sequence[Agent]) -> str:
    """The time ran out."""
    why = (
        *(goals.say() or _unfinished(agents), _casualties(agents), goals.describe_full_storehouses(agents)),
        *(_lost_boxes(agents), _left(agents)),
    )
    return Recorded("The time of {seconds} s ran out: {why}.", f"{seconds:g}", _joined(*why))


def describe_stuck(goals: Goals, agents: Sequence[Agent], missing: Sequence[str] = ()) -> str:
    """Nothing can change any more; `missing` says of a team who waits for whom."""
    names = [agent.name for agent in agents if not agent.ended and agent.down == WELL]
    if missing:
        waiting = _joined(*missing[:SHOWN])
    elif not names:
        waiting = ""
    elif len(names) == 1:
        waiting = Recorded("{name} waits for something that will not come", names[0])
    else:
        waiting = Recorded("{names} wait for something that will not come", list_names(names))
    why = (
        waiting,
        goals.describe_full_storehouses(agents),
        _casualties(agents),
        goals.say(),
        _lost_boxes(agents),
        _left(agents),
    )
    return Recorded("Nothing can change any more: {why}.", _joined(*why))


def _unfinished(agents: Sequence[Agent]) -> str:
    """How many programs go on."""
    running = len(agents) - len(_agents_with(ENDED, agents))
    if len(agents) == 1:
        return Recorded("the program had not ended")
    return Recorded.counted(
        "{count} of {all} programs had not ended", "{count} of {all} programs had not ended", running, len(agents)
    )


def _casualties(agents: Sequence[Agent]) -> str:
    """Who failed, stalled or lost its radio before its program had ended, when and why; "" for nobody."""
    suffering = _not_well(agents)
    return list_names([fault_text for agent in suffering if not agent.ended and (fault_text := agent.fault_text)])


def is_at_once(seconds: float, agents: Sequence[Agent]) -> bool:
    """Whether all programs ended before time passed, so that nothing could be seen."""
    return seconds < AT_ONCE_S and all(agent.ended for agent in agents)


def _at_once(agents: Sequence[Agent]) -> str:
    if len(agents) == 1:
        return Recorded("the program came to its end at once, without a part that takes time")
    return Recorded("every program came to its end at once, without a part that takes time")


def _driving(agents: Sequence[Agent]) -> str:
    """Whose motors go on after its program has ended; "" for nobody's."""
    names = [agent.name for agent in agents if agent.ended and agent.is_driving]
    if len(names) == 1:
        return Recorded("{name} ended with its motors on", names[0])
    return Recorded("{names} ended with their motors on", list_names(names)) if names else ""


def _left(agents: Sequence[Agent]) -> str:
    """Who is beyond the edge of the world; "" for nobody."""
    names = [agent.name for agent in _agents_with(LEFT, agents) if agent.is_outside]
    return Recorded("{names} left the world, which has no wall there", list_names(names)) if names else ""


def _lost_boxes(agents: Sequence[Agent]) -> str:
    """Whose boxes are lost; "" for nobody's."""
    names = [agent.name for agent in _agents_with(ORIGIN, agents) if agent.lost_its_box]
    if len(names) == 1:
        return Recorded("the box of {name} is lost", names[0])
    return Recorded("the boxes of {names} are lost", list_names(names)) if names else ""


def _agents_with(column: int, agents: Sequence[Agent]) -> list[Agent]:
    """Those of whom a number of `robots.ints` is not 0: of most columns nobody, which is looked up at once."""
    row = numbers(agents[0].state.robots.ints[column]) if agents else []
    return [agent for agent in agents if row[agent.index]] if any(row) else []


def _not_well(agents: Sequence[Agent]) -> Sequence[Agent]:
    """All of whom a fault could be told: nobody where nothing befell anybody."""
    silent = numbers(agents[0].state.team.robots[T_SILENT]) if agents else []
    has_fault = _agents_with(DOWN, agents) or _agents_with(MUTED, agents) or any(since >= 0 for since in silent)
    return agents if has_fault else ()


def _joined(*clauses: str) -> str:
    """The clauses that say something, one after another."""
    return Series(SEMICOLON, filter(None, clauses))


def list_names(names: Sequence[str]) -> str:
    """`a`, `a and b`, `a, b and c`: the first few of them."""
    shown = list(names[:SHOWN])
    if len(names) > SHOWN:
        shown.append(Recorded("{count} more", len(names) - SHOWN))
    return all_of(shown)
