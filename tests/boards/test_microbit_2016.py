"""On the own firmware of a micro:bit of 2016: what drives on each of its kits, and stops."""

from __future__ import annotations

import pytest

from kitrobot.deploy import Line, NoMemoryError, RawRepl, Receiver, deploy
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


def test_what_is_too_large_is_refused_before_anything_on_the_board_changes(used_microbit: Emulated) -> None:
    def there() -> tuple[bool, dict[str, bytes]]:
        line = Line(used_microbit.address)
        try:
            receiver = Receiver(RawRepl(line))
            receiver.begin()
            return receiver.is_2016, {name: receiver.read(name) for name in receiver.names()}
        finally:
            line.close()

    before = there()
    assert before[0]
    ((_, program),) = programs(open_mission(EXAMPLES / "kit-rover" / "kit-rover.krt"), small_kits()["cutebot"])
    stages = []
    with pytest.raises(NoMemoryError, match="nothing was sent"):
        deploy(
            used_microbit.address,
            program.file.to_bytes(),
            program.package,
            lambda stage, done, total: stages.append(stage),
            fresh=True,
            replace=True,
        )
    assert stages == ["connect", "compare"]
    assert there() == before
