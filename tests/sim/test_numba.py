"""Plain and compiled steps give the same bytes: on random teams, in the transport mission, and when a run changes over.

`HYPOTHESIS_PROFILE=thorough` tries more of them.
"""

from __future__ import annotations

import os
import random
import subprocess
import sys
from pathlib import Path

import hypothesis
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.mission.radio import Radio
from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.jit import cache as jit_cache
from kitrobot.sim.jit import compiler as jit_compiler
from kitrobot.sim.jit import policy as jit_policy
from kitrobot.sim.jit.policy import expect_run
from kitrobot.sim.recorder import simulate
from kitrobot.sim.simulation import Simulation
from tests.effort import examples
from tests.patience import PATIENCE_S
from tests.sim.building import transport
from tests.sim.team_building import RunningTeam, random_team_program
from tests.sim.teams import random_team
from tests.team_programs.hosting import TooLarge

ROOT = Path(__file__).parents[2]


RADIOS = (None, Radio(700, 40, 30), Radio(None, 0, 10))

pytestmark = pytest.mark.usefixtures("with_numba")


def hurried(run: Simulation) -> Simulation:
    assert run.compile_step()
    return run


def programmed_team(seed: int) -> Simulation:
    """A team that runs a program of the level social, and of which some fail, with spare ones."""
    maker, program = random_team_program(seed, 1)
    chance = random.Random(seed)
    kinds, names = tuple(FailureKind), list(maker.agents)
    failures = [Failure(chance.choice(names), chance.random() * 4, chance.choice(kinds)) for _ in range(4)]
    try:
        return RunningTeam(maker, program, seed, failures, RADIOS[seed % len(RADIOS)]).run
    except TooLarge:
        hypothesis.assume(False)
        raise


def states(run: Simulation, stretches: list[int]) -> list[bytes]:
    """The snapshots after so many steps each."""
    found = []
    for steps in stretches:
        run.advance(steps)
        found.append(run.snapshot())
    return found


@given(st.integers(0, 10**9), st.integers(1, 14))
@hypothesis.settings(max_examples=examples(12, 1000))
def test_random_teams_run_alike_plain_and_compiled(seed: int, robots: int) -> None:
    stretches = [1, 1, 2, 30, 100, 1]
    radio = RADIOS[seed % len(RADIOS)]
    plain, compiled = random_team(seed, robots, radio=radio), hurried(random_team(seed, robots, radio=radio))
    assert states(plain, stretches) == states(compiled, stretches)
    assert plain.agents == compiled.agents
    assert plain.poses() == compiled.poses()
    assert (plain.outcome, plain.sentence, plain.events) == (compiled.outcome, compiled.sentence, compiled.events)


@given(st.integers(0, 10**9))
@hypothesis.settings(max_examples=examples(5, 300))
def test_random_programs_of_teams_run_alike_plain_and_compiled(seed: int) -> None:
    plain, compiled = programmed_team(seed), programmed_team(seed)
    plain.stays_plain = True
    stretches = [1, 30, 1, 200, 2000]
    assert states(plain, stretches) == states(hurried(compiled), stretches)
    assert (plain.outcome, plain.sentence, plain.events) == (compiled.outcome, compiled.sentence, compiled.events)


@pytest.mark.parametrize("seed", [1, 2])
def test_the_trace_of_the_transport_mission_is_the_same_to_the_byte(seed: int, tmp_path: Path) -> None:
    simulate(transport(seed, 4), tmp_path / "plain.krtrace")
    simulate(hurried(transport(seed, 4)), tmp_path / "compiled.krtrace")
    assert (tmp_path / "plain.krtrace").read_bytes() == (tmp_path / "compiled.krtrace").read_bytes()


def test_a_run_that_changes_over_in_the_middle_is_the_same_run() -> None:
    plain, changing = random_team(5, 10), random_team(5, 10)
    plain.advance(70)
    changing.advance(70)
    assert changing.compile_step()
    assert states(plain, [1, 50]) == states(changing, [1, 50])


@pytest.mark.parametrize("before", [1, 200, 400])
def test_that_robots_are_held_is_found_out_alike(before: int) -> None:
    ends = []
    for compiled in (False, True):
        run = transport(1)
        run.stays_plain = not compiled
        run.advance(before)
        assert run.compile_step() or not compiled
        run.advance(400 - before)
        run.inject_fault("carrier-1", "stall")
        run.advance(5000)
        ends.append((run.outcome, run.tick, run.snapshot()))
    assert ends[0][0] == "stuck"
    assert ends[0] == ends[1]


def test_many_robots_run_alike_plain_and_compiled() -> None:
    plain, compiled = random_team(15, 300), hurried(random_team(15, 300))
    assert states(plain, [40, 160]) == states(compiled, [40, 160])
    assert plain.collisions == compiled.collisions > 0


def test_force_and_set_variable_do_the_same_on_both() -> None:
    runs = random_team(3, 4), hurried(random_team(3, 4))
    rng = random.Random(1)
    for _ in range(6):
        agent = rng.choice(runs[0].agents)
        sensor, value = rng.choice(sorted(agent.inputs)), rng.choice((None, 0, 1, 50, 10**12))
        variable, number = rng.choice(sorted(agent.values)), rng.randrange(2)
        for run in runs:
            run.force(agent.name, sensor, value)
            run.set_variable(agent.name, variable, number)
        assert states(runs[0], [15]) == states(runs[1], [15])


