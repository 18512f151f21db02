"""Access to real robots as an interface: ports, links, sending a program.

It is implemented by `kitrobot.deploy`, which is imported when the first page opens the robots' panel; a test may
replace it by a twin that fails at will.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.robot_subscriber import AT_PAGE
from kitrobot.wire.board import BoardWay

if TYPE_CHECKING:
    from kitrobot.deploy.firmware.ports import Port
    from kitrobot.robots.board_link import Link
    from kitrobot.robots.program import BoardProgram

Progress = Callable[[str, int, int], None]
"""What is done now (`connect`, `compare`, `send`, `start`), and how many bytes of how many; what it raises breaks the
sending off."""


class RobotGateway(Protocol):
    """The way to robots."""

    def list_ports(self) -> list[Port]:
        """The ports of this machine where robots may be."""

    def connect(self, address: str) -> Link:
        """Greets the robot there. Raises KitRobotError."""

    def deploy(self, address: str, program: BoardProgram, progress: Progress, replace: bool, fresh: bool) -> None:
        """Puts a program on the robot there. Raises KitRobotError, and what `progress` raises."""

    def way(self, error: KitRobotError) -> BoardWay:
        """The way in which a sending that failed so can be repeated."""

    def is_lost(self, error: KitRobotError) -> bool:
        """Whether an error means that the link is lost, not only that the robot refused."""


class SerialGateway:
    """The way to robots that are plugged in or on the network."""

    def list_ports(self) -> list[Port]:
        """As `deploy.list_ports`."""
        from kitrobot.deploy.firmware.ports import list_ports

        return list_ports()

    def connect(self, address: str) -> Link:
        """As `deploy.connect`."""
        from kitrobot.deploy.line.handshake import connect

        return connect(address)

    def deploy(self, address: str, program: BoardProgram, progress: Progress, replace: bool, fresh: bool) -> None:
        """As `deploy.deploy`."""
        from kitrobot.boards.sent_firmware import store_firmware_version
        from kitrobot.boards.sent_programs import store_sent_program
        from kitrobot.deploy.installation.deployment import deploy
        from kitrobot.deploy.installation.installation import RobotContext

        robot = RobotContext(program.needs, program.names.fault_text)
        file = program.file.to_bytes()
        done = deploy(address, file, program.package, progress, replace=replace, fresh=fresh, robot=robot)
        if not address.startswith(AT_PAGE):  # these are others each time
            store_firmware_version(address, done)
        # Then `kitrobot watch` and `kitrobot log` know it too.
        store_sent_program(program, [done.program])

    def way(self, error: KitRobotError) -> BoardWay:
        """Whether it was refused for somebody else's program, or for want of room."""
        from kitrobot.deploy.errors import ForeignError, FullError

        return "replace" if isinstance(error, ForeignError) else "fresh" if isinstance(error, FullError) else ""

    def is_lost(self, error: KitRobotError) -> bool:
        """Whether the line is broken or silent."""
        from kitrobot.deploy.errors import LineError, SilentError

        return isinstance(error, LineError | SilentError)
