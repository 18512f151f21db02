"""Random teams that lose robots and get them back, against what their programs say: who may do a line, and what the end
of the run has to be.
"""

from __future__ import annotations

import random
from collections import Counter
from dataclasses import dataclass, field

from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kitrobot.sim.tables.team_columns import T_MISSED, T_ROLE, T_SEAT
from tests.effort import examples
from tests.sim.team_building import RunningTeam
from tests.team_programs.blocks import BlocksMaker
from tests.team_programs.hosting import TooLarge
from tests.team_programs.reference import Meaning, TooLong

SETTLED = 6
"""Steps after a line in which a robot may be lost before its team knows that the line is over."""


@dataclass
class Losses:
    """A random team, what is to befall it, and the lines that its robots do.

    Attributes:
        begun: (robot, line) → how often it was begun and is over, whatever befell the robot.
        sure: the same, and the robot was well for a while afterwards.
        strange: lines that somebody began whose place is not in their block.
    """

    seed: int
    begun: Counter[tuple[str, int]] = field(default_factory=Counter)
    sure: Counter[tuple[str, int]] = field(default_factory=Counter)
    strange: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        chance = random.Random(self.seed)
        self.substitutes = chance.random() < 0.7
        spares = chance.randrange(2) if self.substitutes else 0
        self.maker = BlocksMaker(chance, spares, "substitute" if self.substitutes else "drop")
        program = self.maker.program()
        roles = {name: role for name, (_, role) in self.maker.agents.items() if role}
        self.meaning = Meaning(roles, self.maker.sets(program), {})
        self.meaning.seq(program.seq, list(roles))
        self.team = RunningTeam(self.maker, program, self.seed)
        kinds = ("fail", "stall", "mute", "revive", "revive") if self.substitutes else ("fail", "stall", "mute")
        moments = [chance.randrange(1, 250) for _ in range(chance.randint(1, 5))]
        self.plan = {sum(moments[: n + 1]): chance.choice(kinds) for n in range(len(moments))}
        self.chance = chance

    def go(self) -> None:
        """The whole run."""
        run, team = self.team.run, self.team
        open_lines: dict[str, int] = {}
        over: dict[str, list[tuple[int, int]]] = {name: [] for name in team.names}
        while run.outcome is None:
            kind = self.plan.get(run.tick)
            if kind is not None:
                down = [a.name for a in run.members if run.view(a.index).state in ("failed", "stalled") or a.fault_text]
                name = self.chance.choice(down if kind == "revive" and down else team.names)
                self.sure.update((name, line) for line, tick in over[name] if tick + SETTLED <= run.tick)
                over[name] = []
                run.inject_fault(name, kind)
            seats = list(run.state.team.robots[T_SEAT])
            team.step()
            for agent in run.members:
                given = [command.arguments[0] for command in agent.commands if command.actuator == "Arm"]
                if agent.name in open_lines and (given or not agent.busy):
                    line = open_lines.pop(agent.name)
                    self.begun[agent.name, line] += 1
                    over[agent.name].append((line, run.tick))
                for line in given:
                    open_lines[agent.name] = line
                    place = team.names[seats[agent.index]]
                    if place not in self.maker.members[line]:
                        self.strange.append(f"{agent.name} in the place of {place} does {line} at {run.tick}")
        for name, lines in over.items():
            self.sure.update((name, line) for line, tick in lines)

    def wanted(self, line: int) -> int:
        """How often a line is to be done."""
        return max(lines.count(line) for lines in self.meaning.lines.values())

    def is_done(self, line: int) -> bool:
        """Whether a line was done as often as it is to be: by one robot where each has but its own place."""
        counts = [self.begun[name, line] for name in self.team.names]
        return (sum(counts) if self.substitutes else max(counts)) >= self.wanted(line)

    def is_surely_done(self, line: int) -> bool:
        """Whether one robot has done all of a line, and was well for long enough that its team knows."""
        return max(self.sure[name, line] for name in self.team.names) >= self.wanted(line)

    def is_lost(self, line: int) -> bool:
        """Whether nobody is in the block of a line any more."""
        robots = self.team.run.state.team.robots
        playing = {self.team.names[robots[T_SEAT][i]] for i, role in enumerate(robots[T_ROLE]) if role >= 0}
        return not playing & self.maker.members[line]


def losses(seed: int) -> Losses:
    try:
        return Losses(seed)
    except (TooLong, TooLarge):
        assume(False)
        raise


@given(st.integers(0, 10**9))
@settings(max_examples=examples(15, 400))
def test_lines_are_done_by_their_robots_only_and_a_team_fails_exactly_when_nobody_is_left_of_a_line(seed: int) -> None:
    case = losses(seed)
    case.go()
    run = case.team.run
    assert case.strange == []
    assert run.outcome in ("done", "failed"), run.sentence
    lines = case.maker.members
    if run.outcome == "done":
        assert [line for line in lines if not case.is_done(line)] == [], run.sentence
    elif any(not run.state.team.robots[T_MISSED][agent.index] for agent in run.members):
        assert any(case.is_lost(line) and not case.is_surely_done(line) for line in lines), run.sentence
