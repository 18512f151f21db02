"""Judges properties by what is recorded of a run, tick by tick: while a fleet runs, and of a recording afterwards.

Conditions are decided by the interpreter on the values that were recorded of each robot, as in a run of the simulator.
What is not recorded is *not decided*: a robot that is not known as it was recorded, ticks that are missing, an end that
is not there.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.run_question import OUTCOMES, find_ready_property, ready_properties_of
from kitrobot.judges.judgement import Judge, JudgeAnswer, JudgeError, Judgement
from kitrobot.judges.record_cases import (
    ConditionCase,
    OutcomeCase,
    ReadyCase,
    RecordCase,
    RecordedSpan,
    UndecidedCase,
)
from kitrobot.mission.model import DEFAULT_RUN_S, DEFAULT_SEED
from kitrobot.mission.property_text import PropertyText, read_question
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import TEAM, TickRecord, TraceEvent, TraceHeader
from kitrobot.trace.source import ENDED
from kitrobot.verifier.properties.conditions import Member, PropertyError
from kitrobot.verifier.properties.custom_properties import parse_conditions
from kitrobot.verifier.properties.property_automaton import PropertyAutomaton
from kitrobot.verifier.properties.run_conditions import RunConditions
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.recorded_agents import RecordedAgent, is_as_recorded, recorded_agents


class RecordMonitor:
    """Properties while they are judged by the records of a run, in the order of the questions.

    Args:
        header: of the recording.
        opened: the mission that is recorded.
        questions: properties as text, or names of those of the mission; none for all that the mission has.
        judge, subject: who judges, and what is judged.
        mission: the mission whose properties are meant; None for `opened`.
        ready: whether those that every mission has are judged too, where there are no questions.

    Raises:
        JudgeError: a robot of the recording is not known.
        QuestionError: a question cannot be understood, or the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
    """

    def __init__(
        self,
        header: TraceHeader,
        opened: OpenMission,
        questions: Sequence[str],
        judge: Judge,
        subject: str,
        *,
        mission: OpenMission | None = None,
        ready: bool = False,
    ) -> None:
        self._header = header
        self._mission = mission or opened
        self._span = RecordedSpan(header, judge, subject)
        found = recorded_agents(header, opened.catalogue.robots, {}, opened.mission.team.works)
        self._agents: dict[int, RecordedAgent] = {one.index: one for one in found}
        self._known = {i for i, one in self._agents.items() if is_as_recorded(header, one.name, one.robot)}
        self._team = self._mission.mission.team if header.plan is not None else None
        self._columns = {column.name: at for at, column in enumerate(header.columns) if column.owner == TEAM}
        self._record = TickRecord(0, [], [])
        self._gaps, self._expected = 0, 0
        self._cases = self._cases_of(questions, ready)
        self._unbroken = list(self._cases)
        self._ready_cases = [one for one in self._cases if isinstance(one, ReadyCase)]
        self._open = [one for one in self._cases if isinstance(one, ConditionCase) and one.is_open]
        self._decided = RunConditions(
            [one for case in self._open for one in case.conditions],
            {i: one.robot for i, one in self._agents.items()},
            lambda agent: tuple(self._agents[agent].cells),
            self._in_set,
        )

    @property
    def is_open(self) -> bool:
        """Whether values of more ticks may decide something."""
        return bool(self._open)

    def judgements(self) -> list[Judgement]:
        """What is said of each property, of what was read so far."""
        return [one.judgement(self._span) for one in self._cases]

    # -- what is recorded

    def follow(self, record: TickRecord, outcome: str | None = None) -> list[Judgement]:
        """Takes in a record of a run that goes on; what is broken now and was not before.

        Args:
            record: of the next tick; the first one is that before the first step.
            outcome: how the run ended with this tick; None where it goes on.
        """
        self.read_events(record.events)
        self.read_values(record)
        self.end(record.tick, outcome)
        broken: list[Judgement] = []
        for case in tuple(self._unbroken):
            if not case.may_be_broken(self._span):
                continue
            found = case.judgement(self._span)
            if found.ruling is JudgeAnswer.BROKEN:
                self._unbroken.remove(case)
                broken.append(found)
        return broken

    def read_events(self, events: Sequence[TraceEvent]) -> None:
        """Takes in what happened."""
        for case in self._ready_cases:
            case.read(events)

    def read_values(self, record: TickRecord) -> None:
        """Takes in the values of a tick; ticks ascend, and the first one is 0, from before the first step."""
        tick = record.tick
        expected, self._expected = self._expected, tick + 1
        self._gaps += tick - expected
        self._record = record
        for i in {i for case in self._open for i in case.agents}:
            self._agents[i].update(record)
        if tick == 0:
            self._decided.keep_beginning()
            return
        for case in self._open:
            limit = tick if case.within_s is None else self._span.limit(case.within_s)
            if expected <= limit:
                case.gap = self._gaps
            if tick == 1 and expected == 1:
                case.automaton.read(0, [self._decided.held_at_beginning(one) for one in case.conditions])
            if tick <= limit:
                case.automaton.read(tick, [self._decided.holds(one) for one in case.conditions])
        self._open = [case for case in self._open if case.is_open]

    def end(self, last_tick: int, outcome: str | None) -> None:
        """Takes in how far the recording goes, and how the run ended; None, and other words, where it did not."""
        self._span.last_tick = last_tick
        self._span.outcome = outcome if outcome in ENDED else None

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

    # -- what is asked

    def _cases_of(self, questions: Sequence[str], ready: bool) -> list[RecordCase]:
        """One for each question; without questions those of the mission, and the `ready` ones."""
        own = [one.name for one in self._mission.mission.properties]
        cases = [self._case(read_question(question, own)) for question in questions]
        if questions:
            return cases
        for one in self._mission.mission.properties:
            try:
                cases.append(self._asked(PropertyText(one.name, "", one)))
            except PropertyError as error:
                cases.append(UndecidedCase(one.name, one.words, error.message))
        if ready:
            with suppress(KitRobotError):
                cases += [
                    ReadyCase(PropertyText(one.name, one.name), one) for one in ready_properties_of(self._simulation())
                ]
        return cases

    def _case(self, text: PropertyText) -> RecordCase:
        own = next((one for one in self._mission.mission.properties if one.name == text.name), None)
        if text.asked is not None or own is not None:
            return self._asked(replace(text, asked=text.asked or own))
        if text.name in OUTCOMES:
            return OutcomeCase(text)
        return ReadyCase(text, find_ready_property(text.name, self._simulation()))

    def _simulation(self) -> Simulation:
        """A run of the mission, of which the ready properties are asked that fit it."""
        return self._mission.prepare(RunOptions(DEFAULT_SEED, DEFAULT_RUN_S)).simulation

    def _asked(self, text: PropertyText) -> ConditionCase:
        assert text.asked is not None
        team, unknown = self._members()
        conditions = parse_conditions(text.asked, team, self._team)
        automaton = PropertyAutomaton(text.asked, self._header.tick_ms)
        case = ConditionCase(text.text, text.asked, text.within_s, conditions, automaton)
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
