"""Events of a step as text: the numbers that it wrote, with the names of mission and world."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.step.agents import Agent
from kitrobot.sim.step.failed_robots import BOX_BACK, BOX_LOST, PASSED
from kitrobot.sim.step.fault_injection import REVIVE
from kitrobot.sim.step.fault_schedule import describe_fault
from kitrobot.sim.tables import columns as c
from kitrobot.sim.tables.state import State, numbers
from kitrobot.text.sentences import Recorded
from kitrobot.world.model import World

Cause = Literal["program", "world", "person", "mission", "chance"]

_CAUSES: tuple[Cause, ...] = ("person", "mission", "chance", "world", "world")
"""Of the faults of a robot, in the order of their numbers in `fault_injection`."""


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happened: `kind` is load, unload, message, collision, failure, revival, member
    (who is in which role or group) or end.

    `index` is the agent's number; `cause` says what brought it about: a program, the world, a person's hand during the
    run, the mission's schedule, or chance.
    """

    tick: int
    kind: str
    agent: str
    text: str
    index: int
    cause: Cause = "program"


class EventText:
    """Turns a run's numbers into sentences."""

    def __init__(
        self,
        world: World,
        members: Sequence[Agent],
        variables: Sequence[RobotObject],
        state: State,
        groups: Sequence[str] = (),
        works: Sequence[str] = (),
    ) -> None:
        self._members = members
        self._groups = groups
        self._works = works
        self._variables = variables
        self._docks = [dock.name for dock in world.docks]
        self._houses = [house.name for house in world.storehouses]
        self._actuators = {
            state.actuators.actuator_index[state.robots.ints[c.ACTUATOR_INDEX][agent.index] + number]: part.name
            for agent in members
            for number, part in enumerate(agent.robot.actuators)
            if state.actuators.actuator_index
        }

    def events(self, state: State) -> list[Event]:
        """What happened in the steps of the last call, in order."""
        count = int(state.clock[c.EVENTS])
        if count == 0:
            return []
        rows = numbers(state.events[: c.EVENT * count])
        made = []
        for at in range(0, len(rows), c.EVENT):
            kind, agent, what, much, tick = rows[at : at + c.EVENT]
            if kind == c.DRAWN:
                continue
            word, text = self._say(kind, what, much)
            cause: Cause = _CAUSES[much] if kind == c.FAULT else "world" if kind == c.COLLISION else "program"
            made.append(Event(tick, word, self._members[agent].name, text, agent, cause))
        return made

    def _say(self, kind: int, what: int, much: int) -> tuple[str, str]:
        """The event's kind and text."""
        if kind == c.END:
            return "end", Recorded("its program has ended")
        if kind == c.COLLISION:
            return "collision", Recorded(
                "touches {what}", self._members[what].name if what >= 0 else Recorded("a wall")
            )
        if kind == c.LOADED:
            return "load", Recorded("a box from {storehouse}", self._houses[what])
        if kind == c.UNLOADED:
            return "unload", Recorded("a box into {storehouse}", self._houses[what])
        if kind == c.NO_EMPTY_CARRIER:
            return "message", Recorded("no empty carrier stands in dock {dock}", self._docks[what])
        if kind == c.NO_LOADED_CARRIER:
            return "message", Recorded("no loaded carrier stands in dock {dock}", self._docks[what])
        if kind == c.NO_BOX:
            return "message", Recorded("storehouse {storehouse} has no box", self._houses[what])
        if kind == c.NO_ROOM:
            return "message", Recorded("storehouse {storehouse} is full", self._houses[what])
        if kind == c.LEAVING:
            return "message", Recorded("leaves the world: only walls hold robots at its edge")
        if kind == c.LOST:
            return "message", Recorded("a command did not reach {actuator}", self._actuators[what])
        if kind == c.FAULT:
            return "revival" if what == REVIVE else "failure", describe_fault(what, much)
        if kind == c.MOVED_OVER:
            return "member", Recorded("goes over to {group}", self._groups[what])
        if kind == c.MISSED:
            return "member", Recorded("is missed by its team")
        if kind == c.TAKEN_OVER:
            if much:
                return "member", Recorded("plays its role again")
            return "member", Recorded("takes over for {agent}", self._members[what].name)
        if kind == c.BACK:
            return "member", Recorded("begins anew, as a spare one")
        if kind == c.UNIT_LOST:
            return "message", Recorded(
                "was too late: its unit of {work} is free again, or another's", self._works[what]
            )
        if kind == c.UNHEARD:
            return "message", Recorded("did not hear {agent}: the message got lost", self._members[what].name)
        if kind == c.TOWED:
            return "message", self._say_towed(what, much)
        assert kind == c.WRITTEN, f"nobody says {kind}"
        variable = self._variables[what]
        boolean = variable.minimum == 0 and variable.type.value == "boolean"
        return "message", f"{variable.name} = {('false', 'true')[much] if boolean else much}"

    def _say_towed(self, house: int, much: int) -> str:
        if much == BOX_BACK:
            return Recorded("is towed away; its box is back in {storehouse}", self._houses[house])
        if much == BOX_LOST and house >= 0:
            return Recorded("is towed away; its box is lost: {storehouse} is full", self._houses[house])
        if much == BOX_LOST:
            return Recorded("is towed away; its box is lost: it came from no storehouse")
        return Recorded("is off its road: others drive round it") if much == PASSED else Recorded("is towed away")


def sensor_names(state: State, members: Sequence[Agent]) -> dict[tuple[int, str], int]:
    """(agent's number, sensor's name) → its number in the tables."""
    sensor = state.sensors.ints
    cells = {(robot, cell): k for k, (robot, cell) in enumerate(zip(sensor[c.S_ROBOT], sensor[c.S_CELL], strict=True))}
    return {
        (agent.index, name): cells[agent.index, cell]
        for agent in members
        for name, cell in agent.machine.layout.sensors.items()
    }
