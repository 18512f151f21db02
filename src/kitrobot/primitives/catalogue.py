"""All constructors and robots that are at hand: shipped, the user's own, and those beside the mission.

Folders are read in that order and a later one wins, name by name; a file that is wrong is reported and left out, and
what an earlier folder gave stays. Which files are read: `*.robot.xml`, and every other `*.xml` whose first element is
`<constructors>` or `<robot>`. `problems` holds what was wrong; nothing here raises because of a file, only because of
a name that is not there.

Left to others: what a constructor means (compiler), missions and worlds in the same folders.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from pathlib import Path

from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Place
from kitrobot.diagnostics.regular import open_regular
from kitrobot.lll.tree import Condition, Instr
from kitrobot.primitives import rules
from kitrobot.primitives.constructors import Constructor, Group
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.crew import Crew, team_robot
from kitrobot.primitives.levels import Level
from kitrobot.primitives.match_template import is_more_specific
from kitrobot.primitives.own_xml import OWN_GROUP, OWN_ICON, OwnVariable, own_label
from kitrobot.primitives.palette_xml import unknown_groups
from kitrobot.primitives.robot import Robot, RobotObject
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.primitives.templates import Shape, inverse_shape, shape, shape_drawn
from kitrobot.text.sentences import COMMA, Sentence, Series, Word
from kitrobot.text.suggestions import Suggestions, did_you_mean
from kitrobot.user_folders import config_folder
from kitrobot.xml import rules as xml_rules
from kitrobot.xml.decoder import MAX_BYTES

SHIPPED = Path(__file__).parent / "shipped"
"""The folder of the XML that comes with the package."""

ROBOT_SUFFIX = ".robot.xml"
"""How the name of a robot's file ends."""

REMEMBERED_FILES = 100
"""How many files are remembered as they were read: the shipped ones, and those of the missions at hand."""

REMEMBERED_BYTES = 100_000
"""The size of a file that is remembered, at most."""

# Atomic groups: a hostile file must not make this search slow.
_FIRST_ELEMENT = re.compile(rb"(?:\s|(?><\?.*?\?>)|(?><!--.*?-->))*+<([A-Za-z]+)", re.DOTALL)


