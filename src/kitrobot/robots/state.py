"""The state of one real robot as last reported, and its changes: the only place where its news are folded.

A `RobotState` is replaced as a whole; a `Change` is one step from the state before, with what a record of a trace holds
of it: commands and events. Values are by cell and instruction; the viewer adds names (names, records).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import Literal, get_args

from kitrobot.deploy.line.board import Hello
from kitrobot.deploy.line.news import Fault, News

Activity = Literal["none", "ready", "running", "ended", "fault"]
ACTIVITIES: tuple[Activity, ...] = get_args(Activity)
"""What a robot does, by the number that it sends."""


@dataclass(frozen=True)
class RobotState:
    """One robot.

    Attributes:
        doing: what its loop does.
        held: whether the run ends when the robot hears nothing from here.
        free: bytes of memory that are left.
        tick: the robot's own count since its run began.
        late: ticks since then that began late.
        generation: which installation on the board it is.
        package: the version of KitRobot on it, "-" for none.
        installed: its program, by the name that the robot gives, "-" for none.
        threads: slot → instruction of each live thread.
        cells: cell → value, as far as they were reported.
        forced: sensors that are held at a value from here.
        fault: why it stopped by itself last, until it runs again.
        lost: the message of a link that is lost, "" while there is one.
    """

    doing: Activity = "none"
    held: bool = False
    free: int = 0
    tick: int = 0
    late: int = 0
    generation: int = 0
    package: str = ""
    installed: str = ""
    threads: Mapping[int, int] = field(default_factory=dict)
    cells: Mapping[int, int] = field(default_factory=dict)
    forced: Mapping[str, int] = field(default_factory=dict)
    fault: Fault | None = None
    lost: str = ""

    @classmethod
    def from_hello(cls, hello: Hello) -> RobotState:
        """A robot of which nothing but its greeting is known."""
        return cls().after_look(hello)

    def after_look(self, hello: Hello) -> RobotState:
        """The same robot after a look at its state."""
        doing = ACTIVITIES[hello.state]
        return replace(
            self,
            doing=doing,
            held=self.held and doing == "running",
            free=hello.free,
            tick=hello.tick,
            late=hello.late,
            generation=hello.generation,
            package=hello.package,
            installed=hello.program,
            threads=self.threads if doing == "running" else {},
            fault=None if doing == "running" else self.fault,
        )

    def after_news(self, news: News) -> RobotState:
        """The same robot after news of its program."""
        threads = {slot: at for slot, at in {**self.threads, **news.threads}.items() if at is not None}
        return replace(
            self,
            tick=news.tick,
            cells={**self.cells, **news.cells},
            threads=threads if self.doing == "running" else {},
        )

    def after_fault(self, fault: Fault) -> RobotState:
        """The same robot after it stopped by itself."""
        return replace(self, doing="fault", held=False, threads={}, tick=fault.tick, fault=fault)

    def after_start(self, held: bool, first: Mapping[int, int]) -> RobotState:
        """The same robot after its program was begun; `first`: cells that have their first values again."""
        cells = {**self.cells, **first}
        return replace(self, doing="running", held=held, tick=0, late=0, cells=cells, threads={}, fault=None)

    def after_stop(self) -> RobotState:
        """The same robot after it was stopped."""
        return replace(self, doing="ready", held=False, threads={}, lost="")

    def after_reboot(self) -> RobotState:
        """The same robot after it began anew by itself: no earlier report holds."""
        return replace(self, tick=0, threads={}, cells={}, forced={})


class ChangeKind(Enum):
    """The cause of a change."""

    GREETED = "greeted"
    LOOKED = "looked"
    NEWS = "news"
    TEXT = "text"
    FAULT = "fault"
    QUIET = "quiet"
    STARTED = "started"
    STOPPED = "stopped"
    REBOOTED = "rebooted"
    FORCED = "forced"
    SET = "set"
    LOST = "lost"


@dataclass(frozen=True)
class RobotEvent:
    """An event of one robot, as `TraceEvent` has it: kind, text, cause."""

    kind: str
    text: str
    cause: str


@dataclass(frozen=True)
class Change:
    """A change: its cause, the state after it, and what else a record of a trace holds of it.

    `commands`: actuator, procedure and arguments of each command that is known to have been given.
    """

    kind: ChangeKind
    state: RobotState
    events: tuple[RobotEvent, ...] = ()
    commands: tuple[tuple[str, str, tuple[int, ...]], ...] = ()
