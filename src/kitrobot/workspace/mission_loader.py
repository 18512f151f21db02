"""An opened mission: its parts, the robots and constructors it is made of, its world, and its diagnostics.

An `OpenMission` comes from a file or, in the studio, from the page; then there is no text to point into and diagnostics
keep the places they have in the LLL. Opening reads the files; `check` finds all problems; `run` is in `mission_run`.
Mistakes in XML files that the mission does not need never prevent opening: they are in `catalogue.problems`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from kitrobot.compiler.compilation import CompiledProgram, compile_program, not_compiled
from kitrobot.compiler.graph.expansion_limit import left_out, oversize_in_mission
from kitrobot.compiler.program.team_check import program_circles
from kitrobot.compiler.team.points import TeamPlan
from kitrobot.compiler.team_compilation import CompiledTeam, compile_team
from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Place, Severity, Source, rule
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.files.disk import read_bytes
from kitrobot.files.embedded_mission import read_carried
from kitrobot.files.examples import find_mission
from kitrobot.files.places import Places
from kitrobot.graph.model import Program, empty_program
from kitrobot.mission.model import DEFAULT_RUN_S, DEFAULT_SEED, Agent, Mission, Team
from kitrobot.mission.reader import read_mission
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.team_objects import has_team
from kitrobot.sim.setup.limits import SimulationError
from kitrobot.sim.setup.setup import check_mission
from kitrobot.text.forms import name_form
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.workspace.mission_check import mission_problems
from kitrobot.workspace.program_report import Report, program_report, projection_report
from kitrobot.workspace.property_check import property_problems
from kitrobot.workspace.robots import find_robot
from kitrobot.workspace.search_path import SearchPath
from kitrobot.world.model import World
from kitrobot.world.xml_reader import check_plan, read_world

if TYPE_CHECKING:
    from kitrobot.sim.simulation import Simulation
    from kitrobot.workspace.compile_cache import CompileCache
    from kitrobot.workspace.mission_run import PreparedRun, Progress, Run, RunOptions

NO_WORLD = rule(
    "mission-no-world",
    Severity.ERROR,
    "The world of a mission is not there",
    "A world's file is looked for in the mission's folder and among the worlds that come with KitRobot. A path that"
    " leads out of the folder is not followed.",
)
NEW_PROGRAM, NEW_ROBOT, NEW_AGENT = "program-1", "mini-robot", "robot-1"


class NoProgramError(KitRobotError):
    """A mission has no such program, or several where one must be chosen."""


@dataclass(frozen=True)
class OpenMission:
    """A mission and what it needs. `diagnostics` is what its files say that is wrong; `text` is its `.krt`, if there
    is one.
    """

    name: str
    mission: Mission
    catalogue: Catalogue
    world: World | None
    diagnostics: tuple[Diagnostic, ...] = ()
    sources: tuple[Source, ...] = ()
    text: Source | None = None
    path: Path | None = None
    world_file: Path | None = None
    """Where its world was read from; None for one that it brings along, or that is not there."""
    common: Catalogue | None = field(default=None, repr=False, compare=False)
    """What the files hold, without the parts that the mission brings along."""
    kept: CompileCache | None = field(default=None, repr=False, compare=False)
    """Where programs that were compiled already are found, in the studio."""

    def _repr_html_(self) -> str:
        """The mission in a notebook: its world with the robots at their starts, its programs, and its mistakes."""
        from kitrobot.workspace.notebook_html import mission_html

        agents = Counter(agent.program for agent in self.mission.team.agents)
        rows = [
            (program.name, f"{program.target}, {len(program.vertices) - 2} parts, in {agents[program.name]} agents")
            for program in self.mission.programs
        ]
        return mission_html(
            Path(self.name).name, rows, self.report.problems, self.simulation if self.report.ok else None
        )

    @property
    def files(self) -> tuple[Path, ...]:
        """The files that it was read from: itself, its world, and the robots at hand."""
        own = (one for one in (self.path, self.world_file) if one is not None)
        return (*own, *self.catalogue.robot_files.values())

    @cached_property
    def places(self) -> Places | None:
        """Where things stand in the `.krt`; None when there is no text."""
        return Places(self.text) if self.text is not None else None

    def placed(self, diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
        """Diagnostics about vertices and arcs with their places in the `.krt`, if there is one."""
        return self.places.placed(diagnostics) if self.places is not None else list(diagnostics)

    def program(self, name: str | None = None) -> Program:
        """The program of that name; without a name, the only one.

        Raises:
            NoProgramError: there is none of that name, or there are several to choose from.
        """
        programs = self.mission.programs
        names = Series(COMMA, (f"`{program.name}`" for program in programs))
        if name is None:
            if len(programs) == 1:
                return programs[0]
            if not programs:
                raise NoProgramError(
                    Sentence("`{mission}` holds no program", self.name), Sentence("draw one in the studio")
                )
            raise NoProgramError(
                Sentence.counted(
                    "`{mission}` holds {count} program: {names}",
                    "`{mission}` holds {count} programs: {names}",
                    self.name,
                    len(programs),
                    names,
                ),
                Sentence("choose one with --program"),
            )
        found = self.mission.program(name_form(name))
        if found is None:
            raise NoProgramError(
                Sentence("`{mission}` holds no program `{program}`", self.name, name),
                Sentence("its programs: {names}", names or "none"),
            )
        return found

    @cached_property
    def compiled(self) -> Mapping[str, CompiledProgram]:
        """Each program compiled, by name, as far as its robot is at hand."""
        made: dict[str, CompiledProgram] = {}
        for program in self.mission.programs:
            if program.name in self._oversize:
                made[program.name] = not_compiled(program, oversize_in_mission(program))
            elif program.level.is_team or program.target in self.catalogue.robots:
                made[program.name] = (
                    compile_program(program, self.catalogue)
                    if self.kept is None
                    else self.kept.of(program, self.catalogue).compiled
                )
        return made

    @cached_property
    def _oversize(self) -> set[str]:
        """The programs before which others have grown to what all of a mission may."""
        return {program.name for program in left_out(self.mission.programs, self.catalogue)}

    @cached_property
    def team(self) -> CompiledTeam | None:
        """The program that agents run as a team, for each of their kinds of robots; None where none can be."""
        social = self.mission.social
        kinds = dict.fromkeys(one.robot for one in self.mission.team.agents if one.program == social)
        return self.compile_team(social, kinds) if kinds else None

    def compile_team(self, name: str, kinds: Collection[str]) -> CompiledTeam | None:
        """A team's program for kinds of robots; None where one of them is not at hand or a program has errors."""
        robots, compiled = self.catalogue.robots, self.compiled
        if name not in compiled or any(item.is_error for one in compiled.values() for item in one.diagnostics):
            return None
        if not all(kind in robots and not has_team(robots[kind], self.mission.team.works) for kind in kinds):
            return None
        from kitrobot.sim.setup.settings import moves_boxes

        return compile_team(name, compiled, self.catalogue, kinds, moves_boxes)

    @property
    def images(self) -> Mapping[ImageName, CompiledProgram]:
        """What agents run, by `Agent.image_name`."""
        team = self.team.kinds if self.team is not None else {}
        of_team = {ImageName(self.mission.social, kind): one for kind, one in team.items()}
        return {ImageName(name): one for name, one in self.compiled.items()} | of_team

    def check(self) -> Report:
        """Looks everything through: the files, the programs, and whether the parts fit together."""
        return self.report

    @cached_property
    def report(self) -> Report:
        """What `check` gives; worked out once."""
        found = list(self.before_setup)
        if not any(item.is_error for item in found):
            found += self._stage_problems()
        made = self.team.kinds if self.team is not None else {}
        projections = tuple(projection_report(robot, compiled) for robot, compiled in made.items())
        programs = tuple(program_report(one.name, self.compiled.get(one.name)) for one in self.mission.programs)
        return Report(programs, tuple(found), self.all_sources, projections)

    @property
    def all_sources(self) -> tuple[Source, ...]:
        """The texts of its files and of its programs."""
        return (*self.sources, *(one.source for one in self.images.values()))

    @cached_property
    def before_setup(self) -> tuple[Diagnostic, ...]:
        """What can be said without letting the team take its places in the world, which is what takes long of many."""
        found = list(self.diagnostics)
        # Whoever names a part of the mission's own world that does not fit is not to blame for it.
        place = self.mission.own_world or self.world
        found += mission_problems(self.mission, self.catalogue, place, self.places)
        found += property_problems(self.mission, self.catalogue, self.places)
        for compiled in self.compiled.values():
            found += self.placed(compiled.diagnostics)
        teams = {one.name: self.compiled[one.name].program for one in self.mission.programs if one.level.is_team}
        found += self.placed(program_circles(teams))
        if self.team is not None and not any(item.is_error for item in found):
            found += self.placed(self.team.diagnostics)
        return tuple(found)

    @property
    def plan(self) -> TeamPlan | None:
        """What the agents agree on, when they run the program of a team."""
        return self.team.plan if self.team is not None else None

    def setup_problems(self, error: SimulationError) -> tuple[Diagnostic, ...]:
        """What keeps a team from taking its places in the world, with the mission's file where it has no place."""
        return tuple(one if one.place or self.text is None else self._located(one) for one in error.diagnostics)

    def _located(self, item: Diagnostic) -> Diagnostic:
        if item.program:
            return self.placed([item])[0]
        start = None
        if item.thing.startswith("start:") and self.mission.own_world is not None and self.places is not None:
            start = self.places.start(int(item.thing.removeprefix("start:")))
        return replace(item, place=start or Place(self.name))

    def _stage_problems(self) -> tuple[Diagnostic, ...]:
        assert self.world is not None, "a mission without its world has an error"
        try:
            check_mission(self.mission, self.world, self.images, self.catalogue, self.plan)
        except SimulationError as error:
            return self.setup_problems(error)
        return ()

    def prepare(self, options: RunOptions | None = None) -> PreparedRun:
        """The mission in its world, set up once: see `PreparedRun`.

        Raises:
            ProblemsError: the mission has errors; all are told.
            SimulationError: a number of the options makes no sense.
            OutputPlaceError: the recording would be written over a file that was read.
        """
        from kitrobot.workspace.mission_run import RunOptions, prepare

        return prepare(self, options if options is not None else RunOptions())

    def simulation(self, seed: int = DEFAULT_SEED, fail_rate: float = 0.0, seconds: float | None = None) -> Simulation:
        """The mission in its world, before its first step, to be stepped by hand.

        Args:
            seed: where chance begins, 0 to 2^53; the same seed gives the same run.
            fail_rate: the probability (0…1) that an agent fails for good within a minute, by chance.
            seconds: simulated seconds after which it is out of time; None: never.

        Raises:
            ProblemsError: the mission has errors; all are told.
            SimulationError: one of the numbers makes no sense.
        """
        from kitrobot.workspace.mission_run import RunOptions

        return self.prepare(RunOptions(seed, seconds, fail_rate)).simulation

    def run(
        self,
        seed: int = DEFAULT_SEED,
        seconds: float = DEFAULT_RUN_S,
        trace: str | PathLike[str] | None = None,
        progress: Progress | None = None,
        fail_rate: float = 0.0,
    ) -> Run:
        """Runs the mission in the simulator, as fast as it goes.

        Args:
            seed: where chance begins; the same seed gives the same run.
            seconds: simulated seconds after which it is out of time.
            trace: a file (`.krtrace`) to record the run in.
            progress: is told the simulated seconds so far, now and then.
            fail_rate: the probability (0…1) that an agent fails for good within a minute, by chance.

        Raises:
            ProblemsError: the mission has errors.
            SimulationError: one of the numbers makes no sense.
            TraceError: the trace cannot be written.
        """
        from kitrobot.workspace.mission_run import RunOptions

        file = Path(trace) if trace is not None else None
        return self.prepare(RunOptions(seed, seconds, fail_rate, file)).run(progress)