CHILD = """
import sys
from kitrobot.sim.simulation import Simulation; from kitrobot.sim.jit import cache as jit_cache
from tests.sim.building import transport
run = transport(3, 3)
assert run.compile_step() is (sys.argv[1] == "yes"), jit_cache.available()
assert run.advance(500) == 500
sys.stdout.buffer.write(run.snapshot())
"""


LONG = """
import sys
from kitrobot.sim.jit import policy as jit_policy
from kitrobot.sim.jit.compiler import step
from tests.sim.teams import random_team
jit_policy.WORTH = 500
run = random_team(5, 10)
run.advance(60)
run.advance(1)
assert step.asked is not None, "600 steps of a robot are work enough"
step.asked.join()
run.advance(60)
assert not isinstance(run.state.clock, list), "the compiled step is there and not taken"
sys.stdout.buffer.write(run.snapshot())
"""


def test_a_long_run_asks_for_the_compiled_step_and_takes_it_when_it_is_there() -> None:
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}:{ROOT / 'src'}"}
    child = subprocess.run(
        [sys.executable, "-c", LONG], env=environment, capture_output=True, check=False, timeout=PATIENCE_S
    )
    assert child.returncode == 0, child.stderr.decode()
    here = random_team(5, 10)
    here.stays_plain = True
    for steps in (60, 1, 60):
        here.advance(steps)
    assert child.stdout == here.snapshot()


CROWD = """
import sys
from kitrobot.sim.jit.policy import expect_run
from kitrobot.sim.jit.compiler import step
from tests.sim.teams import random_team
expect_run(100)
assert step.asked is not None
step.asked.join()
run = random_team(5, 130)
run.advance(20)
run.advance(20)
assert not isinstance(run.state.clock, list), "it was there from the start and is not taken"
sys.stdout.buffer.write(run.snapshot())
"""


def test_for_a_crowd_the_compiled_step_is_asked_for_before_its_run_begins(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[bool] = []
    monkeypatch.setattr(jit_compiler.step, "ask", lambda: asked.append(True))
    expect_run(99)
    assert asked == [], "for so few it is not worth it"
    expect_run(100)
    assert asked == [True]


@pytest.mark.thorough("test_for_a_crowd_the_compiled_step_is_asked_for_before_its_run_begins; taken: a long run")
def test_what_a_crowd_needs_is_there_before_its_run_begins() -> None:
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}:{ROOT / 'src'}"}
    child = subprocess.run(
        [sys.executable, "-c", CROWD], env=environment, capture_output=True, check=False, timeout=PATIENCE_S
    )
    assert child.returncode == 0, child.stderr.decode()
    here = random_team(5, 130)
    here.stays_plain = True
    for _ in range(2):
        here.advance(20)
    assert child.stdout == here.snapshot()


QUICK = """
import os
import sys
from importlib.machinery import ModuleSpec

class config:
    CACHE_DIR = ""

class Compiled:
    def __init__(self):
        self.overloads = {(): self}

    def entry_point(self, tables, steps):
        return 0

    __call__ = entry_point

def register_jitable(**options):
    return lambda function: function

def overload(function, **options):
    return lambda replacement: replacement

def njit(**options):
    with open(os.path.join(os.environ["KITROBOT_CACHE"], "compiled-by"), "a") as said:
        said.write(f"{os.getpid()}\\n")
    return lambda function: Compiled()

__spec__ = ModuleSpec("numba", None)
extending = sys.modules["kitrobot.sim.jit.numba_tables"] = sys.modules[__name__]
"""
"""In place of Numba: compiles to functions that do nothing, and says which process asked."""

ASKED = """
from kitrobot.sim.jit.compiler import step
step.ask()
step.asked.join()
assert step.made is not None
"""


def test_what_is_not_kept_yet_is_compiled_in_a_process_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "numba.py").write_text(QUICK)
    path = os.pathsep.join(map(str, (tmp_path, ROOT, ROOT / "src")))
    environment = {**os.environ, "PYTHONPATH": path, "KITROBOT_CACHE": str(tmp_path)}
    for _ in range(2):
        subprocess.run([sys.executable, "-c", ASKED], env=environment, check=True, timeout=PATIENCE_S)
    assert [path.name for path in tmp_path.glob(f"*/{jit_cache.READY}")] == [jit_cache.READY]
    elsewhere, first, second = (tmp_path / "compiled-by").read_text().split()
    assert len({elsewhere, first, second}) == 3, "once more by each who asked, from what was compiled elsewhere"


SLOW = QUICK.replace(
    """    return lambda function: Compiled()
""",
    """    if "make_alone" in " ".join(sys.orig_argv):
        folder = os.environ["KITROBOT_CACHE"]
        said = os.open(os.path.join(folder, "said"), os.O_WRONLY)
        os.write(said, b"begun")
        open(os.path.join(folder, "go-on"), "rb").read()
    return lambda function: Compiled()
""",
)
"""The same, but that compiling takes until somebody says `go-on`; `said` ends with its process."""

