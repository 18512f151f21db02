"""What a person measured of a robot on the floor → its kit, as it is.

Wheels that turn the wrong way, or that are each other's, are written down as such (`left-flipped`, settings of left and
right exchanged). The distance that it drove gives its full speed, the angle that it turned corrects what its driver
counts with (`rate`, `counts`); how far answers lie apart is the noise. The simulator is given speed, rate and noise
(`Kit.measured`). Left to others: asking (cli), moving the robot (bench_run).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from statistics import fmean, stdev

from kitrobot.boards.bench import Bench, BenchStep, bench_of
from kitrobot.boards.bench_notes import MEASURES, fits, shipped_notes
from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Source
from kitrobot.diagnostics.read_files import expect_output
from kitrobot.files.disk import FileError, read_bytes, replace_file, saving_in
from kitrobot.primitives.catalogue import SHIPPED
from kitrobot.primitives.kit import Kit, KitPart, Measurement
from kitrobot.primitives.kit_xml import read_kit, write_kit
from kitrobot.primitives.robot import Category, Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.text.sentences import Sentence
from kitrobot.user_folders import config_folder

USUAL_RATE = 180
"""Degrees a second at full speed: what a driver counts with that is not told another one."""

MOST_MM, MOST_DEGREES = 20_000, 3600
LEAST_RATE, MOST_RATE = 10, 2000
MOST_SPEED = 5000
"""Millimetres a second at full speed that a driver takes."""

LEAST_COUNTS, MOST_COUNTS = 20, 100_000
_WAIT_S = 0.1
_MOST_NOISE = 50.0
_ROBOT = Path(__file__).parent / "shipped" / "bench.robot.xml"
_LEFT, _RIGHT = "left-", "right-"
_OF_A_MOTOR = ("forward", "backward", "power", "flipped", "trim")
_USUAL = (("left-flipped", "no"), ("right-flipped", "no"))


class MeasureError(KitRobotError):
    """What was measured cannot be, or the kit's file cannot say it."""


@cache
def bench_robot() -> Robot:
    """The robot that has all parts that kits have."""
    robot, problems = read_robot(_ROBOT.read_bytes(), _ROBOT.name)
    assert robot is not None, problems
    return robot


@dataclass(frozen=True)
class WheelTurn:
    """Which wheel turned, and which way."""

    side: str
    forward: bool


@dataclass(frozen=True)
class Answers:
    """What was seen: of each wheel that was told to go forward, which one turned; millimetres and degrees, a number for
    each time.
    """

    wheels: Mapping[str, WheelTurn] = field(default_factory=dict)
    distances: Sequence[float] = ()
    turns: Sequence[float] = ()


def measuring_steps(kit: Kit, folder: Path | None = None) -> tuple[Bench, dict[str, BenchStep]]:
    """What is done to measure a kit: the steps by what they measure.

    Raises:
        MeasureError: the kit has no wheels.
    """
    bench = bench_of(bench_robot(), kit, folder, ())
    there = {step.key: step.part for step in bench.steps if step.part.category is Category.ACTUATOR}
    notes = {note.measures: note for note in shipped_notes() if note.measures}
    steps: dict[str, BenchStep] = {}
    for measure in MEASURES:
        note = notes[measure]
        for part in there.values():
            method = part.method(note.procedure)
            if part.device in note.devices and note.part in ("", part.name) and method is not None and fits(part, note):
                number = len(steps) + 1
                steps[measure] = BenchStep(number, part, method, note.arguments, note.seen, note.trouble, note.lasts)
    if not steps:
        raise MeasureError(
            Sentence("the kit `{kit}` has no wheels to measure", kit.name), Sentence("take a kit that drives")
        )
    return replace(bench, steps=tuple(steps.values())), steps


def calibrated(kit: Kit, answers: Answers) -> Kit:
    """The kit as it was measured.

    Raises:
        MeasureError: an answer cannot be, or its file cannot say it.
    """
    made = _wheels(kit, answers.wheels) if answers.wheels else kit
    measured: dict[str, dict[str, str]] = {}
    notes = {note.measures: note for note in shipped_notes() if note.measures}
    if answers.distances:
        note = notes["distance"]
        _refuse_outside(answers.distances, 1, MOST_MM, Sentence("millimetres"))
        full = fmean(answers.distances) / (note.lasts * _WAIT_S) * 100 / note.arguments[0]
        told = {"speed": _written(full), **_noise(answers.distances)}
        made = _driving(made, full)
        measured |= {"drive": told, "wheel": told}
    if answers.turns:
        note = notes["turn"]
        _refuse_outside(answers.turns, 1, MOST_DEGREES, Sentence("degrees"))
        made, rate = _turning(made, fmean(answers.turns) / (note.arguments[0] * 3.6))
        measured["turn"] = {**rate, **_noise(answers.turns)}
    kept = [one for one in made.measured if not set(one.devices) & measured.keys()]
    new = [Measurement((device,), settings) for device, settings in measured.items() if settings]
    return replace(made, measured=(*kept, *new))


def _refuse_outside(values: Sequence[float], least: float, most: float, unit: Sentence) -> None:
    for value in values:
        if not math.isfinite(value) or not least <= value <= most:
            raise MeasureError(
                Sentence(
                    "expected {least} to {most} {unit}, found {value}", f"{least:g}", f"{most:g}", unit, f"{value:g}"
                ),
                Sentence("measure once more; where the robot did not move, `kitrobot bench` says what to look for"),
            )


