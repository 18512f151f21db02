"""Missions."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from tests.growth.shapes.registry import shape

_START = '<vertex id="start" element="Start"/><vertex id="stop" element="Stop"/>'


def mission(program: str = "", rest: str = "", vertices: str = _START) -> str:
    """A mission of one program, with whatever else it holds."""
    inner = f'<program name="p" robot="mini-robot">{vertices}{program}</program>'
    return f'<kitrobot version="1">\n{inner}\n{rest}\n</kitrobot>\n'


def _krt(pieces: dict[str, tuple[str, str]]) -> None:
    for what, (once, one) in pieces.items():

        def make(n: int, once: str = once, one: str = one) -> str:
            return mission(once + "".join(one.replace("#", str(at)) + "\n" for at in range(n)))

        shape(f"krt {what}")(make)


_krt(
    {
        "vertices that hang on nothing": ("", '<vertex id="v#" element="Wheel.Stop"/>'),
        "vertices of unknown elements": ("", '<vertex id="v#" element="Wheel.Stopp"/>'),
        "vertices of unknown constructors": ("", '<vertex id="v#" element="Whyle"/>'),
        "vertices of different unknown elements": ("", '<vertex id="v#" element="Thing#"/>'),
        "vertices with one id": ("", '<vertex id="v" element="Wheel.Stop"/>'),
        "vertices without an id": ("", '<vertex element="Wheel.Stop"/>'),
        "vertices without anything": ("", "<vertex/>"),
        "ids that look made": ("", '<vertex id="v" element="Wheel.Stop"/><vertex id="v-#" element="Wheel.Stop"/>'),
        "starts": ("", '<vertex id="s#" element="Start"/>'),
        "arcs to nowhere": ("", '<arc from="start" to="v#"/>'),
        "arcs from nowhere": ("", '<arc from="v#" to="stop"/>'),
        "arcs that are equal": ("", '<arc from="start" to="stop"/>'),
        "arcs without ends": ("", "<arc/>"),
        "arcs from ports that are not there": ("", '<arc from="start" out="x#" to="stop"/>'),
        "arcs to vertices, and others to nowhere": (
            "",
            '<vertex id="v#" element="Wheel.Stop"/><arc from="v#" to="w#"/>',
        ),
        "arcs that fill one slot": (
            '<vertex id="w" element="While"/>',
            '<vertex id="v#" element="Run.IsTrue"/><arc from="v#" to="w" at="condition"/>',
        ),
        "arcs to one vertex": (
            '<vertex id="w" element="Wheel.Stop"/>',
            '<vertex id="v#" element="Wheel.Stop"/><arc from="v#" to="w"/>',
        ),
        "loops of one vertex": ("", '<vertex id="v#" element="Wheel.Stop"/><arc from="v#" to="v#"/>'),
        "bodies that do not come back": (
            "",
            '<vertex id="w#" element="While"/><vertex id="v#" element="Wheel.Stop"/>'
            '<arc from="w#" out="body" to="v#"/>',
        ),
        "vertices with a note": ("", '<vertex id="v#" element="Wheel.Stop"><note>a note #</note></vertex>'),
        "unknown elements": ("", "<thing/>"),
        "unknown elements of a vertex": ("", '<vertex id="v#" element="Wheel.Stop"><thing>text</thing></vertex>'),
        "unknown attributes": ("", '<vertex id="v#" element="Wheel.Stop" x="1"/>'),
        "stray texts": ("", 'text <vertex id="v#" element="Wheel.Stop"/>'),
        "comments": ("", "<!-- a comment -->"),
        "settings that are no numbers": (
            "",
            '<vertex id="v#" element="Wheel.Advance"><set name="speed">x</set></vertex>',
        ),
        "settings that nobody knows": ("", '<vertex id="v#" element="Wheel.Advance"><set name="x">1</set></vertex>'),
    }
)


def chain(n: int, element: Callable[[int], str], inside: str = "") -> str:
    """Vertices one after another from Start to Stop."""
    names = ["start", *(f"v{at}" for at in range(n)), "stop"]
    made = [f'<vertex id="v{at}" element="{element(at)}">{inside}</vertex>\n' for at in range(n)]
    arcs = [f'<arc from="{a}" to="{b}"/>\n' for a, b in pairwise(names)]
    return "".join(made + arcs)


@shape("krt instructions in a row")
def _row(n: int) -> str:
    return mission(chain(n, lambda at: "Wheel.Stop"))


@shape("krt instructions in a row, each with notes")
def _row_with_notes(n: int) -> str:
    return mission(chain(n, lambda at: "Wheel.Stop", '<note>a\nb</note><note at="after">c</note>'))


@shape("krt unknown instructions in a row")
def _unknown_row(n: int) -> str:
    return mission(chain(n, lambda at: f"Thing{at}.Do"))


@shape("krt instructions in a row, listed from the end")
def _backwards(n: int) -> str:
    lines = chain(n, lambda at: "Wheel.Stop").splitlines(keepends=True)
    return mission("".join(reversed(lines)))


@shape("krt instructions in a circle")
def _circle(n: int) -> str:
    row = "".join(
        f'<vertex id="v{at}" element="Wheel.Stop"/><arc from="v{at}" to="v{(at + 1) % n}"/>' for at in range(n)
    )
    return mission(row)


@shape("krt rows that hang on nothing")
def _parked_rows(n: int) -> str:
    row = "".join(
        f'<vertex id="a{at}" element="Wheel.Stop"/><vertex id="b{at}" element="Wheel.Stop"/>'
        f'<arc from="a{at}" to="b{at}"/>'
        for at in range(n)
    )
    return mission(row)


@shape("krt empty loops in a row")
def _loops(n: int) -> str:
    inner = "".join(
        f'<vertex id="c{at}" element="Run.IsTrue"/><arc from="c{at}" to="v{at}" at="condition"/>'
        f'<arc from="v{at}" out="body" to="v{at}" at="return"/>\n'
        for at in range(n)
    )
    return mission(chain(n, lambda at: "While") + inner)


@shape("krt loops without conditions in a row")
def _bare_loops(n: int) -> str:
    return mission(chain(n, lambda at: "While"))


@shape("krt loops in one another")
def _nested(n: int) -> str:
    made = ""
    before, port = "start", "next"
    for at in range(n):
        made += f'<vertex id="v{at}" element="Repetition"/><arc from="{before}" out="{port}" to="v{at}"/>\n'
        before, port = f"v{at}", "body"
    for at in reversed(range(n)):
        made += f'<arc from="{before}" out="{port}" to="v{at}" at="return"/>\n'
        before, port = f"v{at}", "next"
    return mission(made + f'<arc from="{before}" out="{port}" to="stop"/>')


@shape("krt conditions in one another")
def _nested_conditions(n: int) -> str:
    made = '<vertex id="w" element="While"/><arc from="start" to="w"/><arc from="w" to="stop"/>'
    made += '<arc from="w" out="body" to="w" at="return"/>'
    into, slot = "w", "condition"
    for at in range(n):
        made += f'<vertex id="n{at}" element="And"/><arc from="n{at}" to="{into}" at="{slot}"/>\n'
        into, slot = f"n{at}", "left"
    return mission(made)


@shape("krt branches of one parallel")
def _branches(n: int) -> str:
    made = '<vertex id="p" element="Parallelism"/><arc from="start" to="p"/><arc from="p" to="stop"/>\n'
    for at in range(1, n + 1):
        made += f'<vertex id="v{at}" element="Wheel.Stop"/><arc from="p" out="branch.{at}" to="v{at}"/>'
        made += f'<arc from="v{at}" to="p" at="return"/>\n'
    return mission(made)


@shape("krt notes at one vertex")
def _notes(n: int) -> str:
    return mission(f'<vertex id="v" element="Wheel.Stop">{"<note>a note</note>" * n}</vertex>')


@shape("krt notes of one vertex that stands in the row")
def _notes_in_row(n: int) -> str:
    return mission(chain(1, lambda at: "Wheel.Stop", '<note>a</note><note at="after">b</note>' * n))


@shape("krt lines of one note")
def _note_lines(n: int) -> str:
    return mission(chain(1, lambda at: "Wheel.Stop", "<note>" + "a line\n" * n + "</note>"))


@shape("krt settings of one vertex")
def _settings(n: int) -> str:
    inner = "".join(f'<set name="s{at}">1</set>' for at in range(n))
    return mission(chain(1, lambda at: "Wheel.Advance", inner))


@shape("krt settings of one name")
def _equal_settings(n: int) -> str:
    return mission(chain(1, lambda at: "Wheel.Advance", '<set name="speed">1</set>' * n))


@shape("krt attributes of one vertex")
def _attributes(n: int) -> str:
    return mission("<vertex " + " ".join(f'a{at}="1"' for at in range(n)) + "/>")


@shape("krt letters of an id")
def _long_id(n: int) -> str:
    return mission(f'<vertex id="{"v" * n}" element="Wheel.Stop"/>')


@shape("krt letters of an element's name")
def _long_element(n: int) -> str:
    return mission(f'<vertex id="v" element="Wheel.{"S" * n}"/>')


@shape("krt entities in a note")
def _entities(n: int) -> str:
    return mission(f'<vertex id="v" element="Wheel.Stop"><note>{"&lt;&#65;" * n}</note></vertex>')


@shape("krt elements within an unknown element")
def _within_unknown(n: int) -> str:
    return mission("", f"<thing>{'<one/>' * n}</thing>")


@shape("krt line feeds")
def _blank(n: int) -> str:
    return mission("\n" * n)


@shape("krt spaces within a tag")
def _blank_tag(n: int) -> str:
    return mission(f"<vertex {' ' * n}/>")


@shape("krt spaces before the first element")
def _blank_start(n: int) -> str:
    return " " * n + mission()


@shape("krt tags that do not end")
def _unended(n: int) -> str:
    return mission('<vertex id="' * n)


@shape("krt angles")
def _angles(n: int) -> str:
    return mission("<" * n)


@shape("krt comments that do not end")
def _unended_comments(n: int) -> str:
    return mission("<!--" * n)


@shape("krt programs")
def _programs(n: int) -> str:
    one = f'<program name="q#" robot="mini-robot">{_START}<arc from="start" to="stop"/></program>\n'
    return mission("", "".join(one.replace("#", str(at)) for at in range(n)))


@shape("krt programs of one name")
def _equal_programs(n: int) -> str:
    return mission("", f'<program name="q" robot="mini-robot">{_START}</program>\n' * n)


@shape("krt programs for unknown robots")
def _unknown_robots(n: int) -> str:
    return mission("", "".join(f'<program name="q{at}" robot="r{at}">{_START}</program>\n' for at in range(n)))


def _rest(pieces: dict[str, str | tuple[str, str, str]]) -> None:
    for what, given in pieces.items():
        before, one, after = ("", given, "") if isinstance(given, str) else given

        def make(n: int, before: str = before, one: str = one, after: str = after) -> str:
            return mission("", before + "".join(one.replace("#", str(at)) + "\n" for at in range(n)) + after)

        shape(f"krt {what}")(make)


_TEAM = ("<team>", "</team>")
_OWN = '<world name="w" version="1" width="3000" height="2000">'
_rest(
    {
        "agents": (_TEAM[0], '<agent name="a#" program="p"/>', _TEAM[1]),
        "agents of one name": (_TEAM[0], '<agent name="a" program="p"/>', _TEAM[1]),
        "agents of unknown programs": (_TEAM[0], '<agent name="a#" program="q#"/>', _TEAM[1]),
        "agents that start nowhere": (
            _TEAM[0],
            '<agent name="a#" program="p" start="s#"/>',
            _TEAM[1] + '<world href="desk.world.xml"/>',
        ),
        "teams": '<team><agent name="a#" program="p"/></team>',
        "roles": (_TEAM[0], '<role name="r#" robot="mini-robot" least="0"/>', _TEAM[1]),
        "roles that nobody can play": (_TEAM[0], '<role name="r#" robot="x#" least="9"/>', _TEAM[1]),
        "groups of one another": (_TEAM[0], '<group name="g#" members="h# g0"/>', _TEAM[1]),
        "members of one group": ('<team><group name="g" members="', "a# ", '"/></team>'),
        "works": (_TEAM[0], '<work name="W#" units="1" lease="1"/>', _TEAM[1]),
        "goals": (_TEAM[0], '<goal storehouse="h#"/>', _TEAM[1] + '<world href="desk.world.xml"/>'),
        "goals that say nothing": (_TEAM[0], '<goal storehouse="h#" stock="x"/>', _TEAM[1]),
        "breakpoints": '<breakpoint program="p" vertex="start"/>',
        "breakpoints at vertices that are not there": '<breakpoint program="q#" vertex="v#"/>',
        "breakpoints with mistakes": '<breakpoint program="p" vertex="v#" hits="x"/>',
        "agents of one breakpoint": ('<breakpoint program="p" vertex="start">', '<agent name="a#"/>', "</breakpoint>"),
        "failures": (
            '<team><agent name="a" program="p"/></team>',
            '<failure agent="a" at="#"/>',
            "",
        ),
        "failures of nobody": '<failure agent="a#" at="5"/>',
        "worlds": '<world href="w#.world.xml"/>',
        "unknown things": "<thing/>",
        "labels": '<label xml:lang="l#">label</label>',
        "labels of one language": "<label>label</label>",
        "variables": '<variable robot="mini-robot" name="V#" min="0" max="9" initial="0"/>',
        "variables of one name": '<variable robot="mini-robot" name="V" min="0" max="9" initial="0"/>',
        "variables of unknown robots": '<variable robot="r#" name="V" min="0" max="9" initial="0"/>',
        "variables with names of others": '<variable robot="mini-robot" name="Wheel" min="0" max="9" initial="0"/>',
        "own parts": '<constructor name="Part#"><code>3*(WAIT(1);)</code></constructor>',
        "own parts of one name": '<constructor name="Part"><code>3*(WAIT(1);)</code></constructor>',
        "own parts with mistakes": '<constructor name="Part#"><code>Wheel.(</code></constructor>',
        "slots of one own part": (
            '<constructor name="Part">',
            '<flow name="s#"/>',
            "<code>3*({s0})</code></constructor>",
        ),
        "instructions of one own part": (
            '<constructor name="Part"><code>',
            "Wheel.Stop();",
            "</code></constructor>",
        ),
        "walls of its own world": (_OWN, '<wall x1="#" y1="0" x2="5" y2="5"/>', "</world>"),
    }
)
