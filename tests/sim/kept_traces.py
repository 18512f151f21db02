"""`python -m tests.sim.kept_traces`: writes anew what each shipped mission without a radio does in its first seconds.

To be called when a mission, or what the simulator is meant to do, has changed; `test_kept_traces` holds it.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from kitrobot.sim.simulation import Simulation
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.mission_run import RunOptions

EXAMPLES = Path("examples")
KEPT = Path("tests/sim/kept_traces.json")
TICKS = 500


def missions() -> list[Path]:
    """All shipped missions."""
    return sorted(EXAMPLES.glob("*/*.krt"))


def anew(mission: Path) -> Simulation:
    """The run of a mission before its first step, with the seed 1."""
    return open_mission(mission).prepare(RunOptions(1, 60)).simulation


def trace_of(mission: Path) -> list[int | str]:
    """The steps that were made, at most `TICKS`, and a hash of all machines, poses (to 0.001) and events after each."""
    run, digest = anew(mission), hashlib.sha256()
    run.stays_plain = True  # the numbers of compiled steps are NumPy's, which `repr` writes differently
    while run.outcome is None and run.tick < TICKS:
        run.step()
        poses = [[round(number, 3) + 0.0 for number in pose] for pose in run.poses()]
        machines = [agent.machine.snapshot() for agent in run.members]
        events = [(event.agent, event.kind, str(event.text)) for event in run.events]
        digest.update(repr((poses, machines, events)).encode())
    return [run.tick, digest.hexdigest()[:32]]


if __name__ == "__main__":
    kept = {mission.relative_to(EXAMPLES).as_posix(): trace_of(mission) for mission in missions()}
    lines = ",\n".join(f"  {json.dumps(name)}: {json.dumps(trace)}" for name, trace in kept.items())
    KEPT.write_text(f"{{\n{lines}\n}}\n", encoding="utf-8")
