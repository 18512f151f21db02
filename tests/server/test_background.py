"""Work beside the loop, in threads and where calls are put to sleep instead: the same work, the same answers."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest

from kitrobot.live import background as module
from kitrobot.live.background import (
    BackgroundTask,
    StopSignal,
    WakeCondition,
    can_block,
    run_in_background,
    set_sleep_function,
)
from tests.patience import PATIENCE_S
from tests.server.sleeping_loop import SleepingLoop, sleep

Run = Callable[[Coroutine[Any, Any, Any]], Any]


@pytest.fixture(params=["threads", "sleeping calls"])
def run(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Runs a coroutine in each of the two."""
    threads = request.param == "threads"
    monkeypatch.setattr(module, "_threads", threads)
    monkeypatch.setattr(module, "_sleep", None if threads else sleep)

    def run(coroutine: Coroutine[Any, Any, Any]) -> Any:
        def whole() -> Any:
            with asyncio.Runner(loop_factory=None if threads else SleepingLoop) as runner:
                return runner.run(coroutine)

        # Playwright's loop counts as running in this thread once a worker has opened its browser.
        with ThreadPoolExecutor(1) as thread:
            return thread.submit(whole).result()

    return run


def test_what_waits_lets_the_loop_go_on_and_is_woken_whatever_the_order(run: Run) -> None:
    async def scenario() -> list[str]:
        turn, may, said = WakeCondition(), set[str](), list[str]()

        def wait(name: str) -> str:
            with turn:
                assert turn.wait_for(lambda: name in may, PATIENCE_S)
                said.append(name)
            return name

        waiting = [asyncio.ensure_future(run_in_background(wait, name)) for name in "abc"]
        for name in "bca":
            with turn:
                may.add(name)
                turn.notify_all()
            while name not in said:
                await asyncio.sleep(0)
        assert [await one for one in waiting] == ["a", "b", "c"]
        return said

    assert run(scenario()) == ["b", "c", "a"]


def test_a_wait_ends_with_its_time_and_what_is_raised_arrives(run: Run) -> None:
    async def scenario() -> None:
        turn = WakeCondition()

        def wait() -> bool:
            with turn:
                return turn.wait(0.001)

        def fail() -> None:
            with turn:
                turn.wait_for(lambda: False, 0.001)
            raise ZeroDivisionError

        assert await run_in_background(wait) is False
        with pytest.raises(ZeroDivisionError):
            await run_in_background(fail)

    run(scenario())


def test_what_was_begun_is_waited_for_but_not_for_ever(run: Run) -> None:
    async def scenario() -> None:
        turn, may, over = WakeCondition(), list[int](), list[int]()

        def work() -> None:
            with turn:
                turn.wait_for(lambda: may, PATIENCE_S)
            over.append(1)

        begun = BackgroundTask(work, "work")
        await run_in_background(begun.wait, 0.001)
        assert over == []
        with turn:
            may.append(1)
            turn.notify_all()
        await run_in_background(begun.wait, PATIENCE_S)
        assert over == [1]
        # Whoever asks once more is answered at once.
        await run_in_background(begun.wait, PATIENCE_S)

    run(scenario())


def test_work_that_nobody_wants_any_more_ends_without_a_word(run: Run) -> None:
    async def scenario() -> None:
        turn, over = WakeCondition(), list[int]()

        def work() -> None:
            with turn:
                turn.wait_for(lambda: over, PATIENCE_S)

        task = asyncio.ensure_future(run_in_background(work))
        await asyncio.sleep(0)
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        with turn:
            over.append(1)
            turn.notify_all()
        await asyncio.sleep(0)

    run(scenario())


def test_long_work_lets_the_loop_go_on_when_it_looks_whether_it_is_to_stop(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "YIELD_INTERVAL_S", -1)

    async def scenario() -> None:
        stop = StopSignal()

        def work() -> None:
            while not stop.is_set():
                pass

        task = asyncio.ensure_future(run_in_background(work))
        await asyncio.sleep(0)
        stop.set()
        await task

    run(scenario())


def test_work_can_wait_where_there_are_threads_or_calls_can_sleep(monkeypatch: pytest.MonkeyPatch) -> None:
    assert can_block()
    monkeypatch.setattr(module, "_sleep", None)
    monkeypatch.setattr(module, "_threads", False)
    assert not can_block()
    set_sleep_function(sleep)
    assert can_block()
