"""On the own firmware of a micro:bit of 2016: what drives on each of its kits, and stops."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.deploy.errors import NoMemoryError
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.workspace.mission_loader import open_mission
from tests.boards.hex_sections import image_2016
from tests.boards.qemu import Emulated, booted
from tests.effort import cases
from tests.verifier.check_fixtures import EXAMPLES
from tools.microbit_kits import programs, small_kits, try_out

pytestmark = pytest.mark.boards


@pytest.mark.parametrize("kit", cases(["cutebot"], ["maqueen", "move-motor"]))
def test_a_square_is_driven_stopped_and_driven_again(tmp_path: Path, kit: str) -> None:
    opened = open_mission(EXAMPLES / "square" / "square.krt")
    ((_, program),) = programs(opened, small_kits()[kit])
    with booted(firmware=image_2016(program, tmp_path)) as board:
        assert try_out(board.address, program, fresh=False) > 2000


def test_what_is_too_large_is_refused_before_anything_on_the_board_changes(used_microbit: Emulated) -> None:
    def there() -> tuple[bool, dict[str, int]]:
        line = Line(used_microbit.address)
        try:
            receiver = Receiver(RawRepl(line))
            receiver.begin()
            return receiver.is_2016, {name: receiver.number(f"os.size({name!r})") for name in receiver.names()}
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
