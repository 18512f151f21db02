"""Steps on a current MicroPython with pins and buses that only remember, for tests of the drivers of kits."""

from __future__ import annotations

import ast
from typing import Any

from tests.boards.modern import onboard_files, run
from tests.boards.test_machine_drivers import HEAD

FULL = 65535
BEFORE = """
import sys
DRV8833 = {"left-forward": "2", "left-backward": "3", "right-forward": "4", "right-backward": "5"}
TB6612 = {"left-forward": "6", "left-backward": "7", "left-power": "8", "right-forward": "9", "right-backward": "10",
    "right-power": "11"}
DRV8835 = {"bridge": "direction", "left-forward": "13", "left-backward": "12", "right-forward": "15",
    "right-backward": "14", "left-flipped": "yes"}
heard = {}
def duties():
    for name, what, value in taken():
        if what == "duty":
            heard[name] = (value * 100 + 32767) // 65535
    return [heard.get(name, 0) for name in (2, 3, 4, 5)]
found = {}
def begin():
    from kitrobot_onboard.drivers.machine.shared.motors import bases
    for each in (bases, heard, levels, log):
        each.clear()
"""


def results_of(steps: dict[str, str]) -> dict[str, Any]:
    """The `result` of each of the steps, all in one run."""
    programs = [f"begin()\n{program}\nfound[{name!r}] = result\n" for name, program in steps.items()]
    text = "\n".join([HEAD, BEFORE, *programs, "print(repr(found))"])
    results: dict[str, Any] = ast.literal_eval(run({**onboard_files(), "test.py": text.encode()}, "test.py"))
    return results
