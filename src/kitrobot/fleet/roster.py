"""`Roster`: which process speaks for each agent of a run. One name is one process, from the first hello to the end.

A process draws a number for itself and sends it in each message. A second process of one name waits for as long as
silence is borne: when the first one is heard all that time, both live, and the second one is refused; when the first
one is silent, the second one takes its place. What was refused or replaced once stays out, so that a recorded hello
takes nobody's place. The time is given to all methods, in ms.
"""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass, field
from enum import Enum

MOST_RIVALS = 8
"""Processes of one name that may wait."""
MOST_OUT = 64
"""Processes of one name that are remembered as refused or replaced."""


class Answer(Enum):
    """What comes of a hello: its process is the first of its name, takes another's place, is known already, is to wait,
    or is refused.
    """

    COMES = 0
    REPLACES = 1
    KNOWN = 2
    WAITS = 3
    REFUSED = 4


@dataclass(slots=True)
class Place:
    """The process of one name.

    Attributes:
        process: its number; 0: nobody came yet.
        life: how many processes of this name took part in the run before.
        heard_at: when it was heard last.
        rivals: other processes that wait, and since when.
        out: those that were refused or replaced.
    """

    process: int = 0
    life: int = 0
    heard_at: int = 0
    rivals: dict[int, int] = field(default_factory=dict)
    out: OrderedDict[int, None] = field(default_factory=OrderedDict)

    def leave_out(self, process: int) -> None:
        """Excludes a process for good."""
        self.rivals.pop(process, None)
        self.out[process] = None
        if len(self.out) > MOST_OUT:
            self.out.popitem(last=False)


class Roster:
    """The processes of so many agents; `silence` is borne, in ms."""

    def __init__(self, agents: int, silence: int) -> None:
        self.places = [Place() for _ in range(agents)]
        self.silence = silence

    def hello(self, now: int, agent: int, process: int, begun: bool) -> Answer:
        """Registers a process as an agent. One that takes a place in a run that has `begun` has another life."""
        place = self.places[agent]
        if process in place.out:
            return Answer.REFUSED
        if place.process == 0:
            place.process, place.heard_at = process, now
            return Answer.COMES
        if place.process == process:
            place.heard_at = now
            return Answer.KNOWN
        if now - place.heard_at >= self.silence:
            place.leave_out(place.process)
            place.rivals.pop(process, None)
            place.process, place.heard_at = process, now
            place.life += begun
            return Answer.REPLACES
        since = place.rivals.setdefault(process, now)
        if place.heard_at - since < self.silence and len(place.rivals) <= MOST_RIVALS:
            return Answer.WAITS
        place.leave_out(process)
        return Answer.REFUSED

    def heard(self, now: int, agent: int, process: int) -> bool:
        """Notes another message of a process; returns whether it is the one that speaks for this agent."""
        if not 0 <= agent < len(self.places) or process == 0 or self.places[agent].process != process:
            return False
        self.places[agent].heard_at = now
        return True

    def missing(self, now: int) -> list[int]:
        """The agents of which no process is heard."""
        return [
            agent
            for agent, place in enumerate(self.places)
            if place.process == 0 or now - place.heard_at >= self.silence
        ]
