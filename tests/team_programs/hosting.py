"""A team that runs: every robot its projected program on a real `Machine`, and a host that sees them all.

The host is the plain meaning of `compiler.team.points`: it knows at once who failed, and nothing is ever on its way.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass, field

from kitrobot.compiler.compilation import compile_lll
from kitrobot.compiler.team.points import ALL, ONE, Point, PointKind
from kitrobot.compiler.team.projection import Projection, project
from kitrobot.diagnostics.model import Source
from kitrobot.image.machine import Machine
from kitrobot.image.model import Image
from kitrobot.lll.printer import print_team_program
from kitrobot.lll.tree import Seq, TeamProgram
from kitrobot.primitives.crew import Crew, declaring
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.primitives.team_objects import with_team

XML = """<robot name="{name}" version="1" tick="20" wait-unit="20">
  <actuator name="Arm" device="drive"><procedure name="Do" completes="later"><parameter name="n" min="0" max="60000"/>
  </procedure></actuator>
  <variable name="Count" min="0" max="1000"/>
</robot>"""


def robot(name: str) -> Robot:
    """A robot that does numbered things, each of which takes a while, and counts."""
    made, problems = read_robot(XML.format(name=name).encode(), f"{name}.robot.xml")
    assert made is not None, problems
    return made


class TooLarge(Exception):
    """A random program that no image holds."""


@dataclass(frozen=True)
class Done:
    """A line that a robot did: its number, and the ticks in which it began and was over."""

    number: int
    began: int
    ended: int


@dataclass
class Anchor:
    """Where a substitute begins: a point and what was answered there, what was agreed since, and how things stood."""

    point: int = -1
    answer: int = 0
    since: list[tuple[int, int]] = field(default_factory=list)
    count: int = 0
    lines: int = 0


@dataclass
class Hosted:
    """A robot of the team."""

    name: str
    kind: str
    role: str
    machine: Machine
    log: list[Done] = field(default_factory=list)
    at: tuple[int, int] | None = None
    """The point at which it waits, and its answer there."""
    anchor: Anchor = field(default_factory=lambda: Anchor())
    answer: int = 0
    """The team's last answer to it."""
    released: bool = True
    busy_until: int = 0
    doing: int = 0
    began: int = 0
    takes: str = ""
    """The work of which it waits for a unit."""
    led_to: int = -1
    told: list[tuple[int, int]] = field(default_factory=list)
    """What it is told again."""
    alive: bool = True
    stands_for: str = ""
    """The robot whose role it took over."""


