"""One property, several judges: missions with mistakes, put into them at random, and what each judge finds in them.

What a judge finds, the others that are able to must find too. A recording says what its run says; a run that breaks a
property is an order of events, so a finished check has one too; the first of many runs is the run; and what a check
confirms, that run shows. Correct missions are broken by nobody.
"""

from __future__ import annotations

import random
import re
from dataclasses import replace
from pathlib import Path

import pytest

import kitrobot
from kitrobot import OpenMission
from kitrobot.checking.verification import VerificationOptions, verify
from kitrobot.checking.verification_result import Verification
from kitrobot.experiments.run_question import RunJudge
from kitrobot.judges import mission_judges
from kitrobot.judges.judgement import Judge, JudgeAnswer, Judgement
from kitrobot.judges.many_runs import FailureOptions
from kitrobot.judges.mission_judges import JudgeOptions, judge_mission
from kitrobot.judges.record_monitor import RecordMonitor
from kitrobot.judges.recording_judge import judge_recording
from kitrobot.judges.run_watch import RunWatch
from kitrobot.mission.property_text import read_property
from kitrobot.sim.event_text import Event
from kitrobot.sim.recorder import Recorder
from kitrobot.workspace.mission_run import PreparedRun, RunOptions
from tests.effort import examples
from tests.verifier.check_fixtures import mutant as mutant_of_transport

SOURCES = {
    "ada": "Wheel.Advance(50); WAIT(10); Count.Add(1); WAIT(10); Count.Add(1); Wheel.Stop();",
    "bob": "WAIT(25); Count.Add(1); WAIT(8); Level.Add(1); WAIT(5); Count.Add(1); Wheel.Stop();",
}
"""Two robots that count; the second one begins when the first one has ended."""
QUESTIONS = (
    "never any bob (Count.GreaterThan(0)) while any ada (Count.LessThan(2))",
    "eventually any bob (Count.EqualTo(2))",
    "after any ada (Count.EqualTo(1)) eventually any ada (Count.EqualTo(2))",
    "stays any ada (Count.EqualTo(1)) until any ada (Count.EqualTo(2))",
    "at most 1 times any ada (Count.EqualTo(1))",
    "any ada (Count.EqualTo(2)) before any bob (Count.EqualTo(1))",
    "again and again any bob (Count.EqualTo(2))",
    "visit any ada (Count.EqualTo(2)); any bob (Count.EqualTo(2))",
    "visit any ada (Count.EqualTo(1)); any ada (Count.EqualTo(2)); any bob (Count.EqualTo(2)) in this order",
    "holds any ada (Count.EqualTo(1)) for 0.9",
    "after any ada (Count.EqualTo(2)) eventually any bob (Count.EqualTo(2)) within 2",
    "done within 20",
)
KEPT_BY_TIME = 3
"""The questions at the end that count seconds, or ask for an outcome: a check has none."""


def opened_mission(sources: dict[str, str]) -> OpenMission:
    starts = tuple(kitrobot.Start(name, pose=kitrobot.Pose(200, 150 + 250 * n, 0.0)) for n, name in enumerate(sources))
    programs = [kitrobot.read_program(text, "mini-robot", f"{name}-runs") for name, text in sources.items()]
    team = kitrobot.Team([kitrobot.Agent(name, f"{name}-runs") for name in sources])
    world = kitrobot.World("yard", 2000, 600, starts=starts)
    return kitrobot.open_mission(kitrobot.Mission(programs=programs, team=team, own_world=world))


def mutant(rng: random.Random) -> dict[str, str]:
    """The mission with one mistake: a line dropped, said twice, or swapped; another number; another name."""
    made = dict(SOURCES)
    name = rng.choice(list(made))
    lines = [line.strip() for line in made[name].split(";") if line.strip()]
    at = rng.randrange(len(lines) - 1)
    match rng.choice(("drop", "twice", "swap", "number", "name")):
        case "drop":
            del lines[at]
        case "twice":
            lines.insert(at, lines[at])
        case "swap":
            lines[at], lines[at + 1] = lines[at + 1], lines[at]
        case "number":
            lines = [
                re.sub(r"[0-9]+", str(rng.randint(1, 40)), line) if n == at else line for n, line in enumerate(lines)
            ]
        case "name":
            lines = [line.replace("Count", "Level") if n >= at else line for n, line in enumerate(lines)]
    made[name] = "; ".join(lines) + ";"
    return made


