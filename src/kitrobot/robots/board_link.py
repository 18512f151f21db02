"""The link to one robot as a session uses it; `deploy.Board` is one, tests have others."""

from __future__ import annotations

from typing import Protocol

from kitrobot.deploy.line.board import Hello
from kitrobot.deploy.line.news import Fault, News, Text


class Link(Protocol):
    """A robot that answered. Every method may raise KitRobotError."""

    def greet(self) -> Hello:
        """Its state now."""

    def look(self) -> Hello:
        """The same; a robot that runs and reported its state lately is not queried."""

    def start(self, held: bool = False) -> None:
        """Begins its program. Held: it stops when it does not hear from us; `news` sees to that."""

    def stop(self) -> None:
        """Stops it."""

    def force(self, cell: int, value: int | None) -> None:
        """Holds an input at a value; None releases it."""

    def set(self, cell: int, value: int) -> None:
        """Sets a variable."""

    def watch(self, period_ms: int) -> None:
        """Has it send what changes, at most so often; 0 ends it."""

    def identify(self) -> None:
        """Makes it visible for two seconds."""

    def last_fault(self) -> Fault | None:
        """Why it stopped by itself last."""

    def news(self, timeout: float) -> News | Fault | Text | None:
        """What it sent unrequested; None when that is nothing."""

    def hurry(self) -> None:
        """From now on nothing is waited for long."""

    def close(self) -> None:
        """Ends the link; the robot goes on, unless it is held."""
