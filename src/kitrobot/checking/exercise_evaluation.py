"""Evaluation of a submission for an exercise: its programs are inspected, run with every seed, and checked.

The work is bounded by steps: each run ends after the exercise's simulated seconds, each check after its states. `stop`
ends it between two stretches of a run or within a check; results found until then are returned. The result contains
nothing that depends on wall-clock time. Left to others: what a goal is (`exercise`), checking (`check_evidence`),
processes and tables for a class (`classroom.grading`).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from kitrobot.checking.check_evidence import assign_judges, collect_check_evidence, group_alike
from kitrobot.checking.run_evidence import collect_run_evidence
from kitrobot.compiler.target import target_of
from kitrobot.compiler.text.part_text import draw_template
from kitrobot.diagnostics.model import Diagnostic, KitRobotError
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.exercise.evidence import CheckEvidence, ProgramEvidence
from kitrobot.exercise.goals import CheckGoal, Fault, Goal, ProgramGoal, RunGoal
from kitrobot.exercise.model import Exercise
from kitrobot.graph.model import IN, RETURN, START, STOP, Program
from kitrobot.lll.tree import Call
from kitrobot.lll.walk import nodes
from kitrobot.mission.model import Mission
from kitrobot.primitives.constructors import Constructor
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Label, Sentence
from kitrobot.verifier.properties.properties import Property
from kitrobot.workspace.exercises import handed_in
from kitrobot.workspace.mission_loader import OpenMission, with_mission
from kitrobot.workspace.mission_run import PreparedRun, RunOptions
from kitrobot.workspace.search_path import SearchPath

Progress = Callable[[int, int], None]
"""Called with how many pieces of work are over, and how many there are."""


def _never() -> bool:
    return False


@dataclass(frozen=True)
class GoalVerdict:
    """The result for one goal.

    Attributes:
        goal: the goal.
        reached: whether it is reached; None where it was not evaluated.
        why: what went wrong; or how a check knows that nothing did; else "".
        seed: the run that shows it, if a run does.
        seconds: when in that run, in simulated seconds.
        runs: in how many of the `of` runs it was reached; both 0 for goals that are not of runs.
    """

    goal: Goal
    reached: bool | None
    why: str = ""
    seed: int | None = None
    seconds: float | None = None
    runs: int = 0
    of: int = 0

    @property
    def runs_ground(self) -> Sentence | str:
        """How runs know that a property is kept; "" where they were not asked that."""
        if not (self.reached and self.runs and isinstance(self.goal, CheckGoal)):
            return ""
        return Sentence.counted(
            "seen in {count} run, which is no proof", "seen in {count} runs, which is no proof", self.runs
        )


@dataclass(frozen=True)
class Evaluation:
    """The result for a submission. `problems` are the errors that kept it from running; then no goal is reached."""

    verdicts: tuple[GoalVerdict, ...]
    problems: tuple[Diagnostic, ...] = ()

    @property
    def full(self) -> bool:
        """Whether every goal is reached."""
        return all(verdict.reached for verdict in self.verdicts)


@dataclass(frozen=True)
class EvaluationOptions:
    """Which parts of an exercise are evaluated.

    Attributes:
        hidden: the hidden goals and seeds too.
        seeds: these seeds only, in place of the exercise's; none: the exercise's.
        runs: goals of runs too.
        checks: goals of checking too, which take longest.
        stop: polled regularly; once it returns True, goals that are not decided yet are left out.
    """

    hidden: bool = False
    seeds: tuple[int, ...] = ()
    runs: bool = True
    checks: bool = True
    stop: Callable[[], bool] = _never


def open_handed_in(start: OpenMission, submission: Mission, search: SearchPath) -> OpenMission:
    """A submission in the mission of its exercise, which lies in the folder of `search`.

    Raises:
        AnotherMissionError: it belongs to another exercise.
    """
    return with_mission(handed_in(start.mission, submission), start.name, search)


def evaluate_submission(
    exercise: Exercise,
    opened: OpenMission,
    options: EvaluationOptions | None = None,
    progress: Progress | None = None,
    start: OpenMission | None = None,
) -> Evaluation:
    """Judges a submission that was put into the mission of its exercise, `start`."""
    options = options or EvaluationOptions()
    goals = exercise.goals_for(options.hidden)
    all_seeds = exercise.seeds_for(options.hidden)
    seeds = options.seeds or all_seeds
    try:
        prepared = opened.prepare(RunOptions(seeds[0], exercise.seconds))
    except ProblemsError as error:
        return _unusable(goals, [one for one in error.diagnostics if one.is_error])
    judges = assign_judges(prepared, [goal for goal in goals if isinstance(goal, CheckGoal)], start)
    run_goals = [goal for goal in goals if isinstance(goal, RunGoal)] if options.runs else []
    watched = judges.runs if options.runs else []
    checks = judges.checks if options.checks else []
    total = (len(seeds) if run_goals or watched else 0) + len(checks)
    done = 0

    def count_done() -> None:
        nonlocal done
        done += 1
        if progress is not None:
            progress(done, total)

    found = {id(goal): _of_check(goal, seen) for goal, seen in judges.nobody}
    seen = collect_program_evidence(opened, start.mission.constructors if start is not None else ())
    for goal in goals:
        if isinstance(goal, ProgramGoal):
            fault = goal.fault(seen)
            found[id(goal)] = _verdict(goal, fault)
    if run_goals or watched:
        is_whole = set(seeds) >= set(all_seeds)
        in_runs = _judge_runs(prepared, seeds, is_whole, run_goals, watched, options.stop, count_done)
        found |= {id(one.goal): one for one in in_runs}
    for alike in group_alike(checks):
        if options.stop():
            break
        seen_of = collect_check_evidence(prepared, alike, options.stop)
        cut = options.stop()
        for check in alike:
            # Only what is broken is known of a check that was cut.
            if not cut or seen_of[check.property].answer == "broken":
                found[id(check)] = _of_check(check, seen_of[check.property])
                count_done()
    return Evaluation(tuple(found.get(id(goal), GoalVerdict(goal, None)) for goal in goals))


def _judge_runs(
    prepared: PreparedRun,
    seeds: Sequence[int],
    is_whole: bool,
    goals: Sequence[RunGoal],
    watched: Sequence[tuple[CheckGoal, Property]],
    stop: Callable[[], bool],
    count_done: Callable[[], None],
) -> Iterator[GoalVerdict]:
    """The verdicts of runs; `is_whole`: they are all of the exercise."""
    faults: list[list[tuple[int, Fault | None]]] = [[] for _ in goals]
    seen: list[list[CheckEvidence]] = [[] for _ in watched]
    properties = {goal.property: one for goal, one in watched}
    paths = any(goal.needs_path for goal in goals)
    for seed in seeds:
        run = collect_run_evidence(_simulation(prepared, seed), seed, paths, stop, properties)
        if run is None:
            break
        for goal, told in zip(goals, faults, strict=True):
            told.append((seed, goal.fault(run)))
        for (check, _), shown in zip(watched, seen, strict=True):
            shown.append(run.properties[check.property])
        count_done()
    yield from (_of_runs(goal, told, len(seeds)) for goal, told in zip(goals, faults, strict=True))
    for (check, _), shown in zip(watched, seen, strict=True):
        yield _of_property(check, shown, len(seeds), is_whole)


def _unusable(goals: Iterable[Goal], problems: list[Diagnostic]) -> Evaluation:
    first = problems[0].message if problems else ""
    return Evaluation(tuple(GoalVerdict(goal, False, first) for goal in goals), tuple(problems))


def _of_check(goal: CheckGoal, seen: CheckEvidence) -> GoalVerdict:
    made = _verdict(goal, goal.fault(seen))
    return replace(made, why=goal.ground(seen)) if made.reached else made


def _of_property(goal: CheckGoal, found: list[CheckEvidence], wanted: int, is_whole: bool) -> GoalVerdict:
    """The verdict of runs on a property. Those in which it never comes up say nothing of it, unless it is in all."""
    told = [one for one in found if one.answer != "vacuous"]
    if found and not told and len(found) == wanted:
        return replace(_verdict(goal, goal.fault(found[0])), reached=False if is_whole else None, seed=None)
    faults = [(one.seed or 0, goal.fault(one)) for one in told]
    return _of_runs(goal, faults, wanted - len(found) + len(told))


def _verdict(goal: Goal, fault: Fault | None) -> GoalVerdict:
    if fault is None:
        return GoalVerdict(goal, True)
    return GoalVerdict(goal, False, fault.sentence, fault.seed, fault.seconds)


def _of_runs(goal: Goal, found: list[tuple[int, Fault | None]], wanted: int) -> GoalVerdict:
    wrong = [(seed, fault) for seed, fault in found if fault is not None]
    reached = len(found) - len(wrong)
    if not wrong:
        return GoalVerdict(goal, True if reached == wanted else None, runs=reached, of=len(found))
    seed, fault = wrong[0]
    return GoalVerdict(goal, False, fault.sentence, seed, fault.seconds, reached, len(found))


# -- what is seen of programs


def collect_program_evidence(opened: OpenMission, given: Sequence[Constructor] = ()) -> ProgramEvidence:
    """The elements that hang on the Start of each program, and those that its own blocks would be drawn as.

    A part is what it does: an own block counts by its name only as far as it is one of `given`, and as what stands in
    it in any case, once for each program.
    """
    blocks = {block.name: block for block in opened.mission.constructors}
    named = {block.name for block in given if block.name in blocks and _is_same(block, blocks[block.name])}
    elements: dict[str, Counter[str]] = {}
    own: dict[str, int] = {}
    for program in opened.mission.programs:
        counts = Counter(attached(program))
        own[program.name] = 0
        for name in sorted(set(counts) & set(blocks)):
            if name not in named:
                own[program.name] += counts.pop(name)
            counts.update(_drawn(blocks[name], program, opened))
        elements[program.name] = counts
    return ProgramEvidence(elements, own, _labels(opened))


def _is_same(one: Constructor, other: Constructor) -> bool:
    return (one.template, one.slots, one.adds) == (other.template, other.slots, other.adds)


def _drawn(block: Constructor, program: Program, opened: OpenMission) -> list[str]:
    """The elements that an own block would be drawn as if it stood in the program itself."""
    if block.template is None:
        return []
    common = opened.common if opened.common is not None else opened.catalogue
    # Under no name: one that is called as a part of the files is not to keep that from being drawn.
    bare = replace(block, name="")
    try:
        drawn = draw_template(bare, target_of(program, opened.catalogue), common)
    except KitRobotError:
        return [f"{node.object}.{node.method}" for node in nodes(block.template) if isinstance(node, Call)]
    elements = (vertex.element for vertex in drawn.vertices)
    return [element for element in elements if element not in (START, STOP) and not element.startswith("{")]


def _labels(opened: OpenMission) -> dict[str, Sentence]:
    """What elements are called on the page, of the constructors and of the robots of all programs."""
    known = {**opened.catalogue.constructors, **(opened.common.constructors if opened.common is not None else {})}
    found: dict[str, Sentence] = {name: Label(name, one.label) for name, one in known.items()}
    for program in opened.mission.programs:
        robot = opened.catalogue.robots.get(program.target)
        for (part, name), (of, method) in (robot.calls if robot is not None else {}).items():
            label: Sentence = Label(name, method.label)
            if not method.alone:
                label = Sentence("{part}: {does}", Label(part, of.label), label)
            found.setdefault(f"{part}.{name}", label)
    return found


def attached(program: Program) -> list[str]:
    """The elements of the vertices that hang on Start, but for Start and Stop: those on the way from it, and what fills
    their slots. What is parked is not among them.
    """
    kinds = {vertex.id: vertex.element for vertex in program.vertices}
    ways: dict[str, list[str]] = {}
    for arc in program.arcs:
        fills = arc.at not in (IN, RETURN)
        ways.setdefault(arc.target if fills else arc.source, []).append(arc.source if fills else arc.target)
    waiting = [vertex.id for vertex in program.vertices if vertex.element == START]
    met = set(waiting)
    while waiting:
        for other in ways.get(waiting.pop(), ()):
            if other in kinds and other not in met:
                met.add(other)
                waiting.append(other)
    return [kinds[vertex] for vertex in met if kinds[vertex] not in (START, STOP)]


def _simulation(prepared: PreparedRun, seed: int) -> Simulation:
    if seed == prepared.options.seed:
        return prepared.again()
    return prepared.opened.prepare(replace(prepared.options, seed=seed)).simulation
