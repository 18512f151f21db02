"""The compiled step: `stepping.advance` through Numba, compiled once for a machine and kept in the user's cache folder.

Compiling takes about a minute, so nobody waits for it: `ask` begins it in a process of its own with low
priority, or, when it was done before, loads what is kept in a thread beside; `compiled` gives the step once it is
there. Numba works on the very functions that CPython runs: they are told to it here, and nothing is decorated. The
folder's name is a digest of their sources, of the constants they use and of what compiles them, so nothing stale is
ever taken.

Everything works without Numba, slower; the environment's KITROBOT_COMPILE=no says to do without it.
"""

from __future__ import annotations

import atexit
import hashlib
import importlib.util
import inspect
import os
import platform
import shutil
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

Advance = Callable[[Any, int], int]

_OPTIONS: dict[str, Any] = {"error_model": "numpy", "nogil": True, "_nrt": False}
"""Other threads go on beside. No division by zero can happen. Nothing is allocated, and the arrays are the caller's:
no references are counted."""

_CALLED: dict[str, Any] = {**_OPTIONS, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
"""Of what compiled functions call. Python calls none of it, and needs no wrapper for that."""

_POINTER_SOURCES = tuple(Path(__file__).with_name(name) for name in ("table_pointer.py", "numba_tables.py"))
"""What tells Numba how tables are reached."""

READY = "ready"
"""The file in the cache folder that says that all of it is there."""

MONTH_S = 30 * 24 * 3600

_lock = threading.Lock()
_making = threading.Lock()
_made: Advance | None = None
_asked: threading.Thread | None = None


def available() -> bool:
    """Whether there is a Numba to compile with, and nobody said not to."""
    return os.environ.get("KITROBOT_COMPILE", "") != "no" and importlib.util.find_spec("numba") is not None


def is_missed() -> bool:
    """Whether Numba could be installed here, and is not; nobody said to do without it."""
    # As in pyproject.toml: elsewhere the extra `fast` brings none.
    machine = platform.machine()
    has_wheel = machine in ("aarch64", "AMD64", "arm64") or (machine == "x86_64" and sys.platform != "darwin")
    return (
        has_wheel
        and sys.implementation.name == "cpython"
        and sys.version_info < (3, 16)
        and os.environ.get("KITROBOT_COMPILE", "") != "no"
        and not available()
    )


def ask() -> None:
    """Begins to make the compiled step beside everything else, unless it was begun before."""
    global _asked
    with _lock:
        if _asked is None and _made is None and available():
            _asked = threading.Thread(target=_make_in_peace, name="compiling", daemon=True)
            _asked.start()


def compiled() -> Advance | None:
    """The compiled step, if it is there."""
    return _made


def is_kept() -> bool:
    """Whether the compiled step is here already, or kept on this machine."""
    return available() and (_made is not None or (cache_folder() / READY).exists())


def wait() -> Advance | None:
    """The compiled step, made here and now if it is not there yet; None where it cannot be."""
    if _made is None and available():
        # As in `_make_in_peace`.
        with suppress(Exception):
            make()
    return _made


def loops() -> dict[str, Callable[..., Any]]:
    """Every function that the step is made of, by the name of its module and its own; not the step itself.

    They are found in the step, in what it calls, and so on.
    """
    from kitrobot.sim.stepping import advance

    found: dict[str, Callable[..., Any]] = {}
    waiting = [advance]
    while waiting:
        for value in _globals_of(waiting.pop()).values():
            name = f"{value.__module__}.{value.__name__}" if inspect.isfunction(value) else ""
            if name and name not in found and value is not advance:
                found[name] = value
                waiting.append(value)
    return found


def _globals_of(function: Any) -> dict[str, Any]:
    """What a function uses of its module, by name."""
    return {name: function.__globals__[name] for name in function.__code__.co_names if name in function.__globals__}


def cache_folder() -> Path:
    """Where this step is kept, compiled for this machine: in KITROBOT_CACHE or the user's cache folder."""
    from kitrobot.sim import arrays, dispatch, state, stepping
    from kitrobot.sim.devices import base

    digest = hashlib.sha256()
    functions = [stepping.advance, *loops().values()]
    modules = {__name__, arrays.__name__, base.__name__, state.__name__, *(one.__module__ for one in functions)}
    sources = {Path(str(sys.modules[name].__file__)) for name in modules}
    for source in sorted({*sources, *_POINTER_SOURCES}):
        digest.update(str(source).encode() + source.read_bytes())
    digest.update(dispatch.SOURCE.encode())
    for function in functions:
        used = sorted(_globals_of(function).items())
        numbers = [(name, value) for name, value in used if isinstance(value, int | float | tuple)]
        digest.update(f"{function.__name__} {numbers}".encode())
    for package in ("numba", "llvmlite", "numpy"):
        try:
            digest.update(f"{package} {version(package)}".encode())
        except PackageNotFoundError:
            digest.update(package.encode())
    digest.update(f"{sys.version} {platform.machine()}".encode())
    return user_cache() / f"step-{digest.hexdigest()[:24]}"


def user_cache() -> Path:
    """The folder for what is compiled: KITROBOT_CACHE, or the user's cache folder."""
    given = os.environ.get("KITROBOT_CACHE")
    if given:
        return Path(given)
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local"), "kitrobot", "cache")
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "kitrobot"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "kitrobot")


