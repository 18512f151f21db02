"""The run of a fleet as everybody sees it: its past is read from its trace while it goes on."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.fleet import run_source as module
from kitrobot.fleet.run_source import FleetSource
from kitrobot.fleet.status_reports import StatusReport, decode_report, encode_report
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import TraceError
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.source import AbilityError, walk
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.mission_run import RunOptions


@pytest.fixture
def run() -> Simulation:
    return open_mission(Path("examples/heart/heart.krt")).prepare(RunOptions()).simulation


def stepped(source: FleetSource, run: Simulation, ticks: int) -> None:
    for _ in range(ticks):
        run.step()
        source.step()


def test_it_is_gone_back_in_while_it_goes_on_and_ends_where_it_ended(
    run: Simulation, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "MOST_RECENT_NUMBERS", 0)
    pressed: list[bool] = []
    source = FleetSource(run, tmp_path / "run.krtrace", (), lambda: pressed.append(True))
    source.step()
    stepped(source, run, 100)
    assert (source.tick, source.latest, source.outcome) == (0, 100, None)
    # What is long ago is in the file, what was just now is at hand: both are the same run.
    seen = []
    while source.advance(7):
        seen.append((source.tick, source.record().numbers, source.active()))
    assert [tick for tick, _, _ in seen] == [*range(7, 100, 7), 100]
    for tick, numbers, active in reversed(seen):
        walk(source.seek(tick))
        assert (source.tick, source.record().numbers, list(source.active())) == (tick, numbers, list(active))
    stepped(source, run, 60)
    walk(source.seek(999))
    assert source.tick == 160
    now = list(source.active())
    walk(source.seek_back(lambda: list(source.active()) != now))
    assert source.tick < 160
    for act in (
        lambda: source.force("robot-1", "x", 1),
        lambda: source.set_variable("robot-1", "x", 1),
        lambda: source.fail("robot-1", "fail"),
    ):
        with pytest.raises(AbilityError, match="process of its own"):
            act()
    source.record_to(tmp_path / "so-far.krtrace")
    source.finish("stuck", Sentence("nothing stirs"))
    assert (source.has_ended, source.outcome) == (True, None)
    source.advance(999)
    assert (source.outcome, source.sentence) == ("stuck", "nothing stirs")
    source.record_to(tmp_path / "whole.krtrace")
    for name, outcome in (("so-far", "stopped"), ("whole", "stuck")):
        with TraceReader(tmp_path / f"{name}.krtrace") as recorded:
            assert (recorded.last_tick, recorded.outcome["outcome"], recorded.cut) == (160, outcome, False)
    source.close()
    assert pressed == [True]


def test_a_full_disk_ends_the_recording_and_not_the_run(run: Simulation, tmp_path: Path) -> None:
    source = FleetSource(run, tmp_path / "run.krtrace", (), lambda: None)
    source.step()

    def full(data: bytes) -> None:
        raise TraceError(Sentence("the trace {path} cannot be written: {reason}", "run", "no room"))

    source._writer._write = full  # type: ignore[method-assign]
    stepped(source, run, 900)
    source.advance(5000)
    assert source.tick == 900
    with pytest.raises(TraceError, match="no room"):
        source.record_to(tmp_path / "copy.krtrace")
    source.finish("done", "")
    source.close()


def test_what_an_agent_says_is_read_as_it_was_said_and_other_lines_are_passed_over() -> None:
    told = StatusReport(
        Sentence("refused: {why}", Sentence("a message of another run")), Sentence("press Run for that"), True
    )
    again = decode_report(encode_report(told))
    assert again == told
    assert isinstance(again.sentence, Sentence)
    assert again.sentence.template == "refused: {why}"
    for line in (b"", b"\n", b"hello\n", encode_report(told)[:40], b"AAAA\n", b"\xff" * 70_000):
        assert decode_report(line) is None
