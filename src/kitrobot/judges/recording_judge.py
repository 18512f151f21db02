"""Judges properties by a recording: of a simulated run, of real robots, of a fleet; several properties in one pass."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

from kitrobot.judges.judgement import Judge, JudgeError, Judgement
from kitrobot.judges.record_monitor import RecordMonitor
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.mission_loader import OpenMission, open_mission
from kitrobot.workspace.traces import OpenTrace, open_trace, unpack


def judge_recording(
    path: Path, questions: Sequence[str] = (), mission: OpenMission | None = None, *, ready: bool = True
) -> list[Judgement]:
    """Judges a recording by properties.

    Args:
        path: the recording.
        questions: properties as text, or names of those of the mission; none for all that the mission has.
        mission: the mission whose properties are meant; None for the one in the recording.
        ready: whether those that every mission has are judged too, where there are no questions.

    Raises:
        TraceError: the recording cannot be read.
        JudgeError: the recording is of another mission.
        QuestionError: a question cannot be understood, or the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
    """
    trace = open_trace(path)
    reader = trace.reader
    with reader, tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        # Parts that are shipped need not be in it, and its own may be wrong: what is known then is enough.
        opened = open_mission(unpack(trace, Path(folder)))
        if mission is not None:
            _expect_same_team(trace, mission)
        judge, name = Judge.RECORDING, reader.path.name
        monitor = RecordMonitor(reader.header, opened, questions, judge, name, mission=mission, ready=ready)
        monitor.read_events([event for _, event in reader.events])
        for record in reader.walk(0) if monitor.is_open else ():
            monitor.read_values(record)
            if not monitor.is_open:
                break
        monitor.end(reader.last_tick, reader.outcome.get("outcome"))
        return monitor.judgements()


def _expect_same_team(trace: OpenTrace, mission: OpenMission) -> None:
    recorded = {agent.name: agent.program for agent in trace.reader.header.agents}
    asked = {agent.name: agent.program for agent in mission.mission.team.agents}
    if recorded != asked:
        raise JudgeError(
            Sentence("{recording} is of another mission than {mission}", trace.reader.path.name, mission.name),
            Sentence("its agents are: {recorded}; those of the mission are: {asked}", listed(recorded), listed(asked)),
        )
