"""A robot on a kit: its parts wired as the kit's file says, and its mistakes, found before anything is sent."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.firmware.chip_pins import refuse_pin
from kitrobot.deploy.kits.waves import SLICES, Wave, clash, waves_of
from kitrobot.deploy.package.declarations import (
    DriverDeclaration,
    Wire,
    counts_only,
    may_join,
    refuse_conditions,
    refuse_what_is_not_understood,
    refuse_wire,
    wires_of,
)
from kitrobot.deploy.package.package import Package, missing_driver
from kitrobot.deploy.package.program_file import used
from kitrobot.image.machine import Layout
from kitrobot.image.model import Image
from kitrobot.primitives.kit import OF_A_TEAM, Kit, KitPart, lacks, on_kit
from kitrobot.primitives.robot import Board, Category, Robot, RobotObject
from kitrobot.text.sentences import COMMA, Label, Sentence, Series

INHERITED = ("side", "reach")
"""Settings of a robot's part that its driver gets where the kit does not give them: what they mean is the same for
the simulator and for a real part.
"""

_EITHER = frozenset({"pin-in", "pin-out", "music"})
"""Drivers of what people plug in at a micro:bit's edge: a kit may name one pin for all of them, a program uses one."""


@dataclass(frozen=True)
class PartOnKit:
    """One part of a robot on a kit.

    `is_used`: by the program; `is_missing`: the kit has nothing for it; `found`: what the kit says of it; `problem`:
    why it does not work there, or None.
    """

    part: RobotObject
    is_used: bool
    is_missing: bool
    found: KitPart | None
    problem: PackageError | None


def parts_used(image: Image, robot: Robot) -> list[RobotObject]:
    """The actuators and sensors of a robot that a program uses."""
    cells, commands = used(image)
    layout = Layout(robot)
    acting = {image.commands[at] for at in commands}
    found = [part for number, part in enumerate(robot.actuators) if number in acting]
    return found + [part for part in robot.sensors if layout.sensors[part.name] in cells]


def fit_to_kit(robot: Robot, kit: Kit, package: Package) -> Robot:
    """The robot with the drivers of a kit: each gets the settings that it understands."""

    def with_known_settings(part: RobotObject) -> RobotObject:
        declaration = package.declared(part.board.driver, kit.family)
        if kit.part_for(part) is None or declaration.settings is None:
            return part
        given = {
            name: value for name, value in part.settings.items() if name in INHERITED and name in declaration.settings
        }
        settings = {**given, **part.board.settings}
        understood = declaration.known(settings)
        known = {name: value for name, value in settings.items() if name in understood or name == "limit"}
        return replace(part, board=Board(part.board.driver, known))

    wired = on_kit(robot, kit)
    return replace(
        wired,
        actuators=tuple(map(with_known_settings, wired.actuators)),
        sensors=tuple(map(with_known_settings, wired.sensors)),
    )


def refuse_what_is_missing(robot: Robot, kit: Kit, image: Image) -> None:
    """Raises a PackageError that names every part which a program uses and a kit lacks."""
    missing = [part for part in parts_used(image, robot) if lacks(kit, part)]
    if not missing:
        return
    names = Series(COMMA, (f"`{part.name}`" for part in missing))
    why = next((found.help for part in missing if (found := kit.part_for(part)) and found.help), {})
    other = Sentence("take another kit; `kitrobot check MISSION --board NAME` says what it has")
    raise PackageError(
        Sentence("the kit `{kit}` lacks what the program uses: {parts}", kit.name, names),
        Label("", why) if why.get("") else other,
    )


def parts_on_kit(robot: Robot, kit: Kit, package: Package, image: Image | None) -> list[PartOnKit]:
    """Every part of a robot on a kit; `image`: of the program that is meant, None for no one."""
    names = {(part.category, part.name) for part in parts_used(image, robot)} if image is not None else set()
    found = []
    for part, wired in zip(_parts(robot), _parts(fit_to_kit(robot, kit, package)), strict=True):
        missing = lacks(kit, part)
        problem = None if missing else _problem(wired, kit, package)
        found.append(PartOnKit(wired, (part.category, part.name) in names, missing, kit.part_for(part), problem))
    return found


def _parts(robot: Robot) -> list[RobotObject]:
    return [*robot.actuators, *robot.sensors]


def _problem(part: RobotObject, kit: Kit, package: Package) -> PackageError | None:
    if part.device in OF_A_TEAM:
        return None  # what hosts the team answers for it
    driver = part.board.driver or part.device
    if package.missing([driver], kit.family):
        return missing_driver(driver, package, kit.family)
    procedures = [method.name for method in part.methods] if part.category is Category.ACTUATOR else None
    declaration = package.declared(driver, kit.family)
    try:
        refuse_what_is_not_understood(part.name, driver, declaration, procedures, part.board.settings)
    except PackageError as error:
        return error
    return None


