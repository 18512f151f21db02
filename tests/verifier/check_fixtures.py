"""Models of small missions for tests."""

from __future__ import annotations

from pathlib import Path

from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import CheckResult, check_properties
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.mission_run import PreparedRun, RunOptions

EXAMPLES = Path(__file__).parents[2] / "examples"
TRANSPORT = (EXAMPLES / "transport" / "transport.krt").read_text(encoding="utf-8")


def prepared(path: Path) -> PreparedRun:
    """A mission before its first step."""
    return open_mission(path).prepare(RunOptions(1, 600.0))


def judged(run: Simulation, timing: Timing, failures: int = 0, states: int = 200_000) -> CheckResult:
    """All ready properties of a run under one assumption."""
    model = Model(run, abstract_run(run), failures, timing)
    return check_properties(model, ready_properties(model), Budget(states))


def answers(made: CheckResult) -> dict[str, str]:
    """The answers by property."""
    return {verdict.property.name: verdict.answer.value for verdict in made.verdicts}


def mutant(folder: Path, *changes: tuple[str, str], carriers: int = 2, stock: int = 2) -> PreparedRun:
    """The transport mission with changes of its text, so many carriers and so many boxes."""
    text = TRANSPORT
    for number in range(carriers + 1, 4):
        text = text.replace(f'    <agent name="carrier-{number}" program="carrier"/>\n', "")
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    ring = Path(__file__).parents[2] / "src" / "kitrobot" / "world" / "shipped" / "ring.world.xml"
    world = ring.read_text(encoding="utf-8").replace('capacity="12" stock="12"', f'capacity="12" stock="{stock}"')
    (folder / "small.world.xml").write_text(world, encoding="utf-8")
    path = folder / "mutant.krt"
    path.write_text(text.replace("ring.world.xml", "small.world.xml"), encoding="utf-8")
    return prepared(path)
