"""A run that the simulator ends as *stuck* breaks `deadlock`; where nothing is left to chance, nothing else does."""

from __future__ import annotations

import random

import pytest

from kitrobot.lll.printer import print_program
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from tests.effort import cases, examples
from tests.sim.building import avatar, empty_world, run_of
from tests.strategies.programs import Shape, random_program
from tests.verifier.check_fixtures import answers, judged
from tests.verifier.test_brute_force_timings import random_road
from tests.verifier.test_teams import team

PARTS = (
    """<actuator name="Lamp" device="lamp"><procedure name="LightOn"/><procedure name="LightOff"/></actuator>""",
    """<variable name="Flag" type="boolean" initial="false" shared="yes"/>""",
    """<variable name="Count" type="integer" min="0" max="2" initial="0" shared="yes"/>""",
    """<variable name="Own" type="integer" min="0" max="2" initial="0"/>""",
)
ROBOT = avatar(*PARTS)
SLOW = avatar(*PARTS, tick=60, name="slow")


def of_texts(*texts: str) -> Simulation:
    """A run of robots in an empty room, one for each program."""
    names = "abcd"[: len(texts)]
    world = empty_world(**{name: (200.0 + 300 * n, 200, 0) for n, name in enumerate(names)})
    return run_of({name: (ROBOT, text) for name, text in zip(names, texts, strict=True)}, world, seconds=100)


def random_run(rng: random.Random) -> tuple[Simulation, list[str]]:
    """Two or three robots with random programs that poll, wait and light lamps."""
    robots = [ROBOT, rng.choice((ROBOT, ROBOT, SLOW)), *([ROBOT] if rng.random() < 0.3 else [])]
    texts = [print_program(random_program(rng, robot, Shape(instructions=6, depth=3))) for robot in robots]
    names = "abc"[: len(robots)]
    world = empty_world(**{name: (200.0 + 300 * n, 200, 0) for n, name in enumerate(names)})
    agents = dict(zip(names, zip(robots, texts, strict=True), strict=True))
    return run_of(agents, world, seconds=100), texts


def to_the_end(run: Simulation) -> None:
    while run.outcome is None:
        run.advance(1000)


def deadlock(run: Simulation, states: int = 20_000) -> str:
    """What Check says in lockstep, which is the simulator's own timing."""
    model = Model(run, abstract_run(run), 0, Timing.LOCKSTEP)
    ready = [one for one in ready_properties(model) if one.name == "deadlock"]
    return check_properties(model, ready, Budget(states)).verdicts[0].answer.value


WAITS_FOR_FLAG = "*[Flag.IsFalse()]( WAIT(20); ); Count.Add(1);"


@pytest.mark.parametrize("timing", cases([Timing.LOCKSTEP], [Timing.PROMPT, Timing.FREE]))
@pytest.mark.parametrize(
    ("texts", "answer"),
    [
        pytest.param([WAITS_FOR_FLAG, WAITS_FOR_FLAG], "broken", id="two poll what neither sets"),
        pytest.param(["*( Own.Set(1); WAIT(20); Own.Set(0); WAIT(40); );"], "broken", id="a robot counts for itself"),
        pytest.param(["*( Lamp.LightOn(); WAIT(20); );"], "broken", id="a lamp is told what it does"),
        pytest.param(["*( Lamp.LightOn(); WAIT(20); Lamp.LightOff(); WAIT(20); );"], "holds", id="a lamp blinks"),
        pytest.param(["*( Flag.Set(1); WAIT(20); Flag.Set(0); WAIT(20); );"], "holds", id="what is shared changes"),
        pytest.param(["*( Lamp.LightOn(); WAIT(20); );", "WAIT(100); Flag.Set(1);"], "broken", id="one of two ends"),
        pytest.param([WAITS_FOR_FLAG, "WAIT(100); Flag.Set(1);"], "holds", id="one waits for the other"),
    ],
)
def test_robots_that_go_round_and_say_nothing_new_stand_still(timing: Timing, texts: list[str], answer: str) -> None:
    """In other timings too: test_units_of_work_that_are_taken_and_never_done_are_a_standstill, and brute force."""
    run = of_texts(*texts)
    assert answers(judged(run, timing))["deadlock"] == answer
    to_the_end(run)
    assert (run.outcome == "stuck") == (answer == "broken")


@pytest.mark.parametrize("timing", list(Timing))
def test_units_of_work_that_are_taken_and_never_done_are_a_standstill(timing: Timing) -> None:
    made = team("ParOfSeq scout ( *[!(Boxes.IsEmpty())]( Boxes.Take(); WAIT(20); ); );")
    assert answers(judged(made.run, timing))["deadlock"] == "broken"


def test_check_says_of_random_missions_what_the_simulator_ends_as() -> None:
    """There are no sensors, and nothing is left to chance."""
    said = {"stuck": 0, "done": 0, "time": 0}
    for seed in range(examples(150, 5000)):
        run, texts = random_run(random.Random(seed))
        answer = deadlock(run)
        to_the_end(run)
        assert run.outcome is not None
        assert (answer == "broken") == (run.outcome == "stuck"), (seed, run.outcome, texts)
        said[run.outcome] += 1
    assert min(said.values()) > 5, said


def test_where_check_finds_no_standstill_on_a_road_no_run_is_stuck() -> None:
    """Robots read signs and keep their distance. In 77, one is held at the end of its road, and told so again."""
    said = {"broken": 0, "holds": 0}
    for seed in (*range(examples(30, 1000)), 77):
        run, texts = random_road(random.Random(seed))
        answer = deadlock(run, 5000)
        to_the_end(run)
        if answer != "not finished":
            assert (answer, run.outcome) != ("holds", "stuck"), (seed, texts)
            said[answer] += run.outcome == "stuck" or answer == "holds"
    assert min(said.values()) > 5, said