def _noise(values: Sequence[float]) -> dict[str, str]:
    """How far answers to one question lie apart, as a part of them in percent; unknown after one."""
    return {"noise": _written(min(100 * stdev(values) / fmean(values), _MOST_NOISE))} if len(values) > 1 else {}


def _written(value: float) -> str:
    return f"{value:.1f}".removesuffix(".0")


def _wheels(kit: Kit, turned: Mapping[str, WheelTurn]) -> Kit:
    """The kit with wheels that are each other's exchanged, and flipped where they turned backward."""
    swapped = [side for side, one in turned.items() if one.side != side]
    backward = {one.side for one in turned.values() if not one.forward}
    if swapped and len(swapped) < len(turned):
        raise MeasureError(
            Sentence("both times the {side} wheel turned", next(iter(turned.values())).side),
            Sentence("look at the wires of the other motor, then begin again"),
        )
    if not swapped and not backward:
        return kit
    parts = tuple(_rewired(part, bool(swapped), backward) if _has_motors(part) else part for part in kit.parts)
    if parts == kit.parts:
        raise MeasureError(
            Sentence(
                "a wheel is wired the other way round, and the file of the kit `{kit}` has no word for that", kit.name
            ),
            Sentence("exchange the wires of its motor"),
        )
    return replace(kit, parts=parts)


def _has_motors(part: KitPart) -> bool:
    return f"{_LEFT}forward" in part.board.settings


def _rewired(part: KitPart, swapped: bool, backward: set[str]) -> KitPart:
    settings = dict(part.board.settings)
    if swapped:
        pairs = {f"{_LEFT}{name}": f"{_RIGHT}{name}" for name in _OF_A_MOTOR}
        pairs |= {right: left for left, right in pairs.items()}
        settings = {pairs.get(name, name): value for name, value in settings.items()}
    for side in sorted(backward):
        name = f"{side}-flipped"
        settings[name] = "no" if settings.get(name) == "yes" else "yes"
    kept = {name: value for name, value in settings.items() if (name, value) not in _USUAL}
    return replace(part, board=replace(part.board, settings=kept))


def _driving(kit: Kit, full_mm_s: float) -> Kit:
    """The kit whose driver knows how fast it drives at full speed; one that follows a road drives no distances."""
    speed = {"speed": str(max(LEAST_RATE, min(round(full_mm_s), MOST_SPEED)))}
    return replace(
        kit,
        parts=tuple(
            replace(part, board=replace(part.board, settings={**part.board.settings, **speed}))
            if part.category is Category.ACTUATOR and not part.is_missing and "drive" in part.devices and not part.when
            else part
            for part in kit.parts
        ),
    )


def _turning(kit: Kit, part_turned: float) -> tuple[Kit, dict[str, str]]:
    """The kit whose driver counts right, after it turned that part of what it should; what the simulator is told."""
    parts, rate = [], {}
    for part in kit.parts:
        if part.category is not Category.ACTUATOR or part.is_missing or not _turns(part):
            parts.append(part)
            continue
        settings = dict(part.board.settings)
        if settings.get("gyro", "none") != "none":
            pass  # it measures by itself
        elif "counts" in settings:
            counts = round(int(settings["counts"]) / part_turned)
            settings["counts"] = str(max(LEAST_COUNTS, min(counts, MOST_COUNTS)))
        else:
            new = round(int(settings.get("rate", USUAL_RATE)) * part_turned)
            settings["rate"] = str(max(LEAST_RATE, min(new, MOST_RATE)))
            rate = {"rate": settings["rate"]}
        parts.append(replace(part, board=replace(part.board, settings=settings)))
    return replace(kit, parts=tuple(parts)), rate


def _turns(part: KitPart) -> bool:
    turning = next(note for note in shipped_notes() if note.measures == "turn")
    return bool(set(turning.devices) & set(part.devices))


def own_place(word: str, kit: Kit, folder: Path) -> Path:
    """Where the kit is written: into its own file, when that is neither shipped nor of all missions; else beside them.

    `word`: what it was asked for with.
    """
    path = Path(word)
    if word.endswith(".xml") and path.parent.resolve() not in (SHIPPED.resolve(), config_folder().resolve()):
        return path
    return folder / f"{kit.name}.board.xml"


def expect_kit_place(kit: Kit, path: Path) -> None:
    """That a kit may be written to a path: to a new file, or over the kit of its name.

    Raises:
        OutputPlaceError: it is another file that was read.
    """
    if not _is_of_kit(kit, path):
        expect_output(path)


def left_out(path: Path) -> tuple[tuple[Diagnostic, ...], tuple[Source, ...]]:
    """What of a kit's file is lost once it is written anew, and the file's text; nothing where there is none."""
    try:
        data = read_bytes(path)
    except FileError:
        return (), ()
    _, found = read_kit(data, str(path))
    source = Source(str(path), data.decode("utf-8-sig", errors="replace"))
    return tuple(one for one in found if one.code.startswith("xml-")), (source,)


def write_kit_file(kit: Kit, path: Path) -> None:
    """Writes a kit's file.

    Raises:
        FileError: it cannot be written.
        OutputPlaceError: as for `expect_kit_place`.
    """
    expect_kit_place(kit, path)
    with saving_in(path):
        replace_file(path, write_kit(kit).encode(), over_input=True)


def _is_of_kit(kit: Kit, path: Path) -> bool:
    try:
        found, _ = read_kit(read_bytes(path), path.name)
    except FileError:
        return False
    return found is not None and found.name == kit.name
