"""A run of a mission in its world, step by step.

A step is the longest time that divides 20 ms and the ticks of all robots; what happens in one is in `step_loop`,
for all robots at once. The same mission, world and seed give the same run, number for number: all chance comes from
the run's seed and the names of agent and device, and nothing reads a clock.

The state of a run is its tables (state); a `Simulation` puts the mission in, gives names to what comes out, and finds
the sentence for the end. `tick` counts finished steps. Once `outcome` is set (see `outcome`), `step` does nothing more.
CPython and Numba give the same steps, only the speed differs (`sim.jit.policy`). Left to others: the clock on the
wall, the trace (`recorder`), who watches.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping, Sequence
from functools import cached_property

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.compiler.team.points import TeamPlan
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.image.model import Image
from kitrobot.mission.model import DEFAULT_SEED, Mission
from kitrobot.mission.trial import FailureKind
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.sim.event_text import Event, EventText
from kitrobot.sim.initial_snapshot import InitialSnapshot
from kitrobot.sim.jit.arrays import as_arrays
from kitrobot.sim.jit.policy import JitPolicy
from kitrobot.sim.outcome import (
    Goals,
    Outcome,
    describe_done,
    describe_failed,
    describe_stuck,
    describe_team_over,
    describe_timeout,
    is_at_once,
)
from kitrobot.sim.overrides import force_sensor, stop_motors
from kitrobot.sim.run_view import RunView
from kitrobot.sim.setup.chance_keys import ChanceKeys
from kitrobot.sim.setup.limits import SimulationError, check_limits, whole_number
from kitrobot.sim.setup.setup import Setup, shared_tables_of
from kitrobot.sim.snapshots import SNAPSHOT_VERSION, damaged, sealed, unsealed
from kitrobot.sim.step.deadlock_detection import mark_activity
from kitrobot.sim.step.fault_injection import BY_HAND
from kitrobot.sim.step.fault_schedule import (
    discard_reported_events,
    has_event_room,
    inject_fault_by_hand,
    schedule_faults,
)
from kitrobot.sim.step.pens import drawn_marks
from kitrobot.sim.step.step_loop import advance, are_goals_reached, can_continue
from kitrobot.sim.tables.columns import ASLEEP, EVENTS, STUCK, TICK
from kitrobot.sim.tables.state_codec import StateCodec
from kitrobot.sim.tables.team_columns import T_ACTUATOR, T_ROLE, TEAM_OVER
from kitrobot.sim.team_text import TeamText
from kitrobot.text.collection import collection_paused
from kitrobot.text.phrases import one_of, shown
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.trace.drawing import Mark
from kitrobot.world.model import World
from kitrobot.world.xml_writer import write_world


class Simulation(RunView):
    """A run, as it is now (`RunView`) and going on.

    `outcome` is None as long as it goes on, and `sentence` says then why it ended. `OpenMission.simulation` makes one
    of a mission, with what that needs.

    Examples:
        >>> import kitrobot
        >>> run = kitrobot.open_mission("square").simulation(seed=1)
        >>> run.step()
        >>> run.tick, run.seconds, run.outcome
        (1, 0.02, None)
        >>> kept = run.snapshot()
        >>> run.advance(99)
        99
        >>> run.restore(kept)
        >>> run.tick
        1

    Args:
        mission: what is run, and by whom.
        world: where; it must have been read without errors.
        images: the compiled programs, by `Agent.image_name`.
        catalogue: the robots.
        seed: decides all chance; 0 to `MAX_SEED`.
        seconds: simulated time after which the run ends with the outcome "time", to `MAX_SECONDS`; None for no limit.
        fail_rate: the probability (0…1) that an agent fails for good within a minute, by chance.
        team: the points of the program that agents run as a team.

    Raises:
        SimulationError: the mission cannot be run in this world; its diagnostics say everything that is in the way.
            Or a number makes no sense (see `limits`); then there are no diagnostics.
    """

    def __init__(
        self,
        mission: Mission,
        world: World,
        images: Mapping[ImageName, CompiledProgram],
        catalogue: Catalogue,
        seed: int = DEFAULT_SEED,
        seconds: float | None = None,
        fail_rate: float = 0.0,
        team: TeamPlan | None = None,
    ) -> None:
        check_limits(seconds, seed, fail_rate)
        seed = whole_number(seed)
        with collection_paused():
            setup = Setup(mission, world, images, catalogue, fail_rate, team=team)
        shared = shared_tables_of(setup.agents)
        super().__init__(world, setup.agents, setup.tables.state(shared), setup.step_ms)
        self._chance = ChanceKeys(self.state, self.members, self._sensors)
        self._chance.put(self.state, seed)
        self.mission = mission
        self.seed = seed
        self.seconds_limit = seconds
        self.fail_rate = fail_rate
        self.outcome: Outcome | None = None
        self.sentence = ""
        self.events: list[Event] = []
        self.drawn: list[Mark] = []
        """What happened in the steps of the last `step` or `advance`, and what pens drew in them."""
        self._codec = StateCodec(self.state)
        self._images = {agent.image_name: images[agent.image_name].image for agent in self.members}
        self.debug = {agent.image_name: images[agent.image_name].debug for agent in self.members}
        """Where the instructions of each program came from; of a team's, those of each kind of robot."""
        self.shared_variables = shared.variables
        groups, works = list(team.groups) if team else (), [work.name for work in mission.team.works]
        self._event_text = EventText(world, self.members, shared.variables, self.state, groups, works)
        self._fault_plan = setup.tables.fault_plan
        self._team_text = TeamText(team, self.members)
        self.team_plan = team
        """The points of the program that agents run as a team; None where they run none."""
        self._goals = Goals(self.state.docks.goals, self.stage)
        self._last_tick: int | None = None
        if seconds is not None:
            self._last_tick = max(1, math.ceil(seconds * 1000 / self.tick_ms - 1e-9))
        self._jit = JitPolicy(len(self.members))
        self.stays_plain = False
        """Set before the first step: CPython runs every step, however many; to compare, and to measure."""

    # -- going on

    def step(self) -> None:
        """One step of everything, `tick_ms` of simulated time; then `events` is what happened in it.

        Raises:
            SimulationError: the run has ended.
        """
        if self.outcome is not None:
            raise SimulationError(
                Sentence("the run has ended, so there is no step after {tick}", self.tick),
                Sentence("look at `outcome` before each step, or go back with `restore`"),
            )
        self.advance(1)

    def advance(self, steps: int, tells: bool = True) -> int:
        """Runs up to so many steps and gives how many; fewer when the run ends, or what happens or is probed fills up.

        `events` is then what happened in all of them, unless nobody asks. Many steps in one call are quicker.
        """
        self.events, self.drawn = [], []
        if self.outcome is not None or steps < 1:
            return 0
        if self._last_tick is not None:
            steps = min(steps, self._last_tick - self.tick)
        discard_reported_events(self.state)
        done = 0
        while done < steps:
            compiled = None if self.stays_plain else self._jit.compiled()
            if compiled is None:
                part = min(steps - done, self._jit.most)
                ran = advance(self.state, part)
                self._jit.worked(ran)
            else:
                if isinstance(self.state.clock, list):
                    self._show(as_arrays(self.state))
                part = steps - done
                ran = int(compiled(self.state, part))
            done += ran
            if ran < part:
                break
        if tells:
            self.events, self.drawn = self._event_text.events(self.state), drawn_marks(self.state)
        self.update_outcome()
        return done

    def compile_step(self) -> bool:
        """Waits until the step is compiled, and takes it from now on; False where it cannot be. Changes no run."""
        return self._jit.wait()

    @property
    def would_gain(self) -> bool:
        """Whether it was long, and would have been much quicker if Numba were installed."""
        return self._jit.would_gain

    def update_outcome(self) -> None:
        """Says anew whether the run is over."""
        clock, goals, members = self.state.clock, self._goals, self.members
        self.outcome, self.sentence = None, ""
        if self.state.team.numbers[TEAM_OVER]:
            self._end("failed", describe_team_over(self._team_text.over(self.state), goals, members))
        elif not clock[STUCK] and not can_continue(self.state):
            self._end("failed", describe_failed(goals, members))
        elif are_goals_reached(self.state):
            self._end("done", describe_done(goals, self.seconds, members))
        elif self._last_tick is not None and clock[TICK] >= self._last_tick:
            assert self.seconds_limit is not None
            self._end("time", describe_timeout(goals, self.seconds_limit, members))
        elif clock[STUCK] and (lost := self._team_text.lost_block(self.state)):
            self._end("failed", describe_team_over(lost, goals, members))
        elif clock[STUCK]:
            self._end("stuck", describe_stuck(goals, members, self._team_text.missing(self.state)))

    def _end(self, outcome: Outcome, sentence: str) -> None:
        """The run is over: so, unless what was to be done is done."""
        if self._goals.hold() if self._goals else self._have_all_ended():
            outcome, sentence = "done", describe_done(self._goals, self.seconds, self.members)
        self.outcome, self.sentence = outcome, sentence

    def _have_all_ended(self) -> bool:
        """Whether all programs have ended, but those of robots without which a team came to the end of its own."""
        team = self.state.team
        links, roles = team.robots[T_ACTUATOR], team.robots[T_ROLE]
        return not team.numbers[TEAM_OVER] and all(
            agent.ended or (len(roles) > 0 and links[agent.index] >= 0 > roles[agent.index]) for agent in self.members
        )

    @property
    def ended_at_once(self) -> bool:
        """Whether the run is over and all its programs ended before time passed."""
        return self.outcome is not None and is_at_once(self.seconds, self.members)

    @property
    def images(self) -> dict[ImageName, Image]:
        """The programs by the names of `Agent.image_name`."""
        return {name: image for name, image in self._images.items() if image is not None}

    def happened(self) -> list[Event]:
        """The events that are in the tables."""
        return self._event_text.events(self.state)

    def watch_programs(self) -> None:
        """From the first step on, `machine.seen` of each member says which instructions ran in its last tick.

        Call it before the first step. A program that sleeps would run the same ones again.
        """
        assert self.tick == 0, "before the first step"
        for agent in self.members:
            seen = agent.machine.seen
            seen += [0] * (agent.machine.image.instructions - len(seen))
        self._codec = StateCodec(self.state)

    # -- from outside

    def force(self, agent: str, sensor: str, value: int | None) -> None:
        """Puts a value in the place of what a sensor measures, from the next step on; None gives it back.

        Values are as the sensor gives them, clamped to its range. A run that was stuck goes on.

        Raises:
            KitRobotError: there is no such agent or sensor, or the value is no whole number.
        """
        value = None if value is None else whole_number(value)
        k = next((self._sensors.get((a.index, sensor)) for a in self.members if a.name == agent), None)
        if k is None:
            raise KitRobotError(
                Sentence("no agent {agent} with a sensor {sensor} takes part in this run", agent, sensor),
                self._names(agent, sensor, lambda member: member.machine.layout.sensors),
            )
        force_sensor(k, value, self.state)
        self.update_outcome()

    def set_variable(self, agent: str, variable: str, value: int) -> None:
        """Sets an agent's variable between two steps, within its range; a shared one spreads with the next step.

        A run that was stuck goes on.

        Raises:
            KitRobotError: there is no such agent or variable, or the value is no whole number.
        """
        value = whole_number(value)
        member = next((a for a in self.members if a.name == agent and variable in a.machine.layout.variables), None)
        if member is None:
            raise KitRobotError(
                Sentence("no agent {agent} with a variable {variable} takes part in this run", agent, variable),
                self._names(agent, variable, lambda member: member.machine.layout.variables),
            )
        member.machine.set_variable(variable, value)
        self.state.robots.ints[ASLEEP][member.index] = 0
        mark_activity(self.state.clock)
        self.update_outcome()

    def inject_fault(self, agent: str, kind: FailureKind | str, cause: int = BY_HAND) -> bool:
        """Lets an agent fail, stall or lose its radio, or makes it well again (see faults); told with the next step.

        Who fails stops its motors at once. A run that ended because nobody could go on does when somebody is revived.
        Gives whether that changed anything. `cause`: by hand, or what became of an agent that is elsewhere
        (fault_injection).

        Raises:
            KitRobotError: there is no such agent or kind, or too much was done to this run between two steps.
        """
        member = self._member(agent)
        if kind not in list(FailureKind):
            raise KitRobotError(
                Sentence("expected {expected}, found {found}", one_of(FailureKind), shown(kind)),
                did_you_mean(kind, FailureKind),
            )
        discard_reported_events(self.state)
        if not has_event_room(self.state, 1 + len(self.shared_variables)):
            raise KitRobotError(
                Sentence("too much was done to this run between two steps"), Sentence("let it go on for a step")
            )
        before = self.state.clock[EVENTS]
        inject_fault_by_hand(self.state, member.index, FailureKind(kind), cause)
        if self.state.clock[EVENTS] == before:
            return False
        self.update_outcome()
        return True

    def plan_failures(self, failures: Sequence[tuple[int, int]]) -> None:
        """Puts up to two failures, (step, agent's place in the team), on the schedule, as if the mission had them too.

        They take the place of those that were put there before, and must not be before this step. A snapshot does not
        keep them.
        """
        schedule_faults(self._fault_plan, failures, self.state)

    @property
    def unreported_events(self) -> list[Event]:
        """What was done by hand since the last step; the next one tells it."""
        return [event for event in self._event_text.events(self.state) if event.tick == self.tick]

    def stop_motors(self) -> None:
        """Everything stands still at once: the emergency stop, after which a run is not gone on with."""
        stop_motors(self.state)

    # -- keeping and going back

    @cached_property
    def identity(self) -> bytes:
        """32 bytes that runs have in common exactly when they are the same mission, world, programs and seed."""
        digest = hashlib.sha256(write_mission(self.mission) + write_world(self.world))
        digest.update(f"{self.seed}/{self.seconds_limit}/{self.fail_rate}/{SNAPSHOT_VERSION}".encode())
        for name, image in sorted(self._images.items()):
            assert image is not None, "staged before"
            digest.update(name.text.encode() + image.to_bytes())
        return digest.digest()

    def snapshot(self) -> bytes:
        """The whole state of the run; a `Simulation` of the same mission, world and seed goes on from it alike.

        The bytes hold no wall clock and no address: another process, with or without Numba, continues identically. They
        are trusted: what they say of programs is not verified again.
        """
        return sealed(self._codec.encode(self.state), self.identity)

    def restore(self, snapshot: bytes) -> None:
        """Goes to a state of this very run, forward or back; `events` and `outcome` are what they were then.

        Raises:
            SimulationError: the bytes are damaged, or of another run; then nothing was changed.
        """
        body = unsealed(snapshot, self.identity)
        try:
            self._codec.decode(self.state, body)
        except ValueError as error:
            raise damaged() from error
        self.events = [event for event in self._event_text.events(self.state) if event.tick < self.tick]
        self.update_outcome()

    def keep_beginning(self) -> None:
        """Keeps the state before the first step, for `begin_again`; call it before that step."""
        assert self.tick == 0, "before the first step"
        self.update_outcome()
        self._beginning = InitialSnapshot(self.state, self._codec, (self.outcome, self.sentence))

    def begin_again(self, seed: int) -> None:
        """Goes back to the beginning that was kept, with another seed: then it is the run that a new one would be.

        Much quicker than setting a mission up again. What was done to the run meanwhile is forgotten.
        """
        self.seed = whole_number(seed)
        self.__dict__.pop("identity", None)
        self._beginning.put_back(self.state)
        self._chance.put(self.state, self.seed)
        self.events, self.drawn = [], []
        self.outcome, self.sentence = self._beginning.end
