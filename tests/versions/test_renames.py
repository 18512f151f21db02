"""A name that one side changed goes on meaning the same thing in what the other side did, whatever it names."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.trial import Breakpoint, Failure, FailureKind
from kitrobot.mission.writer import write_mission
from kitrobot.versions.mission_merge import merge_missions
from kitrobot.versions.references import NameKind
from kitrobot.workspace.file_merge import merge_checked
from kitrobot.workspace.mission_loader import read_mission_data
from kitrobot.workspace.search_path import SearchPath

TEXT = """<kitrobot version="1">
  <constructor name="Hop"><number name="times" min="1" max="9" default="2"/>
    <code>{times}*(Wheel.Advance(50); Trips.Set(1); WAIT(1))</code></constructor>
  <variable robot="mini-robot" name="Trips" min="0" max="9" initial="2"/>
  <program name="all" level="social">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="SeqOfPar"><set name="members">walkers</set></vertex>
    <vertex id="v2" element="Program"><set name="name">search</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" out="body" to="v2"/>
    <arc from="v2" to="v1" at="return"/>
    <arc from="v1" to="stop"/>
  </program>
  <program name="search" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Trips.Set"><set name="value">1</set></vertex>
    <vertex id="v2" element="Hop"><set name="times">3</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="v2"/>
    <arc from="v2" to="stop"/>
  </program>
  <program name="alone" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wait"><set name="duration">1</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="ada" program="all" start="west" robot="mini-robot"/>
    <agent name="bob" program="all" start="east" robot="mini-robot"/>
    <goal storehouse="depot" stock="3"/>
    <role name="walkers" robot="mini-robot" most="2"/>
    <group name="crowd" members="walkers"/>
    <work name="rooms" units="4"/>
  </team>
  <world version="1" name="yard" width="3000" height="3000">
    <road name="way" width="200"><point x="500" y="500"/><point x="2500" y="500"/></road>
    <storehouse name="depot" x="800" y="900" width="300" height="200" capacity="9" stock="3"/>
    <dock name="gate" road="way" at="500" reach="80" storehouse="depot" kind="load"/>
    <start name="west" x="1000" y="2000"/>
    <start name="east" x="2000" y="2000"/>
    <start name="north" x="1500" y="2500"/>
  </world>
