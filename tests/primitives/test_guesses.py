"""Only near spellings are guessed."""

import pytest

from kitrobot.primitives.robot import Category
from kitrobot.sim.setup.settings import simulated_devices
from kitrobot.text.suggestions import nearest

NEAR = [
    ("driv", "drive"),
    ("lamb", "lamp"),
    ("turns", "turn"),
    ("color", "colour"),
    ("Switch", "switch"),
    ("wehel", "wheel"),
    ("acelerometre", "accelerometer"),
]


@pytest.mark.parametrize(("word", "meant"), NEAR)
def test_a_near_spelling_is_guessed(word: str, meant: str) -> None:
    known = [*simulated_devices(Category.ACTUATOR), *simulated_devices(Category.SENSOR)]
    assert nearest(word, known) == meant


@pytest.mark.parametrize("word", ["motor", "force", "thermometer", "barometer", "gyrometer", "speedometer", "", "x"])
def test_another_word_is_not_guessed(word: str) -> None:
    known = [*simulated_devices(Category.ACTUATOR), *simulated_devices(Category.SENSOR)]
    assert nearest(word, known) == ""
