"""A display of five by five lights, each from 0 (dark) to 9 (bright), as on a micro:bit.

Its outputs are what it shows: five numbers, a row each from the top, whose five decimal digits are the lights from
the left. The pictures and digits are those that the board shows.
"""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete, DisplayKind, Setting, Values
from kitrobot.sim.tables.columns import A_DONE, A_OWN, A_ROBOT, DOWN, FAILED
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

COLUMN_S, SCROLLED_S = A_OWN[:2]
"""Columns of a display: the seconds for each column of a number that scrolls, and how long it has scrolled."""

SIDE = 5
_CLEAR, _IMAGE, _NUMBER, _SCROLL, _PIXEL = range(5)
_SCROLLED = SIDE
"""Where the number that scrolls stands, behind the rows."""


def _rows(*pictures: str) -> tuple[int, ...]:
    """Pictures as numbers, five rows each of five bits."""
    return tuple(int(row.replace(".", "0").replace("#", "1"), 2) for picture in pictures for row in picture.split())


IMAGES = _rows(
    ".#.#. ##### ##### .###. ..#..",  # 0 heart
    "..... .#.#. .###. ..#.. .....",  # 1 small heart
    "..... .#.#. ..... #...# .###.",  # 2 happy
    "..... .#.#. ..... .###. #...#",  # 3 sad
    "..... .#.#. ..... .#.#. #.#.#",  # 4 confused
    "#...# .#.#. ..... ##### #.#.#",  # 5 angry
    "..... ##.## ..... .###. .....",  # 6 asleep
    ".#.#. ..... ..#.. .#.#. ..#..",  # 7 surprised
    "..... ....# ...#. #.#.. .#...",  # 8 yes
    "#...# .#.#. ..#.. .#.#. #...#",  # 9 no
    "..#.. .###. #.#.# ..#.. ..#..",  # 10 arrow up
    "..#.. ...#. ##### ...#. ..#..",  # 11 arrow right
    "..#.. ..#.. #.#.# .###. ..#..",  # 12 arrow down
    "..#.. .#... ##### .#... ..#..",  # 13 arrow left
    "..#.. .#.#. #...# .#.#. ..#..",  # 14 diamond
    "..... ..#.. .#.#. ..#.. .....",  # 15 small diamond
    "##### #...# #...# #...# #####",  # 16 square
    "..... .###. .#.#. .###. .....",  # 17 small square
    "..#.. .###. ##.## .###. ..#..",  # 18 target
    ".#.#. #.#.# .#.#. #.#.# .#.#.",  # 19 chessboard
)
_DIGITS = _rows(
    ".##.. #..#. #..#. #..#. .##..",
    "..#.. .##.. ..#.. ..#.. .###.",
    "###.. ...#. .##.. #.... ####.",
    "####. ...#. ..#.. #..#. .##..",
    "..##. .#.#. #..#. ##### ...#.",
    "##### #.... ####. ....# ####.",
    "...#. ..#.. .###. #...# .###.",
    "##### ...#. ..#.. .#... #....",
    ".###. #...# .###. #...# .###.",
    ".###. #...# .###. ..#.. .#...",
    "..... ..... .###. ..... .....",
)
_MINUS = 10
_LIT = tuple(int(f"{bits:05b}") * 9 for bits in range(32))
"""Five bits as five lights, dark or bright."""
_PLACES = (10_000, 1000, 100, 10, 1)
LAST_IMAGE = len(IMAGES) // SIDE - 1


class Display(Actuator):
    """`Image(number)` shows a picture, `Number(value)` a digit, `Scroll(value)` lets a number run through,
    `Pixel(x, y, brightness)` sets one light, counted from the top left, `Clear()` darkens all.
    """

    name = "display"
    discrete = Discrete.INSTANT
    procedures = ("Clear", "Image", "Number", "Scroll", "Pixel")
    shown = SIDE
    outputs = SIDE + 1
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting(
            "delay", 150.0, Sentence("how long a number that runs through takes for each column"), "ms", 1.0, 60_000.0
        ),
    )

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("delay") / 1000,)

    @classmethod
    def display_kind(cls, values: Values) -> DisplayKind:
        return "lights"


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Does what a command says."""
    actuator = state.actuators.ints
    output = state.actuators.outputs[k]
    procedure = command.procedure
    first = command.first
    actuator[A_DONE][k] = 1
    if procedure == _PIXEL:
        x = min(max(first, 0), SIDE - 1)
        y = min(max(command.second, 0), SIDE - 1)
        place = _PLACES[x]
        output[y] += (min(max(command.last, 0), 9) - output[y] // place % 10) * place
        return
    for y in range(SIDE):
        output[y] = 0
    if procedure == _IMAGE:
        at = SIDE * min(max(first, 0), LAST_IMAGE)
        for y in range(SIDE):
            output[y] = _LIT[IMAGES[at + y]]
    elif procedure == _NUMBER:
        at = SIDE * min(max(first, 0), 9)
        for y in range(SIDE):
            output[y] = _LIT[_DIGITS[at + y]]
    elif procedure == _SCROLL:
        output[_SCROLLED] = first
        state.actuators.floats[SCROLLED_S][k] = 0.0
        actuator[A_DONE][k] = 0


def advance(first: int, last: int, dt: float, state: State) -> None:
    """Goes on for a step with the devices `first` … `last` - 1."""
    actuator = state.actuators.ints
    actuator_floats = state.actuators.floats
    outputs = state.actuators.outputs
    down = state.robots.ints[DOWN]
    done = actuator[A_DONE]
    for k in range(first, last):
        if done[k] or down[actuator[A_ROBOT][k]] == FAILED:
            continue
        actuator_floats[SCROLLED_S][k] += dt
        output = outputs[k]
        if run_through(
            output[_SCROLLED], int(actuator_floats[SCROLLED_S][k] / actuator_floats[COLUMN_S][k] + 1e-9), output
        ):
            done[k] = 1


def run_through(value: int, column: int, output: list[int]) -> bool:
    """Shows a number that has run in from the right by so many columns; True when it has run out again.

    Each character is five columns wide, with a dark one behind it.
    """
    magnitude = -value if value < 0 else value
    count = 1
    highest = 1
    while magnitude // highest >= 10:
        highest *= 10
        count += 1
    signs = 1 if value < 0 else 0
    width = (SIDE + 1) * (count + signs)
    for y in range(SIDE):
        output[y] = 0
    for x in range(SIDE):
        at = column + x - SIDE
        across = at % (SIDE + 1)
        if at < 0 or at >= width or across == SIDE:
            continue
        number = at // (SIDE + 1) - signs
        digit = _MINUS
        if number >= 0:
            digit = magnitude
            for _ in range(count - 1 - number):
                digit //= 10
            digit %= 10
        for y in range(SIDE):
            if _DIGITS[SIDE * digit + y] >> (SIDE - 1 - across) & 1:
                output[y] += 9 * _PLACES[x]
    return column >= SIDE + width
