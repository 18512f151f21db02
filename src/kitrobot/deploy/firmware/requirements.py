"""Which MicroPython a board has to have, and where its maker has it."""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.deploy.errors import FirmwareError
from kitrobot.deploy.firmware.chip_pins import PLATFORMS
from kitrobot.primitives.kit import CHIP_OF_V2
from kitrobot.text.sentences import Sentence

EVERYWHERE = "https://micropython.org/download/"
"""Where MicroPython for most boards is to be had."""

DOWNLOADS = {
    0x0D28: "https://python.microbit.org/",
    0x2E8A: "https://micropython.org/download/?vendor=Raspberry%20Pi",
    0x303A: "https://micropython.org/download/?vendor=Espressif",
    0x239A: "https://micropython.org/download/?vendor=Adafruit",
    0x2341: "https://micropython.org/download/?vendor=Arduino",
}
"""USB vendor → the page from which its boards' MicroPython is fetched. Nothing here fetches it."""


_MICROBIT = "microbit"
_BOARDS = {
    _MICROBIT: Sentence("a micro:bit"),
    "rp2": Sentence("a board such as the Raspberry Pi Pico"),
    "esp32": Sentence("an ESP32"),
}
"""What MicroPython calls its platform → what people call it."""


@dataclass(frozen=True)
class FirmwareRequirements:
    """What a kit needs: its name, the least version (as `1.20` or `1.25.0-preview`, "" for any), where it
    is to be had, and which kind of board and of chip it is for ("" where the kit does not say).
    """

    kit: str
    least: str
    href: str = ""
    family: str = ""
    chip: str = ""

    def refuse_other_board(self, platform: str) -> None:
        """Raises a FirmwareError when a board is of another kind, by what its MicroPython calls its platform.

        What this does not know is not refused: new ports come, and a kit may fit them.
        """
        meant = _MICROBIT if self.family == _MICROBIT else PLATFORMS.get(self.chip, "")
        if platform not in _BOARDS or platform == meant or not (meant or platform == _MICROBIT):
            return
        raise FirmwareError(
            Sentence(
                "the kit `{kit}` is for {meant}, and this board is {found}",
                self.kit,
                _BOARDS[meant] if meant else Sentence("another kind of board"),
                _BOARDS[platform],
            ),
            Sentence("name the kit of this board with --board, or choose another board with --to; nothing was sent"),
        )

    def refuse_board_of_2016(self) -> None:
        """Raises a FirmwareError when the kit is for a micro:bit V2 alone: the board is one of 2016."""
        if self.chip == CHIP_OF_V2:
            raise FirmwareError(
                Sentence("the kit `{kit}` is for a micro:bit V2, and this board is one of 2016", self.kit),
                Sentence("name a kit for the micro:bit of 2016 with --board, or take a micro:bit V2"),
            )

    def refuse_older(self, version: str) -> None:
        """Raises a FirmwareError when a board's version is older than that."""
        if not self.least or not version or _order(version) >= _order(self.least):
            return
        raise FirmwareError(
            Sentence(
                "the board has MicroPython {version}, and the kit `{kit}` needs {least} or later",
                version,
                self.kit,
                self.least,
            ),
            Sentence(
                "fetch a newer one from {href}; a board that shows a drive takes it with `kitrobot flash FILE`",
                self.href or EVERYWHERE,
            ),
        )


def _order(version: str) -> tuple[int, ...]:
    """What is larger for a later version: all its numbers, then whether it is a release and no preview of that."""
    numbers, _, level = version.partition("-")
    found = [int(number) for number in numbers.split(".")]
    return (*found, *(0 for _ in range(3 - len(found))), 0 if level else 1)