@dataclass
class Catalogue:
    """What programs can be made of. `groups` is in the order of the palette; `constructors` follows it.

    `robot_files` and `constructor_files` say which file a robot or a constructor is from, by its name. `crew` is the
    team whose programs are meant, where there is one.
    """

    robots: dict[str, Robot] = field(default_factory=dict)
    groups: list[Group] = field(default_factory=list)
    problems: list[Diagnostic] = field(default_factory=list)
    robot_files: dict[str, Path] = field(default_factory=dict)
    constructor_files: dict[str, Path] = field(default_factory=dict)
    crew: Crew = field(default_factory=Crew)

    def is_own(self, robot: str) -> bool:
        """Whether a file other than those that come with KitRobot says what the robot of that name is."""
        return robot in self.robot_files and self.robot_files[robot].parent != SHIPPED

    @cached_property
    def constructors(self) -> dict[str, Constructor]:
        """Every constructor by its name."""
        return {constructor.name: constructor for group in self.groups for constructor in group.constructors}

    @cached_property
    def growth(self) -> dict[str, int]:
        """By how many instructions and tests vertices become more than one, of constructors of which they do."""
        return {name: made.size - 1 for name, made in self.constructors.items() if made.size > 1}

    @cached_property
    def inverse(self) -> Mapping[Shape, Constructor]:
        """The constructor that an LLL construct of a shape (`templates.shape`) becomes; the first that fits."""
        table: dict[Shape, Constructor] = {}
        for constructor in self.constructors.values():
            shape = inverse_shape(constructor)
            if shape is not None:
                table.setdefault(shape, constructor)
        return table

    @cached_property
    def drawn(self) -> Mapping[Shape, Sequence[Constructor]]:
        """The constructors that an LLL construct of a shape may be drawn as, in the order in which they are tried.

        A template comes before each that it is a special case of; otherwise they are in the order of the palette.
        """
        table: dict[Shape, list[Constructor]] = {}
        for constructor in self.constructors.values():
            shape = shape_drawn(constructor)
            if shape is not None:
                row = table.setdefault(shape, [])
                wider = (at for at, other in enumerate(row) if is_more_specific(constructor, other))
                row.insert(next(wider, len(row)), constructor)
        return table

    @cached_property
    def reads(self) -> Mapping[Shape, Sequence[tuple[Constructor, Instr | Condition]]]:
        """By their shape, the templates that are only read, and whose they are."""
        table: dict[Shape, list[tuple[Constructor, Instr | Condition]]] = {}
        for constructor in self.constructors.values():
            for template in constructor.reads:
                table.setdefault(shape(template), []).append((constructor, template))
        return table

    @cached_property
    def teams(self) -> Mapping[Level, Robot]:
        """The targets of programs of a team, by their level."""
        return {level: team_robot(self.crew, self.robots, level) for level in Level if level.is_team}

    def extended(
        self, constructors: Sequence[Constructor], variables: Sequence[OwnVariable], crew: Crew | None = None
    ) -> Catalogue:
        """The same with what a mission brings along; it wins over what is there, as a later folder does.

        A variable whose name the robot has already is left out, and `problems` says so.
        """
        if not constructors and not variables:
            return self if crew is None else replace(self, crew=crew)
        own = {constructor.name for constructor in constructors}
        groups = [replace(group, constructors=_without(group.constructors, own)) for group in self.groups]
        if constructors:
            groups.append(Group(OWN_GROUP, "action", tuple(constructors), own_label(), OWN_ICON))
        robots, problems = dict(self.robots), list(self.problems)
        taken: dict[str, set[str]] = {}
        added: dict[str, list[RobotObject]] = {}
        for own_variable in variables:
            robot, variable = robots.get(own_variable.robot), own_variable.variable
            if robot is None:
                continue
            if robot.name not in taken:
                taken[robot.name] = {part.name for part in robot.objects}
            names = taken[robot.name]
            if variable.name in names:
                problems.append(
                    rules.OWN_VARIABLE(Sentence("{robot} has a {variable} already", robot.name, variable.name))
                )
            else:
                names.add(variable.name)
                added.setdefault(robot.name, []).append(variable)
        for name, more in added.items():
            robots[name] = replace(robots[name], variables=(*robots[name].variables, *more))
        files = {name: path for name, path in self.constructor_files.items() if name not in own}
        return Catalogue(robots, groups, problems, self.robot_files, files, crew or self.crew)

    def robot(self, name_or_path: str | Path) -> Robot:
        """The robot of that name, or of that `.robot.xml` file.

        Raises:
            KitRobotError: no such robot, or its file is wrong (then with its diagnostics).
        """
        if isinstance(name_or_path, str) and name_or_path in self.robots:
            return self.robots[name_or_path]
        path = Path(name_or_path)
        if path.suffix.lower() != ".xml":
            help = did_you_mean(str(name_or_path), self.robots) or Sentence(
                "robots at hand: {robots}", Series(COMMA, self.robots)
            )
            raise KitRobotError(Sentence("there is no robot named {robot}", name_or_path), help)
        data, problem = _read(path)
        if data is None:
            assert problem is not None
            raise KitRobotError(problem.message, Sentence("give a robot's name, or the path of its .robot.xml"))
        robot, problems = read_robot(data, str(path))
        if robot is None:
            raise KitRobotError(
                Sentence("the robot of {path} cannot be used", path), Sentence("mend the file"), tuple(problems)
            )
        return robot


def _without(constructors: tuple[Constructor, ...], names: set[str]) -> tuple[Constructor, ...]:
    return tuple(constructor for constructor in constructors if constructor.name not in names)


def load_catalogue(folders: Sequence[Path | str] = ()) -> Catalogue:
    """Reads what is shipped, the user's folder and the given ones; a folder that is not there holds nothing."""
    loading = _CatalogueLoader()
    for folder in (SHIPPED, config_folder(), *map(Path, folders)):
        loading.folder(folder)
    return loading.catalogue()


def _robot(data: bytes, name: str) -> tuple[Robot | None, Sequence[Diagnostic]]:
    """As `read_robot`; what the same file gave before is given again."""
    return _robot_once(data, name) if len(data) <= REMEMBERED_BYTES else read_robot(data, name)


def _constructors(data: bytes, name: str) -> tuple[Sequence[Group], Sequence[Diagnostic]]:
    """As `read_constructors`; what the same file gave before is given again."""
    return _constructors_once(data, name) if len(data) <= REMEMBERED_BYTES else read_constructors(data, name)


@lru_cache(REMEMBERED_FILES)
def _robot_once(data: bytes, name: str) -> tuple[Robot | None, tuple[Diagnostic, ...]]:
    robot, problems = read_robot(data, name)
    return robot, tuple(problems)


