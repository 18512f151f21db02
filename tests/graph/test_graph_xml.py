"""Programs of a mission, both ways."""

from functools import partial

from hypothesis import given
from hypothesis import strategies as st

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.graph.graph_xml import write_program
from kitrobot.graph.model import Arc, Note, Program, Vertex, empty_program
from tests.counting import MOST, growth
from tests.primitives.samples import MISSION, read_programs


def file_of(*programs: Program) -> str:
    lines = [line for program in programs for line in write_program(program)]
    return "\n".join(['<kitrobot version="1">', *lines, "</kitrobot>", ""])


def read(text: str) -> tuple[Program, list[Diagnostic]]:
    programs, problems = read_programs(text.encode(), "f.krt")
    [program] = programs
    return program, problems


XML_TEXT = st.text(
    st.characters(exclude_categories=["Cs"], exclude_characters="\ufffe\uffff").filter(
        lambda c: c >= " " or c in "\t\n\r"
    ),
    max_size=12,
)
NAME = XML_TEXT.filter(bool)
UNKNOWN = st.lists(
    st.sampled_from(
        [
            "<x/>",
            '<x a=">/"/>',
            "<x></x>",
            "<x >\n  text &lt; &#13;\n</x >",
            "<x><x/></x>",
            "<x><![CDATA[</x>]]></x>",
            "<x><!-- /> --></x>",
        ]
    ),
    max_size=3,
).map("".join)
VERTICES = st.lists(
    st.builds(
        Vertex,
        NAME,
        NAME,
        st.dictionaries(NAME, XML_TEXT, max_size=3),
        st.lists(st.builds(Note, XML_TEXT, XML_TEXT), max_size=2),
        UNKNOWN,
    ),
    max_size=6,
    unique_by=lambda vertex: vertex.id,
)
PROGRAMS = st.builds(
    Program, NAME, NAME, VERTICES, st.lists(st.builds(Arc, NAME, NAME, XML_TEXT, XML_TEXT), max_size=6)
)


@given(PROGRAMS)
def test_what_was_written_reads_as_the_same_program_and_writes_the_same_bytes(program: Program) -> None:
    text = file_of(program)
    back, problems = read(text)
    assert back == program
    assert {problem.code for problem in problems} <= {"xml-unknown-element"}
    assert file_of(back) == text


@given(PROGRAMS)
def test_a_vertex_or_arc_is_one_line_unless_unknown_xml_has_more(program: Program) -> None:
    for vertex in program.vertices:
        vertex.unknown = ""
    lines = write_program(program)
    assert len(lines) == len(program.vertices) + len(program.arcs) + 2
    assert not [line for line in lines if "\n" in line or "\r" in line]


def test_the_layout_is_that_of_the_design() -> None:
    program = Program(
        "carrier",
        "carrier",
        [
            Vertex("start", "Start"),
            Vertex("v1", "While"),
            Vertex("v3", "Wheel.Advance", {"speed": "50"}, [Note("slowly"), Note("a\nb", "after")]),
        ],
        [
            Arc("start", "v1"),
            Arc("v2", "v1", at="condition"),
            Arc("v1", "v3", out="body"),
            Arc("v1", "v1", "body", "return"),
        ],
    )
    assert write_program(program) == [
        '  <program name="carrier" robot="carrier">',
        '    <vertex id="start" element="Start"/>',
        '    <vertex id="v1" element="While"/>',
        '    <vertex id="v3" element="Wheel.Advance"><set name="speed">50</set><note>slowly</note>'
        '<note at="after">a&#10;b</note></vertex>',
        '    <arc from="start" to="v1"/>',
        '    <arc from="v2" to="v1" at="condition"/>',
        '    <arc from="v1" out="body" to="v3"/>',
        '    <arc from="v1" out="body" to="v1" at="return"/>',
        "  </program>",
    ]


def test_a_canonical_file_is_written_as_it_was_read() -> None:
    program, problems = read(MISSION)
    assert problems == []
    assert file_of(program) == MISSION


