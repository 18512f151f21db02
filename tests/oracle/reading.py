"""What the oracle reads off the text of a program without running it: slots, marks, stops, the length of a wait."""

from __future__ import annotations

from collections.abc import Iterator

from kitrobot.lll.tree import Call, Conditional, Event, Instr, Interrupt, Parallel, Repeat, Seq, While
from kitrobot.primitives.robot import Robot

Stop = tuple[str, str]
"""An actuator and its procedure that ends the effect of a marked action."""


def clamp(value: int, minimum: int, maximum: int) -> int:
    """The nearest number in the range."""
    return min(max(value, minimum), maximum)


def ticks_of_wait(duration: int, robot: Robot) -> int:
    """Whole ticks, rounded up; at least one."""
    return max(1, -(-duration * robot.wait_unit_ms // robot.tick_ms))


def inner_bodies(item: Instr) -> list[Seq]:
    """The bodies inside an instruction that belong to the same thread."""
    match item:
        case Repeat() | While() | Event():
            return [item.body]
        case Conditional():
            return [item.then] if item.orelse is None else [item.then, item.orelse]
    return []


def bodies(thread_body: Seq) -> Iterator[Seq]:
    """The bodies that own a slot, in reading order: this one, then each branch followed by what is nested in it."""
    yield thread_body
    yield from nested_branches(thread_body)


def nested_branches(seq: Seq) -> Iterator[Seq]:
    """The branches of all parallels inside a body, each followed by what is nested in it."""
    for item in seq.items:
        if isinstance(item, Parallel):
            for branch in item.branches:
                yield from bodies(branch)
        for body in inner_bodies(item):
            yield from nested_branches(body)


def is_marked(seq: Seq) -> bool:
    """Whether a marked action stands in this branch, not counting those in the branches of inner parallels."""
    return any(isinstance(item, Interrupt) or any(map(is_marked, inner_bodies(item))) for item in seq.items)


def stops_in_text(seq: Seq, robot: Robot) -> Iterator[Stop]:
    """The stops of the marked actions of a branch in reading order."""
    for item in seq.items:
        if isinstance(item, Interrupt):
            assert isinstance(item.call, Call)
            part, method = robot.calls[item.call.object, item.call.method]
            if method.stop is not None:
                yield part.name, method.stop
        for body in inner_bodies(item):
            yield from stops_in_text(body, robot)
