"""A board that Node emulates in a process of its own, with its line on a TCP port of loopback."""

from __future__ import annotations

import json
import subprocess
import tempfile
import threading
from pathlib import Path
from queue import Queue
from types import TracebackType
from typing import Any, Self

from tests.patience import PATIENCE_S
from tools import page


class NodeBoard:
    """A board that runs while the `with` lasts; `address` is what a host connects to.

    Args:
        script: what Node runs, with `module` and the file of `given` as its arguments.
        module: the module of the emulator.
        given: what the script is to know.
        within: the words of a command that Node is started by, as `ip netns exec NAME`.
    """

    def __init__(self, script: Path, module: Path, given: dict[str, Any], within: tuple[str, ...] = ()) -> None:
        self.script, self.module, self.given, self.within = script, module, given, within
        self.address = ""

    def __enter__(self) -> Self:
        node, environment = page.node_program()
        self._folder = tempfile.TemporaryDirectory()
        given = Path(self._folder.name, "given.json")
        given.write_text(json.dumps(self.given), encoding="utf-8")
        self.process = subprocess.Popen(
            [*self.within, node, str(self.script), str(self.module), str(given)],
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,  # as in `tests.boards.qemu`
        )
        self._answers: Queue[str] = Queue()
        threading.Thread(target=self._listen, daemon=True).start()
        self.address = self._answer()["address"]
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        assert self.process.stdin is not None
        self.process.stdin.close()
        try:
            self.process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self._folder.cleanup()

    def cut_power(self) -> None:
        """Takes the power away at once and gives it back: the board starts as when it was switched on."""
        self._ask("cut")

    def _ask(self, command: str) -> dict[str, Any]:
        assert self.process.stdin is not None
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()
        return self._answer()

    def _answer(self) -> dict[str, Any]:
        line = self._answers.get(timeout=PATIENCE_S)
        assert line, "the board's process ended"
        answer: dict[str, Any] = json.loads(line)
        return answer

    def _listen(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self._answers.put(line)
        self._answers.put("")