def make() -> Advance:
    """The compiled step, from the cache or anew; whoever calls this waits for it.

    Raises:
        Exception: whatever Numba or the file system says; nothing can be assumed of it.
    """
    global _made
    from kitrobot.sim.sample_state import small_state

    with _making:
        if _made is None:
            folder = cache_folder()
            folder.mkdir(parents=True, exist_ok=True)
            function = _told(folder)
            function(small_state(), 0)
            (folder / READY).touch()
            _forget_old(folder)
            _made = function
        return _made


def _forget_old(folder: Path) -> None:
    """Deletes what other versions left in the cache and nobody has used for a month."""
    used = (folder / READY).stat().st_mtime
    for other in folder.parent.glob("step-*"):
        with suppress(OSError):
            if other != folder and used - max(other.stat().st_mtime, _used(other)) > MONTH_S:
                shutil.rmtree(other, ignore_errors=True)


def _used(folder: Path) -> float:
    ready = folder / READY
    return ready.stat().st_mtime if ready.exists() else 0.0


def _told(folder: Path) -> Advance:
    """`advance` as a function of Numba's, which has been told everything that it calls."""
    import numba
    from numba import extending

    from kitrobot.sim import numba_tables, rows  # noqa: F401 (it tells Numba what a pointer to tables is)
    from kitrobot.sim.stepping import advance

    def same_arrays(one: Any, other: Any) -> Any:
        def same(one: Any, other: Any) -> bool:
            k = 0
            while k < len(one) and one[k] == other[k]:
                k += 1
            return k == len(one)

        return same

    def copy_arrays(to: Any, row: Any) -> Any:
        def copy_row(to: Any, row: Any) -> None:
            for k in range(len(row)):
                to[k] = row[k]

        return copy_row

    # Numba's annotations know fewer options than Numba does.
    options: Any = _CALLED
    extending.overload(rows.same, jit_options=options)(same_arrays)
    extending.overload(rows.copy_row, jit_options=options)(copy_arrays)
    for loop in loops().values():
        if loop.__module__ != rows.__name__:
            extending.register_jitable(**options)(loop)
    config: Any = numba.config
    kept = config.CACHE_DIR
    config.CACHE_DIR = str(folder)
    try:
        compiled: Any = numba.njit(cache=True, **_OPTIONS)(advance)
    finally:
        config.CACHE_DIR = kept
    return lambda state, steps: compiled(state.pointer, steps)


def _make_in_peace() -> None:
    """What `ask` does in its thread: a machine where it cannot be done goes on plain."""
    # Numba may fail in any way on a machine we do not know; the plain step is as right as the compiled one.
    with suppress(Exception):
        if (cache_folder() / READY).is_file() or compile_elsewhere():
            make()


def compile_elsewhere(module: str = __name__) -> bool:
    """Compiles in a process of its own, which has no part in our threads; whether it did."""
    command = [sys.executable, "-c", f"from {module} import make; make()"]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    nice: dict[str, Any] = {}
    if sys.platform == "win32":
        nice["creationflags"] = subprocess.BELOW_NORMAL_PRIORITY_CLASS | subprocess.CREATE_NO_WINDOW
    elif hasattr(os, "nice"):
        command = ["nice", "-n", "10", *command]
    with subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment, **nice
    ) as child:
        atexit.register(child.kill)
        try:
            return child.wait() == 0
        finally:
            atexit.unregister(child.kill)
