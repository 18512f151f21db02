"""Missions built in Python: checked, run, stepped, intervened in, gone on with elsewhere, and saved."""

from __future__ import annotations

import inspect
import math
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import kitrobot
from kitrobot import (
    Agent,
    Arc,
    Ball,
    Box,
    Corner,
    Dock,
    Failure,
    Goal,
    Mission,
    OpenMission,
    Pose,
    Program,
    Road,
    RunOptions,
    Simulation,
    Start,
    Storehouse,
    Team,
    Vertex,
    Wall,
    World,
)
from kitrobot.cli.run import run_mission
from kitrobot.cli.team import run_team
from kitrobot.mission.breakdown import Breakdown, BreakdownRule
from kitrobot.mission.model import DEFAULT_SEED
from kitrobot.mission.radio import Radio
from kitrobot.sim.recorder import Recorder

TEXT = "//( <Captor.LessThan(20)>();, °Wheel.Advance(50)°; ); Count.Add(1);"
PLACES = {"ada": Pose(200, 300, 0.0), "bob": Pose(500, 150, 0.1234567)}
WORLD = World(
    "yard",
    1000,
    600,
    walls=(Wall(900, 0, 900, 600),),
    starts=tuple(Start(name, pose=pose) for name, pose in PLACES.items()),
)


def mission(world: World = WORLD, text: str = TEXT, **more: Any) -> Mission:
    program = kitrobot.read_program(text, "mini-robot", "approach")
    team = Team([Agent(start.name, "approach") for start in WORLD.starts])
    return Mission(programs=[program], team=team, own_world=world, **more)


@pytest.fixture
def opened() -> OpenMission:
    return kitrobot.open_mission(mission())


def finished(simulation: Simulation) -> Simulation:
    while simulation.outcome is None:
        simulation.step()
    return simulation


def test_a_mission_without_a_file_runs(opened: OpenMission) -> None:
    assert opened.check().problems == ()
    run = opened.run()
    assert (run.outcome, run.ticks) == ("done", 118)


def test_storehouses_a_road_docks_goals_and_things_can_be_built() -> None:
    corners = (Corner(300, 300, 100), Corner(1700, 300, 100), Corner(1700, 900, 100), Corner(300, 900, 100))
    world = World(
        "ring",
        2000,
        1200,
        roads=(Road("ring", 200, True, corners),),
        storehouses=(
            Storehouse("A", 700, 20, 200, 100, capacity=5, stock=1),
            Storehouse("B", 1300, 20, 200, 100, 5, 0),
        ),
        docks=(
            Dock("In", "ring", 500, 20, "A", "load", "right"),
            Dock("Out", "ring", 1100, 20, "B", "unload", "right"),
        ),
        starts=(Start("c", road="ring", at_mm=400), Start("l", dock="In")),
        boxes=(Box(1000, 600, 60, 60, 50, 0.5),),
        balls=(Ball(1200, 600, 20, 50, 0.5),),
    )
    wait = kitrobot.read_program("WAIT(5);", "carrier", "wait")
    help_ = kitrobot.read_program("WAIT(5);", "loader", "help")
    team = Team([Agent("c", "wait"), Agent("l", "help")], [Goal("B", "0")])
    one = kitrobot.open_mission(Mission(programs=[wait, help_], team=team, own_world=world))
    assert [problem.message for problem in one.check().problems if problem.is_error] == []
    run = one.simulation()
    assert run.things == [(1000, 600), (1200, 600)]
    assert run.stock == {"A": 1, "B": 0}
    assert finished(run).sentence == "Done after 0.5 s: B holds 0 boxes."


def test_a_graph_built_by_hand_is_the_program_of_its_text() -> None:
    built = Program("p", "mini-robot")
    built.vertices = [Vertex("a", "Start"), Vertex("b", "Wheel.Advance", {"speed": "50"}), Vertex("c", "Stop")]
    built.arcs = [Arc("a", "b"), Arc("b", "c")]
    text = kitrobot.compile("Wheel.Advance(50);", "mini-robot")
    assert kitrobot.compile_program(built, "mini-robot").image == text.image


