"""A robot's fault as an event of a trace."""

from __future__ import annotations

from kitrobot.deploy.line.news import Fault
from kitrobot.robots.names import BoardNames
from kitrobot.robots.state import RobotEvent
from kitrobot.text.sentences import Recorded
from kitrobot.trace.model import LINK, PROGRAM, ROBOT

_CAUSES = {3: PROGRAM, 4: PROGRAM, 6: LINK}
"""What brings a fault about: a program that is too large or damaged, a link that was lost; else the robot itself."""


def describe_fault(fault: Fault, names: BoardNames | None) -> str:
    """The text of a fault's event: its number, meaning, the robot's own text, vertex and line."""
    detail = (names.fault_text(fault.text) if names is not None else fault.text).strip()
    vertex = names.vertex(fault.instruction) if names is not None else None
    line = names.line(fault.instruction) if names is not None else 0
    if not line:
        return (
            Recorded("fault {number}: {meaning} ({text})", fault.number, fault.meaning, detail)
            if detail
            else Recorded("fault {number}: {meaning}", fault.number, fault.meaning)
        )
    place = (
        Recorded("at the vertex {vertex}, line {line} of the code", vertex, line)
        if vertex
        else Recorded("at line {line} of the code", line)
    )
    if detail:
        return Recorded("fault {number}: {meaning} ({text}); {place}", fault.number, fault.meaning, detail, place)
    return Recorded("fault {number}: {meaning}; {place}", fault.number, fault.meaning, place)


def fault_event(fault: Fault, names: BoardNames | None) -> RobotEvent:
    """A fault as an event."""
    return RobotEvent("failure", describe_fault(fault, names), _CAUSES.get(fault.number, ROBOT))
