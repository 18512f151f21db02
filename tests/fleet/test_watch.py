"""Properties that are watched while a fleet runs: what is said meanwhile is what its recording says afterwards."""

from __future__ import annotations

import json
import random
import re
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.cli.agent import prepare_team_run
from kitrobot.fleet.envelopes import TEAM_PROCESS
from kitrobot.fleet.processes import Agents
from kitrobot.fleet.run_source import FleetSource
from kitrobot.fleet.team_process import FleetCallbacks, FleetRun, TeamProcess
from kitrobot.judges.fleet_watch import FleetWatch
from kitrobot.judges.judgement import Judge, JudgeAnswer, Judgement
from kitrobot.judges.recording_judge import judge_recording
from kitrobot.sim.recorder import Recorder, outcome_of
from kitrobot.sim.simulation import Simulation
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.writer import TraceWriter
from kitrobot.workspace import fleets
from kitrobot.workspace.fleets import FleetPlan
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.mission_run import RunOptions
from tests.effort import examples
from tests.fleet.bus import Bus
from tests.fleet.network import LEASE, Faults, Fleet
from tests.fleet.test_convoy import CONVOY
from tests.judges.test_agreement import QUESTIONS, mutant, opened_mission

READY = ("deadlock", "done", "stuck within 3", "time", "any ada (Count.EqualTo(2)) within 0.7")


def recorded_by(said: list[Judgement], path: Path) -> list[Judgement]:
    """The same, as a recording says it."""
    return [replace(one, judge=Judge.RECORDING, subject=path.name) for one in said]


def watched_fleet(opened: OpenMission, path: Path, faults: Faults, killed: int, ticks: int) -> FleetWatch:
    """A fleet of two agents, watched and recorded up to a tick; at another one the first agent is killed."""
    fleet = Fleet(lambda: opened.prepare(RunOptions(1, 12.0)).simulation)
    fleet.faults = faults
    recorder = Recorder(fleet.run)
    said: list[str] = []
    watch = FleetWatch(recorder.header, opened, (*QUESTIONS, *READY), said.append)
    with TraceWriter(path, recorder.header) as writer:

        def on_step() -> None:
            record = recorder.record()
            before = len(watch.broken)
            watch.after_step(record, fleet.run.outcome)
            assert all(one.tick <= record.tick for one in watch.broken[before:])
            writer.record(record)

        fleet.on_step = on_step
        on_step()
        while fleet.run.outcome is None and fleet.run.tick < ticks:
            if fleet.run.tick >= killed and 0 in fleet.hosts:
                fleet.kill(0)
            fleet.step()
        writer.finish(outcome_of(fleet.run))
    assert len(said) == len(watch.broken)
    return watch


@settings(max_examples=examples(6, 150), deadline=None)
@given(
    seed=st.integers(0, 10_000),
    loss=st.sampled_from((0, 20)),
    delay=st.sampled_from((0, 30)),
    killed=st.sampled_from((9999, 9999, 20, 60)),
    ticks=st.sampled_from((9999, 9999, 70)),
)
def test_what_is_said_of_a_fleet_while_it_runs_is_what_its_recording_says(
    tmp_path_factory: pytest.TempPathFactory, seed: int, loss: int, delay: int, killed: int, ticks: int
) -> None:
    path = tmp_path_factory.mktemp("fleet") / "run.krtrace"
    opened = opened_mission(mutant(random.Random(seed)))
    watch = watched_fleet(opened, path, Faults(loss=loss, delay=delay), killed, ticks)
    said = watch.judgements()
    assert recorded_by(said, path) == judge_recording(path, (*QUESTIONS, *READY))
    # What broke was said at once, and is an event of its tick.
    ends = [one for one in said if one.ruling is JudgeAnswer.BROKEN]
    assert sorted((one.question, one.tick) for one in watch.broken) == sorted((one.question, one.tick) for one in ends)
    with TraceReader(path) as trace:
        events = [event.text for _, event in trace.events if "the property " in event.text]
    assert events == [f"the property {one.question} is broken" for one in watch.broken]


