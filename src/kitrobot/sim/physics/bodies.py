"""The robots of a run, and what they share with one another, by name: a window on the tables of its state.

For looking and for tests; the loops use the tables themselves.
"""

from __future__ import annotations

from typing import Any

from kitrobot.sim.tables import columns
from kitrobot.sim.tables.state import State
from kitrobot.world.model import World


class RobotTable:
    """One row a quantity, one entry a robot: `bodies.x[i]`. `quantity` is a column's name in lower case."""

    def __init__(self, state: State) -> None:
        self._state = state

    def __len__(self) -> int:
        return len(self._state.robots.ints[columns.ROAD])

    def __getattr__(self, quantity: str) -> Any:
        if quantity in _REAL:
            return self._state.robots.floats[_REAL[quantity]]
        if quantity in _WHOLE:
            return self._state.robots.ints[_WHOLE[quantity]]
        raise AttributeError(quantity)


def _names(first: str, last: str) -> dict[str, int]:
    """Column name → number, for the columns of one table, which stand side by side in `columns`."""
    names = [name for name, value in vars(columns).items() if name.isupper() and isinstance(value, int)]
    return {name.lower(): getattr(columns, name) for name in names[names.index(first) : names.index(last) + 1]}


_REAL = _names("X", "SAVED_TARGET")
_WHOLE = _names("SOLID", "ORIGIN")


class WorldState:
    """What all robots of a run share: the world, its stock, and the robots themselves.

    `stock[h]` is the number of boxes in the storehouse h, `delivered[i]` how many boxes robot i brought. Boxes are
    never made: `total` stays the sum of all stock, all loads, and boxes that were lost with a robot that was towed.
    """

    def __init__(self, world: World, state: State) -> None:
        self.world = world
        self.total = sum(house.stock for house in world.storehouses)
        self.show(state)

    def show(self, state: State) -> None:
        """From now on the state is this."""
        self.bodies = RobotTable(state)
        self.stock = state.docks.stock
        self.delivered = state.robots.ints[columns.DELIVERED]
