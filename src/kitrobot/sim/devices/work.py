"""Takes units of a work of the team, and says that they are done (see sim.team_work)."""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete, Setting, Values
from kitrobot.sim.tables.columns import A_DONE, A_OWN, A_ROBOT
from kitrobot.sim.tables.state import State
from kitrobot.sim.tables.team_columns import T_ACTUATOR
from kitrobot.sim.team.work import finish_unit, take_unit
from kitrobot.text.sentences import Sentence

WORK = A_OWN[0]
"""Column: the number of the work."""

TAKE = 0

NUMBER = Setting("number", 0.0, Sentence("which work of the team"), "", 0.0, 65_535.0)


class WorkLink(Actuator):
    """Takes part in a work. On a robot that is not of the team it is done at once."""

    name = "work"
    settings = (LATENCY, LOST_COMMANDS, NUMBER)
    procedures = ("Take", "Done")
    discrete = Discrete.BUSY
    agrees = True

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("number"),)


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Takes a unit of the work, or reports that it is done."""
    i = state.actuators.ints[A_ROBOT][k]
    w = int(state.actuators.floats[WORK][k])
    team = state.team
    if w >= len(team.holds) or team.robots[T_ACTUATOR][i] < 0:
        return
    if command.procedure == TAKE:
        take_unit(i, w, k, state)
    else:
        finish_unit(i, w, state)
        state.actuators.ints[A_DONE][k] = 1


def is_busy(k: int, state: State) -> bool:
    """Never: whoever waits for a unit goes on only when others do."""
    return False