def ask(opened: OpenMission, folder: Path) -> dict[Judge, list[Judgement]]:
    """What each judge says of each question, in their order."""
    trace = folder / "run.krtrace"
    trace.unlink(missing_ok=True)
    recorded = opened.prepare(RunOptions(1, 30.0, 0.0, trace))
    run = recorded.simulation
    watch, recorder = RunWatch(run, QUESTIONS), Recorder(run)
    monitor = RecordMonitor(recorder.header, opened, QUESTIONS, Judge.TEAM, "")
    broken = monitor.follow(recorder.record())

    def after_step() -> list[Event]:
        broken.extend(monitor.follow(recorder.record(), run.outcome))
        return watch.after_step()

    recorded.run(watch=after_step)
    prepared = opened.prepare(RunOptions(1, 30.0))
    options = JudgeOptions(runs=2, failures=FailureOptions(2, 1))
    said: dict[Judge, list[Judgement]] = {judge: [] for judge in Judge}
    for one in judge_mission(prepared, QUESTIONS, options):
        said[one.judge].append(one)
    assert [(one.ruling, one.tick) for one in watch.judgements("")] == [
        (one.ruling, one.tick) for one in said[Judge.RUN]
    ]
    said[Judge.RECORDING] = judge_recording(trace, QUESTIONS)
    said[Judge.TEAM] = monitor.judgements()
    assert [replace(one, judge=Judge.TEAM, subject="") for one in said[Judge.RECORDING]] == said[Judge.TEAM]
    # What breaks is said once, in its tick.
    ends = [one for one in said[Judge.TEAM] if one.ruling is JudgeAnswer.BROKEN]
    assert sorted(map(str, broken)) == sorted(map(str, ends))
    return said


def check_agreement(opened: OpenMission, said: dict[Judge, list[Judgement]]) -> None:
    for question, check, run, runs, recording in zip(
        QUESTIONS, *(said[one] for one in (Judge.CHECK, Judge.RUN, Judge.RUNS, Judge.RECORDING)), strict=True
    ):
        assert (recording.ruling, recording.tick) == (run.ruling, run.tick), (question, recording.reason)
        if run.ruling is JudgeAnswer.BROKEN:
            assert check.ruling is not JudgeAnswer.KEPT, (question, check.reason)
            assert runs.ruling is JudgeAnswer.BROKEN, question
            assert runs.seed == run.seed
        if check.ruling is JudgeAnswer.BROKEN and check.seed is not None:
            spec = opened.prepare(RunOptions(check.seed, 600.0)).spec
            answer = RunJudge(read_property(question), spec).answer(check.seed, lambda: False)
            assert answer is not None
            assert (answer.holds, answer.tick) == (False, check.tick), question
        assert (check.ruling is JudgeAnswer.NOT_DECIDED) == (question in QUESTIONS[-KEPT_BY_TIME:]), check.reason


def test_no_judge_breaks_what_is_right(tmp_path: Path) -> None:
    opened = opened_mission(SOURCES)
    said = ask(opened, tmp_path)
    check_agreement(opened, said)
    for judge in (Judge.RUN, Judge.RUNS, Judge.RECORDING, Judge.TEAM):
        assert {one.ruling for one in said[judge]} == {JudgeAnswer.KEPT}, [one.reason for one in said[judge]]


def test_what_a_judge_finds_in_a_mission_with_a_mistake_the_others_find_too(tmp_path: Path) -> None:
    found = dict.fromkeys(Judge, 0)
    for seed in range(examples(2, 1000)):
        sources = mutant(random.Random(seed))
        opened = opened_mission(sources)
        said = ask(opened, tmp_path)
        try:
            check_agreement(opened, said)
        except AssertionError as error:
            raise AssertionError(f"{seed}: {sources}") from error
        for judge, ones in said.items():
            found[judge] += any(one.ruling is JudgeAnswer.BROKEN for one in ones)
    assert min(found.values()) > 0, found
    assert (
        found[Judge.RUN] == found[Judge.RECORDING] == found[Judge.TEAM] == found[Judge.RUNS] <= found[Judge.FAILURES]
    ), found


