"""Takes part in a team: comes to its points, and waits there for the others (see meetings)."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete
from kitrobot.sim.tables.columns import A_DONE, A_ROBOT
from kitrobot.sim.tables.state import State
from kitrobot.sim.tables.team_columns import T_ACTUATOR, T_ROLE
from kitrobot.sim.team.meetings import arrive

JOIN = 0


class TeamLink(Actuator):
    """Comes to the points of a team's program. On a robot that is not of the team it is done at once."""

    name = "team"
    settings = (LATENCY, LOST_COMMANDS)
    procedures = ("Join", "Enter", "Meet", "Ask", "Move")
    discrete = Discrete.BUSY
    agrees = True


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Begins what a command says: waits for a role, or comes to a point."""
    i = state.actuators.ints[A_ROBOT][k]
    robots = state.team.robots
    if len(robots[T_ACTUATOR]) == 0 or robots[T_ACTUATOR][i] < 0:
        return
    state.actuators.ints[A_DONE][k] = 0
    if command.procedure != JOIN:
        arrive(i, command.first, command.second, state)
    elif robots[T_ROLE][i] >= 0:
        state.actuators.ints[A_DONE][k] = 1


def is_busy(k: int, state: State) -> bool:
    """Never: whoever waits at a point goes on only when others come."""
    return False