def kit_problems(kit: Kit, package: Package) -> list[tuple[KitPart, PackageError]]:
    """What is wrong with a kit's file: drivers, settings, pins that the board does not have, pins and channels of chips
    that are used twice.
    """
    found: list[tuple[KitPart, PackageError]] = []
    wired: dict[tuple[str, ...], tuple[KitPart, Wire]] = {}
    waves: list[tuple[KitPart, Wave]] = []
    for part in kit.parts:
        if part.is_missing:
            continue
        try:
            declarations = _understood(part, kit, package)
            for wire in _wires(part, declarations):
                _refuse_wire(part, wire, kit, wired)
            _refuse_waves(part, declarations, kit, waves)
        except PackageError as problem:
            found.append((part, problem))
    return found


def _understood(part: KitPart, kit: Kit, package: Package) -> Mapping[str, DriverDeclaration]:
    """The declarations of a part's drivers, by their names.

    Raises:
        PackageError: one is not there, a setting is known to none, or one of them needs another.
    """
    declarations: dict[str, DriverDeclaration] = {}
    for device in part.devices:
        driver = part.board.driver or device
        if package.missing([driver], kit.family):
            raise missing_driver(driver, package, kit.family)
        declarations[driver] = package.declared(driver, kit.family)
        refuse_conditions(_name(part), declarations[driver], part.board.settings)
    known = {
        name
        for declaration in declarations.values()
        for name in (part.board.settings if declaration.settings is None else declaration.known(part.board.settings))
    }
    for name in part.board.settings:
        if name not in known and not (name == "limit" and part.category is Category.ACTUATOR):
            raise PackageError(
                Sentence("no driver of `{part}` knows the setting `{setting}`", _name(part), name),
                counts_only(declarations.values(), name)
                or Sentence("known are {settings}", Series(COMMA, (f"`{one}`" for one in sorted(known)))),
            )
    procedures = () if part.category is Category.ACTUATOR else None
    for driver, declaration in declarations.items():
        understood = declaration.known(part.board.settings)
        given = {name: value for name, value in part.board.settings.items() if name in understood}
        given |= {name: setting.words[0] for name, setting in understood.items() if name in INHERITED and setting.words}
        refuse_what_is_not_understood(_name(part), driver, declaration, procedures, given)
    return declarations


def _wires(part: KitPart, declarations: Mapping[str, DriverDeclaration]) -> list[Wire]:
    """Each pin and channel of a part once."""
    settings = part.board.settings
    found: dict[str, Wire] = {}
    for declaration in declarations.values():
        for wire in wires_of(declaration.known(settings), settings):
            found.setdefault(wire.name, wire)
    return list(found.values())


def _refuse_wire(part: KitPart, wire: Wire, kit: Kit, wired: dict[tuple[str, ...], tuple[KitPart, Wire]]) -> None:
    if kit.pins and wire.setting.is_pin and wire.target not in kit.pins:
        raise PackageError(
            Sentence("`{part}` is wired to the pin `{pin}`, which this board does not have", _name(part), wire.target),
            Sentence("its pins are those in `pins`; mend one of the two"),
        )
    refuse_pin(_name(part), wire, kit.chip)
    other = wired.get(wire.place)
    if other is not None:
        help = Sentence("give one of them another pin")
        if other[0] is part:
            refuse_wire(_name(part), wire, None, help)
        either = {one.board.driver or one.devices[0] for one in (other[0], part)} <= _EITHER
        if not either and not may_join(other[1], wire):
            refuse_wire(_name(part), wire, _name(other[0]), help)
    wired[wire.place] = part, wire


def _refuse_waves(
    part: KitPart, declarations: Mapping[str, DriverDeclaration], kit: Kit, waves: list[tuple[KitPart, Wave]]
) -> None:
    """Raises a PackageError when the chip cannot give the waves of a part beside those before."""
    if kit.chip not in SLICES:
        return
    for declaration in declarations.values():
        usual = {name: setting.usual for name, setting in declaration.known(part.board.settings).items()}
        for wave in waves_of(declaration.waves, part.board.settings, usual):
            for other, beside in waves:
                why = clash(wave, beside, kit.chip)
                if why:
                    words = (
                        Sentence("pins that are 16 apart have one wave on this chip; take another pin")
                        if why == "wave"
                        else Sentence("the two pins have one frequency on this chip; take another pin")
                    )
                    raise PackageError(
                        Sentence(
                            "`{part}` at pin `{pin}` and `{other}` at pin `{beside}` cannot both have a square wave",
                            _name(part),
                            str(wave.pin),
                            _name(other),
                            str(beside.pin),
                        ),
                        words,
                    )
            waves.append((part, wave))


def _name(part: KitPart) -> str:
    return " ".join(part.names or part.devices)