def test_what_a_fleet_does_not_record_is_not_decided() -> None:
    opened = opened_mission({"ada": "WAIT(3);", "bob": "WAIT(3);"})
    run = opened.prepare(RunOptions(1, 12.0)).simulation
    recorder = Recorder(run)
    unknown = [one for one in recorder.header.columns if (one.owner, one.name) != ("ada", "variable Count")]
    header = replace(recorder.header, columns=tuple(unknown))
    watch = FleetWatch(header, opened, ("never any ada (Count.EqualTo(0))",), lambda sentence: None)
    watch.after_step(recorder.record(), None)
    [said] = watch.judgements()
    assert said.ruling is JudgeAnswer.NOT_DECIDED
    assert said.reason == "what ada read and stored was not recorded, or its robot has changed"


def test_the_run_that_a_page_sees_has_what_breaks_among_its_events(tmp_path: Path) -> None:
    opened = opened_mission({"ada": "WAIT(9);", "bob": "WAIT(9);"})
    run = opened.prepare(RunOptions(1, 12.0)).simulation
    source = FleetSource(run, tmp_path / "run.krtrace", (), lambda: None)
    said: list[str] = []
    source.on_record = FleetWatch(source.header, opened, ("done within 0.1",), said.append).after_step
    for _ in range(7):
        source.step()
        run.step()
    assert said == ["the property `done within 0.1` is broken at 0.10 s"]
    assert [(one.tick, one.text) for one in source.new_events(99).events if one.kind == "message"] == [
        (5, "the property done within 0.1 is broken")
    ]
    source.finish("stopped", "")
    source.close()


@pytest.fixture
def convoy(tmp_path: Path, bus: Bus, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The example without its scheduled failure, and a bus on which its fleet runs."""

    def run_on_bus(simulation: Simulation, plan: FleetPlan, agents: Agents, callbacks: FleetCallbacks) -> FleetRun:
        for i in range(len(plan.names)):
            bus.agent(i)
        team = TeamProcess(simulation, bus.channel(TEAM_PROCESS), LEASE, 1.0, dict, callbacks)
        team.gather(60)
        return team.run()

    monkeypatch.setattr(fleets, "run_fleet", run_on_bus)
    for beside in CONVOY.parent.iterdir():
        shutil.copy(beside, tmp_path)
    text = re.sub(r"<failure [^>]*/>", "", CONVOY.read_text(encoding="utf-8"))
    text = text.replace(
        "</kitrobot>", '<property name="never at once" never="any robot-1 (Captor.LessThan(0))"/></kitrobot>'
    )
    file = tmp_path / "convoy.krt"
    file.write_text(text, encoding="utf-8")
    bus.anew = lambda: prepare_team_run(file, RunOptions()).simulation
    return file


def test_a_property_that_breaks_stops_the_team(convoy: Path, tmp_path: Path, kitrobot: Any, bus: Bus) -> None:
    trace = tmp_path / "run.krtrace"
    asked = ("done within 1", "never any robot-1 (Captor.LessThan(0))")
    words = [word for one in asked for word in ("--watch", one)]
    found = kitrobot("team", convoy, *words, "--stop-on-broken", "--trace", trace, "--json")
    assert found.status == 1, found.err
    result = json.loads(found.out)
    assert (result["outcome"], result["sentence"]) == (
        "stopped",
        "Stopped, since the property `done within 1` is broken.",
    )
    assert sorted(result["stopped_ms"]) == ["robot-1", "robot-2", "robot-3", "robot-4"]
    assert all(one.agent.host is not None and one.agent.host.stopped for one in bus.processes)
    assert "the property `done within 1` is broken at 1.00 s" in found.err
    assert [one["ruling"] for one in result["watched"]] == ["broken", "kept"]
    afterwards = [one.to_json() for one in judge_recording(trace, asked)]
    assert [one | {"judge": "team", "of": str(convoy)} for one in afterwards] == result["watched"]


def test_a_property_that_breaks_and_does_not_stop_the_team_is_in_its_status(convoy: Path, kitrobot: Any) -> None:
    found = kitrobot("team", "--watch", convoy, "--watch", "done within 1", "--seconds", "1.5")
    assert found.status == 1
    assert "  outcome     time" in found.out
    assert "team  broken" in found.out
    assert "never at once: never `any robot-1 (Captor.LessThan(0))`" in found.out