@lru_cache(REMEMBERED_FILES)
def _constructors_once(data: bytes, name: str) -> tuple[tuple[Group, ...], tuple[Diagnostic, ...]]:
    groups, problems = read_constructors(data, name)
    return tuple(groups), tuple(problems)


class _CatalogueLoader:
    """What the folders read so far amount to."""

    def __init__(self) -> None:
        self.robots: dict[str, Robot] = {}
        self.robot_files: dict[str, Path] = {}
        self.groups: dict[str, Group] = {}
        self.constructors: dict[str, tuple[Constructor, Place]] = {}
        self.problems: list[Diagnostic] = []

    def folder(self, folder: Path) -> None:
        try:
            paths = sorted(path for path in folder.glob("*.xml") if path.is_file())
        except OSError as error:
            self.problems.append(_unreadable(folder, error))
            return
        seen: dict[str, Path] = {}
        for path in paths:
            data, problem = _read(path)
            if problem is not None:
                self.problems.append(problem)
            elif data is not None:
                for name in self.file(path, data):
                    if name in seen:
                        message = Sentence(
                            "{name} is in {file} of this folder already; this one is used", name, seen[name].name
                        )
                        self.problems.append(rules.SAME_FOLDER(message, Place(str(path))))
                    seen[name] = path

    def file(self, path: Path, data: bytes) -> list[str]:
        """Takes in one file; the names it brought."""
        first = _FIRST_ELEMENT.match(data.removeprefix(b"\xef\xbb\xbf"))
        root = first.group(1) if first else b""
        if path.name.lower().endswith(ROBOT_SUFFIX) or root == b"robot":
            robot, problems = _robot(data, str(path))
            self.problems += problems
            if robot is None:
                return []
            self.robots[robot.name] = robot
            self.robot_files[robot.name] = path
            return [Sentence("the robot {robot}", robot.name)]
        if root != b"constructors" and not path.name.lower().endswith("constructors.xml"):
            return []
        groups, problems = _constructors(data, str(path))
        self.problems += problems
        for group in groups:
            known = self.groups.get(group.name, group)
            label = {**known.label, **group.label}
            icon, holds = group.icon or known.icon, group.holds or known.holds
            self.groups[group.name] = Group(group.name, group.colour, (), label, icon, holds)
            for constructor in group.constructors:
                self.constructors[constructor.name] = (constructor, Place(str(path)))
        return [
            Sentence("the constructor {constructor}", constructor.name)
            for group in groups
            for constructor in group.constructors
        ]

    def catalogue(self) -> Catalogue:
        suggestions = Suggestions()
        members: dict[str, list[Constructor]] = {name: [] for name in self.groups}
        for constructor, place in self.constructors.values():
            if constructor.adds is not None:
                target, name = constructor.adds
                found = self.constructors.get(target)
                slot = found[0].slot(name) if found is not None else None
                if slot is None or not slot.repeat:
                    message = Sentence(
                        "{constructor} adds to {target}.{slot}, which is no repeated slot",
                        constructor.name,
                        target,
                        name,
                    )
                    help = suggestions.did_you_mean(target, self.constructors) if found is None else ""
                    self.problems.append(rules.ADDS(message, place, help=help))
                    continue
            members[constructor.group].append(constructor)
        # One without constructors is a tab of the palette for parts of robots.
        groups = [replace(group, constructors=tuple(members[name])) for name, group in self.groups.items()]
        self.problems += unknown_groups([*self.robots.values()], groups)
        files = {name: Path(place.file) for name, (_, place) in self.constructors.items()}
        return Catalogue(self.robots, groups, self.problems, self.robot_files, files)


def _read(path: Path) -> tuple[bytes | None, Diagnostic | None]:
    try:
        size = path.stat().st_size
        if size > MAX_BYTES:
            return None, xml_rules.TOO_LARGE(
                Sentence("expected at most {most} bytes, found {found}", MAX_BYTES, size), Place(str(path))
            )
        with open_regular(path) as stream:
            return stream.read(), None
    except OSError as error:
        return None, _unreadable(path, error)


def _unreadable(path: Path, error: OSError) -> Diagnostic:
    reason = Word(error.strerror or type(error).__name__)
    return rules.UNREADABLE(Sentence("cannot read {path}: {reason}", path, reason), Place(str(path)))
