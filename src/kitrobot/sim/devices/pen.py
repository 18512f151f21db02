"""A pen in the middle of a robot: while it is down, its robot draws a line on the floor as it goes."""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, DisplayKind, Setting, Values
from kitrobot.sim.tables.columns import A_DONE
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence
from kitrobot.trace.drawing import MOST_COLOUR as MOST_PEN_COLOUR
from kitrobot.trace.drawing import MOST_WIDTH_MM as MOST_PEN_WIDTH_MM

_UP, _DOWN, _COLOUR, _WIDTH = range(4)


class Pen(Actuator):
    """`PenDown()`, `PenUp()`, `Colour(colour)` and `Width(width)`, in mm; the last two while it is up or down.

    Colours are 0 black, 1 red, 2 green, 3 blue, 4 orange, 5 violet, 6 yellow, 7 pink. What is drawn is not seen by any
    sensor. Each takes a tick, so that one after the other is done: a device takes one command a tick.
    """

    name = "pen"
    procedures = ("PenUp", "PenDown", "Colour", "Width")
    draws = True
    shown = 3
    outputs = 3
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("colour", 0.0, Sentence("its colour before the program chooses one"), "", 0.0, MOST_PEN_COLOUR),
        Setting("width", 3.0, Sentence("how wide it draws before the program says so"), "mm", 1.0, MOST_PEN_WIDTH_MM),
    )

    @classmethod
    def display_kind(cls, values: Values) -> DisplayKind:
        return "pen"

    @classmethod
    def initial_outputs(cls, values: Values) -> Sequence[int]:
        return 0, round(values.number("colour")), round(values.number("width"))


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Does what a command says. The outputs are whether it is down, its colour and its width."""
    output = state.actuators.outputs[k]
    state.actuators.ints[A_DONE][k] = 0
    if command.procedure == _COLOUR:
        output[1] = min(max(command.first, 0), MOST_PEN_COLOUR)
    elif command.procedure == _WIDTH:
        output[2] = min(max(command.first, 1), MOST_PEN_WIDTH_MM)
    else:
        output[0] = command.procedure


def advance(first: int, last: int, dt: float, state: State) -> None:
    """Goes on for a step with the devices `first` … `last` - 1."""
    done = state.actuators.ints[A_DONE]
    for k in range(first, last):
        done[k] = 1
