"""Whether its robot hears another one, named in the XML."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Sensor, Setting
from kitrobot.sim.tables.columns import S_LEAST, S_MOST, S_OWN, S_ROBOT, S_VALUE
from kitrobot.sim.tables.state import State
from kitrobot.sim.team.radio import has_radio, is_in_reach, is_on
from kitrobot.text.sentences import Sentence

OTHER = S_OWN[0]
"""Column: the number of the other robot."""


class Hears(Sensor):
    """1 while a certain robot of the run is in reach of its radio."""

    name = "hears"
    settings = (
        LATENCY,
        LOST_READINGS,
        WRONG,
        Setting(
            "of",
            "",
            Sentence("the name of an agent"),
            Sentence("the name of an agent"),
            reads=bool,
            required=True,
            names_agent=True,
        ),
    )


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    others = state.sensors.floats[OTHER]
    for k in range(first, last):
        i = sensor[S_ROBOT][k]
        j = int(others[k])
        heard = is_on(i, state) and is_on(j, state) and (not has_radio(state) or is_in_reach(i, j, state))
        sensor[S_VALUE][k] = sensor[S_MOST][k] if heard else sensor[S_LEAST][k]
