"""Write the heat maps in `docs/pictures`: what every failure in the example `transport-team` comes to.

python -m tools.sweep_maps    runs both sweeps, which takes minutes, and writes the maps
"""

from __future__ import annotations

from pathlib import Path

import kitrobot
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.sweep import SweepOptions, run_sweep
from kitrobot.workspace.sweep_map import heat_map

ROOT = Path(__file__).resolve().parents[1]
EXAMPLE = ROOT / "examples" / "transport-team" / "transport-team.krt"
PICTURES = ROOT / "docs" / "pictures"
MAPS = {
    "fail-sweep.svg": (SweepOptions(100), "One robot fails"),
    "fail-sweep-pairs.svg": (SweepOptions(20, pairs=True), "Two robots fail"),
}


def main() -> None:
    """Writes the maps, and says what they show."""
    for name, (options, title) in MAPS.items():
        sweep = run_sweep(kitrobot.open(EXAMPLE).prepare(RunOptions(1, 600.0)), options)
        (PICTURES / name).write_text(heat_map(sweep, title), encoding="utf-8")
        print(f"{name}: {sweep.total} fields, {sweep.counts}, {sweep.real_seconds:.0f} s")


if __name__ == "__main__":
    main()