LEFT = """
import os, sys
from kitrobot.sim.jit.compiler import step
step.ask()
sys.stdin.read()
os._exit(0)
"""


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the stand-in waits at a pipe with a name")
def test_what_is_begun_is_compiled_to_the_end_though_the_one_that_asked_has_ended(tmp_path: Path) -> None:
    """Meanwhile nobody else compiles: a second one that asks is refused."""
    (tmp_path / "numba.py").write_text(SLOW)
    os.mkfifo(tmp_path / "said")
    os.mkfifo(tmp_path / "go-on")
    path = os.pathsep.join(map(str, (tmp_path, ROOT, ROOT / "src")))
    environment = {**os.environ, "PYTHONPATH": path, "KITROBOT_CACHE": str(tmp_path)}
    with (
        subprocess.Popen([sys.executable, "-c", LEFT], env=environment, stdin=subprocess.PIPE) as first,
        open(tmp_path / "said", "rb", buffering=0) as said,
    ):
        assert said.read(5) == b"begun"
        first.communicate()
        subprocess.run([sys.executable, "-c", REFUSED], env=environment, check=True, timeout=PATIENCE_S)
        assert not list(tmp_path.glob(f"*/{jit_cache.READY}"))
        (tmp_path / "go-on").write_bytes(b"")
        assert said.read() == b"", "its process ends"
    assert len(list(tmp_path.glob(f"*/{jit_cache.READY}"))) == 1
    assert not (tmp_path / jit_cache.LOCK).exists()
    assert len((tmp_path / "compiled-by").read_text().split()) == 1
    subprocess.run([sys.executable, "-c", ASKED], env=environment, check=True, timeout=PATIENCE_S)


REFUSED = """
from kitrobot.sim.jit.compiler import step
step.ask()
thread = step.asked
thread.join()
assert step.made is None
step.ask()
assert step.asked is thread, "nothing is begun as long as another process compiles"
"""


def test_many_short_runs_ask_for_the_compiled_step_together(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[bool] = []
    monkeypatch.setattr(jit_compiler.step, "ask", lambda: asked.append(True))
    monkeypatch.setattr(jit_policy, "WORTH", 3000)
    monkeypatch.setattr(jit_policy, "done", jit_policy.Work())
    for _ in range(3):
        policy = jit_policy.JitPolicy(5)
        assert policy.compiled() is None
        assert asked == []
        policy.worked(200)
    assert jit_policy.JitPolicy(1).compiled() is jit_compiler.step.made is not None
    assert asked == [True]


@pytest.mark.slow
@pytest.mark.thorough("test_what_is_not_kept_yet_is_compiled_in_a_process_of_its_own, with a stand-in for Numba")
def test_numba_compiles_what_is_not_kept_yet(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}:{ROOT / 'src'}", "KITROBOT_CACHE": str(tmp_path)}
    subprocess.run([sys.executable, "-c", LONG], env=environment, capture_output=True, check=True, timeout=PATIENCE_S)
    assert [path.name for path in tmp_path.glob(f"*/{jit_cache.READY}")] == [jit_cache.READY]


@pytest.mark.parametrize("prelude", ["", "import sys; sys.modules['numba'] = None\n"])
def test_without_numba_or_when_told_so_the_run_is_plain_and_the_same(prelude: str) -> None:
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}:{ROOT / 'src'}"}
    if not prelude:
        environment["KITROBOT_COMPILE"] = "no"
    child = subprocess.run(
        [sys.executable, "-c", prelude + CHILD, "no"],
        env=environment,
        capture_output=True,
        check=False,
        timeout=PATIENCE_S,
    )
    assert child.returncode == 0, child.stderr.decode()
    here = hurried(transport(3, 3))
    here.advance(500)
    assert child.stdout == here.snapshot()


def test_what_is_kept_is_only_for_these_very_sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("KITROBOT_CACHE", str(tmp_path))
    folder = jit_compiler.cache_folder()
    assert folder.parent == tmp_path
    assert folder == jit_compiler.cache_folder()
    monkeypatch.setattr(jit_cache, "version", lambda package: f"{package} of tomorrow")
    assert jit_compiler.cache_folder() != folder


def test_every_loop_of_the_step_is_told_to_numba() -> None:
    names = {name.removeprefix("kitrobot.sim.") for name in jit_compiler.loops()}
    assert {
        "devices.range.sense",
        "step.execution.react",
        "physics.step.move_robots",
        "tables.random_numbers.gauss",
    } <= names


def test_a_machine_where_compiling_fails_goes_on_plain(tmp_path: Path) -> None:
    nowhere = tmp_path / "file"
    nowhere.write_text("no folder")
    environment = {
        **os.environ,
        "PYTHONPATH": f"{ROOT}:{ROOT / 'src'}",
        "KITROBOT_CACHE": str(nowhere),
    }
    subprocess.run(
        [sys.executable, "-c", CHILD, "no"], env=environment, capture_output=True, check=True, timeout=PATIENCE_S
    )
