"""The command line from the start of its process to the end, against a bare Python that does nothing.

Processor time of the whole process, in milliseconds. What is above the bare Python is ours: imports, reading the
arguments, the work. The peer is the floor, not a rival: a ratio of 0.5 is twice the time of `python -c pass`.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.measurement import Row, milliseconds
from benchmarks.random_programs import text_of_lines

TITLE = "starting"
_BARE = ("-c", "pass")


@dataclass(frozen=True)
class Size:
    lines: int
    rounds: int


FULL = Size(lines=30, rounds=15)
TINY = Size(lines=3, rounds=1)


def run(size: Size, *, peers: bool) -> list[Row]:
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder, "small.lll")
        program.write_text(text_of_lines(size.lines), encoding="utf-8")
        commands: dict[str, Sequence[str]] = {
            "kitrobot --version": ("-m", "kitrobot", "--version"),
            "kitrobot format, a small file": ("-m", "kitrobot", "format", str(program)),
        }
        if peers:
            commands["bare"] = _BARE
        seconds: dict[str, list[float]] = {name: [] for name in commands}
        for number in range(size.rounds + 1):
            for name, arguments in commands.items():
                begun = _processor_time()
                subprocess.run([sys.executable, *arguments], check=True, stdout=subprocess.DEVNULL)
                if number:
                    seconds[name].append(_processor_time() - begun)
    times = {name: milliseconds(taken) for name, taken in seconds.items()}
    bare = times.pop("bare", None)
    peer = "python -c pass" if bare else ""
    return [Row(name, "ms", taken, peer, bare, lower_is_better=True) for name, taken in times.items()]


def _processor_time() -> float:
    """Seconds that the children which have ended took; the clock on the wall where the system does not count them."""
    if sys.platform == "win32":
        return time.perf_counter()
    import resource

    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
