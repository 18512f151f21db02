"""Constructors from XML."""

import pytest

from kitrobot.lll.tree import Hole, Seq, While
from kitrobot.primitives.constructors import Constructor, Role, Slot, SlotKind
from kitrobot.primitives.constructors_xml import read_constructors
from tests.primitives.samples import CONSTRUCTORS, constructors, messages


def read_one(inside: str) -> Constructor:
    groups, problems = read_constructors(constructors(inside).encode(), "f.xml")
    assert problems == []
    [constructor] = groups[0].constructors
    return constructor


def test_a_constructor_is_its_slots_and_its_template() -> None:
    [group], problems = read_constructors(CONSTRUCTORS.encode(), "f.xml")
    assert problems == []
    assert group.constructors == (
        Constructor(
            name="While",
            group="Loops",
            colour="loop",
            slots=(Slot("condition", SlotKind.CONDITION), Slot("body", SlotKind.FLOW, loop=True)),
            code="*[{condition}]({body})",
            template=While(Hole("condition"), Seq(hole=Hole("body"))),
            role=Role.INSTRUCTION,
            icon="rotate-cw",
            help={"": "Ä test < — ✓"},
        ),
    )


def test_texts_come_by_language_with_english_as_the_default() -> None:
    made = read_one(
        '<constructor name="A"><label xml:lang="en">a</label><label xml:lang="FR">b</label>'
        "<help>  two\n  words </help><code>BREAK</code></constructor>"
    )
    assert made.label == {"": "a", "fr": "b"}
    assert made.help == {"": "two words"}


def test_every_kind_of_slot_keeps_its_attributes() -> None:
    made = read_one(
        """<constructor name="All" colour="team">
          <number name="n" min="1" max="9" default="2" unit="s"><label>for</label></number>
          <value name="v" max="5"/> <text name="t" default="7"/> <action name="a"/> <condition name="c"/>
          <flow name="f"/> <flow name="r" repeat="yes" least="3"/>
          <code>{n}*({f}); A.b({v},{t}); °{a}°; [{c}](); //({r})</code>
        </constructor>"""
    )
    assert made.colour == "team"
    assert made.slots == (
        Slot("n", SlotKind.NUMBER, minimum=1, maximum=9, default="2", unit="s", label={"": "for"}),
        Slot("v", SlotKind.VALUE, maximum=5),
        Slot("t", SlotKind.TEXT, default="7"),
        Slot("a", SlotKind.ACTION),
        Slot("c", SlotKind.CONDITION),
        Slot("f", SlotKind.FLOW),
        Slot("r", SlotKind.FLOW, repeat=True, least=3),
    )
    assert isinstance(made.template, Seq)


@pytest.mark.parametrize(
    ("code", "role"),
    [
        ("!(A.b())", Role.CONDITION),
        ("A.b() &amp; C.d()", Role.CONDITION),
        ("A.b() | C.d()", Role.CONDITION),
        ("A.b()", Role.INSTRUCTION),
        ("WAIT(3)", Role.INSTRUCTION),
        ("BREAK; BREAK", Role.INSTRUCTION),
    ],
)
def test_the_role_is_read_off_the_template(code: str, role: Role) -> None:
    assert read_one(f'<constructor name="X"><code>{code}</code></constructor>').role is role


def test_one_that_adds_has_no_template() -> None:
    made = read_one('<constructor name="B"><adds constructor="P" slot="branch"/></constructor>')
    assert (made.role, made.adds, made.template) == (Role.BRANCH, ("P", "branch"), None)


def test_slots_may_stand_after_the_code() -> None:
    assert read_one('<constructor name="X"><code>{n}*()</code><number name="n"/></constructor>').slots


