"""All judges on one mission, and where two of them do not agree.

One run is watched by the run judge, recorded, judged while it is recorded, and judged once more from its recording; the
check, many runs and failures are asked beside it.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.run_question import RunAnswer, RunJudge, ready_properties_of
from kitrobot.judges.judgement import Judge, JudgeAnswer, Judgement
from kitrobot.judges.many_runs import FailureOptions
from kitrobot.judges.mission_judges import JudgeOptions, judge_mission
from kitrobot.judges.record_monitor import RecordMonitor
from kitrobot.judges.recording_judge import judge_recording
from kitrobot.judges.run_watch import RunWatch
from kitrobot.lll.printer import print_template
from kitrobot.lll.tree import Call
from kitrobot.lll.walk import nodes
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.mission.property_text import read_property
from kitrobot.primitives.robot import Category, Kind
from kitrobot.sim.event_text import Event
from kitrobot.sim.recorder import Recorder
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.programs import AbstractionError
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.conditions import PropertyError
from kitrobot.verifier.properties.custom_properties import build_custom_property, property_variables
from kitrobot.verifier.properties.ready_monitors import ENDS_IN_VAIN
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.mission_run import PreparedRun, RunOptions

FORMS = (
    "never {a} while {b}",
    "eventually {a}",
    "after {a} eventually {b}",
    "stays {a} until {b}",
    "at most 2 times {a}",
    "{a} before {b}",
    "again and again {a}",
    "visit {a}; {b} in this order",
    "holds {a} for 0.4",
    "after {a} eventually {b} within 3",
)
"""What is asked of a mission, of two tests that its programs make."""
WITHIN_S = 9.0
"""Of ready properties that are asked with a time too."""
_WHOLE = ("delivered", "deadlock")
"""The ready properties that speak of the whole mission."""
LONGEST_S = 600.0
"""A run whose time was up is looked at once more for so long, in simulated seconds."""
_BY_TIME = "time"


@dataclass(frozen=True)
class ComparisonOptions:
    """How much is asked.

    Attributes:
        seconds: simulated seconds of a run at most.
        states: of a check at most.
        check_seconds: for the check of one property at most.
        runs: of many runs, how many.
        moments: at how many moments robots fail.
        dear: of how many questions many runs are asked too; failures are asked of the first of them.
        stop: asked now and then whether to break off.
    """

    seconds: float
    states: int = 5_000
    check_seconds: float = 1.0
    runs: int = 2
    moments: int = 2
    dear: int = 2
    stop: Callable[[], bool] = lambda: False


@dataclass(frozen=True)
class Disagreement:
    """Two judges that do not agree on a question: which rule it is that they break, and what both say.

    `known`: why it is known, as docs/check.md has it; "" for a fault.
    """

    rule: str
    question: str
    first: str
    second: str
    known: str = ""


@dataclass
class Comparison:
    """What judges said of a mission: by judge and question; where they disagree; and how the recorded run ended."""

    said: dict[Judge, dict[str, Judgement]] = field(default_factory=dict)
    disagreements: list[Disagreement] = field(default_factory=list)
    outcome: str = ""
    limits: tuple[str, ...] = ()

    def rulings(self) -> dict[str, dict[str, str]]:
        """The rulings alone, as plain values."""
        return {
            judge.value: {question: one.ruling.value for question, one in found.items()}
            for judge, found in self.said.items()
        }


def questions_of(opened: OpenMission, seed: int) -> list[str]:
    """What is asked of a mission besides its ready properties: its own ones, and forms of tests that it makes."""
    rng = random.Random(seed)
    tests = sorted(_tests(opened))
    tests = _checked_tests(opened, tests) or tests
    own = [one.name for one in opened.mission.properties]
    if not tests:
        return [*own, "done within 60"]
    found = []
    for form in FORMS:
        a, b = rng.sample(tests, 2) if len(tests) > 1 else (tests[0], f"!({tests[0]})")
        found.append(form.format(a=a, b=b))
    return [*own, *found, "done within 60"]


def _tests(opened: OpenMission) -> set[str]:
    """The tests of sensors and variables in the programs of robots, each of the agents that make it; where no program
    makes one, those that their robots offer.
    """
    made: set[str] = set()
    offered: set[str] = set()
    for agent in opened.mission.team.agents:
        kind = agent.robot or next(one.target for one in opened.mission.programs if one.name == agent.program)
        tests = {
            name: method
            for name, (part, method) in opened.catalogue.robots[kind].calls.items()
            if method.kind is Kind.TEST and part.category in (Category.SENSOR, Category.VARIABLE)
        }
        offered |= {f"any {agent.name} ({'.'.join(name)}())" for name, one in tests.items() if not one.parameters}
        for node in nodes(opened.images[agent.image_name].program):
            if isinstance(node, Call) and (node.object, node.method) in tests:
                made.add(f"any {agent.name} ({print_template(node).strip().rstrip(';')})")
    return made or offered


def _checked_tests(opened: OpenMission, tests: Sequence[str]) -> list[str]:
    """Those of the tests that a check can decide: not of sensors that may read anything."""
    run = opened.prepare(RunOptions(1, LONGEST_S)).simulation
    asked = {one: AskedProperty("asked", Form.NEVER, one) for one in tests}
    found: list[str] = []
    with suppress(AbstractionError):
        model = Model(run, abstract_run(run, property_variables(run, [*asked.values()])), 0, Timing.LOCKSTEP)
        for test, one in asked.items():
            with suppress(PropertyError):
                build_custom_property(model, one)
                found.append(test)
    return found


def compare(opened: OpenMission, questions: Sequence[str], folder: Path, options: ComparisonOptions) -> Comparison:
    """Asks all judges of a mission without errors; the recording is made in that folder."""
    made = Comparison()
    prepared = opened.prepare(RunOptions(1, options.seconds))
    ready: list[str] = []
    with suppress(KitRobotError):
        ready = [one.name for one in ready_properties_of(prepared.simulation)]
        ready += [f"{name} within {WITHIN_S:g}" for name in ready if name in _WHOLE]
        made.limits = tuple(map(str, abstract_run(prepared.simulation).limits))
    asked = [*ready, *questions]
    made.outcome = _judge_recorded_run(opened, asked, folder, options, made)
    # A check of all questions is one exploration; runs are made for each of them.
    dear = _dear(ready, questions, options.dear)
    judges = {Judge.CHECK: asked, Judge.RUNS: dear, Judge.FAILURES: dear[:1]}
    for judge, its in judges.items():
        for one in judge_mission(prepared, its, judge_options_of(options, judge)):
            made.said.setdefault(one.judge, {})[one.question] = one
    made.disagreements += run_disagreements(made)
    made.disagreements += check_disagreements(prepared, made, dear, options.stop)
    return made


def judge_options_of(options: ComparisonOptions, judge: Judge) -> JudgeOptions:
    """What is chosen for one of the judges that are asked beside the recorded run."""
    return JudgeOptions(
        (judge,),
        check_seconds=options.check_seconds,
        states=options.states,
        runs=options.runs,
        failures=FailureOptions(options.moments, 1),
        stop=options.stop,
    )


def _dear(ready: Sequence[str], questions: Sequence[str], count: int) -> list[str]:
    """The questions of which runs are made for each: own ones, and the ready one that speaks of the whole."""
    whole = [one for one in _WHOLE if one in ready][:1]
    return [*questions[: max(1, count - len(whole))], *whole][:count]


def _judge_recorded_run(
    opened: OpenMission, asked: Sequence[str], folder: Path, options: ComparisonOptions, made: Comparison
) -> str:
    """Makes one run that is watched and recorded, and judges it thrice; its outcome."""
    trace = folder / "run.krtrace"
    trace.unlink(missing_ok=True)
    recorded = opened.prepare(RunOptions(1, options.seconds, 0.0, trace))
    run = recorded.simulation
    watch, recorder = RunWatch(run, asked), Recorder(run)
    monitor = RecordMonitor(recorder.header, opened, asked, Judge.TEAM, "")
    broken = monitor.follow(recorder.record())

    def after_step() -> list[Event]:
        broken.extend(monitor.follow(recorder.record(), run.outcome))
        return watch.after_step()

    recorded.run(watch=after_step)
    for judge, found in (
        (Judge.RUN, watch.judgements("")),
        (Judge.TEAM, monitor.judgements()),
        (Judge.RECORDING, judge_recording(trace, asked)),
    ):
        made.said[judge] = {one.question: one for one in found}
    said = {one.question: one for one in broken}
    for question, one in made.said[Judge.TEAM].items():
        if (one.ruling is JudgeAnswer.BROKEN) != (question in said):
            made.disagreements.append(Disagreement("what breaks is said in its tick", question, _words(one), "events"))
    assert run.outcome is not None, "a run with a time limit ends"
    return run.outcome


def run_disagreements(made: Comparison) -> Iterator[Disagreement]:
    """Where judges of the same run do not say the same."""
    said = made.said
    for question, run in said[Judge.RUN].items():
        recording, team = said[Judge.RECORDING][question], said[Judge.TEAM][question]
        if replace(recording, judge=Judge.TEAM, subject="") != replace(team, subject=""):
            yield _between("a recording and the monitor of its run", recording, team)
        if recording.ruling is JudgeAnswer.NOT_DECIDED:
            # It lacks what decides this, or is more careful when the time of a run is up (docs/check.md).
            if run.ruling is JudgeAnswer.BROKEN and not _is_left_out(recording, made.outcome):
                yield _between("a run and its recording", run, recording)
        elif (run.ruling, run.tick) != (recording.ruling, recording.tick):
            yield _between("a run and its recording", run, recording)
        runs = said[Judge.RUNS].get(question)
        if runs is None or run.ruling is not JudgeAnswer.BROKEN or runs.ruling is JudgeAnswer.NOT_DECIDED:
            continue
        if (runs.ruling, runs.tick, runs.seed) != (run.ruling, run.tick, run.seed):
            yield _between("a run and the first of many", run, runs)


def _is_left_out(recording: Judgement, outcome: str) -> bool:
    """Whether a recording of a run with that outcome does not decide that (docs/check.md)."""
    question = recording.question
    if question.startswith("served-"):
        return outcome in ENDS_IN_VAIN
    return question in ("stock", "stopped") or question.startswith("meets-")


def check_disagreements(
    prepared: PreparedRun, made: Comparison, dear: Sequence[str], stop: Callable[[], bool]
) -> Iterator[Disagreement]:
    """Where a finished check and runs do not agree."""
    said = made.said
    for question, check in said[Judge.CHECK].items():
        if check.ruling is JudgeAnswer.KEPT:
            run, runs = said[Judge.RUN][question], said[Judge.RUNS].get(question)
            for other in (run, runs):
                if other is not None and other.ruling is JudgeAnswer.BROKEN:
                    yield from _if_it_lasts(prepared, made, check, other, stop)
                    break
        elif check.ruling is JudgeAnswer.BROKEN and check.seed is not None and question in dear and not check.faults:
            answer = RunJudge(read_property(question), prepared.spec).answer(check.seed, stop)
            if answer is not None and (answer.holds, answer.tick) != (False, check.tick):
                yield Disagreement("what a check confirms, that run shows", question, _words(check), str(answer))


def _if_it_lasts(
    prepared: PreparedRun, made: Comparison, check: Judgement, other: Judgement, stop: Callable[[], bool]
) -> Iterator[Disagreement]:
    """A run that breaks what the check keeps; where that only is because its time was up, it is made longer."""
    seed = other.seed if other.seed is not None else 1
    longer = replace(prepared.spec, seconds=LONGEST_S)
    answer = RunJudge(read_property(check.question), longer).answer(seed, stop)
    if answer is not None and not answer.holds:
        found = _between("what a check keeps in every order, no run breaks", check, other)
        yield replace(found, known=_known(made, answer))


def _known(made: Comparison, answer: RunAnswer) -> str:
    """Why a run may break by its end what the check keeps; "" where it may not."""
    if answer.sentence and any("read anything at any time" in limit for limit in made.limits):
        return "a reading that may change at any time keeps the mission alive in the model"
    return ""


def _between(rule: str, first: Judgement, second: Judgement) -> Disagreement:
    return Disagreement(rule, first.question, _words(first), _words(second))


def _words(one: Judgement) -> str:
    return f"{one.judge.value}: {one.ruling.value}: {one.reason}"


def run_length(run: Simulation) -> tuple[str, float]:
    """How a run that has a time limit ends, and after how many simulated seconds."""
    while run.outcome is None:
        run.advance(1000)
    return run.outcome, run.seconds
