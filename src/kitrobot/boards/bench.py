"""The parts of a robot tried by hand, one step after the other: the steps, and the program that waits for them.

The program has a variable of its own. What that holds is the number of the step that is done: the part's procedure is
called, and ended as soon as the variable holds something else. Sensors are all sampled, and those that are not looked
at are held (`force`), so one that is not plugged in spoils nothing but its own step. Left to others: the robot at the
other end (bench_run), keys and tables (cli), the page.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

from kitrobot.boards.bench_notes import BenchNote, notes_for
from kitrobot.boards.programs import ready_program
from kitrobot.compiler.compilation import compile_text
from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.kits.kits import parts_on_kit
from kitrobot.deploy.package.package import Package
from kitrobot.diagnostics.model import KitRobotError, Source
from kitrobot.primitives.automatic import number_variable
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.robot import Category, Method, Robot, RobotObject, Texts
from kitrobot.primitives.robot import Kind as MethodKind
from kitrobot.robots.program import BoardProgram
from kitrobot.text.sentences import Label, Sentence
from kitrobot.user_folders import config_folder

PROGRAM = "bench"
"""What the program is called."""

_VARIABLE = "Bench"

PartKey = tuple[Category, str]
"""A part of a robot: an actuator and a sensor may share a name."""


class NoPartsError(KitRobotError):
    """There is nothing to try."""


@dataclass(frozen=True)
class BenchStep:
    """One thing to try. `number` is what the variable holds meanwhile, 0 for a sensor; `call` is the procedure with its
    numbers as LLL writes it, "" for a sensor.
    """

    number: int
    part: RobotObject
    method: Method | None
    arguments: tuple[int, ...]
    seen: Texts
    trouble: Texts
    lasts: int | None = None
    """It ends by itself: after so many units of WAIT, or with 0 when the part is done. None: when it is ended."""

    @property
    def key(self) -> PartKey:
        """The part."""
        return self.part.category, self.part.name

    @property
    def call(self) -> str:
        """What is called."""
        return _call(self.part, self.method, self.arguments) if self.method is not None else ""


@dataclass(frozen=True)
class Bench:
    """What can be tried of a robot. `left_out`: parts that its kit lacks or that cannot work there, and why."""

    robot: Robot
    kit: Kit | None
    folder: Path | None
    variable: str
    steps: tuple[BenchStep, ...]
    left_out: tuple[tuple[RobotObject, str], ...]

    def program(self, parts: Collection[PartKey]) -> BoardProgram:
        """The program that waits for the steps of these parts.

        Raises:
            KitRobotError: a driver is missing or not told what it needs.
        """
        most = max((step.number for step in self.steps), default=0)
        robot = replace(self.robot, variables=(*self.robot.variables, number_variable(self.variable, most)))
        steps = [step for step in self.steps if step.key in parts]
        source = Source(PROGRAM, program_text(self.variable, steps))
        compiled = compile_text(source.text, robot, source.name)
        # Hints are for who reads the program, and nobody does.
        found = tuple(one for one in compiled.diagnostics if one.is_error)
        return ready_program(PROGRAM, robot, compiled, found, (source,), self.folder, kit=self.kit)

    def together(self, parts: Sequence[PartKey], needed: PartKey | None = None) -> list[PartKey]:
        """As many of these parts as can be on the robot at once, the needed one among them: some share a pin.

        Raises:
            KitRobotError: a driver is missing or not told what it needs.
        """
        try:
            self.program(parts)
        except PackageError:
            found: list[PartKey] = []
            for key in [*([needed] if needed is not None else []), *(one for one in parts if one != needed)]:
                with suppress(PackageError):
                    self.program([*found, key])
                    found.append(key)
            if not found or (needed is not None and needed not in found):
                raise
            return found
        return list(parts)


def bench_of(
    robot: Robot, kit: Kit | None, folder: Path | None = None, notes: Sequence[BenchNote] | None = None
) -> Bench:
    """All that can be tried of a robot on a kit (None: wired as its own file says), in the order of its file.

    Raises:
        NoPartsError: its kit has none of its parts.
    """
    parts, left_out = _there(robot, kit, folder)
    found: list[BenchStep] = []
    number = 0
    for part in parts:
        for note in notes_for(part, tuple(notes) if notes is not None else None):
            method = part.method(note.procedure) if note.procedure else None
            number += method is not None
            found.append(BenchStep(number if method else 0, part, method, note.arguments, note.seen, note.trouble))
    if not found:
        raise NoPartsError(
            Sentence("there is nothing to try of the robot `{robot}`", robot.name),
            Sentence("name another robot with --robot, or what it is built of with --board"),
        )
    names = {part.name for part in robot.objects}
    variable = _VARIABLE
    while variable in names:
        variable += "_"
    return Bench(robot, kit, folder, variable, tuple(found), tuple(left_out))


def _there(
    robot: Robot, kit: Kit | None, folder: Path | None
) -> tuple[list[RobotObject], list[tuple[RobotObject, str]]]:
    """The parts that can be tried, and the others with why not."""
    parts = [*robot.actuators, *robot.sensors]
    if kit is None:
        return parts, []
    package = Package((config_folder(), *([folder] if folder is not None else [])))
    there: list[RobotObject] = []
    left_out: list[tuple[RobotObject, str]] = []
    for part, looked in zip(parts, parts_on_kit(robot, kit, package, None), strict=True):
        if looked.is_missing:
            why = looked.found.help if looked.found is not None else {}
            left_out.append((part, Label("", why) or Sentence("the kit `{kit}` has none", kit.name)))
        elif isinstance(looked.problem, PackageError):
            left_out.append((part, looked.problem.message))
        else:
            there.append(part)
    return there, left_out


def program_text(variable: str, steps: Sequence[BenchStep]) -> str:
    """The LLL that waits for the steps."""
    lines = ["*("]
    for step in steps:
        if step.method is None:
            continue
        end = step.method.stop
        ends = f" {step.part.name}.{end}();" if end is not None else ""
        here = f"{variable}.EqualTo({step.number})"
        if step.lasts is None:
            inside = f"{step.call}; <!({here})>();{ends}"
        else:
            waits = f" WAIT({step.lasts});{ends}" if step.lasts else ""
            inside = f"{step.call};{waits} {variable}.Set(0);"
        lines.append(f"  [{here}]({inside} )!();")
    for key in dict.fromkeys(step.key for step in steps if step.method is None):
        part = next(step.part for step in steps if step.key == key)
        if (test := _test(part)) is not None:
            # Only what a program asks is sampled.
            lines.append(f"  [{test}]({variable}.Add(0); )!();")
    return "\n".join([*lines, "  WAIT(0);", ");"]) + "\n"


def _test(part: RobotObject) -> str | None:
    for method in part.methods:
        if method.kind is MethodKind.TEST:
            return _call(part, method, tuple(max(0, one.default) for one in method.parameters))
    return None


def _call(part: RobotObject, method: Method, arguments: Sequence[int]) -> str:
    return f"{part.name}.{method.name}({', '.join(map(str, arguments))})"
