"""A team as processes: an agent each, that meet over the network, and the world of simulated bodies.

The door opens lazily: Zenoh is imported when a channel is opened, and only then.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kitrobot.lazy import lazy_names

if TYPE_CHECKING:
    from kitrobot.fleet.agent_process import AgentBoard, AgentProcess, RunEnd
    from kitrobot.fleet.board_line import open_board
    from kitrobot.fleet.charter import LEASE_MS, LEAST_LEASE_MS, MOST_LEASE_MS, FleetError, charter_of
    from kitrobot.fleet.envelopes import TEAM_PROCESS
    from kitrobot.fleet.identity import identity_of
    from kitrobot.fleet.keys import VARIABLE, find_key, key_of, new_key
    from kitrobot.fleet.processes import Agents, end_of_input
    from kitrobot.fleet.run_source import FleetSource
    from kitrobot.fleet.status_reports import StatusReport, encode_report
    from kitrobot.fleet.team_process import FleetCallbacks, FleetRun, TeamProcess
    from kitrobot.fleet.transport import Channel, Network
else:
    # Hidden from mypy, which would take every name for one that there is.
    __getattr__ = lazy_names(
        __name__,
        {
            "agent_process": ("AgentBoard", "AgentProcess", "RunEnd"),
            "board_line": ("open_board",),
            "charter": ("LEASE_MS", "LEAST_LEASE_MS", "MOST_LEASE_MS", "FleetError", "charter_of"),
            "envelopes": ("TEAM_PROCESS",),
            "identity": ("identity_of",),
            "keys": ("VARIABLE", "find_key", "key_of", "new_key"),
            "processes": ("Agents", "end_of_input"),
            "run_source": ("FleetSource",),
            "team_process": ("FleetRun", "FleetCallbacks", "TeamProcess"),
            "status_reports": ("StatusReport", "encode_report"),
            "transport": ("Channel", "Network"),
        },
    )

__all__ = [
    "LEASE_MS",
    "LEAST_LEASE_MS",
    "MOST_LEASE_MS",
    "TEAM_PROCESS",
    "VARIABLE",
    "AgentBoard",
    "AgentProcess",
    "Agents",
    "Channel",
    "FleetCallbacks",
    "FleetError",
    "FleetRun",
    "FleetSource",
    "Network",
    "RunEnd",
    "StatusReport",
    "TeamProcess",
    "charter_of",
    "encode_report",
    "end_of_input",
    "find_key",
    "identity_of",
    "key_of",
    "new_key",
    "open_board",
]
