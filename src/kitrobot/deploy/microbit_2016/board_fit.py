"""What a micro:bit of 2016 does not have: kits and parts that are for a V2 alone."""

from __future__ import annotations

from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.firmware.requirements import FirmwareRequirements
from kitrobot.deploy.line.receiver import MICROBIT
from kitrobot.deploy.package.package import Package
from kitrobot.deploy.package.program_file import UNUSED, Device, ProgramFile
from kitrobot.text.sentences import COMMA, Sentence, Series


def refuse_on_2016(program: ProgramFile, package: Package, needs: FirmwareRequirements | None) -> None:
    """Refuses what is for a V2 alone, when the board is one of 2016.

    Args:
        program: the file in which drivers have the names that robots' XML gives them.
        package: where drivers are looked for.
        needs: the firmware that the robot's kit requires.

    Raises:
        FirmwareError: the kit is for a V2.
        BoardError: parts are; `said` is the first of them, as a board names it.
    """
    if needs is not None:
        needs.refuse_board_of_2016()
    lacking = [
        (number, device)
        for number, device in enumerate(program.devices)
        if device.driver != UNUSED and package.declared(device.driver, MICROBIT).chip
    ]
    if not lacking:
        return
    names = Series(COMMA, (f"`{device.part or device.driver}`" for _, device in lacking))
    refusal = BoardError(
        Sentence("only a micro:bit V2 has what the program uses: {parts}", names),
        Sentence("take a micro:bit V2, or leave these parts out of the program"),
    )
    refusal.said = _address(*lacking[0])
    raise refusal


def _address(number: int, device: Device) -> str:
    """How a board names a device in a fault: an actuator by its place, a sensor by its cell."""
    return f"a{number}" if device.kind == "a" else f"s{device.words[0]}"