def open_mission(path: Path, *, robot: str | None = None) -> OpenMission:
    """Opens a `.krt`, or a picture that carries one, with what lies beside it.

    Args:
        path: the file, or the name of an example. Places in the mission of a picture count in the `.krt` that it
            carries.
        robot: a robot's name or file, in place of the ones that the programs are for.

    Raises:
        FileError: the file cannot be read, or is a picture without a mission.
        ProblemsError: nothing of the file can be used.
        KitRobotError: there is no such robot.
    """
    path = find_mission(path)
    opened = read_mission_data(read_carried(path), str(path), SearchPath(path.parent))
    opened = replace(opened, path=path)
    if robot is not None:
        retarget(opened, find_robot(robot, path.parent))
    return opened


def retarget(opened: OpenMission, robot: Robot) -> None:
    """Puts a robot in the place of the ones that programs are for; before anything of them was asked."""
    opened.catalogue.robots[robot.name] = robot
    for program in opened.mission.programs:
        program.target = program.target and robot.name


def read_mission_data(data: bytes, name: str, search: SearchPath) -> OpenMission:
    """Opens the bytes of a `.krt`, with what lies in the folders of `search`.

    Raises:
        ProblemsError: nothing of it can be used.
    """
    mission, diagnostics = read_mission(data, name)
    text = Source(name, data.decode("utf-8-sig", errors="replace"))
    if mission is None:
        raise ProblemsError(Sentence("`{name}` cannot be opened", name), "", tuple(diagnostics), (text,))
    opened = _open(mission, name, search, Places(text))
    return replace(opened, diagnostics=(*diagnostics, *opened.diagnostics), sources=(text, *opened.sources), text=text)


