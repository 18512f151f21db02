"""The functions of `engines` through Numba: compiled once for a machine, and kept in the user's cache folder.

As with the simulator's step (`sim.compiling`) nobody waits for it: `ask` begins it in a process of its own with low
priority, or loads what is kept in a thread beside, and `compiled` gives it once it is there. The folder's name is a
digest of the sources and of what compiles them, so nothing stale is ever taken.
"""

from __future__ import annotations

import hashlib
import inspect
import platform
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

from kitrobot.sim.compiling import READY, available, compile_elsewhere, user_cache
from kitrobot.verifier import engines
from kitrobot.verifier.fairness import Search
from kitrobot.verifier.tables import Graph, Tables

_OPTIONS: dict[str, Any] = {"error_model": "numpy", "nogil": True, "_nrt": False}
"""Other threads go on beside, no division by zero can happen, and nothing is allocated (see `sim.compiling`)."""
_CALLED: dict[str, Any] = {**_OPTIONS, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
_INLINED = frozenset(
    {"changed", "decode", "emit", "expand_interleaved", "find", "happen", "key_hash", "react", "sensed"}
    | {"tick_each", "touch", "visit"}
)
"""What each state goes through. A call copies the places of all tables, so inlining these makes exploring twice as
fast; inlining the others too makes compiling take longer and exploring no faster."""

_lock = threading.Lock()
_making = threading.Lock()
_made: engines.Engine | None = None
_asked: threading.Thread | None = None


def ask() -> None:
    """Begins to make the compiled functions beside everything else, unless it was begun before."""
    global _asked
    with _lock:
        if _asked is None and _made is None and available():
            _asked = threading.Thread(target=_make_in_peace, name="compiling", daemon=True)
            _asked.start()


def compiled() -> engines.Engine | None:
    """The compiled functions, if they are there."""
    return _made


def is_kept() -> bool:
    """Whether the compiled functions are kept on this machine."""
    return available() and (cache_folder() / READY).is_file()


def make() -> engines.Engine:
    """The compiled functions, from the cache or anew; whoever calls this waits for it.

    Raises:
        Exception: whatever Numba or the file system says; nothing can be assumed of it.
    """
    global _made
    with _making:
        if _made is None:
            folder = cache_folder()
            folder.mkdir(parents=True, exist_ok=True)
            made = _told(folder)
            (folder / READY).touch()
            _made = made
        return _made


def called() -> dict[str, Callable[..., Any]]:
    """What the functions of `engines` call, and what that calls, and so on, by module and name."""
    found: dict[str, Callable[..., Any]] = {}
    waiting = list(engines.FUNCTIONS.values())
    while waiting:
        function = waiting.pop()
        for name in function.__code__.co_names:
            value = function.__globals__.get(name)
            if inspect.isfunction(value) and f"{value.__module__}.{value.__name__}" not in found:
                found[f"{value.__module__}.{value.__name__}"] = value
                waiting.append(value)
    return found


def cache_folder() -> Path:
    """Where the functions are kept, compiled for this machine."""
    return user_cache() / f"step-check-{_digest()}"


@cache
def _digest() -> str:
    """What says that compiled functions are those of these sources, and of what compiles them here."""
    digest = hashlib.sha256(Path(__file__).read_bytes())
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(str(source).encode() + source.read_bytes())
    packages = [f"{package} {version(package)}" for package in ("numba", "llvmlite", "numpy")]
    digest.update(f"{packages} {sys.version} {platform.machine()}".encode())
    return digest.hexdigest()[:24]


def _told(folder: Path) -> engines.Engine:
    """The functions as Numba's, compiled for arrays."""
    import numba
    from numba import extending

    # Numba's annotations know fewer options than Numba does.
    for function in called().values():
        options: Any = {**_CALLED, "forceinline": True} if function.__name__ in _INLINED else _CALLED
        extending.register_jitable(**options)(function)
    config: Any = numba.config
    typeof: Any = numba.typeof
    kept = config.CACHE_DIR
    config.CACHE_DIR = str(folder)
    try:
        made = {name: numba.njit(cache=True, **_OPTIONS)(one) for name, one in engines.FUNCTIONS.items()}
    finally:
        config.CACHE_DIR = kept
    for name, arguments in _samples().items():
        made[name].compile(tuple(typeof(one) for one in arguments))
    return engines.arrays(made)


def _samples() -> dict[str, tuple[Any, ...]]:
    """Arguments like those that each function is given."""
    import numpy as np

    words, numbers, marks = np.zeros(1, np.int64), np.zeros(1, np.int32), np.zeros(1, np.uint8)
    kinds: dict[str, Any] = {"x": words, "y": words, "taken": np.zeros(1, np.uint16)}
    tables: list[Any] = [words] * len(Tables._fields)
    t, g = Tables(*tables), Graph(*(kinds.get(name, numbers) for name in Graph._fields))
    rows: list[Any] = [words if name in ("numbers", "masks") else numbers for name in Search._fields]
    s = Search(*rows)
    return {
        "advance": (t, g, 1),
        "expand": (t, 1, 1),
        "rehash": (g, 1, True),
        "repack": (g, 1, 1, words, words, True, True),
        "mark": (t, g, 1, 1, True, words, words, marks),
        "observe": (t, g, 1, 1, True, 1, words),
        "crossing": (g, 1, marks, marks),
        "search": (t, g, s, 1),
        "reach": (g, marks, 1, numbers, 1, numbers),
        "sample": (g, numbers, marks, numbers),
        "way": (g, 1, 1, marks, numbers, numbers),
    }


def _make_in_peace() -> None:
    """What `ask` does in its thread: a machine where it cannot be done goes on plain."""
    # As in `sim.compiling`: Numba may fail in any way on a machine we do not know.
    with suppress(Exception):
        if (cache_folder() / READY).is_file() or compile_elsewhere(__name__):
            make()
