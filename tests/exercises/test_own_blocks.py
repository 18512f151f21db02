"""What goals of programs see of own blocks: what they do, whatever they are called."""

from __future__ import annotations

import pytest

from kitrobot.checking.exercise_evaluation import collect_program_evidence
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.exercise.goals import AvoidanceGoal, Parts, UseGoal
from kitrobot.graph.model import Arc, Vertex
from kitrobot.lll.parse_results import parse
from kitrobot.mission.model import Mission
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.own_xml import read_own
from kitrobot.workspace.mission_loader import open_mission, with_mission
from kitrobot.workspace.search_path import SearchPath
from tests.exercises.handing_in import FOLDER


def block(name: str, code: str, slots: str = "") -> Constructor:
    made, problems = read_own([f'<constructor name="{name}">{slots}<code>{code}</code></constructor>'], "x")
    assert isinstance(made, Constructor), problems
    return made


def with_blocks(*blocks: Constructor, text: str = "Wheel.Stop();", uses: int = 1) -> Mission:
    """The mission of the third exercise; its program is `text`, and then each of the blocks."""
    opened = open_mission(FOLDER / "03-square.krt")
    (program,) = opened.mission.programs
    robot = opened.catalogue.robots[program.target]
    drawn = lll_to_graph(parse(text, "x").program, robot, opened.catalogue, program.name)
    end = next(arc for arc in drawn.arcs if arc.target == "stop")
    for number, one in enumerate([one for one in blocks for _ in range(uses)]):
        settings = {slot.name: "3" for slot in one.slots}
        drawn.vertices.insert(-1, Vertex(f"own{number}", one.name, settings))
        end.target, end = f"own{number}", Arc(f"own{number}", "stop")
        drawn.arcs.append(end)
    opened.mission.programs = [drawn]
    opened.mission.constructors = list(blocks)
    return opened.mission


def seen(mission: Mission, given: tuple[Constructor, ...] = ()):
    return collect_program_evidence(with_mission(mission, "x.krt", SearchPath(FOLDER)), given)


def uses(part: str, times: int = 1) -> UseGoal:
    return UseGoal({}, 1, False, "", part, times)


def avoids(part: str) -> AvoidanceGoal:
    return AvoidanceGoal({}, 1, False, "", part)


LOOP = block("Thrice", "3*(Wheel.Advance(50); WAIT(5);)")


def test_what_a_block_would_be_drawn_as_is_in_the_program():
    found = seen(with_blocks(LOOP))
    assert uses("Repetition").fault(found) is None
    assert avoids("Wait").fault(found) is not None
    assert uses("Wheel.Advance").fault(found) is None
    assert uses("Wait", 2).fault(found) is not None


@pytest.mark.parametrize("name", ["Repetition", "Wait", "Wait Until"])
@pytest.mark.parametrize(("code", "part"), [("WAIT(9)", "Wait"), ("2*(WAIT(1);)", "Repetition")])
def test_a_block_is_no_part_of_ours_for_its_name(name, code, part):
    found = seen(with_blocks(block(name, code)))
    assert uses(part).fault(found) is None
    if name not in (part, "Wait"):
        assert uses(name).fault(found) is not None
        assert avoids(name).fault(found) is None


def test_holes_are_no_parts_and_what_stands_around_them_is():
    hop = block("Hop", "{times}*(WAIT({times});)", '<number name="times" min="1" max="9" default="2"/>')
    found = seen(with_blocks(hop))
    assert uses("Repetition").fault(found) is None
    # Wheel.Stop, the block, and in it a repetition and a wait.
    assert Parts({}, 1, False, "", 4).fault(found) is None
    assert Parts({}, 1, False, "", 3).fault(found) is not None


def test_a_block_counts_once_however_often_it_stands():
    found = seen(with_blocks(LOOP, uses=3))
    assert uses("Repetition", 2).fault(found) is not None
    assert Parts({}, 1, False, "", 7).fault(found) is None
    assert Parts({}, 1, False, "", 6).fault(found) is not None


def test_a_condition_of_ones_own_is_looked_into():
    near = block("Near", "Captor.LessThan(10) &amp; !(Button.IsPressed())")
    mission = with_blocks(text="[Captor.LessThan(9)](Wheel.Stop(););")
    mission.constructors = [near]
    for vertex in mission.programs[0].vertices:
        if vertex.element == "Captor.LessThan":
            vertex.element, vertex.settings = "Near", {}
    found = seen(mission)
    for part in ("And", "No", "Button.IsPressed", "Captor.LessThan"):
        assert uses(part).fault(found) is None


def test_a_block_of_the_exercise_counts_by_its_name_as_long_as_it_is_that_block():
    assert uses("Thrice").fault(seen(with_blocks(LOOP), (LOOP,))) is None
    assert uses("Thrice").fault(seen(with_blocks(LOOP))) is not None
    other = block("Thrice", "WAIT(9)")
    assert uses("Thrice").fault(seen(with_blocks(other), (LOOP,))) is not None
