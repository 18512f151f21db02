"""What Numba compiles: once for a machine, kept in the user's cache folder, made beside everything else.

Compiling takes a minute or more, so nobody waits for it: `Compilation.ask` begins it in a process of its own with low
priority, or, when it was done before, loads what is kept in a thread beside; then it is in `Compilation.made`. That
process goes on when the one that asked has ended, or short runs and checks would never have anything compiled. Each
function is kept as soon as it is done, one process at a time compiles (a lock in the cache folder says which), and it
ends by itself.
Numba works on the very functions that CPython runs: they are told to it here, and nothing is decorated.

Everything works without Numba, slower; the environment's KITROBOT_COMPILE=no says to do without it.
"""

from __future__ import annotations

import hashlib
import importlib.util
import inspect
import os
import platform
import shutil
import subprocess
import sys
import threading
from collections.abc import Callable, Iterable
from contextlib import suppress
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from types import ModuleType
from typing import Any, Generic, TypeVar

from kitrobot.files.file_lock import FileLock
from kitrobot.user_folders import cache_folder

Made = TypeVar("Made")

_OPTIONS: dict[str, Any] = {"error_model": "numpy", "nogil": True, "_nrt": False}
"""Other threads go on beside. No division by zero can happen. Nothing is allocated, and the arrays are the caller's:
no references are counted."""

