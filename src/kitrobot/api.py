"""The functions of `import kitrobot`: from a mission, a file's or one built in Python, to its run.

Missions, worlds and programs are the values that a `.krt` file is read into; there are no others. A mission built in
Python is opened as the file that it would be saved as, so it is held against the same rules, and its run is number for
number the run of that file. Left to others: everything else; this is a door like the command line.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

from kitrobot.compiler.compilation import CompiledProgram, compile_lll, compile_text
from kitrobot.compiler.compilation import compile_program as compile_graph
from kitrobot.compiler.program.checker import check
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.experiments.study import Study, choose_executor, sweep_mission
from kitrobot.graph.model import Program
from kitrobot.lll.parse_results import ParseResult
from kitrobot.lll.parse_results import parse as parse_lll
from kitrobot.lll.tree import Seq
from kitrobot.mission.model import DEFAULT_RUN_S, DEFAULT_SEED, Mission
from kitrobot.mission.writer import save, write_mission
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Robot
from kitrobot.text.phrases import listed, shown
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.mission_loader import OpenMission, read_mission_data
from kitrobot.workspace.mission_loader import open_mission as open_file
from kitrobot.workspace.robots import find_robot
from kitrobot.workspace.search_path import SearchPath
from kitrobot.workspace.traces import OpenTrace

if TYPE_CHECKING:
    from kitrobot.experiments.probability import Probability, Progress, RunLimits
    from kitrobot.experiments.rare_probability import RareProbability
    from kitrobot.judges.judgement import JudgeLimits, Judgement
    from kitrobot.verifier.report.state_walk import StateWalk

UNSAVED = "mission.krt"
"""What messages call a mission that is no file."""


def open_mission(mission: str | PathLike[str] | Mission, *, folder: str | PathLike[str] = ".") -> OpenMission:
    """Opens a mission with the robots, constructors and the world that lie beside it.

    Then `.check()` gives a `Report` with all that is wrong, `.run(seed=1)` runs it to its end and gives a `Run`,
    `.simulation(seed=1)` gives a `Simulation` to step, look at and intervene in. `kitrobot.open` is the same function.

    Args:
        mission: the path of a `.krt` file, or of a picture that carries a mission; the name of an example; or a
            mission built in Python. Of that a copy is opened: later changes do not count.
        folder: where the robots, constructors and the world's file of a mission built in Python are looked for,
            after those that come with KitRobot. A file has its own folder.

    Raises:
        KitRobotError: the file cannot be read, or nothing of it can be used; `diagnostics` says why.

    Examples:
        >>> import kitrobot
        >>> kitrobot.open_mission("transport").run().outcome
        'done'
    """
    if isinstance(mission, Mission):
        return read_mission_data(write_mission(mission), UNSAVED, SearchPath(Path(folder)))
    return open_file(Path(mission))


def sweep(
    mission: str | PathLike[str] | Mission | OpenMission,
    *,
    vary: Mapping[str, Sequence[int | float | str] | str] | None = None,
    seeds: Iterable[int] = (1,),
    measures: Sequence[str] | Mapping[str, str | Callable[[OpenTrace], float | None]] = (),
    folder: str | PathLike[str] | None = None,
    jobs: int | None = 1,
    cluster: str | None = None,
    **chosen: Any,
) -> Study:
    """Runs a mission many times while numbers of it vary, and gives the study. What is there already is not run again.

    Args:
        mission: as for `open_mission`, or a mission that is open.
        vary: values by address (`kitrobot sweep FILE --addresses` lists them): a list, or a text such as `30:60:5`,
            `2..6`, `lhs(20)`. Every combination is run unless `is_zip=True`.
        seeds: the seeds of each point.
        measures: what is measured, such as `distance` or `time any carrier-1 (Cargo.IsPressed())`; or by name, where a
            Python function takes the recording of a run (`OpenTrace`) and gives a number or None.
        folder: where the study is kept, to go on with it later; without one it goes with the `Study`.
        jobs: how many processes; None: one a core. More than one need the `if __name__ == "__main__":` of a script.
        cluster: the address of a Dask scheduler, or `local` (`kitrobot[cluster]`).
        chosen: `seconds` (600), `fail_rate` (0), `is_zip` (False), `table` (a CSV file of points).

    Raises:
        ProblemsError: the mission has errors.
        KitRobotError: something that was asked for makes no sense, or the folder holds another study.

    Examples:
        >>> import kitrobot
        >>> study = kitrobot.sweep("square", vary={"fail-rate": [0, 0.5]}, seeds=range(1, 3))
        >>> [(row.point["fail-rate"], row.seed, row.outcome) for row in study.rows][:2]
        [(0, 1, 'done'), (0, 2, 'done')]
    """
    opened = mission if isinstance(mission, OpenMission) else open_mission(mission)
    return sweep_mission(
        opened,
        vary=vary,
        seeds=seeds,
        measures=measures,
        folder=Path(folder) if folder is not None else None,
        executor=choose_executor(jobs, cluster),
        **chosen,
    )


def save_mission(mission: Mission, path: str | PathLike[str]) -> None:
    """Writes a mission as a `.krt` file. A file that was there is kept, with `~` behind its name.

    The same mission gives the same bytes. Robots of your own are not part of it: their `.robot.xml` belongs beside it.

    Raises:
        KitRobotError: the file cannot be written; what was there is as it was.
    """
    save(Path(path), mission)


def probability(
    mission: str | PathLike[str] | Mission | OpenMission,
    question: str,
    *,
    fail_rate: float = 0.0,
    precision: float = 0.05,
    confidence: float = 0.95,
    at_least: float | None = None,
    seed: int = DEFAULT_SEED,
    **limits: Unpack[RunLimits],
) -> Probability:
    """How probable it is that a run of a mission has a property, from as many runs as that takes.

    Args:
        mission: as of `open_mission`, or what that gave.
        question: what is asked of each run: `delivered within 120`, `done`, `never any carrier (…)`.
        fail_rate: the probability (0…1) that an agent fails for good within a minute, by chance.
        precision: the probability is at most so far from the estimate; more than 0 and less than 0.5.
        confidence: how often such an answer is right; between 0 and 1.
        at_least: only decide whether the probability is at least this; within the precision either answer may come.
        seed: of the first run; each next one has the next seed.
        limits: `seconds`, simulated ones after which a run is out of time (600), where the question sets none; `runs`,
            at most so many; `jobs`, so many processes instead of one for each core (with several, a script needs
            `if __name__ == "__main__":`); `progress`, told how many runs are over, and of how many.

    Raises:
        ProblemsError: the mission has errors.
        KitRobotError: the question cannot be understood, or a number makes no sense.

    Examples:
        >>> import kitrobot
        >>> found = kitrobot.probability("square", "done within 20", precision=0.2, jobs=1)
        >>> found.runs, found.interval.estimate, round(found.interval.low, 2), found.interval.high
        (24, 1.0, 0.81, 1.0)
    """
    from kitrobot.experiments.probability import ProbabilityOptions, find_probability
    from kitrobot.workspace.mission_run import RunOptions

    opened = mission if isinstance(mission, OpenMission) else open_mission(mission)
    prepared = opened.prepare(RunOptions(seed, limits.get("seconds", DEFAULT_RUN_S), fail_rate))
    chosen = ProbabilityOptions(precision, confidence, at_least, limits.get("runs"), limits.get("jobs"))
    return find_probability(prepared, question, chosen, limits.get("progress"))


def rare_probability(
    mission: str | PathLike[str] | Mission | OpenMission,
    question: str,
    counts: str,
    *,
    fail_rate: float = 0.0,
    seed: int = DEFAULT_SEED,
    seconds: float = DEFAULT_RUN_S,
    progress: Progress | None = None,
    **options: Any,
) -> RareProbability:
    """How probable something is that hardly ever happens in a run of a mission, by multilevel splitting.

    Args:
        mission: as of `open_mission`, or what that gave.
        question: as of `probability`.
        counts: where runs branch: at one more that is `delivered` or has `failed`, or of the `collisions`.
        fail_rate: as of `probability`.
        seed: decides all chance.
        seconds: as of `probability`.
        progress: told how many repetitions are over, and of how many.
        options: other fields of `experiments.rare_probability.SplittingOptions`, such as `branches`.

    Raises:
        KitRobotError: the mission has errors, the question cannot be understood, or runs cannot be split so.
    """
    from kitrobot.experiments.rare_probability import SplittingOptions, find_rare_probability
    from kitrobot.workspace.mission_run import RunOptions

    opened = mission if isinstance(mission, OpenMission) else open_mission(mission)
    prepared = opened.prepare(RunOptions(seed, seconds, fail_rate))
    return find_rare_probability(prepared, question, SplittingOptions(counts, **options), progress)


def judge(
    subject: str | PathLike[str] | Mission | OpenMission,
    *questions: str,
    by: Sequence[str] = ("check", "run", "runs", "failures"),
    mission: str | PathLike[str] | Mission | OpenMission | None = None,
    **limits: Unpack[JudgeLimits],
) -> list[Judgement]:
    """What judges say of properties: of a mission, or of a recording of a run, of real robots or of a fleet.

    Args:
        subject: a mission, as of `open_mission` or what that gave; or the path of a `.krtrace`, whose judge is the
            recording itself.
        questions: properties as text, such as `never any carrier (Collision.IsPressed())`, or names of those of the
            mission; none for all of its own, of a recording also the ready ones.
        by: the judges of a mission: `check` every order of events, `run` one run, `runs` many, `failures` each robot
            failing at each of many moments.
        mission: of a recording, the mission whose properties are meant; None: the one in it.
        limits: `seed` of the first run (1); `seconds`, simulated ones of a run (600); `fail_rate` (0); `runs`, how many
            (100); `moments`, at which robots fail (20); `check_seconds`, of one property (60); `timings`, of the check
            (`lockstep`); `approximate`, whether it forgets states to look at more; `jobs`, so many processes (1; with
            several, a script needs `if __name__ == "__main__":`).

    Raises:
        ProblemsError: the mission has errors.
        KitRobotError: a question cannot be understood, a number makes no sense, or the recording cannot be read.

    Examples:
        >>> import kitrobot
        >>> [said] = kitrobot.judge("transport", "at most 3 times any carrier-1 (Cargo.IsPressed())", by=["run"])
        >>> said.ruling.value, said.seconds
        ('broken', 45.08)
    """
    from kitrobot.judges.mission_judges import judge_mission, judge_options
    from kitrobot.judges.recording_judge import judge_recording
    from kitrobot.workspace.mission_run import RunOptions
    from kitrobot.workspace.traces import is_trace

    def opened(one: str | PathLike[str] | Mission | OpenMission) -> OpenMission:
        return one if isinstance(one, OpenMission) else open_mission(one)

    if isinstance(subject, (str, PathLike)) and is_trace(fspath(subject)):
        return judge_recording(Path(subject), questions, None if mission is None else opened(mission))
    seed, seconds = limits.get("seed", DEFAULT_SEED), limits.get("seconds", DEFAULT_RUN_S)
    prepared = opened(subject).prepare(RunOptions(seed, seconds, limits.get("fail_rate", 0.0)))
    chosen = judge_options(
        by,
        limits.get("timings", ("lockstep",)),
        limits.get("check_seconds", 60.0),
        limits.get("runs", 100),
        *(limits.get("moments", 20), limits.get("jobs", 1)),
        approximate=limits.get("approximate", False),
    )
    return list(judge_mission(prepared, questions, chosen))


def walk(
    mission: str | PathLike[str] | Mission | OpenMission,
    *,
    timing: str = "free",
    failures: int = 0,
) -> StateWalk:
    """A walk by hand through the states that a check explores, standing in the first one.

    Args:
        mission: as of `open_mission`, or what that gave.
        timing: when agents tick: `free` (whenever), `prompt` (each between two events) or `lockstep` (all at once).
        failures: how many robots may fail, 0 to 3.

    Raises:
        ProblemsError: the mission has errors.
        KitRobotError: it cannot be checked, or a number or a name makes no sense.

    Examples:
        >>> import kitrobot
        >>> walk = kitrobot.walk("passing-loop")
        >>> [str(text) for text in walk.list_steps()[0].sentences]
        ['carrier-1 goes on in its program', 'AskANorth = 1']
        >>> walk.take_step(0)
        >>> walk.go_back()
    """
    from kitrobot.checking.mission_walk import begin_walk
    from kitrobot.verifier.model.timing import Timing
    from kitrobot.workspace.mission_run import RunOptions

    known = {one.value: one for one in Timing}
    if timing not in known:
        raise KitRobotError(Sentence("expected one of {known}, found {found}", listed(known), shown(str(timing))))
    opened = mission if isinstance(mission, OpenMission) else open_mission(mission)
    return begin_walk(opened.prepare(RunOptions(DEFAULT_SEED, DEFAULT_RUN_S)), known[timing], failures)


def parse(text: str, name: str = "program.lll") -> ParseResult:
    """Reads an LLL text: the tree of what could be understood, and the mistakes.

    Args:
        text: the program.
        name: the file that the mistakes show.

    Examples:
        >>> import kitrobot
        >>> parsed = kitrobot.parse("WAIT(1); WAIT(;")
        >>> len(parsed.program.items), [problem.place.column for problem in parsed.diagnostics]
        (2, [15])
    """
    return parse_lll(text, name)


def read_program(text: str, robot: str | PathLike[str] | Robot, name: str = "program-1") -> Program:
    """The graph of an LLL text, for a mission.

    Args:
        text: the program of one robot.
        robot: a robot, the name of one that is at hand, or the path of a `.robot.xml`.
        name: what agents of the mission call it.

    Raises:
        ProblemsError: the text has mistakes, or the robot has no such part; `diagnostics` says all of them.
        KitRobotError: there is no such robot.

    Examples:
        >>> import kitrobot
        >>> program = kitrobot.read_program("Wheel.Advance(50); WAIT(10); Wheel.Stop();", "mini-robot")
        >>> [vertex.element for vertex in program.vertices]
        ['Start', 'Wheel.Advance', 'Wait', 'Wheel.Stop', 'Stop']
    """
    target = _robot(robot)
    parsed = parse_lll(text, f"{name}.lll")
    found = [*parsed.diagnostics, *check(parsed.program, target, parsed.source)]
    if any(item.is_error for item in found):
        raise ProblemsError(Sentence("the program `{name}` has errors", name), "", tuple(found), (parsed.source,))
    return lll_to_graph(parsed.program, target, load_catalogue(), name)


def compile_program(
    program: str | Seq | Program, robot: str | PathLike[str] | Robot, name: str = "program.lll"
) -> CompiledProgram:
    """Compiles a program for a robot: LLL, image, debug map, and everything there is to say about it.

    Mistakes are in `diagnostics`, and then `image` is None; none is raised. `kitrobot.compile` is the same function.

    Args:
        program: an LLL text, a tree as `parse` gives it, or a graph.
        robot: a robot, the name of one that is at hand, or the path of a `.robot.xml`.
        name: the file name that the mistakes of a text show.

    Raises:
        KitRobotError: there is no such robot.

    Examples:
        >>> import kitrobot
        >>> kitrobot.compile_program("Wheel.Advance(50);", "mini-robot").ok
        True
        >>> [problem.code for problem in kitrobot.compile_program("Wheel.Advance(500);", "mini-robot").diagnostics]
        ['out-of-range']
    """
    target = _robot(robot)
    if isinstance(program, str):
        return compile_text(program, target, name)
    if isinstance(program, Program):
        catalogue = load_catalogue()
        catalogue.robots[target.name] = target
        return compile_graph(replace(program, target=target.name), catalogue)
    return compile_lll(program, target)


def robot(word: str | PathLike[str]) -> Robot:
    """The robot of that name, or of that `.robot.xml`.

    Raises:
        KitRobotError: there is none, or its file is wrong; then `diagnostics` says why.

    Examples:
        >>> import kitrobot
        >>> robot = kitrobot.robot("mini-robot")
        >>> [sensor.name for sensor in robot.sensors], robot.tick_ms
        (['Captor', 'Light', 'Button'], 20)
    """
    return find_robot(fspath(word))


def _robot(given: str | PathLike[str] | Robot) -> Robot:
    return given if isinstance(given, Robot) else robot(given)


open = open_mission
compile = compile_program
