"""The loops of motion, contacts and sight are taken by Numba as they are, and give the same numbers to the last bit."""

from __future__ import annotations

import inspect
import random
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from kitrobot.sim import contacts, motion, sight

numba = pytest.importorskip("numba")

COUNT = 12
"""Robots, walls and points in the lists."""


def loops(*modules: ModuleType) -> list[Callable[..., Any]]:
    """Every function of the modules."""
    return [
        value
        for module in modules
        for value in vars(module).values()
        if inspect.isfunction(value) and value.__module__ == module.__name__
    ]


def arguments(function: Callable[..., Any], rng: random.Random) -> list[Any]:
    """Random lists of the right kinds: a ring of 500 mm with a few robots on it, walls and free robots anywhere."""
    whole = {
        "order": list(range(COUNT)),
        "road": [rng.choice((0, -1)) if function.__name__ != "measure_gaps" else 0 for _ in range(COUNT)],
        "closed": [rng.randrange(2)],
        "first": [0],
        "last": [COUNT - 1],
        "leader": [(robot + 1) % COUNT for robot in range(COUNT)],
        "pairs": [0] * 64,
        "solid": [rng.randrange(2) for _ in range(COUNT)],
        "stretch": [0] * COUNT,
    }
    real = {"along": [100.0 * point for point in range(COUNT)], "road_length": [500.0]}
    if function.__name__ == "follow":
        real["length"] = [500.0]
    single = {"first": 0, "last": COUNT - 1, "room": 30, "me": 0}
    made: list[Any] = []
    for name, parameter in inspect.signature(function).parameters.items():
        kind = str(parameter.annotation)
        if kind == "list[int]":
            made.append(list(whole[name]))
        elif kind == "list[float]":
            made.append(list(real.get(name, [rng.uniform(1, 400) for _ in range(COUNT)])))
        else:
            made.append(single[name] if kind == "int" else rng.uniform(0.1, 50))
    return made


@pytest.mark.parametrize("function", loops(motion, contacts, sight), ids=lambda function: function.__name__)
def test_plain_and_compiled_agree(function: Callable[..., Any]) -> None:
    compiled = numba.njit(function)
    for seed in range(20):
        plain = arguments(function, random.Random(seed))
        arrays = [np.array(value) if isinstance(value, list) else value for value in plain]
        assert function(*plain) == compiled(*arrays)
        for before, after in zip(plain, arrays, strict=True):
            if isinstance(before, list):
                assert after.tolist() == before