CALLED: dict[str, Any] = {**_OPTIONS, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
"""Of what compiled functions call. Python calls none of it, and needs no wrapper for that."""

READY = "ready"
"""The file in the cache folder that says that all of it is there."""

LOCK = "compiling.lock"
"""The file in the cache folder that is locked while a process compiles."""

LONGEST_S = 3600.0
"""After so many seconds a process that compiles gives up; what it has compiled until then is kept."""

_BUSY = 3
"""The status of a process that compiles nothing, since another one does."""

MONTH_S = 30 * 24 * 3600

_SOURCES = tuple(Path(__file__).with_name(name) for name in ("cache.py", "table_pointer.py", "numba_tables.py"))
"""What tells Numba how to compile, and how tables are reached."""


def available() -> bool:
    """Whether there is a Numba to compile with, and nobody said not to."""
    try:
        return os.environ.get("KITROBOT_COMPILE", "") != "no" and importlib.util.find_spec("numba") is not None
    except ImportError:
        return False  # an import hook of the process refuses it


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


class Compilation(Generic[Made]):
    """Functions that are compiled when they are asked for.

    Attributes:
        made: what was compiled, once it is there.
        asked: the thread that makes it, once it was asked for.
    """

    def __init__(self, name: str, folder: Callable[[], Path], build: Callable[[Path], Made]) -> None:
        """Compiles nothing yet.

        Args:
            name: under which a module has this value, as `module:name`; another process makes it by that.
            folder: where it is kept: one folder for these very sources (see `folder_of`).
            build: makes it from what is in the folder, or anew.
        """
        self.made: Made | None = None
        self._is_refused = False
        self.asked: threading.Thread | None = None
        self._name = name
        self._folder = folder
        self._build = build
        self._asking = threading.Lock()
        self._making = threading.Lock()

    def ask(self) -> None:
        """Begins to make it beside everything else, unless that was begun before, or another process compiles; where
        one did, and is done, asking again begins anew.
        """
        with self._asking:
            if self.made is not None or not available():
                return
            if self.asked is None or (self._is_refused and not FileLock.is_taken(_lock())):
                self._is_refused = False
                self.asked = threading.Thread(target=self._make_in_peace, name="compiling", daemon=True)
                self.asked.start()

    def is_kept(self) -> bool:
        """Whether it is here already, or kept on this machine."""
        return available() and (self.made is not None or self._is_ready())

    def wait(self) -> Made | None:
        """It, made here and now if it is not there yet; None where that cannot be."""
        if self.made is None and available():
            # As in `_make_in_peace`.
            with suppress(Exception):
                self.make()
        return self.made

    def make(self) -> Made:
        """It, from the cache or anew; whoever calls this waits for it.

        Raises:
            Exception: whatever Numba or the file system says; nothing can be assumed of it.
        """
        with self._making:
            if self.made is None:
                folder = self._folder()
                folder.mkdir(parents=True, exist_ok=True)
                made = self._build(folder)
                (folder / READY).touch()
                _forget_old(folder)
                self.made = made
            return self.made

    def make_alone(self) -> None:
        """Makes it in this process, which is there for nothing else; it ends where another one compiles already.

        Raises:
            SystemExit: another one does.
        """
        deadline = threading.Timer(LONGEST_S, os._exit, [1])
        deadline.daemon = True
        deadline.start()
        lock = None
        # Where files cannot be locked, two may compile the same.
        with suppress(OSError):
            cache_folder().mkdir(parents=True, exist_ok=True)
            lock = FileLock.take(_lock())
            if lock is None:
                sys.exit(_BUSY)
        try:
            self.make()
        finally:
            if lock is not None:
                lock.release()

    def _is_ready(self) -> bool:
        return (self._folder() / READY).is_file()

    def _make_in_peace(self) -> None:
        """What `ask` does in its thread: a machine where it cannot be done goes on plain."""
        # Numba may fail in any way on a machine we do not know; plain functions are as right as compiled ones.
        with suppress(Exception):
            status = 0 if self._is_ready() else _make_elsewhere(*self._name.split(":"))
            if status == 0:
                self.make()
            self._is_refused = status == _BUSY


def functions_called(roots: Iterable[Callable[..., Any]]) -> dict[str, Callable[..., Any]]:
    """What functions call, and what that calls, and so on, by module and name."""
    waiting = list(roots)
    found: dict[str, Callable[..., Any]] = {}
    while waiting:
        for value in globals_of(waiting.pop()).values():
            name = f"{value.__module__}.{value.__name__}" if inspect.isfunction(value) else ""
            if name and name not in found:
                found[name] = value
                waiting.append(value)
    return found


def globals_of(function: Any) -> dict[str, Any]:
    """What a function uses of its module, by name."""
    return {name: function.__globals__[name] for name in function.__code__.co_names if name in function.__globals__}


def njit(folder: Path, functions: Iterable[Callable[..., Any]]) -> list[Any]:
    """Functions as Numba's, compiled when they are first called or told to, and kept in a folder."""
    import numba

    config: Any = numba.config
    kept = config.CACHE_DIR
    config.CACHE_DIR = str(folder)
    try:
        return [numba.njit(cache=True, **_OPTIONS)(function) for function in functions]
    finally:
        config.CACHE_DIR = kept


def folder_of(begin: str, functions: Iterable[Callable[..., Any]], modules: Iterable[ModuleType], *more: str) -> Path:
    """A folder in the cache whose name is a digest: of the modules of these functions and the numbers that they take
    from others, of these modules, of what compiles them, and of more.

    So nothing stale is ever taken.
    """
    names, texts = {module.__name__ for module in modules}, [*more]
    for function in functions:
        used = globals_of(function).items()
        names |= {function.__module__, *(value.__name__ for _, value in used if isinstance(value, ModuleType))}
        numbers = [(name, value) for name, value in used if isinstance(value, int | float | tuple)]
        texts.append(f"{function.__name__} {sorted(numbers)}")
    digest = hashlib.sha256()
    for source in sorted({*_SOURCES, *(Path(str(sys.modules[name].__file__)) for name in names)}):
        digest.update(str(source).encode() + source.read_bytes())
    for text in texts:
        digest.update(text.encode())
    for package in ("numba", "llvmlite", "numpy"):
        try:
            digest.update(f"{package} {version(package)}".encode())
        except PackageNotFoundError:
            digest.update(package.encode())
    digest.update(f"{sys.version} {platform.machine()}".encode())
    return cache_folder() / f"{begin}-{digest.hexdigest()[:24]}"


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


def _lock() -> Path:
    return cache_folder() / LOCK


def _make_elsewhere(module: str, name: str) -> int:
    """Compiles in a process of its own, which has no part in our threads, and goes on without us; its status."""
    command = [sys.executable, "-c", f"from {module} import {name}; {name}.make_alone()"]
    # The folder that we are in may be taken away while it goes on.
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(os.path.abspath, sys.path))}
    apart: dict[str, Any] = {"start_new_session": True}
    if sys.platform == "win32":
        flags = subprocess.BELOW_NORMAL_PRIORITY_CLASS | subprocess.CREATE_NO_WINDOW
        apart = {"creationflags": flags | subprocess.CREATE_NEW_PROCESS_GROUP}
    elif hasattr(os, "nice"):
        command = ["nice", "-n", "10", *command]
    nothing = subprocess.DEVNULL
    child = subprocess.Popen(
        command, stdin=nothing, stdout=nothing, stderr=nothing, env=environment, cwd=os.path.abspath(os.sep), **apart
    )
    return child.wait()