BAD = [
    ("<code>{n}*()</code>", "{n} | constructor-template | the hole {n} has no slot"),
    (
        '<flow name="b"/><code>BREAK</code>',
        "<code | constructor-template | expected a hole {b} for the slot b, found none",
    ),
    ('<flow name="b"/><code>3*({b});3*({b})</code>', "{b} | constructor-template | the hole {b} stands there twice"),
    (
        '<flow name="b"/><code>WAIT({b})</code>',
        "{b} | constructor-template | expected a slot <number> for {b}, found <flow>",
    ),
    (
        '<flow name="b" repeat="yes"/><code>3*({b})</code>',
        "{b} | constructor-template | the repeated slot b can only be a branch of a parallel",
    ),
    (
        '<code>{b}</code><flow name="b"/>',
        "<code | constructor-template | expected LLL around the hole, found only a hole",
    ),
    ("<code>3*(</code>", "( | not-closed | this `(` is never closed"),
    ("<code></code>", " | syntax | a template cannot be empty"),
    (
        '<flow name="in"/><code>3*({in})</code>',
        "in | constructor-slot | a slot cannot be named in, a port of every vertex",
    ),
    (
        '<flow name="a b"/><code>BREAK</code>',
        "a b | xml-bad-value | expected a name of letters, digits and _ (not WAIT or BREAK) in name, found “a b”",
    ),
    (
        '<flow name="b" least="2"/><code>3*({b})</code>',
        '2 | constructor-slot | expected repeat="yes" beside least, found none',
    ),
    (
        '<number name="n" min="5" max="3"/><code>{n}*()</code>',
        "5 | robot-range | expected min at most max, found 5 and 3",
    ),
    (
        '<number name="n" max="3" default="4"/><code>{n}*()</code>',
        "4 | xml-bad-value | expected a whole number from -536870911 to 3 in default, found “4”",
    ),
    (
        '<number name="n" max="536870912"/><code>{n}*()</code>',
        "536870912 | xml-bad-value | expected a whole number from -536870911 to 536870911 in max, found “536870912”",
    ),
    ('<flow name="b"/><flow name="b"/><code>3*({b})</code>', "b | xml-duplicate | the slot “b” is there already"),
    (
        "<code>BREAK</code><code>BREAK</code>",
        "<constructor | xml-missing | expected one <code> or one <adds> in the constructor, found 2",
    ),
    (
        "<help>nothing</help>",
        "<constructor | xml-missing | expected one <code> or one <adds> in the constructor, found 0",
    ),
    (
        '<flow name="b"/><adds constructor="P" slot="s"/>',
        "<constructor | constructor-slot | expected no slots beside <adds>, found some",
    ),
    (f"<code>{'(' * 200}</code>", "( | syntax | expected an instruction, found `(`"),
    (f"<code>{' ' * 10_001}</code>", "<code | constructor-template | expected at most 10000 characters, found 10001"),
]


@pytest.mark.parametrize(("inside", "message"), BAD, ids=range(len(BAD)))
def test_a_wrong_constructor_is_reported_and_left_out_and_its_neighbour_stays(inside: str, message: str) -> None:
    text = constructors(
        f'<constructor name="Bad">{inside}</constructor><constructor name="Good"><code>BREAK</code></constructor>'
    )
    [group], problems = read_constructors(text.encode(), "f.xml")
    assert [constructor.name for constructor in group.constructors] == ["Good"]
    assert problems
    assert messages(read_constructors, text) == [message]


@pytest.mark.parametrize("name", ["", "Start", "Stop", "Object.Method", " x", "a  b", "x" * 101])
def test_names_that_mean_something_else_are_refused(name: str) -> None:
    text = constructors(f'<constructor name="{name}"><code>BREAK</code></constructor>')
    [group], problems = read_constructors(text.encode(), "f.xml")
    assert group.constructors == ()
    assert problems


def test_a_colour_is_one_of_six() -> None:
    text = constructors('<constructor name="A" colour="loops"><code>BREAK</code></constructor>')
    _, [problem] = read_constructors(text.encode(), "f.xml")
    assert "expected loop, choice, parallel, action, test or team in colour, found “loops”" in problem.message
    assert problem.help == "did you mean loop?"


def test_an_icon_is_the_name_of_a_lucide_picture() -> None:
    text = constructors('<constructor name="A" icon="Arrow Up"><code>BREAK</code></constructor>')
    assert "expected the name of a Lucide icon" in messages(read_constructors, text)[0]


def test_the_second_of_two_with_one_name_is_left_out() -> None:
    one = '<constructor name="A"><code>BREAK</code></constructor>'
    two = '<constructor name="A"><code>WAIT(1)</code></constructor>'
    text = constructors(f'{one}</group><group name="H" colour="loop">{two}')
    groups, [problem] = read_constructors(text.encode(), "f.xml")
    assert [constructor.code for group in groups for constructor in group.constructors] == ["BREAK"]
    assert problem.code == "xml-duplicate"


def test_a_mistake_in_code_is_shown_where_it_stands_in_the_file() -> None:
    text = constructors(
        '<constructor name="A"><number name="n"/><code>\n'
        "&lt;A.b()&gt;(<![CDATA[ WAIT({n}); <A.c()> ]]><!-- - -->(WAIT(&#57;9999)))"
        "</code></constructor>"
    )
    _, [problem] = read_constructors(text.encode(), "f.xml")
    assert problem.code == "number-too-large"
    assert problem.place is not None
    line = text.split("\n")[1]
    assert problem.place.line == 2
    assert line[problem.place.column - 1 : problem.place.end_column - 1] == "&#57;9999"
