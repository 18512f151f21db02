"""A board with a current MicroPython, without hardware: its WebAssembly build under Node (`webassembly/`).

`ModernBoard` is one at the end of a line, with a file system, soft reset and power that can be cut; `run` runs a
program there without a line, for what is to be compared or measured. Node and the build come with the page's tools.
"""

from __future__ import annotations

import base64
import json
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from time import monotonic

import kitrobot_onboard
from kitrobot.deploy.line.board import Board, Hello
from tests.boards.node_board import NodeBoard
from tests.patience import PATIENCE_S
from tools import page

HERE = Path(__file__).resolve().parent / "webassembly"
PACKAGE = "@micropython/micropython-webassembly-pyscript"


def micropython() -> Path:
    """The module that loads MicroPython; installed with the page's tools when it is not yet."""
    page.install_modules()
    return page.WEB / "node_modules" / PACKAGE / "micropython.mjs"


def version() -> str:
    """The version of MicroPython, as npm numbers it."""
    described = json.loads(micropython().with_name("package.json").read_text(encoding="utf-8"))
    return str(described["version"])


def onboard_files() -> dict[str, bytes]:
    """All of `kitrobot_onboard`, under that name, and `machine` and others whose pins only remember."""
    folder = Path(kitrobot_onboard.__file__).parent
    files = {
        f"kitrobot_onboard/{path.relative_to(folder).as_posix()}": path.read_bytes() for path in folder.rglob("*.py")
    }
    return files | {path.name: path.read_bytes() for path in (HERE.parent / "recording").glob("*.py")}


def greet_until(board: Board, is_there: Callable[[Hello], bool]) -> Hello:
    """Greets a board until it is so, and listens to it between two greetings.

    MicroPython in WebAssembly never closes the file of its answers, and has room for 4096 open files: a board that is
    greeted as fast as it answers has none left before a busy machine has done some ticks.
    """
    end = monotonic() + PATIENCE_S
    while not is_there(hello := board.greet()):
        assert monotonic() < end, f"the board stays at {hello}"
        board.news(0.1)
    return hello


def run(files: dict[str, bytes], name: str, timeout_s: float = 120) -> str:
    """What MicroPython prints when it runs the file `name` of a flash that holds `files` (paths with `/`).

    Then it calls `step` of that file until it returns false; garbage is collected between those calls.
    """
    node, environment = page.node_program()
    with tempfile.TemporaryDirectory() as folder:
        for path, content in files.items():
            target = Path(folder, path)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
        command = [node, str(HERE / "run.mjs"), str(micropython()), folder, name]
        done = subprocess.run(command, env=environment, capture_output=True, timeout=timeout_s, check=False)
    errors = done.stderr.decode(errors="replace")
    assert done.returncode == 0, errors[-3000:]
    return done.stdout.decode()


class ModernBoard(NodeBoard):
    """One with a current MicroPython.

    Args:
        files: what its flash holds at power-on.
        port: of its serial line on loopback; 0 for any that is free.
        within: as of `NodeBoard`.
        pace: how many times slower its clock goes than this computer's; a host that a busy computer keeps waiting is
            then still in time for it.
    """

    def __init__(
        self, files: dict[str, bytes] | None = None, port: int = 0, within: tuple[str, ...] = (), pace: int = 1
    ) -> None:
        held = {name: base64.b64encode(data).decode() for name, data in (files or {}).items()}
        super().__init__(HERE / "board.mjs", micropython(), {"port": port, "files": held, "pace": pace}, within)

    def deaf(self, on: bool) -> None:
        """Its host takes nothing any more of what it says, as one that keeps a USB port open and does not read."""
        self._ask("deaf" if on else "hears")

    def said(self) -> tuple[int, int]:
        """How often a program was refused room for what it would say, and how often one wrote all the same and was
        held up.
        """
        found = self._ask("said")
        return found["refused"], found["heldUp"]

    def files(self) -> dict[str, bytes]:
        """What the flash holds: what was closed, whatever is still open."""
        return {name: base64.b64decode(text) for name, text in self._ask("files")["files"].items()}
