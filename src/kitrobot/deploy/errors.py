"""The errors between a host and a board; each message is one sentence with a way out."""

from __future__ import annotations

from kitrobot.diagnostics.model import KitRobotError


class DeployError(KitRobotError):
    """Something that was asked of a board could not be done."""


class LineError(DeployError):
    """The line to the board cannot be opened, or broke."""


class BrokenOffError(KitRobotError):
    """Whoever waited for a board waits no more. No DeployError: nothing is tried again, and nothing undone."""


class SilentError(DeployError):
    """Nobody answers on the line, or nobody that we understand; `printed` is what was heard instead."""

    printed: str = ""


class ResetError(SilentError):
    """The board began anew while it was talked with: what listened there is gone."""


class BoardError(DeployError):
    """The board answers and says no, or does not hold what it should; `said` is the text of the fault behind it, which
    begins with the device (docs/reference/link.md), "" for none.
    """

    said: str = ""


class CrampedError(BoardError):
    """The receiver found no piece of free memory that was long enough; begun anew, it has an empty one."""


class NoMemoryError(BoardError):
    """The board has too little memory for what it was asked."""


class ForeignError(BoardError):
    """The board holds somebody else's program, which is not overwritten unasked."""


class FirmwareError(BoardError):
    """The board has a MicroPython that is too old, or for another kind of board."""


class FullError(BoardError):
    """There is no room on the board for the new beside the old."""


class PackageError(DeployError):
    """A file that belongs on the board is missing or no Python that a board can read."""
