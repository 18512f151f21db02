"""On the own firmware of a micro:bit of 2016: what drives on each of its kits, and stops."""

from __future__ import annotations

import pytest

from kitrobot.workspace import open_mission
from tests.boards.qemu import Emulated
from tests.effort import cases
from tests.verifier.building import EXAMPLES
from tools.kit_pages import measured_2016, what_runs
from tools.microbit_kits import programs, small_kits, try_out

pytestmark = pytest.mark.boards


@pytest.mark.parametrize("kit", cases(["cutebot"], ["maqueen", "move-motor"]))
def test_a_square_is_driven_stopped_and_driven_again(used_microbit: Emulated, kit: str) -> None:
    opened = open_mission(EXAMPLES / "square" / "square.krt")
    ((_, program),) = programs(opened, small_kits()[kit])
    assert try_out(used_microbit.address, program) > 2000


def test_what_was_measured_is_of_missions_that_the_kits_have_all_parts_for() -> None:
    kits = small_kits()
    runs = what_runs(list(kits.values()))
    found = measured_2016()
    for mission, row in runs.items():
        for kit, missing in row.items():
            assert (kit in found.get(mission, {})) == (missing == ""), f"{mission} on {kit}: measure it again"