def test_a_mission_is_opened_as_it_is_now(opened: OpenMission) -> None:
    one = mission()
    copy = kitrobot.open_mission(one)
    one.team.agents.clear()
    assert copy.run().ticks == opened.run().ticks


def test_kinds_of_robots_are_found_in_the_folder(tmp_path: Path) -> None:
    (tmp_path / "r.robot.xml").write_text(
        '<robot name="r" version="1"><actuator name="Arm" device="lamp"><procedure name="LightOn"/></actuator></robot>'
    )
    program = kitrobot.read_program("WAIT(1);", tmp_path / "r.robot.xml", "p")
    one = Mission(programs=[program], team=Team([Agent("ada", "p")]), own_world=WORLD)
    assert not kitrobot.open_mission(one).check().ok
    assert kitrobot.open_mission(one, folder=tmp_path).run().outcome == "done"


# -- the same run as the command line's


def test_the_recording_is_that_of_the_command_line(tmp_path: Path, opened: OpenMission) -> None:
    kitrobot.save_mission(mission(), tmp_path / "yard.krt")
    opened.run(seed=7, trace=str(tmp_path / "api.krtrace"))
    command = [sys.executable, "-m", "kitrobot", "run", "yard.krt", "--seed", "7", "--trace", "cli.krtrace"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    assert (tmp_path / "api.krtrace").read_bytes() == (tmp_path / "cli.krtrace").read_bytes()


def test_a_stepped_run_is_the_run_of_the_saved_file_tick_by_tick(tmp_path: Path, opened: OpenMission) -> None:
    kitrobot.save_mission(mission(), tmp_path / "yard.krt")
    runs = [opened.simulation(), kitrobot.open_mission(tmp_path / "yard.krt").simulation()]
    recorders = [Recorder(run) for run in runs]
    assert recorders[0].header == recorders[1].header
    while runs[0].outcome is None:
        assert recorders[0].record() == recorders[1].record()
        for run in runs:
            run.step()
    assert runs[1].outcome == "done"


@pytest.mark.parametrize(
    "function",
    [Simulation, RunOptions, OpenMission.run, OpenMission.simulation, run_mission, run_team],
    ids=lambda function: function.__qualname__,
)
def test_the_seed_is_the_same_everywhere_where_nothing_is_said(function: Callable[..., object]) -> None:
    assert inspect.signature(function).parameters["seed"].default == DEFAULT_SEED == 1


# -- interventions, and snapshots


def test_what_is_done_to_a_run_changes_it(opened: OpenMission) -> None:
    run = opened.simulation()
    run.advance(20)
    run.force("ada", "Captor", 5)
    run.set_variable("ada", "Count", 40)
    run.inject_fault("bob", "fail")
    assert run.forced("ada") == ["Captor"]
    finished(run)
    assert run.agent("ada").values["Count"] == 41
    assert run.agent("ada").inputs["Captor"] == 5
    assert (run.agent("bob").state, run.outcome) == ("failed", "failed")


def test_a_failure_on_the_schedule_is_the_failure_by_hand() -> None:
    planned = finished(kitrobot.open_mission(mission(failures=[Failure("bob", 0.4)])).simulation())
    by_hand = kitrobot.open_mission(mission()).simulation()
    by_hand.advance(20)
    by_hand.inject_fault("bob", "fail")
    assert finished(by_hand).poses() == planned.poses()


GO_ON = """
import sys, kitrobot
simulation = kitrobot.open_mission("yard.krt").simulation(seed=3)
simulation.restore(open("kept", "rb").read())
while simulation.outcome is None:
    simulation.step()
sys.stdout.buffer.write(simulation.snapshot())
"""


def test_another_process_goes_on_from_a_snapshot_with_what_was_forced(tmp_path: Path) -> None:
    kitrobot.save_mission(mission(), tmp_path / "yard.krt")
    run = kitrobot.open_mission(mission()).simulation(seed=3)
    run.advance(20)
    run.force("ada", "Captor", 50)
    run.set_variable("bob", "Count", 9)
    (tmp_path / "kept").write_bytes(run.snapshot())
    run.advance(2)
    run.force("ada", "Captor", None)
    run.restore((tmp_path / "kept").read_bytes())
    assert (run.tick, run.forced("ada")) == (20, ["Captor"])
    command = [sys.executable, "-c", GO_ON]
    went_on = subprocess.run(command, cwd=tmp_path, capture_output=True, check=True)
    assert went_on.stdout == finished(run).snapshot()


# -- what is wrong


def start(pose: Pose) -> World:
    return replace(WORLD, starts=(Start("ada", pose=pose), WORLD.starts[1]))


@pytest.mark.parametrize(
    ("wrong", "code"),
    [
        (mission(start(Pose(2000, 300, 0))), "world-outside"),
        (mission(start(Pose(math.nan, 300, 0))), "xml-bad-value"),
        (mission(start(Pose(200, 300, math.inf))), "xml-bad-value"),
        (mission(start(Pose(900, 300, 0))), "world-start"),
        (mission(replace(WORLD, starts=WORLD.starts[:1])), "mission-no-start"),
        (mission(replace(WORLD, width_mm=-1)), "xml-bad-value"),
        (mission(replace(WORLD, docks=(Dock("D", "nowhere", 0, 10, "A", "load"),))), "world-unknown-name"),
        (replace(mission(), team=Team([Agent("ada", "aproach")])), "mission-no-program"),
        (replace(mission(), team=Team([Agent("ada", "approach"), Agent("ada", "approach")])), "xml-duplicate"),
        (replace(mission(), team=Team([Agent("ada", "approach")], [Goal("Z", "1")])), "mission-no-storehouse"),
        (mission(failures=[Failure("bob", math.nan)]), "xml-bad-value"),
        (mission(failures=[Failure("bob", -1)]), "xml-bad-value"),
        (mission(breakdown=Breakdown(BreakdownRule.TOW, math.nan)), "xml-bad-value"),
        (mission(radio=Radio(math.nan)), "xml-bad-value"),
        (Mission(), "run-no-agent"),
        (replace(mission(), programs=[Program("approach", "nobody")]), "mission-no-robot"),
        (replace(mission(), programs=[Program("approach", "mini-robot", [Vertex("a", "Start")])]), "start-stop"),
    ],
)
def test_a_mission_that_does_not_fit_says_so_and_does_not_run(wrong: Mission, code: str) -> None:
    opened = kitrobot.open_mission(wrong)
    assert code in [problem.code for problem in opened.check().problems if problem.is_error]
    with pytest.raises(kitrobot.ProblemsError, match="has errors, so it was not run") as caught:
        opened.simulation()
    assert code in str(caught.value)
    assert "help: " in str(caught.value)


def test_very_many_mistakes_are_counted_in_the_text_of_the_error() -> None:
    walls = tuple(Wall(0, -1, 0, -2 - n) for n in range(15))
    opened = kitrobot.open_mission(mission(replace(WORLD, walls=walls)))
    with pytest.raises(kitrobot.ProblemsError, match="5 more in `diagnostics`") as caught:
        opened.run()
    assert len(caught.value.diagnostics) == 15


def test_a_text_with_mistakes_makes_no_graph_and_tells_all_of_them() -> None:
    with pytest.raises(kitrobot.ProblemsError, match="the program `p` has errors") as caught:
        kitrobot.read_program("Weel.Advance(50); Wheel.Advance(101);", "mini-robot", "p")
    assert [problem.code for problem in caught.value.diagnostics] == ["unknown-object", "out-of-range"]
    assert "did you mean Wheel?" in str(caught.value)


@pytest.mark.parametrize(
    ("act", "sentence"),
    [
        (
            lambda run: run.force("eve", "Captor", 1),
            "no agent eve with a sensor Captor.*\nhelp: those who do are ada or",
        ),
        (lambda run: run.force("adda", "Captor", 1), "no agent adda.*\nhelp: did you mean ada"),
        (lambda run: run.force("ada", "Captr", 1), "a sensor Captr.*\nhelp: did you mean Captor"),
        (lambda run: run.force("ada", "Captor", math.nan), "expected a whole number, found `nan`\nhelp: "),
        (lambda run: run.force("ada", "Captor", 2.5), "expected a whole number, found `2.5`\nhelp: "),
        (lambda run: run.set_variable("ada", "Xyzzy", 1), "a variable Xyzzy.*\nhelp: it has Count, "),
        (lambda run: run.set_variable("ada", "Count", "1"), "expected a whole number, found `1`\nhelp: "),
        (lambda run: run.inject_fault("eve", "fail"), "no agent eve takes part.*\nhelp: "),
        (lambda run: run.inject_fault("ada", "stal"), "expected fail, .* found “stal”\nhelp: did you mean stall"),
        (lambda run: run.agent("eve"), "no agent eve takes part.*\nhelp: "),
        (lambda run: run.forced("eve"), "no agent eve takes part.*\nhelp: "),
        (lambda run: run.restore(b""), "not a whole snapshot.*\nhelp: "),
        (lambda run: run.restore(run.snapshot()[:-1]), "not a whole snapshot.*\nhelp: "),
        (lambda run: run.restore(run.snapshot()[:50]), "not a whole snapshot.*\nhelp: "),
    ],
)
def test_what_cannot_be_done_to_a_run_is_said_and_changes_nothing(
    opened: OpenMission, act: Callable[[Simulation], object], sentence: str
) -> None:
    run = opened.simulation()
    run.advance(5)
    before = run.snapshot()
    with pytest.raises(kitrobot.KitRobotError, match=sentence):
        act(run)
    assert run.snapshot() == before


@pytest.mark.parametrize("other", [{"seed": 2}, {"seconds": 9.0}, {"fail_rate": 0.5}])
def test_a_snapshot_of_another_run_is_refused(opened: OpenMission, other: dict[str, Any]) -> None:
    with pytest.raises(kitrobot.KitRobotError, match="this snapshot is of another run\nhelp: "):
        opened.simulation().restore(opened.simulation(**other).snapshot())
    with pytest.raises(kitrobot.KitRobotError, match="this snapshot is of another run\nhelp: "):
        opened.simulation().restore(kitrobot.open_mission("transport").simulation().snapshot())


def test_no_step_is_made_after_the_end(opened: OpenMission) -> None:
    run = finished(opened.simulation())
    with pytest.raises(kitrobot.KitRobotError, match="the run has ended, so there is no step after 118\nhelp: "):
        run.step()
    assert run.advance(5) == 0


@pytest.mark.parametrize(
    ("numbers", "sentence"),
    [
        ({"seed": -1}, "expected a seed from 0"),
        ({"seed": 1.5}, "expected a whole number, found `1.5`"),
        ({"seed": math.nan}, "expected a whole number, found `nan`"),
        ({"seconds": math.nan}, "expected a time limit"),
        ({"seconds": 0.0}, "expected a time limit"),
        ({"fail_rate": math.nan}, "expected a probability"),
        ({"fail_rate": 1.1}, "expected a probability"),
    ],
)
def test_numbers_that_make_no_sense_are_refused(opened: OpenMission, numbers: dict[str, Any], sentence: str) -> None:
    for begin in (opened.simulation, opened.run):
        with pytest.raises(kitrobot.KitRobotError, match=f"{sentence}.*\nhelp: "):
            begin(**numbers)


def test_a_mission_that_cannot_be_saved_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(kitrobot.KitRobotError, match="there is no folder"):
        kitrobot.save_mission(mission(), tmp_path / "nowhere" / "m.krt")


# -- the door


def test_importing_the_package_imports_nothing_of_it() -> None:
    code = "import sys; before = set(sys.modules); import kitrobot; print(sorted(set(sys.modules) - before))"
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert [name for name in eval(printed) if name != "__future__"] == ["kitrobot"]
