"""What the page is told of a team while it runs: roles, groups, who waits for whom; the same of a recording."""

from __future__ import annotations

import contextlib
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from kitrobot.live.run_encoder import RunEncoder
from kitrobot.live.team_snapshots import TeamSnapshotEncoder
from kitrobot.sim.recorder import Recorder
from kitrobot.trace.header import header_from_json, header_to_json
from kitrobot.trace.model import TEAM, TraceError, TraceHeader
from kitrobot.trace.reader import TraceReader
from kitrobot.workspace.first_team import first_team
from kitrobot.workspace.mission_loader import open_mission, with_mission
from kitrobot.workspace.search_path import SearchPath

EXAMPLES = Path(__file__).parents[2] / "examples"
CONVOY = EXAMPLES / "convoy" / "convoy.krt"


def told(steps: int) -> list[dict[str, Any]]:
    simulation = open_mission(CONVOY).simulation()
    recorder = Recorder(simulation)
    encoder = RunEncoder(recorder.header)
    news = []
    for _ in range(steps):
        record = recorder.record()
        news.append(encoder.encode_changes(record, record.tick, False, record.events))
        simulation.step()
    return news


def test_roles_groups_and_changes_are_told_when_they_change() -> None:
    news = [one for one in told(230) if one["team"] is not None]
    first, last = news[0]["team"], news[-1]["team"]
    assert [(one["name"], one["role"], one["groups"]) for one in first["members"]] == [
        ("robot-1", "leader", ["convoy"]),
        ("robot-2", "follower", ["convoy"]),
        ("robot-3", "follower", ["convoy"]),
        ("robot-4", "", []),
    ]
    assert first["meetings"] == []
    lost, substitute = last["members"][1], last["members"][3]
    assert (lost["role"], lost["missed"]) == ("", True)
    assert (substitute["role"], substitute["stands_for"], substitute["groups"]) == ("follower", "robot-2", ["convoy"])
    [meeting] = last["meetings"]
    assert (meeting["program"], meeting["vertex"]) == ("convoy", "v5")
    assert (meeting["here"], meeting["missing"]) == (["robot-1", "robot-3"], ["robot-4"])
    assert (meeting["here_count"], meeting["count"]) == (2, 3)
    assert len(news) < 20, "it is told only when it changes"


def test_what_changes_a_team_is_an_event_of_its_own_kind() -> None:
    kinds = [(event["kind"], event["agent"]) for one in told(230) for event in one["events"]]
    assert kinds == [("failure", "robot-2"), ("member", "robot-2"), ("member", "robot-4")]


def test_a_recording_is_told_as_the_run_was(tmp_path: Path) -> None:
    opened = open_mission(CONVOY)
    opened.run(trace=tmp_path / "a.krtrace")
    reader = TraceReader(tmp_path / "a.krtrace")
    with contextlib.closing(reader):
        encoder = RunEncoder(reader.header)
        record = reader.seek(220)
        assert encoder.encode_snapshot(record, 220, [])["team"] == [one["team"] for one in told(221) if one["team"]][-1]


def test_threads_in_a_program_that_stands_in_the_team_s_are_told_with_its_name() -> None:
    alone = open_mission(EXAMPLES / "square" / "square.krt")
    folder = SearchPath(EXAMPLES / "square")
    simulation = with_mission(first_team(alone, "team"), "square", folder).simulation()
    recorder = Recorder(simulation)
    encoder = RunEncoder(recorder.header)
    inner: set[tuple[str, str]] = set()
    for _ in range(100):
        record = recorder.record()
        [report] = encoder.encode_snapshot(record, record.tick, [])["agents"].values()
        inner |= {(program, vertex) for _, program, vertex in report["inner"]}
        simulation.step()
    known = {vertex.id for vertex in alone.mission.programs[0].vertices}
    assert inner
    assert {program for program, _ in inner} == {alone.mission.programs[0].name}
    assert {vertex for _, vertex in inner} <= known


def header() -> TraceHeader:
    return Recorder(open_mission(CONVOY).simulation()).header


def test_the_plan_travels_in_the_header() -> None:
    assert header_from_json(json.loads(json.dumps(header_to_json(header())))) == header()


@pytest.mark.parametrize(
    ("key", "value"),
    [("plan", {}), ("plan", []), ("plan", {"members": [1]}), ("inner", {"a": [["b"]]}), ("inner", {"a": "b"})],
)
def test_a_header_whose_plan_makes_no_sense_is_refused(key: str, value: object) -> None:
    data = {**header_to_json(header()), key: value}
    with pytest.raises(TraceError):
        header_from_json(data)


def test_numbers_that_count_nothing_are_left_out() -> None:
    one = header()
    row = [2**60] * len(one.columns)
    snapshot = TeamSnapshotEncoder(one).encode(row)
    assert snapshot is not None
    assert {(member["role"], member["stands_for"]) for member in snapshot["members"]} == {("", "")}
    assert snapshot["meetings"] == []
    assert one.plan is not None
    assert snapshot["groups"] == list(one.plan.groups)
    bare = replace(one, columns=tuple(column for column in one.columns if column.owner != TEAM))
    assert TeamSnapshotEncoder(bare).encode([0] * len(bare.columns)) is None
    assert TeamSnapshotEncoder(replace(one, plan=None)).encode(row) is None
