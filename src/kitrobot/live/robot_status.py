"""The status of one robot as pages see it: a value that is replaced as a whole, and errors in the words of a panel.

Not here: the robot itself (robot_worker), and which pages receive the status (robot_registry).
"""

from __future__ import annotations

from dataclasses import dataclass, field

from kitrobot.deploy.errors import ForeignError, FullError, LineError, SilentError
from kitrobot.deploy.line.news import Fault
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.robots.names import BoardNames
from kitrobot.robots.state import RobotState
from kitrobot.text.sentences import Sentence
from kitrobot.wire.bench import BoardBenchShape
from kitrobot.wire.board import BoardFaultShape, BoardMessage, BoardPhase, BoardProgressShape, BoardWay

LONGEST_TEXT = 500


@dataclass(frozen=True)
class RobotStatus:
    """The status of a robot; `version` grows with each change."""

    version: int = 0
    phase: BoardPhase = "closed"
    robot: RobotState = field(default_factory=RobotState)
    names: BoardNames | None = None
    progress: BoardProgressShape | None = None
    message: str = ""
    help: str = ""
    way: BoardWay = ""
    micropython: str = ""
    recorded: bool = False
    bench: BoardBenchShape | None = None

    def to_message(self, address: str, name: str, holder: str) -> BoardMessage:
        """The status as a message to pages."""
        state, names = self.robot, self.names
        return BoardMessage(
            address=address,
            name=name,
            holder=holder,
            phase=self.phase,
            state=state.doing,
            held=state.held and self.phase != "closed",
            free=state.free,
            generation=state.generation,
            package=state.package,
            installed=state.installed,
            program=names.program if names is not None else "",
            progress=self.progress,
            fault=fault_shape(state.fault, names) if state.fault is not None else None,
            message=self.message,
            help=self.help,
            way=self.way,
            micropython=self.micropython,
            recorded=self.recorded,
            bench=self.bench,
        )


def fault_shape(fault: Fault, names: BoardNames | None) -> BoardFaultShape:
    """A fault, with the vertex and the line that it happened at."""
    at = fault.instruction
    return BoardFaultShape(
        number=fault.number,
        sentence=fault.meaning,
        text=(names.fault_text(fault.text) if names is not None else fault.text)[:LONGEST_TEXT],
        program=names.program if names is not None else "",
        vertex=(names.vertex(at) or "") if names is not None else "",
        line=names.line(at) if names is not None else 0,
        tick=fault.tick,
    )


def recovery_hint(error: KitRobotError) -> str:
    """The help of an error, for a reader who has a panel with buttons and not a terminal."""
    if "`kitrobot " not in error.help and " --" not in error.help:
        return error.help
    if isinstance(error, ForeignError):
        return Sentence("save it first if you need it, then press Replace it")
    if isinstance(error, FullError):
        return Sentence(
            "press Make room: what KitRobot put there goes first, and until the new program is whole there is none"
        )
    if isinstance(error, SilentError):
        return Sentence("press its reset button; when it holds no KitRobot yet, press Send")
    return (
        Sentence("look at its cable, then try again")
        if isinstance(error, LineError)
        else Sentence("send the program again")
    )


def no_answer_error(name: str) -> KitRobotError:
    """The error of a robot that sent nothing at all."""
    return KitRobotError(Sentence("`{robot}` does not answer", name), Sentence("look at its cable, then try again"))
