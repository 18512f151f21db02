"""Where things of a mission stand in its file."""

from __future__ import annotations

from kitrobot.diagnostics.model import Place, Rule, Severity, Source
from kitrobot.files.places import Places
from kitrobot.text.sentences import Sentence

RULE = Rule("test-places", Severity.ERROR, "A test", Sentence("Only for tests."))
TEXT = """<kitrobot version="1">
  <!-- <vertex id="a" element="X"/> -->
  <program name="p &amp; q" robot='r'>
    <vertex
       id="a" element="X"><note><![CDATA[<vertex id="b"/>]]></note></vertex>
    <vertex id='b' element="Y"/>
    <arc from="a" to="b"/>
    <arc to="b" out="body" from="a" at="return"/>
  </program>
  <program name="other" robot="r">
    <vertex id="a" element="Z"/>
  </program>
  <team><agent name="x" program="p"/><goal storehouse="A"/><goal storehouse="B"/></team>
  <world href="w"/>
</kitrobot>
"""
PLACES = Places(Source("m.krt", TEXT))


def where(**names):
    """Line and column of what a diagnostic is about."""
    place = PLACES.placed([RULE(Sentence("wrong"), Place("p.lll", 9, 9), **names)])[0].place
    assert place is not None
    assert place.file == "m.krt"
    return place.line, place.column


def test_a_vertex_stands_where_its_tag_begins():
    assert where(program="p & q", vertices=["b"]) == (6, 5)


def test_a_vertex_is_one_of_its_program():
    assert where(program="p & q", vertices=["a"]) == (4, 5)
    assert where(program="other", vertices=["a"]) == (11, 5)


def test_an_arc_is_known_by_its_ports_in_any_order():
    assert where(program="p & q", arcs=[("a", "next", "b", "in")]) == (7, 5)
    assert where(program="p & q", arcs=[("a", "body", "b", "return")]) == (8, 5)


def test_what_is_not_in_the_file_stands_where_its_program_begins():
    assert where(program="other", vertices=["none"]) == (10, 3)


def test_a_program_that_is_not_in_the_file_stands_at_its_beginning():
    assert where(program="none", vertices=["a"]) == (1, 1)


def test_a_diagnostic_about_no_program_keeps_its_place():
    item = RULE(Sentence("wrong"), Place("w.xml", 3, 4))
    assert PLACES.placed([item]) == [item]


def test_agents_goals_and_the_world_have_places():
    assert PLACES.agent("x") is not None
    goals = [PLACES.goal(number) for number in range(3)]
    assert [goal.column if goal else None for goal in goals] == [38, 60, None]
    assert PLACES.world is not None
    assert PLACES.world.line == 14


def test_a_hostile_text_is_scanned_in_a_moment():
    for piece in ("<!--", "<vertex ", "<vertex a=", '<vertex a="', "<![CDATA[", "<?", "<vertex a='b' " * 3):
        Places(Source("m.krt", piece * 20_000))
