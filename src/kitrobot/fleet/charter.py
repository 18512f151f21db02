"""The charter of a fleet: the members of a run, as the protocol of the room `team` needs them.

Each agent is a member. Roles, groups, meetings and works of the mission are in the notes of the log (see `replica`).
"""

from __future__ import annotations

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import TICK
from kitrobot.team.charter import MOST_MEMBERS, Charter
from kitrobot.text.sentences import Help, Sentence

LEASE_MS = 500
"""A role changes hands about 2.3 times this after a failure, 2.8 times after that of the first of the view."""
LEAST_LEASE_MS, MOST_LEASE_MS = 100, 60_000


class FleetError(KitRobotError):
    """A fleet cannot be started, or cannot go on."""


def charter_of(simulation: Simulation, lease_ms: int = LEASE_MS) -> Charter:
    """The charter of all agents of a run that has not begun.

    Raises:
        FleetError: they are too many.
    """
    assert simulation.state.clock[TICK] == 0, "before the first step"
    count = len(simulation.members)
    if count > MOST_MEMBERS:
        help: Help = Sentence("take some out of the team, or run the mission in the simulator: `kitrobot run`")
        raise FleetError(
            Sentence("a fleet has at most {most} agents, and this mission has {count}", MOST_MEMBERS, count), help
        )
    return Charter(
        members=count,
        variables=len(simulation.state.shared.ints[0]),
        lease=lease_ms,
    )