def with_mission(mission: Mission, name: str, search: SearchPath, kept: CompileCache | None = None) -> OpenMission:
    """Opens a mission that is no file (yet), with what lies in the folders of `search`.

    `kept`: what was worked out for it before.
    """
    return _open(mission, name, search, None, kept)


def new_mission() -> Mission:
    """The mission to begin with: one program, start and stop, and one robot in the empty world."""
    return mission_of(empty_program(NEW_PROGRAM, NEW_ROBOT))


def mission_of(program: Program) -> Mission:
    """A mission of one program, with one robot in the empty world."""
    return Mission(programs=[program], team=Team(agents=[Agent(NEW_AGENT, program.name)]))


def _open(
    mission: Mission, name: str, search: SearchPath, places: Places | None, kept: CompileCache | None = None
) -> OpenMission:
    common = search.catalogue()
    extended = common.extended if kept is None else partial(kept.catalogue, common)
    known = extended(mission.constructors, mission.variables, mission.crew)
    own = tuple(known.problems[len(common.problems) :])
    if mission.own_world is not None:
        world, told = check_plan(mission.own_world)
        # What was read from a file has said with its lines what is wrong with its world.
        told = own if places is not None else (*own, *told)
        return OpenMission(name, mission, known, world, told, common=common, kept=kept)
    if mission.has_unread_world:
        # Not the empty world instead: nothing could be said about places in it. A file has told what is wrong.
        lost = NO_WORLD(Sentence("the mission's own world has a mistake"), help=Sentence("mend <world> in its file"))
        told = own if places is not None else (*own, lost)
        return OpenMission(name, mission, known, None, told, common=common, kept=kept)
    path = search.world_file(mission.world_href)
    if path is None:
        place = (places.world or Place(name)) if places is not None else None
        help = Sentence("put its file into `{folder}`", search.folder.name)
        found = NO_WORLD(Sentence("there is no world `{world}`", mission.world_href), place, help=help)
        return OpenMission(name, mission, known, None, (*own, found), common=common, kept=kept)
    data = read_bytes(path)
    world, diagnostics = read_world(data, path.name)
    source = Source(path.name, data.decode("utf-8-sig", errors="replace"))
    told = (*own, *diagnostics)
    return OpenMission(name, mission, known, world, told, (source,), world_file=path, common=common, kept=kept)