def test_questions_are_checked_together_also_where_one_is_none_for_a_check(monkeypatch: pytest.MonkeyPatch) -> None:
    explored: list[VerificationOptions] = []

    def counted(prepared: PreparedRun, options: VerificationOptions) -> Verification:
        made = verify(prepared, options)
        if options.states != 1:
            explored.append(options)
        return made

    monkeypatch.setattr(mission_judges, "verify", counted)
    prepared = opened_mission(SOURCES).prepare(RunOptions(1, 30.0))
    free = "eventually any ada (Captor.LessThan(30))"
    said = list(judge_mission(prepared, (QUESTIONS[0], free, *QUESTIONS[1:4]), JudgeOptions((Judge.CHECK,))))
    assert [one.ruling for one in said] == [JudgeAnswer.KEPT, JudgeAnswer.NOT_DECIDED, *(3 * [JudgeAnswer.KEPT])]
    assert "Captor" in said[1].reason
    assert len(explored) == 1
    [alone] = judge_mission(prepared, (free,), JudgeOptions((Judge.CHECK,)))
    assert alone == said[1]


@pytest.mark.parametrize(
    ("question", "ruling", "tick"),
    [
        ("delivered within 2", JudgeAnswer.BROKEN, 100),
        ("delivered within 2.01", JudgeAnswer.BROKEN, 101),
        ("delivered within 3", JudgeAnswer.BROKEN, 150),
        ("delivered within 3.02", JudgeAnswer.NOT_DECIDED, -1),
        ("done within 0.58", JudgeAnswer.BROKEN, 29),
        ("done within 60", JudgeAnswer.NOT_DECIDED, -1),
        ("time within 3", JudgeAnswer.KEPT, -1),
        ("deadlock within 60", JudgeAnswer.KEPT, -1),
    ],
)
def test_the_time_of_a_question_counts_alike_in_a_run_and_in_its_recording(
    question: str, ruling: JudgeAnswer, tick: int, tmp_path: Path
) -> None:
    trace = tmp_path / "run.krtrace"
    recorded = kitrobot.open_mission("transport").prepare(RunOptions(1, 3.0, 0.0, trace))
    watch = RunWatch(recorded.simulation, [question])
    recorded.run(watch=watch.after_step)
    [run] = watch.judgements("")
    [recording] = judge_recording(trace, [question])
    assert [(one.question, one.ruling, one.tick) for one in (run, recording)] == 2 * [(question, ruling, tick)]
    if ruling is JudgeAnswer.NOT_DECIDED:
        assert run.reason == recording.reason == "the time of the run was up before the deadline"


def test_an_event_that_breaks_a_property_has_one_tick_for_all_judges(tmp_path: Path) -> None:
    stops = '<vertex id="v15" element="Wheel.Stop"/>'
    opened = mutant_of_transport(tmp_path, (stops, stops.replace("Wheel.Stop", "Lamp.LightOn"))).opened
    trace = tmp_path / "run.krtrace"
    recorded = opened.prepare(RunOptions(1, 30.0, 0.0, trace))
    tick = RunJudge(read_property("contact"), recorded.spec).answer(1, lambda: False).tick  # type: ignore[union-attr]
    asked = ["contact", f"contact within {(tick + 1) / 50}", f"contact within {tick / 50}"]
    watch = RunWatch(recorded.simulation, asked)
    recorded.run(watch=watch.after_step)
    for said in (watch.judgements(""), judge_recording(trace, asked)):
        assert [one.tick for one in said] == [tick, tick, -1]
        assert [one.ruling for one in said] == [JudgeAnswer.BROKEN, JudgeAnswer.BROKEN, JudgeAnswer.KEPT]
    answers = [RunJudge(read_property(one), recorded.spec).answer(1, lambda: False) for one in asked]
    assert [one is not None and one.holds for one in answers] == [False, False, True]


