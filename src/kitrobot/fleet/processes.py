"""The processes of agents that a team starts: each ends with the one that started it, whichever way that ends.

An agent reads its standard input, which nobody writes to: when it comes to an end, so does the agent.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from types import TracebackType

from kitrobot.fleet.status_reports import MOST_LINE_BYTES, StatusReport, decode_report

END_WITHIN_S = 3.0
"""How long processes have to end by themselves."""


class Agents:
    """Started agents by name; as a context, all of them have ended at its end.

    Args:
        heard: called, in a thread for each agent, with its name and report. Without it their messages go where ours go.
    """

    def __init__(self, heard: Callable[[str, StatusReport], None] | None = None) -> None:
        self.processes: dict[str, subprocess.Popen[bytes]] = {}
        self._heard = heard
        self._listening: dict[str, threading.Thread] = {}

    def start(self, name: str, arguments: Sequence[str], environment: Mapping[str, str]) -> None:
        """Starts the command line with these arguments for an agent."""
        heard = self._heard
        self.processes[name] = process = subprocess.Popen(
            [sys.executable, "-m", "kitrobot", *arguments, *(["--told"] if heard is not None else [])],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE if heard is not None else subprocess.DEVNULL,
            stderr=None if heard is None or os.environ.get("KITROBOT_DEBUG") else subprocess.DEVNULL,
            env={**os.environ, **environment},
            start_new_session=True,
        )
        if heard is not None:
            listening = threading.Thread(target=_listen, args=(name, process, heard), daemon=True, name=f"hears {name}")
            self._listening[name] = listening
            listening.start()

    def ended(self) -> dict[str, int]:
        """The status of each process that has ended and whose output was read to its end."""
        found = {name: process.poll() for name, process in self.processes.items()}
        return {name: status for name, status in found.items() if status is not None and not self._is_heard(name)}

    def _is_heard(self, name: str) -> bool:
        listening = self._listening.get(name)
        return listening is not None and listening.is_alive()

    def __enter__(self) -> Agents:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        end = time.monotonic() + (END_WITHIN_S if kind is None else 0.5)
        for process in self.processes.values():
            if process.stdin is not None:
                process.stdin.close()
        for process in self.processes.values():
            try:
                process.wait(max(0.0, end - time.monotonic()))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        for listening in self._listening.values():
            listening.join(1.0)


def _listen(name: str, process: subprocess.Popen[bytes], heard: Callable[[str, StatusReport], None]) -> None:
    assert process.stdout is not None
    with process.stdout as lines:
        while line := lines.readline(MOST_LINE_BYTES):
            report = decode_report(line)
            if report is not None:
                heard(name, report)


def end_of_input() -> threading.Event:
    """Set when standard input is at its end."""
    over = threading.Event()

    def read() -> None:
        try:
            while os.read(0, 4096):
                pass
        except OSError:
            pass
        over.set()

    threading.Thread(target=read, daemon=True, name="end of input").start()
    return over