</kitrobot>
"""


def put(text: str, before: str, *lines: str) -> str:
    """The text with lines before the first place where `before` stands."""
    assert before in text
    return text.replace(before, "".join(f"{line}\n" for line in lines) + before, 1)


def in_program(text: str, name: str, element: str, settings: dict[str, str], inside: str = "") -> str:
    """The text with one more vertex at the end of a program, and in it a vertex `inside`, as XML."""
    head, found, rest = text.partition(f'<program name="{name}"')
    program, end, rest = rest.partition("</program>")
    sets = "".join(f'<set name="{field}">{value}</set>' for field, value in settings.items())
    vertices = inside + f'<vertex id="v9" element="{element}">{sets}</vertex>'
    arcs = '<arc from="v9" to="stop"/>'
    if inside:
        arcs += '<arc from="v9" out="body" to="v8"/><arc from="v8" to="v9" at="return"/>'
    program = program.replace('<vertex id="stop"', vertices + '<vertex id="stop"')
    program = re.sub(r'<arc from="(v[12])" to="stop"/>', rf'<arc from="\1" to="v9"/>{arcs}', program)
    return head + found + program + end + rest


def in_block(text: str, members: str, inside: str) -> str:
    """The text with one more line that a set of the team does."""
    return in_program(text, "all", "SeqOfPar", {"members": members}, inside)


def condition(name: str, text: str) -> str:
    return f'  <property name="{name}" eventually="{text}"/>'


TRIAL = "  <world version"
USES = {
    NameKind.VARIABLE: (
        "Trips",
        "Laps",
        [
            lambda text: in_program(text, "search", "Trips.Add", {"value": "2"}),
            lambda text: put(text, TRIAL, '  <breakpoint program="search" vertex="v1" when="Trips.LessThan(3)"/>'),
            lambda text: put(text, TRIAL, condition("often", "any ada (Trips.EqualTo(3))")),
            lambda text: put(
                text, "  <variable", '<constructor name="Skip"><code>Trips.Set(4); WAIT(2)</code></constructor>'
            ),
            lambda text: in_block(
                text, "walkers", '<vertex id="v8" element="Trips.Set"><set name="value">5</set></vertex>'
            ),
        ],
    ),
    NameKind.PART: (
        "Hop",
        "Jump",
        [lambda text: in_program(text, "alone", "Hop", {"times": "4"})],
    ),
    NameKind.ROAD: (
        "way",
        "street",
        [lambda text: put(text, '    <start name="west"', '    <start name="curb" road="way" at="900"/>')],
    ),
    NameKind.STOREHOUSE: (
        "depot",
        "barn",
        [
            lambda text: text.replace('"depot" stock="3"/>\n    <role', '"depot" stock="2"/>\n    <role'),
            lambda text: put(
                text,
                "    <start",
                '    <dock name="exit" road="way" at="1500" reach="80" storehouse="depot" kind="unload"/>',
            ),
            lambda text: put(text, "    <start", '    <start name="inside" storehouse="depot"/>'),
        ],
    ),
    NameKind.DOCK: (
        "gate",
        "door",
        [lambda text: put(text, "    <start", '    <start name="docked" dock="gate"/>')],
    ),
    NameKind.START: (
        "north",
        "top",
        [
            lambda text: put(
                text, "    <goal", '    <agent name="eve" program="all" start="north" robot="mini-robot"/>'
            ),
            lambda text: put(text, "    <goal", '    <agent name="north" program="all" robot="mini-robot"/>'),
            lambda text: text.replace('start="west"', 'start="north"'),
        ],
    ),
    NameKind.PROGRAM: (
        "search",
        "look-round",
        [
            lambda text: put(text, TRIAL, '  <breakpoint program="search" vertex="v1"/>'),
            lambda text: in_block(
                text, "walkers", '<vertex id="v8" element="Program"><set name="name">search</set></vertex>'
            ),
        ],
    ),
    NameKind.AGENT: (
        "bob",
        "eve",
        [
            lambda text: put(text, TRIAL, '  <failure agent="bob" at="3"/>'),
            lambda text: put(
                text, TRIAL, '  <breakpoint program="search" vertex="v1"><agent name="bob"/></breakpoint>'
            ),
            lambda text: put(text, TRIAL, condition("bump", "any bob (Collision.IsPressed())")),
            lambda text: put(text, "    <work", '    <group name="pair" members="bob ada"/>'),
            lambda text: in_block(text, "{bob}", '<vertex id="v8" element="Light.LightOn"/>'),
        ],
    ),
    NameKind.ROLE: (
        "walkers",
        "runners",
        [
            lambda text: put(text, "    <work", '    <group name="second" members="walkers"/>'),
            lambda text: put(text, TRIAL, condition("bump", "all {walkers} (Collision.IsPressed())")),
        ],
    ),
    NameKind.GROUP: (
        "crowd",
        "fast movers",
        [
            lambda text: put(text, "    <work", '    <group name="second" members="crowd"/>'),
            lambda text: put(text, TRIAL, condition("bump", "most crowd (Collision.IsPressed())")),
        ],
    ),
    NameKind.WORK: (
        "rooms",
        "halls",
        [
            lambda text: in_block(text, "walkers", '<vertex id="v8" element="rooms.Take"/>'),
            lambda text: put(text, TRIAL, condition("done", "all walkers (rooms.IsEmpty())")),
        ],
    ),
}
CASES = [(kind, index) for kind, (_, _, uses) in USES.items() for index in range(len(uses))]


def mission(text: str) -> Mission:
    found, problems = read_mission(text.encode(), "m.krt")
    assert found is not None
    assert [str(one.message) for one in problems if one.is_error] == []
    return found


def opened(one: Mission):
    return read_mission_data(write_mission(one), "m.krt", SearchPath(Path(__file__).parent))


def errors(one: Mission) -> list[str]:
    return [str(item.message) for item in opened(one).check().problems if item.is_error]


def renamed(kind: NameKind, text: str) -> str:
    """The text with another name for what is of a kind, as a person changes it."""
    old, new, _ = USES[kind]
    text = re.sub(rf"(?<![\w-]){old}(?![\w-])", new, text)
    for written in ("members", "eventually"):  # a name of two words stands between quotes in a set
        text = re.sub(rf'({written}="[^"]*)fast movers', r"\1&quot;fast movers&quot;", text)
    # An agent whose name was the start's goes on being called so.
    return text.replace('<agent name="top" program="all"', '<agent name="north" program="all" start="top"')


@pytest.mark.parametrize(("kind", "use"), CASES)
def test_a_rename_is_followed_in_what_the_other_side_did(kind, use):
    other = USES[kind][2][use](TEXT)
    base, ours, theirs = mission(TEXT), mission(renamed(kind, TEXT)), mission(other)
    expected = mission(renamed(kind, other))
    assert errors(base) == errors(ours) == errors(theirs) == errors(expected) == []
    for merged in (merge_checked(base, ours, theirs, opened), merge_checked(base, theirs, ours, opened)):
        assert (merged.mission, merged.conflicts) == (expected, ())


@pytest.mark.parametrize("kind", list(NameKind))
def test_two_new_names_for_one_thing_are_a_conflict_that_can_be_decided(kind):
    old, new, _ = USES[kind]
    after = renamed(kind, TEXT)
    ours, theirs = (mission(re.sub(rf"\b{new}\b", name, after)) for name in ("mine", "other"))
    merged = merge_checked(mission(TEXT), ours, theirs, opened)
    assert merged.conflicts == (f"the name of the {kind.value} {old} was changed in both: ours is kept",)
    assert (merged.mission, merged.clashes[0].ours, merged.clashes[0].theirs) == (ours, "mine", "other")
    assert merge_missions(mission(TEXT), ours, theirs, [merged.clashes[0].name]).mission == theirs


def test_what_one_removed_and_the_other_uses_is_a_conflict():
    ours = mission(TEXT.replace("Trips.Set(1); ", ""))
    ours = replace(ours, variables=[], programs=[ours.programs[0], replace(ours.programs[2], name="search")])
    theirs = mission(in_program(TEXT, "alone", "Trips.Add", {"value": "2"}))
    assert errors(ours) == errors(theirs) == []
    merged = merge_checked(mission(TEXT), ours, theirs, opened)
    assert merged.conflicts != ()


def test_one_start_for_two_new_robots_is_a_conflict():
    agents = [f'    <agent name="{name}" program="all" start="north" robot="mini-robot"/>' for name in ("eve", "kim")]
    ours, theirs = (mission(put(TEXT, "    <goal", agent)) for agent in agents)
    (sentence,) = merge_checked(mission(TEXT), ours, theirs, opened).conflicts
    assert sentence.startswith("the two do not fit together: ")


def test_a_breakpoint_of_a_program_that_the_other_removed_is_a_conflict():
    other = put(TEXT, TRIAL, '  <breakpoint program="alone" vertex="v1"/>')
    ours = mission(TEXT)
    ours.programs = ours.programs[:2]
    for sides in ((ours, mission(other)), (mission(other), ours)):
        merged = merge_checked(mission(TEXT), *sides, opened)
        assert merged.conflicts == (
            "the breakpoint at v1 of alone was set in one, and the other removed the program: nothing pauses there",
        )


def test_a_breakpoint_stays_at_its_vertex_where_both_gave_one_id_to_new_ones():
    before = '<vertex id="stop"'
    ours = mission(in_program(TEXT, "alone", "Light.LightOn", {}))
    arcs = '<arc from="start" to="v1"/>\n    <arc from="v1" to="stop"/>'
    text = TEXT.replace(arcs, '<arc from="start" to="v9"/><arc from="v9" to="v1"/><arc from="v1" to="stop"/>')
    head, found, rest = text.partition('<program name="alone"')
    rest = rest.replace(before, '<vertex id="v9" element="Light.LightOff"/>' + before, 1)
    theirs = mission(put(head + found + rest, TRIAL, '  <breakpoint program="alone" vertex="v9"/>'))
    merged = merge_checked(mission(TEXT), ours, theirs, opened)
    assert merged.conflicts == ()
    (breakpoint,) = merged.mission.breakpoints
    program = merged.mission.program("alone")
    assert program is not None
    at = next(vertex for vertex in program.vertices if vertex.id == breakpoint.vertex)
    assert (at.element, breakpoint.vertex) == ("Light.LightOff", "v2")


@pytest.mark.parametrize(
    ("field", "one", "two", "sentence"),
    [
        (
            "breakpoints",
            Breakpoint("search", "v2", hits=2),
            Breakpoint("search", "v2", hits=3),
            "the breakpoint at v2 of search was changed in both: ours is kept",
        ),
        (
            "breakpoints",
            Breakpoint("search", "v2", ("ada", "bob")),
            Breakpoint("search", "v2", ("ada", "bob"), every=True),
            "the breakpoint at v2 of search for ada, bob was changed in both: ours is kept",
        ),
        (
            "failures",
            Failure("ada", 1.5, FailureKind.STALL),
            Failure("ada", 1.5, FailureKind.MUTE),
            "the failure of ada at 1.5 s was changed in both: ours is kept",
        ),
    ],
)
def test_a_conflict_of_what_has_no_name_is_words(field, one, two, sentence):
    ours, theirs = mission(TEXT), mission(TEXT)
    setattr(ours, field, [one])
    setattr(theirs, field, [two])
    assert merge_missions(mission(TEXT), ours, theirs).conflicts == (sentence,)


def edits():
    """Renames and uses, in any order: (what, kind, which use)."""
    return st.lists(st.tuples(st.booleans(), st.sampled_from(CASES)), min_size=1, max_size=4)


def edited(changes) -> str:
    """A text with uses put in, and things renamed after that; what cannot be once more is left out."""
    text = TEXT
    steps = [USES[kind][2][use] for kind, use in dict.fromkeys(case for is_use, case in changes if is_use)]
    steps += [partial(renamed, kind) for kind in dict.fromkeys(case[0] for is_use, case in changes if not is_use)]
    for step in steps:
        after = step(text)
        found, problems = read_mission(after.encode(), "m.krt")
        text = text if found is None or any(one.is_error for one in problems) else after
    return text


@given(
    edits(), edits(), st.sets(st.sampled_from(["all", "search", "alone", "Trips", "Hop", "rooms", "north", "crowd"]))
)
def test_two_right_missions_become_a_right_one_or_a_conflict(mine, other, gone):
    ours, theirs = mission(edited(mine)), without(mission(edited(other)), gone)
    if errors(ours) or errors(theirs):
        return
    for sides in ((ours, theirs), (theirs, ours)):
        merged = merge_checked(mission(TEXT), *sides, opened)
        assert merged.conflicts or errors(merged.mission) == []
        assert all("(" not in one.partition(":")[0] for one in merged.conflicts)


def without(one: Mission, gone: set[str]) -> Mission:
    """The mission without what has one of these names, and what speaks of it left as it is."""
    team, world = one.team, one.own_world
    assert world is not None
    return replace(
        one,
        programs=[program for program in one.programs if program.name not in gone],
        variables=[own for own in one.variables if own.variable.name not in gone],
        constructors=[own for own in one.constructors if own.name not in gone],
        team=replace(
            team,
            works=[work for work in team.works if work.name not in gone],
            groups=[group for group in team.groups if group.name not in gone],
        ),
        own_world=replace(world, starts=tuple(start for start in world.starts if start.name not in gone)),
    )
