"""Two people's edits brought together: both stand, or a sentence says which does not; the result always opens."""

from __future__ import annotations

import copy
import random
from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.compilation import compile_program
from kitrobot.graph.model import Arc, Note, Program, Vertex
from kitrobot.lll.tree import FAILURES, GroupDeclaration, Members, RoleDeclaration, WorkDeclaration
from kitrobot.mission.model import Agent, Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.versions.mission_merge import merge_missions
from kitrobot.workspace.mission_loader import new_mission

CATALOGUE = load_catalogue()
TEXT = """<kitrobot version="1">
  <program name="p" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="While"/>
    <vertex id="v2" element="Run.IsTrue"/>
    <vertex id="v3" element="Wheel.Advance"><set name="speed">50</set></vertex>
    <vertex id="v4" element="Wait"><set name="duration">5</set></vertex>
    <vertex id="v5" element="If Then"/>
    <vertex id="v6" element="Run.IsTrue"/>
    <vertex id="v7" element="Light.LightOn"/>
    <vertex id="v8" element="Wait"><set name="duration">8</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v2" to="v1" at="condition"/>
    <arc from="v1" out="body" to="v3"/>
    <arc from="v3" to="v4"/>
    <arc from="v4" to="v5"/>
    <arc from="v6" to="v5" at="condition"/>
    <arc from="v5" out="then" to="v7"/>
    <arc from="v7" to="v5" at="return"/>
    <arc from="v5" to="v1" at="return"/>
    <arc from="v1" to="v8"/>
    <arc from="v8" to="stop"/>
  </program>
  <program name="q" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wait"><set name="duration">1</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="p"/>
  </team>
</kitrobot>
"""


def base():
    mission, problems = read_mission(TEXT.encode(), "base.krt")
    assert mission is not None
    assert problems == []
    return mission


def errors(mission: Mission) -> Counter:
    found: Counter = Counter()
    for program in mission.programs:
        found.update(item.code for item in compile_program(program, CATALOGUE).diagnostics if item.is_error)
    return found


def insert(program: Program, after: str, out: str, id: str, element: str = "Wait", **settings: str) -> None:
    arc = next(arc for arc in program.arcs if (arc.source, arc.out) == (after, out))
    program.vertices.insert(-1, Vertex(id, element, settings or {"duration": "3"}))
    program.arcs.append(Arc(id, arc.target, "next", arc.at))
    arc.target, arc.at = id, "in"


def delete(program: Program, id: str) -> None:
    """Takes an instruction out of its chain."""
    onward = next(arc for arc in program.arcs if arc.source == id and arc.out == "next")
    for arc in program.arcs:
        if arc.target == id and arc.at == "in":
            arc.target, arc.at = onward.target, onward.at
    program.arcs.remove(onward)
    program.vertices = [vertex for vertex in program.vertices if vertex.id != id]


def declare(mission: Mission, dice: random.Random) -> None:
    """Adds, changes or removes a declaration of the team."""
    name, team = dice.choice("abc"), mission.team
    made = {
        "roles": RoleDeclaration(name, "mini-robot", 1, dice.randint(1, 3)),
        "groups": GroupDeclaration(name, Members(["robot-1", "a"]), dice.choice(FAILURES)),
        "works": WorkDeclaration(name, dice.randrange(9), after=dice.choice((None, "x"))),
    }
    what = dice.choice(list(made))
    rows = [one for one in getattr(team, what) if one.name != name]
    setattr(team, what, rows if dice.random() < 0.3 else [*rows, made[what]])


