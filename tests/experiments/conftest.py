"""Little missions for many runs."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

import kitrobot
from kitrobot import Agent, Mission, OpenMission, Pose, Start, Team, World
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.sim.jit.compiler import step
from tests import compiled_step

TEXT = "Wheel.Advance(50); WAIT(10); Count.Add(1); WAIT(10); Count.Add(1); Wheel.Stop();"
"""Two seconds; Count is 1 after one of them, and 2 in the end."""
SURE = 0.99
"""A probability to fail within a minute, of which two seconds leave 0.01 ** (2 / 60) of all runs well: 0.858."""


@pytest.fixture(scope="session")
def counter() -> OpenMission:
    """A robot that counts to two."""
    world = World("yard", 2000, 600, starts=(Start("ada", pose=Pose(200, 300, 0.0)),))
    program = kitrobot.read_program(TEXT, "mini-robot", "count")
    asked = [AskedProperty("counted", Form.EVENTUALLY, "any ada (Count.EqualTo(2))")]
    team = Team([Agent("ada", "count")])
    return kitrobot.open_mission(Mission(programs=[program], team=team, own_world=world, properties=asked))


@pytest.fixture(scope="module")
def compiled_runs() -> Iterator[None]:
    """Runs can take the compiled step, where there is Numba."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_COMPILE", "")
        with compiled_step.alone():
            step.wait()
        yield
