"""Checks that the drivers of a program's devices accept the settings of the robot's XML, before anything is sent."""

from __future__ import annotations

from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.package.declarations import Wire, may_join, refuse_what_is_not_understood, refuse_wire, wires_of
from kitrobot.deploy.package.package import FAMILIES, Package
from kitrobot.deploy.package.program_file import UNUSED, Device, ProgramFile
from kitrobot.text.sentences import Sentence

_PLAIN = {"pin-in", "pin-out"}
"""Drivers of pins to which one may do both, by turns."""


def refuse_misfits(file: ProgramFile, package: Package, family: str) -> None:
    """Holds the devices against the drivers for a kind of board.

    Raises:
        PackageError: a driver does not understand its settings or its procedures, or two parts share a pin or a
            channel of a chip.
    """
    wired: dict[tuple[str, ...], tuple[Device, Wire]] = {}
    for device in file.devices:
        if device.driver == UNUSED or device.kind == "t":
            continue
        part = device.part or device.driver
        declaration = package.declared(device.driver, family)
        first = 2 if device.kind == "a" else 3
        settings = dict(word.split("=", 1) for word in device.words[first:])
        procedures = None
        if device.kind == "a":
            procedures = [call.split("/")[0] for call in device.words[1].split(",") if call != "-"]
        refuse_what_is_not_understood(part, device.driver, declaration, procedures, settings)
        for wire in wires_of(declaration.known(settings), settings):
            other = wired.get(wire.place)
            if other is not None and other[0] is device:
                refuse_wire(part, wire, None, Sentence("give one of them another pin in the robot’s XML"))
            if other is not None and {other[0].driver, device.driver} != _PLAIN and not may_join(other[1], wire):
                refuse_wire(
                    part,
                    wire,
                    other[0].part,
                    Sentence("give one of them another pin in the robot’s XML, or use only one of them in a program"),
                )
            wired[wire.place] = device, wire


def refuse_what_fits_no_board(file: ProgramFile, package: Package) -> None:
    """The same when it is not known yet which kind of board it will be: it must fit one of those it has drivers for.

    Raises:
        PackageError: what the first of these kinds does not understand.
    """
    problems = []
    for family in FAMILIES:
        if package.missing(file.drivers, family):
            continue
        try:
            refuse_misfits(file, package, family)
        except PackageError as problem:
            problems.append(problem)
        else:
            return
    if problems:
        raise problems[0]
