"""Judges properties by a recording: of a simulated run, of real robots, of a fleet; several properties in one pass.

Conditions are decided by the interpreter on the values that were recorded of each robot, tick by tick, as in a run of
the simulator. What a recording does not hold is *not decided*: a robot that is not known as it was recorded, ticks that
are missing, an end that is not there.
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.run_question import OUTCOMES, find_ready_property, ready_properties_of
from kitrobot.judges.judgement import Judge, JudgeAnswer, JudgeError, Judgement
from kitrobot.judges.recorded_events import breaks_ready_property
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.mission.property_text import PropertyText, read_property
from kitrobot.sim.simulation import Simulation
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import TEAM, TickRecord
from kitrobot.trace.source import ENDED
from kitrobot.verifier.properties.conditions import AgentCondition, Member, PropertyError
from kitrobot.verifier.properties.custom_properties import parse_conditions
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.property_automaton import PropertyAutomaton, PropertyState
from kitrobot.verifier.properties.ready_monitors import waited_long_enough
from kitrobot.verifier.properties.run_conditions import RunConditions
from kitrobot.workspace.mission_loader import OpenMission, open_mission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.recorded_agents import RecordedAgent, is_as_recorded, recorded_agents
from kitrobot.workspace.traces import OpenTrace, open_trace, unpack

_SURE_IN_GAPS = (Form.NEVER, Form.AT_MOST)
"""The forms that stay broken whatever happened in ticks that are missing."""


def judge_recording(
    path: Path, questions: Sequence[str] = (), mission: OpenMission | None = None, *, ready: bool = True
) -> list[Judgement]:
    """Judges a recording by properties.

    Args:
        path: the recording.
        questions: properties as text, or names of those of the mission; none for all that the mission has.
        mission: the mission whose properties are meant; None for the one in the recording.
        ready: whether those that every mission has are judged too, where there are no questions.

    Raises:
        TraceError: the recording cannot be read.
        JudgeError: the recording is of another mission.
        QuestionError: a question cannot be understood, or the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
    """
    trace = open_trace(path)
    with trace.reader, tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        # Parts that are shipped need not be in it, and its own may be wrong: what is known then is enough.
        opened = open_mission(unpack(trace, Path(folder)))
        if mission is not None:
            _expect_same_team(trace, mission)
        return _Recording(trace, opened, mission or opened).judge(questions, ready)


def _expect_same_team(trace: OpenTrace, mission: OpenMission) -> None:
    recorded = {agent.name: agent.program for agent in trace.reader.header.agents}
    asked = {agent.name: agent.program for agent in mission.mission.team.agents}
    if recorded != asked:
        raise JudgeError(
            Sentence("{recording} is of another mission than {mission}", trace.reader.path.name, mission.name),
            Sentence("its agents are: {recorded}; those of the mission are: {asked}", listed(recorded), listed(asked)),
        )


@dataclass
class _Case:
    """A property of which conditions are judged."""

    question: str
    asked: AskedProperty
    within_s: float | None
    conditions: list[AgentCondition]
    automaton: PropertyAutomaton
    unknown: str = ""
    """A robot whose values were not recorded, or are not known as they were."""
    gap: int = 0
    """Ticks that were missing when it was decided."""

    @property
    def agents(self) -> list[int]:
        """The numbers of the agents that it speaks of."""
        return sorted({agent for one in self.conditions for agents in one.tests.values() for agent in agents})


class _Recording:
    """A recording while properties are judged by it. `opened`: its mission; `mission`: the one with the properties."""

    def __init__(self, trace: OpenTrace, opened: OpenMission, mission: OpenMission) -> None:
        self._trace, self._mission = trace, mission
        self._reader = trace.reader
        self._header = header = trace.reader.header
        robots, works = opened.catalogue.robots, opened.mission.team.works
        found = recorded_agents(header, robots, {}, works)
        self._agents: dict[int, RecordedAgent] = {one.index: one for one in found}
        self._known = {i for i, one in self._agents.items() if is_as_recorded(header, one.name, one.robot)}
        self._team = mission.mission.team if header.plan is not None else None
        self._columns = {column.name: at for at, column in enumerate(header.columns) if column.owner == TEAM}
        self._record = TickRecord(0, [], [])

    def judge(self, questions: Sequence[str], ready: bool) -> list[Judgement]:
        """Judges all of them, in their order; without questions those of the mission, and the `ready` ones."""
        cases: list[_Case | Property | Judgement | PropertyText] = []
        for text in [read_property(question) for question in questions]:
            cases.append(self._case(text))
        if not questions:
            for one in self._mission.mission.properties:
                try:
                    cases.append(self._asked(PropertyText(one.name, "", one)))
                except PropertyError as error:
                    cases.append(self._undecided(one.name, one.words, error.message))
            cases += self._ready() if ready else []
        asked = [one for one in cases if isinstance(one, _Case)]
        gaps = self._read(asked)
        return [self._judgement(one, gaps) for one in cases]

    def _case(self, text: PropertyText) -> _Case | Property | PropertyText:
        own = next((one for one in self._mission.mission.properties if one.name == text.name), None)
        if text.asked is not None or own is not None:
            return self._asked(replace(text, asked=text.asked or own))
        if text.name in OUTCOMES:
            return text
        run = self._simulation()
        return find_ready_property(text.name, run)

    def _simulation(self) -> Simulation:
        """A run of the mission, of which the ready properties are asked that fit it."""
        return self._mission.prepare(RunOptions(1, 600.0)).simulation

    def _ready(self) -> list[Property]:
        with suppress(KitRobotError):
            return ready_properties_of(self._simulation())
        return []

    def _asked(self, text: PropertyText) -> _Case:
        assert text.asked is not None
        team, unknown = self._members()
        conditions = parse_conditions(text.asked, team, self._team)
        case = _Case(
            text.text, text.asked, text.within_s, conditions, PropertyAutomaton(text.asked, self._header.tick_ms)
        )
        missing = next((unknown[i] for i in case.agents if i in unknown), "")
        sets = {name for one in conditions for name in one.sets}
        if not missing and sets and self._header.plan is None:
            missing = min(sets)
        case.unknown = missing
        return case

    def _members(self) -> tuple[list[Member], dict[int, str]]:
        """The agents as conditions name them, and the names of those whose values are not known."""
        members, unknown = [], {}
        for i, agent in enumerate(self._header.agents):
            recorded = self._agents.get(i)
            if recorded is None:
                raise JudgeError(
                    Sentence("the robot {robot} of {agent} is not known any more", agent.robot, agent.name),
                    Sentence("put its file beside the mission, and record the run again"),
                )
            if i not in self._known:
                unknown[i] = agent.name
            members.append(Member(agent.name, agent.program, recorded.robot))
        return members, unknown

    def _read(self, cases: Sequence[_Case]) -> int:
        """Reads the recording once, for all cases; how many ticks are missing in it."""
        gaps, expected = 0, 1
        open_cases = [case for case in cases if not case.unknown]
        if not open_cases:
            return 0
        decided = RunConditions(
            [one for case in open_cases for one in case.conditions],
            {i: one.robot for i, one in self._agents.items()},
            lambda agent: tuple(self._agents[agent].cells),
            self._in_set,
        )
        wanted = {i for case in open_cases for i in case.agents}
        for record in self._reader.walk(1):
            gaps, expected = gaps + record.tick - expected, record.tick + 1
            self._record = record
            for i in wanted:
                self._agents[i].update(record)
            for case in open_cases:
                if case.within_s is not None and record.tick * self._header.tick_ms > case.within_s * 1000:
                    continue
                case.automaton.read(record.tick, [decided.holds(one) for one in case.conditions])
                if case.automaton.standing is not PropertyState.OPEN and case.automaton.decided_at == record.tick:
                    case.gap = gaps
            open_cases = [case for case in open_cases if case.automaton.standing is PropertyState.OPEN]
            if not open_cases:
                break
        for case in open_cases:
            case.gap = gaps
        return gaps

    def _in_set(self, name: str) -> tuple[int, ...]:
        """The agents that are in a role or a group, as the team recorded it."""
        plan = self._header.plan
        assert plan is not None, "only a team has roles and groups"
        numbers, found = self._record.numbers, []
        for i, agent in enumerate(self._header.agents):
            role = self._columns.get(f"role of {agent.name}")
            if role is None or numbers[role] < 0:
                continue
            if name in plan.groups:
                column = self._columns[f"group {plan.groups.index(name)} of {agent.name}"]
                inside = numbers[column] > 0
            else:
                inside = name in plan.roles and plan.roles.index(name) == numbers[role]
            if inside:
                found.append(i)
        return tuple(found)

    # -- what is said

    def _judgement(self, one: _Case | Property | Judgement | PropertyText, gaps: int) -> Judgement:
        if isinstance(one, Judgement):
            return one
        if isinstance(one, _Case):
            return self._of_case(one)
        if isinstance(one, PropertyText):
            return self._of_outcome(one)
        return self._of_ready(one)

    def _undecided(self, question: str, words: Sentence, reason: Sentence) -> Judgement:
        return Judgement(Judge.RECORDING, self._reader.path.name, question, words, JudgeAnswer.NOT_DECIDED, reason)

    def _at(self, tick: int) -> str:
        return f"{tick * self._header.tick_ms / 1000:.2f}"

    @property
    def _outcome(self) -> str | None:
        """How the run ended; None of a recording without its end."""
        outcome = self._reader.outcome.get("outcome")
        return outcome if outcome in ENDED else None

    def _of_case(self, case: _Case) -> Judgement:
        asked, automaton = case.asked, case.automaton
        words = asked.words
        if case.within_s is not None:
            words = Sentence("{question}, within {seconds} s", words, f"{case.within_s:g}")
        names = tuple(self._header.agents[i].name for i in case.agents)
        made = replace(self._undecided(case.question, words, Sentence("")), agents=names, tick_ms=self._header.tick_ms)
        if case.unknown:
            reason = Sentence("what {name} read and stored was not recorded, or its robot has changed", case.unknown)
            return replace(made, reason=reason)
        if automaton.standing is PropertyState.BROKEN:
            if case.gap and asked.form not in _SURE_IN_GAPS:
                return replace(made, reason=self._missing_ticks(case.gap))
            return made.broken_at(automaton.decided_at)
        if automaton.standing is PropertyState.KEPT:
            if case.gap and asked.form is Form.BEFORE:
                return replace(made, reason=self._missing_ticks(case.gap))
            return made.kept_at(automaton.decided_at)
        return self._of_end(case, made)

    def _of_end(self, case: _Case, made: Judgement) -> Judgement:
        """Of a property that was still open when the recording, or the time that is looked at, ended."""
        automaton, last, outcome = case.automaton, self._reader.last_tick, self._outcome
        if case.within_s is not None and last * self._header.tick_ms >= case.within_s * 1000:
            last, outcome = int(case.within_s * 1000 / self._header.tick_ms + 1e-9), "time"
        if case.gap:
            return replace(made, reason=self._missing_ticks(case.gap))
        if not automaton.is_broken_by_end():
            is_over = outcome is not None
            reason = Sentence("kept in this run, to its end") if is_over else Sentence("kept in all that was recorded")
            return replace(made, ruling=JudgeAnswer.KEPT, reason=reason)
        since = self._at(max(0, automaton.waits_since))
        if outcome is None:
            reason = Sentence("the recording ends, and what is waited for since {seconds} s may still come", since)
            return replace(made, reason=reason)
        if outcome == "time" and automaton.deadline is not None:
            return replace(made, reason=Sentence("the time of the run was up before the deadline"))
        if not waited_long_enough(outcome, last, automaton.waits_since):
            reason = Sentence("the time of the run was up, and it waited only since {seconds} s", since)
            return replace(made, reason=reason)
        reason = Sentence("the run ended, and what it waited for since {seconds} s had not come", since)
        return replace(made, ruling=JudgeAnswer.BROKEN, reason=reason, tick=last)

    def _missing_ticks(self, count: int) -> Sentence:
        return Sentence.counted(
            "{count} tick was not recorded, and it may have been decided there",
            "{count} ticks were not recorded, and it may have been decided there",
            count,
        )

    def _of_outcome(self, text: PropertyText) -> Judgement:
        words = Sentence("a run ends with the outcome {outcome}", text.name)
        made = replace(self._undecided(text.text, words, Sentence("")), tick_ms=self._header.tick_ms)
        outcome, last = self._outcome, self._reader.last_tick
        limit = None if text.within_s is None else text.within_s * 1000 / self._header.tick_ms
        if limit is not None:
            made = replace(made, words=Sentence("{question}, within {seconds} s", words, f"{text.within_s:g}"))
            if last > limit:
                outcome, last = "time", int(limit)
        if outcome is None:
            return replace(made, reason=Sentence("the recording ends before the run does"))
        reason = Sentence("the run ended at {seconds} s with the outcome {outcome}", self._at(last), outcome)
        if outcome == text.name:
            return replace(made, ruling=JudgeAnswer.KEPT, reason=reason)
        return replace(made, ruling=JudgeAnswer.BROKEN, reason=reason, tick=last)

    def _of_ready(self, one: Property) -> Judgement:
        made = replace(self._undecided(one.name, one.sentence, Sentence("")), tick_ms=self._header.tick_ms)
        outcome = self._outcome
        if one.monitor is not None:
            reason = Sentence("a recording does not hold what this is decided by; ask a run")
            return replace(made, reason=reason)
        if one.seen_as:
            event = next((event for _, event in self._reader.events if breaks_ready_property(event, one.seen_as)), None)
            if event is not None:
                agents = (self._header.agents[event.agent].name,) if event.agent >= 0 else ()
                return replace(made.broken_at(event.tick), agents=agents)
            if self._header.real:
                return replace(made, reason=Sentence("real robots do not tell what they touch and reach"))
            return replace(made, ruling=JudgeAnswer.KEPT, reason=Sentence("kept in all that was recorded"))
        if outcome is None:
            return replace(made, reason=Sentence("the recording ends before the run does"))
        if outcome == "failed" and one.spares_teams and self._header.plan is not None:
            return replace(made, reason=Sentence("the recording does not say whether the team gave up"))
        reason = Sentence(
            "the run ended at {seconds} s with the outcome {outcome}", self._at(self._reader.last_tick), outcome
        )
        if outcome in one.ends_as:
            return replace(made, ruling=JudgeAnswer.BROKEN, reason=reason, tick=self._reader.last_tick)
        return replace(made, ruling=JudgeAnswer.KEPT, reason=reason)