def edited(mission: Mission, seed: int, count: int) -> Mission:
    """A copy with random edits."""
    dice = random.Random(seed)
    mission = copy.deepcopy(mission)
    for step in range(count):
        program = dice.choice(mission.programs)
        flow = [arc for arc in program.arcs if arc.at in ("in", "return")]
        plain = [vertex for vertex in program.vertices if vertex.element in ("Wait", "Light.LightOn", "Wheel.Advance")]
        match dice.randrange(8):
            case 0 | 1:
                arc = dice.choice(flow)
                number = max(int(vertex.id[1:]) for vertex in program.vertices if vertex.id[1:].isdigit()) + 1
                insert(program, arc.source, arc.out, f"v{number}", duration=str(dice.randrange(100)))
            case 2 if plain:
                vertex = dice.choice(plain)
                if vertex.settings:
                    vertex.settings = {name: str(dice.randrange(100)) for name in vertex.settings}
            case 3 if len(plain) > 1:
                delete(program, dice.choice(plain).id)
            case 4:
                dice.choice(program.vertices).notes = [Note(f"note {dice.randrange(9)}")]
            case 5:
                mission.team.agents.append(Agent(f"r{seed}-{step}", program.name))
            case 6:
                program.name = dice.choice([program.name, f"name-{seed}-{step}"])
                names = {one.name for one in mission.programs}
                mission.team.agents = [agent for agent in mission.team.agents if agent.program in names]
            case 7:
                declare(mission, dice)
    return mission


@given(st.integers(0, 10**6), st.integers(0, 6))
def test_what_only_one_side_did_is_the_result(seed, count):
    side = edited(base(), seed, count)
    for ours, theirs in ((base(), side), (side, base()), (side, side)):
        merged = merge_missions(base(), ours, theirs)
        assert (merged.mission, merged.conflicts) == (side, ())


@given(st.integers(0, 10**6), st.integers(0, 10**6), st.integers(1, 4), st.integers(1, 4))
def test_the_result_opens_without_mistakes_that_neither_side_had(one, other, count, more):
    ours, theirs = edited(base(), one, count), edited(base(), other + 1, more)
    merged = merge_missions(base(), ours, theirs)
    read, problems = read_mission(write_mission(merged.mission), "merged.krt")
    assert problems == []
    assert read == merged.mission
    assert errors(merged.mission) <= errors(ours) + errors(theirs)


@given(st.integers(0, 10**6), st.integers(0, 10**6))
def test_edits_of_different_programs_both_stand(one, other):
    ours, theirs = base(), base()
    ours.programs[0] = edited(Mission(programs=[ours.programs[0]]), one, 3).programs[0]
    theirs.programs[1] = edited(Mission(programs=[theirs.programs[1]]), other, 3).programs[0]
    ours.programs[0].name, theirs.programs[1].name = "p", "q"
    merged = merge_missions(base(), ours, theirs)
    assert merged.conflicts == ()
    assert merged.mission.programs == [ours.programs[0], theirs.programs[1]]


def test_insertions_at_different_places_of_one_chain_both_stand_with_ids_of_their_own():
    ours, theirs = base(), base()
    insert(ours.programs[0], "v3", "next", "v9", duration="33")
    insert(theirs.programs[0], "v4", "next", "v9", duration="44")
    merged = merge_missions(base(), ours, theirs)
    assert merged.conflicts == ()
    program = merged.mission.programs[0]
    assert {vertex.settings.get("duration") for vertex in program.vertices} >= {"33", "44"}
    assert len({vertex.id for vertex in program.vertices}) == len(program.vertices)
    assert errors(merged.mission) == errors(base())


def test_two_settings_of_one_instruction_both_stand():
    ours, theirs = base(), base()
    ours.programs[0].vertices[3].settings["speed"] = "20"
    theirs.programs[0].vertices[3].notes = [Note("fast")]
    merged = merge_missions(base(), ours, theirs)
    assert merged.conflicts == ()
    assert merged.mission.programs[0].vertices[3] == Vertex("v3", "Wheel.Advance", {"speed": "20"}, [Note("fast")])


def test_one_setting_changed_differently_is_a_conflict_that_ours_wins_and_the_rest_still_merges():
    ours, theirs = base(), base()
    ours.programs[0].vertices[3].settings["speed"] = "20"
    theirs.programs[0].vertices[3].settings["speed"] = "30"
    theirs.programs[0].vertices[4].settings["duration"] = "9"
    merged = merge_missions(base(), ours, theirs)
    assert merged.conflicts == ("p: the speed of Wheel.Advance (v3) was changed in both: ours is kept",)
    assert merged.mission.programs[0].vertices[3].settings == {"speed": "20"}
    assert merged.mission.programs[0].vertices[4].settings == {"duration": "9"}


