"""What every test may use: Hypothesis profiles and the browser's path."""

from __future__ import annotations

import gc
import os
import signal
import subprocess
import tempfile
from collections.abc import Callable, Generator

import hypothesis
import pytest

from kitrobot.text.collection import collection_paused
from tests import compiled_step
from tests.effort import THOROUGH
from tests.shares import in_shares
from tools import chromium, firefox, pico

# A shell starts what runs in its background deaf to Ctrl+C, and what that starts inherits it: some tests press it.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# What studios keep of their folders goes away with the tests.
_STATE = tempfile.TemporaryDirectory(prefix="kitrobot-state-")
os.environ.setdefault("KITROBOT_STATE", _STATE.name)

# Compiling the step would take the time of other tests; those that are about it ask for `with_numba`.
os.environ.setdefault("KITROBOT_COMPILE", "no")
os.environ.setdefault("KITROBOT_CACHE", str(compiled_step.CACHE))

# No deadlines: on a busy machine they fail tests that are right.
hypothesis.settings.register_profile("ci", max_examples=10, deadline=None, derandomize=True, print_blob=True)
hypothesis.settings.register_profile("thorough", max_examples=2000, deadline=None, print_blob=True)
hypothesis.settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "ci"))


def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """Two workers more than cores: boards, processes and pages are waited for, and no core is ever without work."""
    usable = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return usable + 2


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Keeps the garbage collector from what ten thousand tests and all modules take: a look at it takes 0.3 s."""
    with collection_paused():
        collected = yield
    gc.freeze()
    gc.set_threshold(5_000)
    return collected


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leaves out what only the thorough profile tries, what needs firmware that nobody names; none is skipped.

    The workers of pytest-xdist get those with a browser first, and last those that need the compiled step, which the
    first of them has made meanwhile.
    """
    names = [name for name, wanted in (("thorough", THOROUGH), ("pico", pico.find() is not None)) if not wanted]
    left_out = [item for item in items if any(item.get_closest_marker(name) for name in names)]
    if left_out:
        items[:] = [item for item in items if item not in left_out]
        config.hook.pytest_deselected(items=left_out)
    workers = getattr(config, "workerinput", {}).get("workercount", 1)
    if workers > 1:
        parted: dict[bool, list[pytest.Item]] = {True: [], False: []}
        compiled = [item for item in items if compiled_step.FIXTURES.intersection(getattr(item, "fixturenames", ()))]
        for item in items:
            if item not in compiled:
                parted[any(item.get_closest_marker(name) for name in ("browser", "slow"))].append(item)
        items[:] = in_shares(parted[True], [*parted[False], *compiled], workers)
        if compiled and config.workerinput["workerid"] == "gw0":  # type: ignore[attr-defined]
            config.add_cleanup(_ended_by(compiled_step.begin()))


def _ended_by(process: subprocess.Popen[bytes] | None) -> Callable[[], None]:
    """Ends a process, if it has not ended by itself."""

    def end() -> None:
        if process is not None:
            process.kill()
            process.wait()

    return end


@pytest.fixture(scope="session")
def chromium_path() -> str:
    """The Chromium of the machine, for Playwright's `executable_path`; its `args` are `tools.chromium.FLAGS`."""
    path = chromium.find()
    if path is None:
        # Not skipped: who leaves the browser tests out says so with -m.
        pytest.fail("no Chromium on this machine; install it, or leave these tests out with -m 'not browser'")
    return path


@pytest.fixture(scope="session")
def firefox_path() -> str:
    """The Firefox of the machine."""
    path = firefox.find()
    if path is None:
        pytest.fail("no Firefox on this machine; install it, or leave its tests out with -m 'not firefox'")
    return path
