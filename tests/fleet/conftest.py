"""The command line as `tests/cli` calls it, and a bus in the place of a network."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from kitrobot.fleet import agent_process
from kitrobot.fleet import team_process as team_processes
from tests.cli.conftest import here, kitrobot
from tests.fleet.bus import Bus

__all__ = ["here", "kitrobot"]


@pytest.fixture
def bus(monkeypatch: pytest.MonkeyPatch) -> Bus:
    """In the place of a network and its clock: what is waited for comes at once."""
    one = Bus()
    monkeypatch.setattr(agent_process, "milliseconds", lambda: one.now)
    monkeypatch.setattr(team_processes, "milliseconds", lambda: one.now)
    monkeypatch.setattr(team_processes, "time", SimpleNamespace(sleep=lambda seconds: one.pass_by()))
    return one
