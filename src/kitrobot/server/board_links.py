"""What the studio needs of real robots, as a seam: ports, links, putting a program on one.

Behind it stands `kitrobot.deploy`, which is read when the first page asks for robots; a test may put a twin here, where
the real thing could not be made to fail at will.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol

from kitrobot.diagnostics import KitRobotError
from kitrobot.server.shapes import BoardWay

if TYPE_CHECKING:
    from kitrobot.deploy import Fault, Hello, News, Port, Text
    from kitrobot.workspace import BoardProgram

Progress = Callable[[str, int, int], None]
"""What is done now (`connect`, `compare`, `send`, `start`), and how many bytes of how many; what it raises breaks the
sending off."""


class Board(Protocol):
    """A link to a robot, as `deploy.Board`. Every method may raise KitRobotError."""

    def greet(self) -> Hello:
        """How it stands now."""

    def look(self) -> Hello:
        """The same, but a robot that runs and told so lately is not asked."""

    def start(self, held: bool = False) -> None:
        """Begins its program. Held: it stops when it does not hear from us; `news` sees to that."""

    def stop(self) -> None:
        """Stops it."""

    def force(self, cell: int, value: int | None) -> None:
        """Holds an input at a value, or lets it go."""

    def set(self, cell: int, value: int) -> None:
        """Sets a variable."""

    def watch(self, period_ms: int) -> None:
        """Has it tell what changes."""

    def identify(self) -> None:
        """Lets it show itself."""

    def last_fault(self) -> Fault | None:
        """Why it stopped by itself last."""

    def news(self, timeout: float) -> News | Fault | Text | None:
        """What it says unasked; None when that is nothing."""

    def close(self) -> None:
        """Ends the link; the robot goes on as it would."""


class Links(Protocol):
    """The way to robots."""

    def list_ports(self) -> list[Port]:
        """The ports of this machine where robots may be."""

    def connect(self, address: str) -> Board:
        """Greets the robot there. Raises KitRobotError."""

    def deploy(self, address: str, program: BoardProgram, progress: Progress, replace: bool, fresh: bool) -> None:
        """Puts a program on the robot there. Raises KitRobotError, and what `progress` raises."""

    def way(self, error: KitRobotError) -> BoardWay:
        """With what a sending that failed so can be asked for again."""

    def is_lost(self, error: KitRobotError) -> bool:
        """Whether an error means that the link is gone, not only that the robot said no."""


class RealLinks:
    """The way to robots that are plugged in or on the network."""

    def list_ports(self) -> list[Port]:
        """As `deploy.list_ports`."""
        from kitrobot.deploy import list_ports

        return list_ports()

    def connect(self, address: str) -> Board:
        """As `deploy.connect`."""
        from kitrobot.deploy import connect

        return connect(address)

    def deploy(self, address: str, program: BoardProgram, progress: Progress, replace: bool, fresh: bool) -> None:
        """As `deploy.deploy`."""
        from kitrobot.deploy import deploy
        from kitrobot.workspace.boards import keep_program

        done = deploy(address, program.file.to_bytes(), program.package, progress, replace=replace, fresh=fresh)
        # Then `kitrobot watch` and `kitrobot log` know it too.
        keep_program(program, [done.program])

    def way(self, error: KitRobotError) -> BoardWay:
        """Whether it was refused for somebody else's program, or for want of room."""
        from kitrobot.deploy import ForeignError, FullError

        return "replace" if isinstance(error, ForeignError) else "fresh" if isinstance(error, FullError) else ""

    def is_lost(self, error: KitRobotError) -> bool:
        """Whether the line is broken or silent."""
        from kitrobot.deploy import LineError, SilentError

        return isinstance(error, LineError | SilentError)
