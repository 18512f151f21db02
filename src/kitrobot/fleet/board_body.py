"""`BoardBody`: a board that is an agent's body and interpreter, as its host knows it, without its line.

The host's machine mirrors the board's: before a tick, orders carry the team's values to the board; after it,
the numbers that the board changed are put into the machine (`deploy.Board.member_tick`). What the board's own sensors
measure is in them too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from kitrobot.image.machine import Machine

REST_MS = 300
"""A board without a tick for so long gets the order to stand still; by itself it does so after 800."""


@dataclass(frozen=True, slots=True)
class Order:
    """What the board is to do.

    Attributes:
        what: a tick, to stand still until the next one, or to stop for good.
        anew: whether its program is begun before.
        inputs, variables: cells, and what they are in this tick.
    """

    what: Literal["tick", "still", "stop"]
    anew: bool = False
    inputs: Mapping[int, int] = field(default_factory=dict)
    variables: Mapping[int, int] = field(default_factory=dict)


class BoardBody:
    """The board of one agent.

    Args:
        machine: the host's, before its first tick.
        actuators: the numbers of the robot's actuators that the program uses.

    Attributes:
        orders: what the board is to do, since somebody took it out.
        works: whether it does a tick now.
        trip: how long a tick took lately at most, ms; half of that after each rest.
        stopped: whether it was stopped for good.
    """

    def __init__(self, machine: Machine, actuators: Sequence[int]) -> None:
        self.orders: list[Order] = []
        self.works = False
        self.trip = 0.0
        self.stopped = False
        self._machine = machine
        self._actuators = actuators
        self._first = machine.cells[: machine.layout.cells]
        threads = 2 * len(machine.image.slots)
        self._numbers = [0] * (machine.layout.cells + threads + machine.width * len(actuators))
        self._anew = True
        self._moves = False
        self._began_at = self._rests_since = 0

    def tick(self, now: int, own: Mapping[int, int], shared: Sequence[int]) -> None:
        """Has a tick done: `own` are inputs that the host knows, `shared` the cells of shared variables."""
        cells, known = self._machine.cells, self._first if self._anew else self._numbers
        variables = {cell: cells[cell] for cell in shared if cells[cell] != known[cell]}
        self.orders.append(Order("tick", self._anew, own, variables))
        if self._anew:
            self._numbers = [0] * len(self._numbers)
        self._anew = False
        self.works = self._moves = True
        self._began_at = self._rests_since = now

    def ticked(self, now: int, changes: Sequence[tuple[int, int]]) -> bool:
        """Takes what a tick has changed into the machine; False when it cannot be of this program."""
        self.works = False
        took = now - self._began_at
        self.trip = max(took, self.trip - (self.trip - took) / 16)
        if self._anew:
            return True  # it was begun anew meanwhile
        numbers, machine = self._numbers, self._machine
        for place, value in changes:
            if place >= len(numbers):
                return False
            numbers[place] = value
        count = machine.layout.cells
        threads = 2 * len(machine.image.slots)
        machine.cells[:count] = numbers[:count]
        machine.threads[:threads] = numbers[count : count + threads]
        width = machine.width
        machine.out[:] = [0] * len(machine.out)
        for place, number in enumerate(self._actuators):
            at = count + threads + width * place
            machine.out[width * number : width * (number + 1)] = numbers[at : at + width]
        return True

    def begin_anew(self) -> None:
        """Its program begins anew with the next tick."""
        self._anew = True

    def rest(self, now: int) -> None:
        """Orders an idle board to stand still; to be called often."""
        if self.works or now - self._rests_since < REST_MS:
            return
        self._rests_since = now
        # A robot that may not act because one tick took long would never learn that the next ones do not.
        self.trip /= 2
        if self._moves:
            self._moves = False
            self.orders.append(Order("stop" if self._machine.ended else "still"))

    def stop(self) -> None:
        """Stops everything on it."""
        if not self.stopped:
            self.stopped, self._moves = True, False
            self.orders.append(Order("stop"))