@pytest.mark.parametrize(
    ("question", "ruling", "tick"),
    [
        ("eventually any ada (Count.EqualTo(0))", JudgeAnswer.KEPT, -1),
        ("never any ada (Count.EqualTo(0))", JudgeAnswer.BROKEN, 0),
        ("never any ada (Count.EqualTo(0)) while any bob (Count.EqualTo(0))", JudgeAnswer.BROKEN, 0),
        ("any bob (Count.EqualTo(1)) before any ada (Count.EqualTo(0))", JudgeAnswer.BROKEN, 0),
        ("stays any ada (Count.EqualTo(0)) until any bob (Count.EqualTo(1))", JudgeAnswer.BROKEN, 1),
        ("visit any ada (Count.EqualTo(0)); any ada (Count.EqualTo(1)) in this order", JudgeAnswer.KEPT, -1),
        # What a sensor reads first is read of the beginning; a check cannot decide it.
        ("never any ada (Captor.GreaterThan(0))", JudgeAnswer.BROKEN, 0),
        ("holds any ada (Count.EqualTo(0)) for 0.04", JudgeAnswer.BROKEN, 1),
        ("holds any ada (Count.EqualTo(0)) for 0.02", JudgeAnswer.KEPT, -1),
    ],
)
def test_the_beginning_counts_for_every_judge(question: str, ruling: JudgeAnswer, tick: int, tmp_path: Path) -> None:
    opened = opened_mission(SOURCES | {"ada": "Count.Add(1); WAIT(10); Count.Add(1);"})
    trace = tmp_path / "run.krtrace"
    recorded = opened.prepare(RunOptions(1, 30.0, 0.0, trace))
    watch = RunWatch(recorded.simulation, [question])
    recorded.run(watch=watch.after_step)
    options = JudgeOptions((Judge.CHECK, Judge.RUN, Judge.RUNS), runs=2, failures=FailureOptions(1, 1))
    [check, run, runs] = judge_mission(opened.prepare(RunOptions(1, 30.0)), [question], options)
    [watched], [recording] = watch.judgements(""), judge_recording(trace, [question])
    for one in (run, runs, watched, recording):
        assert (one.ruling, one.tick) == (ruling, tick), one.judge
    # The words are one another's too: when it was decided, where it was.
    assert run.reason == recording.reason or recording.reason == "kept in this run, to its end"
    if "Captor" in question or "holds" in question:
        assert check.ruling is JudgeAnswer.NOT_DECIDED
    else:
        assert (check.ruling, check.tick) == (ruling, tick)


def test_a_recording_of_another_mission_is_refused(tmp_path: Path) -> None:
    trace = tmp_path / "run.krtrace"
    opened_mission(SOURCES).prepare(RunOptions(1, 30.0, 0.0, trace)).run()
    with pytest.raises(kitrobot.KitRobotError, match="of another mission") as raised:
        judge_recording(trace, QUESTIONS[:1], opened_mission({"eve": SOURCES["ada"]}))
    assert "eve" in raised.value.help


def test_a_cut_recording_decides_what_is_in_it(tmp_path: Path) -> None:
    trace = tmp_path / "run.krtrace"
    opened_mission(SOURCES).prepare(RunOptions(1, 1.5, 0.0, trace)).run()
    data = trace.read_bytes()
    trace.write_bytes(data[: data.rindex(b"KREN")])
    said = {one.question: one for one in judge_recording(trace, (*QUESTIONS, "done", "deadlock"))}
    assert said[QUESTIONS[0]].ruling is JudgeAnswer.KEPT
    assert said[QUESTIONS[1]].ruling is JudgeAnswer.NOT_DECIDED
    assert "may still come" in said[QUESTIONS[1]].reason
    assert {said[name].ruling for name in ("done", "deadlock")} == {JudgeAnswer.NOT_DECIDED}


def test_an_approximate_check_says_of_nothing_that_it_is_kept() -> None:
    opened = opened_mission(SOURCES)
    asked = (
        "never any ada (Count.EqualTo(9))",
        "never any ada (Count.EqualTo(2))",
        "eventually any ada (Count.EqualTo(2))",
    )
    found = kitrobot.judge(opened, *asked, by=["check"], approximate=True)
    assert [one.ruling.value for one in found] == ["not decided", "broken", "not decided"]
    assert "by an approximate search, which is no proof" in found[0].reason
    assert found[1].seed == 1
    assert "an approximate check cannot decide it" in found[2].reason


def test_python_and_json_say_the_same() -> None:
    opened = opened_mission(SOURCES)
    [said] = kitrobot.judge(opened, "any ada (Count.EqualTo(1)) within 0.5", by=["run"], seconds=30.0)
    assert replace(said, subject="").to_json() == {
        "judge": "run",
        "of": "",
        "property": "any ada (Count.EqualTo(1)) within 0.5",
        "sentence": "eventually `any ada (Count.EqualTo(1))`, within 0.5 s",
        "ruling": "broken",
        "reason": "broken at 0.52 s (tick 26)",
        "tick": 26,
        "seconds": 0.52,
        "seed": 1,
        "failures": [],
        "agents": [],
        "why": [],
    }


@pytest.mark.parametrize("names", [{"by": ["nobody"]}, {"timings": ["later"]}, {"moments": 0, "by": ["failures"]}])
def test_a_choice_that_makes_no_sense_is_an_error(names: dict[str, object]) -> None:
    with pytest.raises(kitrobot.KitRobotError):
        kitrobot.judge(opened_mission(SOURCES), "done", **names)  # type: ignore[arg-type]