class Team:
    """All robots of a team, tick by tick.

    Args:
        team: the team's program.
        members: agent → kind of robot, role ("" for a spare one).
        programs: other programs of the mission.
        seed: how long each line takes.
    """

    def __init__(
        self,
        team: TeamProgram,
        members: Mapping[str, tuple[str, str]],
        programs: Mapping[str, Seq] | None = None,
        seed: int = 0,
    ) -> None:
        source = Source("team.lll", print_team_program(team))
        kinds = tuple((name, kind) for name, (kind, _) in members.items())
        crew = declaring(Crew(agents=kinds), team)
        self.left = {work.name: work.units for work in team.works}
        self.projection: Projection = project(
            team.seq, crew, programs or {}, source, "team", lambda call: call.object in self.left
        )
        assert self.projection.diagnostics == [], self.projection.diagnostics
        self.points = self.projection.plan.points
        self.chance = random.Random(seed)
        self.tick = 0
        self.counts: dict[int, int] = {}
        self.held: set[tuple[str, str]] = set()
        """Robot and work of each unit that somebody has."""
        self.images: dict[str, tuple[Image, Robot]] = {}
        for kind, program in self.projection.programs.items():
            target = with_team(robot(kind), team.works)
            compiled = compile_lll(program, target, name=kind)
            if compiled.image is None:
                assert [item.code for item in compiled.diagnostics if item.is_error] == ["too-large"]
                raise TooLarge
            self.images[kind] = compiled.image, target
        self.robots = {name: Hosted(name, kind, role, self.machine(kind)) for name, (kind, role) in members.items()}
        self.order = {name: number for number, name in enumerate(members)}
        groups = self.projection.plan.groups
        self.inner = {name: [one for one in names if one in groups] for name, names in groups.items()}
        self.groups = {
            name: {one.name for one in self.robots.values() if {one.name, one.role} & (names - (set(groups) - {name}))}
            for name, names in groups.items()
        }

    def machine(self, kind: str) -> Machine:
        image, target = self.images[kind]
        return Machine(image, target)

    def is_member(self, one: Hosted, names: frozenset[str]) -> bool:
        """Whether a robot is in a set as it is now."""
        if not one.role:
            return False
        if names == ALL:
            return True
        return any(
            one.name in self.in_group(name) if name in self.groups else name in (one.name, one.role, one.stands_for)
            for name in names
        )

    def in_group(self, name: str) -> set[str]:
        """The robots of a group, and of the groups in it."""
        found, waiting, seen = set[str](), [name], set[str]()
        while waiting:
            group = waiting.pop()
            if group in self.groups and group not in seen:
                seen.add(group)
                found |= self.groups[group]
                waiting += self.inner[group]
        return found

    def who(self, names: frozenset[str]) -> list[Hosted]:
        """The robots of a set that have not failed, a substitute in the place of the one that it stands for."""
        found = [one for one in self.robots.values() if one.alive and self.is_member(one, names)]
        return sorted(found, key=lambda one: self.order[one.stands_for or one.name])

    def step(self) -> None:
        """One tick of all, and then what the team agrees on."""
        for one in self.robots.values():
            if not one.alive:
                continue
            machine = one.machine
            if one.doing and self.tick >= one.busy_until:
                one.log.append(Done(one.doing, one.began, self.tick))
                one.doing = 0
            machine.set_done("Arm", not one.doing)
            machine.set_done("Team", one.released)
            machine.set_input("Team", one.answer)
            for work, left in self.left.items():
                machine.set_done(work, one.takes != work)
                machine.set_input(work, left)
            for command in machine.tick():
                if command.actuator == "Arm":
                    assert not one.doing
                    one.doing, one.began = command.arguments[0], self.tick
                    one.busy_until = self.tick + self.chance.randrange(1, 6)
                elif command.actuator in self.left:
                    self.works(one, command.actuator, command.procedure)
                else:
                    self.called(one, command.procedure, list(command.arguments))
        for number, point in enumerate(self.points):
            self.agree(number, point)
        for work in self.left:
            self.share_out(work)
        self.tick += 1

    def works(self, one: Hosted, work: str, what: str) -> None:
        """A robot wants a unit of a work, or says that its one is done."""
        if what == "Take":
            one.takes = "" if (one.name, work) in self.held else work
            self.share_out(work)
        elif (one.name, work) in self.held:
            self.held.discard((one.name, work))
            self.left[work] -= 1

    def share_out(self, work: str) -> None:
        """Free units are given to those who wait; without one go on who would wait in vain."""
        holders = [name for name, held in self.held if held == work]
        for one in self.robots.values():
            if one.alive and one.takes == work and len(holders) < self.left[work]:
                self.held.add((one.name, work))
                holders.append(one.name)
                one.takes = ""
        if not self.left[work] or (holders and all(self.robots[name].at for name in holders)):
            for one in self.robots.values():
                one.takes = "" if one.takes == work else one.takes

    def called(self, one: Hosted, method: str, arguments: list[int]) -> None:
        """A command to `Team`."""
        one.released = False
        if method == "Join":
            one.released = bool(one.role)
            return
        number = arguments[0]
        point = self.points[number]
        if one.led_to >= 0:
            first, last = point.leads
            one.answer, one.released = int(first <= one.led_to <= last), True
            if number == one.led_to:
                one.led_to, one.answer = -1, one.anchor.answer
        elif one.told:
            agreed, answer = one.told.pop(0)
            assert agreed == number
            one.answer, one.released = answer, True
        elif point.kind in (PointKind.BLOCK, PointKind.BRANCH):
            self.release(one, number, int(self.is_member(one, point.members)))
        else:
            one.at = number, (arguments[1] if len(arguments) > 1 else 0)

    def release(self, one: Hosted, number: int, answer: int) -> None:
        """A robot goes on from a point."""
        one.at, one.answer, one.released = None, answer, True
        anchor = one.anchor
        if anchor.point >= 0 and self.points[anchor.point].kind is PointKind.BLOCK:
            first, last = self.points[anchor.point].leads
            if first <= number <= last:
                anchor.since.append((number, answer))
                return
        kind = self.points[number].kind
        if kind is PointKind.BRANCH or (kind is PointKind.BLOCK and not answer):
            return
        count = int(one.machine.cells[one.machine.layout.variables["Count"]])
        one.anchor = Anchor(number, answer, [], count, len(one.log))

    def fail(self, name: str) -> None:
        """A robot fails; a spare one of its kind takes its role over, if there is one."""
        lost = self.robots[name]
        lost.alive = False
        self.held = {(one, work) for one, work in self.held if one != name}
        spare = next(
            (one for one in self.robots.values() if one.alive and not one.role and one.kind == lost.kind), None
        )
        if spare is None:
            return
        for group in self.groups.values():
            if name in group:
                group.remove(name)
                group.add(spare.name)
        spare.role, spare.stands_for = lost.role, lost.stands_for or lost.name
        spare.anchor, spare.led_to, spare.told = lost.anchor, lost.anchor.point, list(lost.anchor.since)
        spare.machine.cells[spare.machine.layout.variables["Count"]] = lost.anchor.count
        spare.log = lost.log[: lost.anchor.lines]
        spare.released = True
        lost.role = ""

    def agree(self, number: int, point: Point) -> None:
        """All go on from a point when all who come there are there."""
        members = self.who(point.members)
        if not members or any(one.at is None or one.at[0] != number for one in members):
            return
        answers = [one.at[1] for one in members if one.at is not None and self.is_member(one, point.asked)]
        result = 0
        if point.kind is PointKind.ASK:
            yes = sum(map(bool, answers))
            result = {
                ONE: yes > 0 and bool(answers[0]),
                "any": yes > 0,
                "all": yes == len(answers),
                "most": 2 * yes > len(answers),
            }[point.quantifier]
            result = int(result is not point.negated)
        elif point.kind is PointKind.COUNT:
            passes = self.counts[number] if members[0].at == (number, 1) else 0
            result = int(passes < point.times)
            self.counts[number] = passes + 1
        elif point.kind is PointKind.MOVE:
            source, target = point.moves
            going = self.who(frozenset((source,)))[: point.times]
            for one in going:
                for group in self.groups:
                    if one.name in self.groups[group] and (group == source or group in self.inner.get(source, ())):
                        self.groups[group].discard(one.name)
                self.groups[target].add(one.name)
        for one in members:
            self.release(one, number, result)

    @property
    def ended(self) -> bool:
        """Whether every robot that takes part has come to the end of its program."""
        return all(one.machine.ended for one in self.robots.values() if one.alive and one.role)

    def run(self, most: int = 20_000) -> None:
        """Until all have ended."""
        while not self.ended:
            assert self.tick < most, {one.name: (one.at, one.doing, one.anchor) for one in self.robots.values()}
            self.step()

    def lines(self) -> dict[str, list[int]]:
        """The lines that each took part in, whoever did them in the end."""
        return {
            one.stands_for or one.name: [done.number for done in one.log] for one in self.robots.values() if one.role
        }