def test_one_place_filled_differently_is_a_conflict():
    ours, theirs = base(), base()
    insert(ours.programs[0], "v3", "next", "v9", duration="33")
    insert(theirs.programs[0], "v3", "next", "v10", duration="44")
    merged = merge_missions(base(), ours, theirs)
    assert len(merged.conflicts) == 1
    assert merged.mission == ours


def test_a_program_renamed_by_one_and_changed_by_the_other_is_both():
    ours, theirs = base(), base()
    ours.programs[0].name = ours.team.agents[0].program = "new"
    theirs.programs[0].vertices[3].settings["speed"] = "30"
    theirs.team.agents.append(Agent("robot-2", "p"))
    merged = merge_missions(base(), ours, theirs)
    assert merged.conflicts == ()
    assert [program.name for program in merged.mission.programs] == ["new", "q"]
    assert merged.mission.programs[0].vertices[3].settings == {"speed": "30"}
    assert [agent.program for agent in merged.mission.team.agents] == ["new", "new"]


def test_a_program_removed_by_one_and_run_by_the_others_new_agent_is_kept_with_a_word():
    ours, theirs = base(), base()
    del ours.programs[1]
    theirs.team.agents.append(Agent("robot-2", "q"))
    merged = merge_missions(base(), ours, theirs)
    assert len(merged.conflicts) == 1
    assert [program.name for program in merged.mission.programs] == ["p", "q"]


@pytest.mark.parametrize("ours_first", [True, False])
def test_a_program_removed_by_one_and_changed_by_the_other_is_a_conflict(ours_first):
    gone, changed = base(), base()
    del gone.programs[1]
    changed.programs[1].vertices[1].settings["duration"] = "7"
    sides = (gone, changed) if ours_first else (changed, gone)
    merged = merge_missions(base(), *sides)
    assert len(merged.conflicts) == 1
    assert merged.mission == sides[0]


def test_both_added_the_file():
    merged = merge_missions(Mission(), new_mission(), base())
    assert [program.name for program in merged.mission.programs] == ["program-1", "p", "q"]


def test_each_conflict_is_decided_by_its_name_and_the_others_stay_ours():
    ours, theirs = base(), base()
    for side, speed, duration in ((ours, "20", "8"), (theirs, "30", "9")):
        side.programs[0].vertices[3].settings["speed"] = speed
        side.programs[0].vertices[4].settings["duration"] = duration
    both = merge_missions(base(), ours, theirs)
    first, second = both.clashes
    assert (first.ours, first.theirs, first.taken, first.open) == ("20", "30", False, True)
    decided = merge_missions(base(), ours, theirs, {first.name})
    assert decided.conflicts == (
        "p: the speed of Wheel.Advance (v3) was changed in both: theirs is taken",
        "p: the duration of Wait (v4) was changed in both: ours is kept",
    )
    assert [vertex.settings for vertex in decided.mission.programs[0].vertices[3:5]] == [
        {"speed": "30"},
        {"duration": "8"},
    ]
    assert merge_missions(base(), ours, theirs, {first.name, second.name, "nothing"}).mission == theirs


def test_a_place_filled_by_both_and_a_program_removed_by_one_can_be_theirs():
    ours, theirs = base(), base()
    insert(ours.programs[0], "v3", "next", "v9", duration="33")
    insert(theirs.programs[0], "v3", "next", "v10", duration="44")
    del ours.programs[1]
    theirs.programs[1].vertices[1].settings["duration"] = "7"
    names = [one.name for one in merge_missions(base(), ours, theirs).clashes]
    assert merge_missions(base(), ours, theirs, names).mission == theirs
    assert merge_missions(base(), theirs, ours, names).mission == ours
