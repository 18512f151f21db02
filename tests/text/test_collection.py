"""Reading pauses the garbage collector and leaves it as it was."""

from __future__ import annotations

import gc

import pytest

from kitrobot.lll.parse_results import parse
from kitrobot.text.collection import collection_paused


@pytest.fixture(autouse=True)
def _running():
    assert gc.isenabled()
    yield
    gc.enable()


def test_the_collector_runs_again_after_a_text_was_read():
    assert not parse("Wheel.Advance(").ok
    assert gc.isenabled()


def test_a_collector_that_stood_still_stays_so():
    gc.disable()
    parse("Wheel.Stop()")
    assert not gc.isenabled()


def test_the_collector_runs_again_after_the_outermost_pause_whatever_went_wrong():
    with collection_paused():
        with pytest.raises(ZeroDivisionError), collection_paused():
            1 / 0  # noqa: B018
        assert not gc.isenabled()
    assert gc.isenabled()
