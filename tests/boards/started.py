"""What a board on CPython does by itself of `booting`: it needs nothing of the host, so it is there at once."""

from __future__ import annotations

import builtins
import gc
import json
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import IO, Any

from kitrobot_onboard.interpreter import tick

START = "start.json"
"""The file that says how what lies beside it is started."""

MICROPYTHON = SimpleNamespace(opt_level=lambda level: None, kbd_intr=lambda sign: None)
UTIME = SimpleNamespace(sleep_ms=lambda ms: None)


def started(port: Any, folder: Path) -> tuple[list[Any], Callable[[Any], None]]:
    """The robot whose files lie in a folder (`booting.lay`), and the loop that it is to be given to."""
    start = json.loads((folder / START).read_text(encoding="utf-8"))
    sys.modules.setdefault("micropython", MICROPYTHON)  # type: ignore[arg-type]
    sys.modules.setdefault("utime", UTIME)  # type: ignore[arg-type]
    sys.modules[start["interpreter"]] = SimpleNamespace(**{start["tick"]: tick})  # type: ignore[assignment]

    def opened(path: str, mode: str = "r") -> IO[Any]:
        return builtins.open(folder / path, mode)

    space: dict[str, Any] = {"open": opened, "port": port}
    # A board collects after each piece; here that would look at all that the tests have in memory.
    sys.modules["gc"] = SimpleNamespace(collect=lambda: None)  # type: ignore[assignment]
    try:
        exec(start["loading"], space)
    finally:
        sys.modules["gc"] = gc
    return space[start["robot"]], space[start["run"]]