def test_characters_that_xml_cannot_hold_become_the_replacement_character() -> None:
    program = empty_program("p\0", "r")
    program.vertices[0].settings = {"a": "\x0b x \ud800 \uffff"}
    back, problems = read(file_of(program))
    assert problems == []
    assert back.name == "p\ufffd"
    assert back.vertices[0].settings == {"a": "\ufffd x \ufffd \ufffd"}


def test_unknown_xml_in_a_vertex_is_kept_word_for_word_and_reported() -> None:
    inside = "<hat size='3' of=\"&lt;>\">\n   <b/> ✓ &#9;</hat>"
    text = MISSION.replace("<note>slowly ✓</note>", f"<note>slowly ✓</note>{inside}")
    program, [problem] = read(text)
    assert program.vertices[1].unknown == inside
    assert problem.message == "<vertex> has no element <hat>; it is kept as it is"
    assert not problem.is_error
    assert file_of(program) == text


def test_a_vertex_whose_id_is_taken_or_missing_gets_a_new_one() -> None:
    vertices = ['id="a" element="A"', 'id="a" element="B"', 'id="a-2" element="C"', 'id="a" element="D"', 'element="E"']
    lines = "\n".join(f"<vertex {vertex}/>" for vertex in vertices)
    program, problems = read(f'<kitrobot version="1"><program name="p" robot="r">\n{lines}</program></kitrobot>')
    assert [(vertex.id, vertex.element) for vertex in program.vertices] == [
        ("a", "A"),
        ("a-3", "B"),
        ("a-2", "C"),
        ("a-4", "D"),
        ("vertex-2", "E"),
    ]
    assert [(p.code, p.program, p.vertices, p.place.line if p.place else 0) for p in problems] == [
        ("xml-duplicate", "p", ("a-3",), 3),
        ("xml-duplicate", "p", ("a-4",), 5),
        ("xml-missing", "p", ("vertex-2",), 6),
    ]


def test_a_vertex_without_an_element_stays_and_is_reported() -> None:
    program, [problem] = read('<kitrobot version="1"><program name="p" robot="r"><vertex id="a"/></program></kitrobot>')
    assert program.vertices == [Vertex("a", "")]
    assert problem.message == 'expected element="…" on <vertex>, found none'


def test_an_arc_that_lacks_an_end_is_left_out_and_reported() -> None:
    arcs = '<arc from="a"/><arc to="a"/><arc from="a" to="b"/>'
    program, problems = read(f'<kitrobot version="1"><program name="p" robot="r">{arcs}</program></kitrobot>')
    assert program.arcs == [Arc("a", "b")]
    assert [problem.code for problem in problems] == ["xml-missing"] * 2


def test_of_two_settings_with_one_name_the_last_counts_and_is_reported() -> None:
    text = MISSION.replace(
        '<set name="speed">50</set>', '<set name="speed">50</set><set name="speed">60</set><set>7</set>'
    )
    program, problems = read(text)
    assert program.vertices[1].settings == {"speed": "60"}
    assert [problem.code for problem in problems] == ["xml-missing", "xml-duplicate"]


def test_vertices_and_arcs_may_stand_in_any_order() -> None:
    program, problems = read(
        '<kitrobot version="1"><program name="p" robot="r"><arc from="a" to="b"/><vertex id="b" element="Stop"/>'
        '<arc from="x" to="y"/><vertex id="a" element="Start"/></program></kitrobot>'
    )
    assert problems == []
    assert [vertex.id for vertex in program.vertices] == ["b", "a"]
    assert [arc.source for arc in program.arcs] == ["a", "x"]


def test_ten_thousand_vertices_are_read_and_written_with_work_in_proportion() -> None:
    def of(count: int) -> Program:
        vertices = [Vertex(f"v{n}", "Wheel.Advance", {"speed": "50"}) for n in range(count)]
        return Program("p", "r", vertices, [Arc(f"v{n}", f"v{n + 1}") for n in range(count)])

    program = of(10_000)
    assert read(file_of(program))[0] == program
    assert growth(lambda n: partial(file_of, of(n)), 500) < MOST
    assert growth(lambda n: partial(read, file_of(of(n))), 500) < MOST
