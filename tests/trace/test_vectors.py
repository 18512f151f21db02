"""Recordings that were made before open as ever: one of a simulated run, one of a real robot."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.live.watched_recording import WatchedRecording
from kitrobot.trace.model import POSE_WORDS, ROBOT, TickRecord, TraceError, TraceHeader
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.source import walk
from kitrobot.trace.writer import TraceWriter
from kitrobot.workspace.replay import state_at, summary_of
from kitrobot.workspace.traces import open_trace

VECTORS = Path(__file__).parent / "vectors"


def test_a_simulated_run_from_before_real_ones_were_recorded() -> None:
    trace = open_trace(VECTORS / "simulated.krtrace")
    with trace.reader as reader:
        assert (reader.last_tick, reader.cut, reader.header.real) == (11, False, False)
        assert not reader.header.unplaced
        found = summary_of(trace)
        assert (found["outcome"], found["real"]) == ("done", False)
        assert state_at(trace, 0.1)["agents"]["robot-1"]["x_mm"] is not None
        assert WatchedRecording(trace).started("r").agents[0].placed


def test_a_real_robot_that_failed() -> None:
    trace = open_trace(VECTORS / "real.krtrace")
    with trace.reader as reader:
        assert (reader.last_tick, reader.cut, reader.header.real) == (50, False, True)
        assert [(event.tick, event.kind, event.cause) for _, event in reader.events] == [
            (5, "outside", "person"),
            (20, "outside", "person"),
            (40, "failure", ROBOT),
        ]
        found = state_at(trace, 0.5)["agents"]["micro:bit"]
        assert (found["values"], found["inputs"], found["forced"]) == (
            {"Count": 1, "Run": 1},
            {"ButtonA": 1},
            ["ButtonA"],
        )
        assert [place["vertex"] for place in found["vertices"]] == ["v5"]
        assert state_at(trace, 9)["agents"]["micro:bit"]["state"] == "failed"
        player = WatchedRecording(trace)
        assert not player.started("r").agents[0].placed
        walk(player.seek(40))
        _, news = player.encode_update()
        assert news["agents"]["micro:bit"]["active"] == [[0, "v3"]]
        assert {event["cause"] for event in news["events"]} == {"person", "robot"}


def changed(path: Path, header: TraceHeader) -> Path:
    """A recording of one empty moment, of that header."""
    with TraceWriter(path, header) as writer:
        writer.record(TickRecord(0, [0] * len(header.columns), [()] * len(header.agents)))
        writer.finish({"outcome": "stopped"})
    return path


def test_a_robot_with_a_piece_of_a_place_is_damage(tmp_path: Path) -> None:
    with TraceReader(VECTORS / "simulated.krtrace") as reader:
        header = reader.header
    for word in POSE_WORDS:
        columns = tuple(column for column in header.columns if column.name != word)
        fields = {name: getattr(header, name) for name in TraceHeader.__dataclass_fields__}
        made = TraceHeader(**{**fields, "columns": columns})
        with (
            open_trace(changed(tmp_path / "r.krtrace", made)).reader as reader,
            pytest.raises(TraceError, match="lacks"),
        ):
            WatchedRecording(open_trace(reader.path))


def test_a_real_robot_whose_program_is_not_in_the_mission_plays_without_vertices(tmp_path: Path) -> None:
    with TraceReader(VECTORS / "real.krtrace") as reader:
        header = reader.header
    fields = {name: getattr(header, name) for name in TraceHeader.__dataclass_fields__}
    agent = header.agents[0]
    other = type(agent)(agent.name, "gone", agent.robot)
    trace = open_trace(changed(tmp_path / "r.krtrace", TraceHeader(**{**fields, "agents": (other,)})))
    with trace.reader:
        assert state_at(trace, 0)["agents"]["micro:bit"]["vertices"] == []
        _, news = WatchedRecording(trace).encode_update()
        assert news["agents"]["micro:bit"]["active"] == []


def test_a_real_robots_recording_cut_anywhere_opens_or_says_why(tmp_path: Path) -> None:
    data = (VECTORS / "real.krtrace").read_bytes()
    path = tmp_path / "cut.krtrace"
    for length in range(0, len(data), 7):
        path.write_bytes(data[:length])
        try:
            trace = open_trace(path)
        except TraceError:
            continue
        with trace.reader:
            assert trace.reader.cut
            summary_of(trace)
