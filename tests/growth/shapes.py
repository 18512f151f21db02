"""Files of every kind in many shapes, each of a size that is asked for: `SHAPES[name](n)` has `n` of something.

A name is the ending of the file, a space, and what there are `n` of. The files are right, mistaken or senseless on
purpose: whoever reads them takes work in proportion to their size, whatever they hold.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable, Iterable
from itertools import pairwise

SHAPES: dict[str, Callable[[int], str | bytes]] = {}


def shape(name: str) -> Callable[[Callable[[int], str | bytes]], Callable[[int], str | bytes]]:
    """Registers what makes files of one shape."""

    def keep(make: Callable[[int], str | bytes]) -> Callable[[int], str | bytes]:
        assert name not in SHAPES
        SHAPES[name] = make
        return make

    return keep


def _lines(kind: str, pieces: dict[str, tuple[str, str, str]]) -> None:
    """Shapes that are one text many times, between a beginning and an end; `#` becomes the number of the time."""
    for what, (before, one, after) in pieces.items():

        def make(n: int, before: str = before, one: str = one, after: str = after) -> str:
            return before + "".join(one.replace("#", str(at)) for at in range(n)) + after

        shape(f"{kind} {what}")(make)


# -- LLL

_lines(
    "lll",
    {
        "instructions": ("", "Wheel.Advance(50);\n", ""),
        "instructions on one line": ("", "Wheel.Advance(50); ", ""),
        "unknown objects": ("", "Nothing#.Advance(50);\n", ""),
        "one unknown object": ("", "Whel.Advance(50);\n", ""),
        "unknown methods": ("", "Wheel.Nothing#(50);\n", ""),
        "instructions without semicolons": ("", "Wheel.Stop()\n", ""),
        "wrong numbers of parameters": ("", "Wheel.Stop(1,2,3);\n", ""),
        "parameters of one call": ("Wheel.Advance(", "1,", "1);"),
        "parameters that are calls": ("Wheel.Advance(", "Captor.Value(),", "1);"),
        "semicolons": ("", ";", ""),
        "line feeds": ("", "\n", ""),
        "spaces": ("", " ", ""),
        "carriage returns": ("", "\r", ""),
        "blanks before an instruction": ("", "\n \t", "Wheel.Stop();"),
        "blanks within a call": ("Wheel", " ", ".Stop();"),
        "blanks within parentheses": ("Wheel.Advance(", "\n", "50);"),
        "blanks after a name": ("", "Wheel   \n", ""),
        "names": ("", "Wheel ", ""),
        "names with points": ("Wheel", ".Advance", "(50);"),
        "calls that do not end": ("", "Wheel.Advance(", ""),
        "calls with numbers that do not end": ("Wheel.Advance(50", ", 50", ";"),
        "letters of a name": ("Wheel", "a", ".Stop();"),
        "letters in another script": ("Wheel", "م", ".Stop();"),
        "vowel signs": ("م", "\u0652", ".Stop();"),
        "digits": ("Wheel.Advance(", "9", ");"),
        "zeros": ("Wheel.Advance(", "0", "1);"),
        "quotation marks": ("", '"', ""),
        "full stops": ("", ".", ""),
        "slashes": ("", "/", ""),
        "hashes": ("", "#\n", ""),
        "exclamation marks": ("", "!", ""),
        "opening parentheses": ("", "(", ""),
        "closing parentheses": ("", ")", ""),
        "opening brackets": ("", "[", ""),
        "closing brackets": ("", "]", ""),
        "opening angles": ("", "<", ""),
        "opening parallels": ("", "//(", ""),
        "opening whiles": ("", "*[Run.IsTrue()](", ""),
        "marks": ("", "°", ""),
        "holes": ("", "{x};", ""),
        "opening braces": ("", "{", ""),
        "opening braces and names": ("", "{ x ", ""),
        "conditions that do not end": ("", "*[Run.IsTrue(", ""),
        "guards within guards": ("", "[Run.IsTrue() & [", ""),
        "conjunctions": ("*[Run.IsTrue()", " & Run.IsTrue()", "](Wheel.Stop(););"),
        "disjunctions": ("*[Run.IsTrue()", " | Run.IsTrue()", "](Wheel.Stop(););"),
        "alternating conjunctions": ("*[Run.IsTrue()", " | Run.IsTrue() & Run.IsTrue()", "](Wheel.Stop(););"),
        "negations": ("*[", "!(", "Run.IsTrue()](Wheel.Stop(););"),
        "comments": ("", "# a comment\n", "Wheel.Stop();"),
        "comments alone": ("", "# a comment\n", ""),
        "comments behind instructions": ("", "Wheel.Stop(); # stop\n", ""),
        "comments behind whiles": ("", "*[Run.IsTrue()]( Wheel.Stop(); # a\n # b\n ); # c\n", ""),
        "comments within a call": ("Wheel.Advance(", "# a comment\n", "50);"),
        "comments within calls": ("", "Wheel.Advance( # a\n 50 # b\n); # c\n", ""),
        "comments within a condition": ("*[Run.IsTrue()", " & # a\n Run.IsTrue()", "](Wheel.Stop(););"),
        "letters of a comment": ("# ", "a", "\nWheel.Stop();"),
        "branches": ("//(", "Wheel.Stop();,", "Wheel.Stop(););"),
        "empty branches": ("//(", ",", ");"),
        "branches with comments": ("//(", "# a\n,", ");"),
        "parallels": ("", "//(Wheel.Stop();, Wheel.Advance(5););\n", ""),
        "marked actions": ("//(", "°Wheel.Advance(5)°;", ", WAIT(5););"),
        "marked actions outside": ("", "°Wheel.Advance(5)°;", ""),
        "shared actuators": ("//(", "Wheel.Advance(5);,", "Wheel.Stop(););"),
        "conditionals": ("", "[Run.IsTrue()](Wheel.Stop(););\n", ""),
        "conditionals with else": ("", "[Run.IsTrue()](Wheel.Stop();)!(Wheel.Stop(););\n", ""),
        "events": ("", "<Captor.LessThan(20)>();\n", ""),
        "repetitions": ("", "3*(Wheel.Stop(););\n", ""),
        "repetitions of nothing": ("", "0*(Wheel.Stop(););\n", ""),
        "breaks": ("", "BREAK;\n", ""),
        "breaks in a loop": ("*[Run.IsTrue()](", "BREAK;\n", ");"),
        "waits": ("", "WAIT(10);\n", ""),
        "waits for nothing": ("", "WAIT();\n", ""),
        "endless loops": ("", "*[1](Wheel.Stop(););\n", ""),
        "commas": ("3*(", "Wheel.Stop();,", ");"),
        "commas alone": ("", ",", ""),
        "numbers": ("", "5 ", ""),
        "large numbers": ("", "Wheel.Advance(99999);\n", ""),
        "numbers out of range": ("", "Wheel.Advance(999);\n", ""),
        "tests as instructions": ("", "Captor.LessThan(5);\n", ""),
        "instructions as tests": ("", "*[Wheel.Stop()](WAIT(1););\n", ""),
        "values as tests": ("", "*[Captor.Value()](WAIT(1););\n", ""),
        "tests as parameters": ("", "Wheel.Advance(Captor.LessThan(5));\n", ""),
        "mistakes within parentheses": ("3*(", "Wheel.Stop(;\n", ");"),
        "mistakes at the ends of lines": ("", "Wheel.Stop(\n", ""),
        "words of the language as names": ("", "WAIT.BREAK();\n", ""),
        "mistakes": ("", "?? %% Wheel\n", ""),
        "mistakes on one line": ("", "?? ", ""),
        "unclosed whiles after one another": ("", "*[Run.IsTrue(](Wheel.Stop();\n", ""),
        "nul characters": ("", "\0", ""),
        "wide characters": ("", "漢\n", ""),
    },
)


@shape("lll bodies in one another, as deep as may be")
def _deep(n: int) -> str:
    return ("3*(" * 50 + "Wheel.Stop();" + ");" * 50 + "\n") * (n // 50 + 1)


@shape("lll bodies in one another, too deep")
def _too_deep(n: int) -> str:
    return "3*(" * n + "Wheel.Stop();" + ");" * n


@shape("lll conditionals in one another, too deep")
def _too_deep_conditions(n: int) -> str:
    return "*[" + "(" * n + "Run.IsTrue()" + ")" * n + "](Wheel.Stop(););"


@shape("lll calls in one another")
def _calls(n: int) -> str:
    return "Wheel.Advance(" * n + "1" + ")" * n + ";"


@shape("lll parallels in one another")
def _parallels(n: int) -> str:
    return ("//(Wheel.Stop();, " * 40 + "Wheel.Stop();" + ");" * 40 + "\n") * (n // 40 + 1)


# -- missions

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


def _inside(kind: str, before: str, after: str, pieces: dict[str, str]) -> None:
    _lines(kind, {what: (before, one + "\n", after) for what, one in pieces.items()})


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

# -- worlds

_WORLD = '<world name="w" version="1" width="3000" height="2000">\n'
_ROAD = (
    '<road name="r" width="100"><point x="10" y="10"/><point x="2990" y="10"/></road>'
    '<storehouse name="h" x="10" y="50" width="50" height="50" capacity="5"/>'
)
_lines(
    "world.xml",
    {
        what: (_WORLD + before, one + "\n", after + "</world>\n")
        for what, (before, one, after) in {
            "walls": ("", '<wall x1="0" y1="0" x2="100" y2="100"/>', ""),
            "walls and a start": ("", '<wall x1="0" y1="0" x2="100" y2="100"/>', '<start name="s" x="500" y="500"/>'),
            "walls outside": ("", '<wall x1="0" y1="0" x2="100000" y2="100"/>', ""),
            "walls without ends": ("", "<wall/>", ""),
            "roads": ("", '<road name="r#" width="9"><point x="1" y="1"/><point x="99" y="1"/></road>', ""),
            "roads of one name": ("", '<road name="r" width="9"><point x="1" y="1"/><point x="99" y="1"/></road>', ""),
            "roads without points": ("", '<road name="r#" width="9"/>', ""),
            "points of one road": ('<road name="r" width="9">', '<point x="#" y="5"/>', "</road>"),
            "equal points of one road": ('<road name="r" width="9">', '<point x="5" y="5"/>', "</road>"),
            "round points of one road": (
                '<road name="r" width="9">',
                '<point x="#" y="5" radius="3"/><point x="#" y="500" radius="3"/>',
                "</road>",
            ),
            "sections of one road": (
                '<road name="r" width="9"><point x="1" y="1"/><point x="99" y="1"/>',
                '<section sign="#" from="0" to="1"/>',
                "</road>",
            ),
            "sections with one sign": (
                '<road name="r" width="9"><point x="1" y="1"/><point x="99" y="1"/>',
                '<section sign="1" from="0" to="1"/>',
                "</road>",
            ),
            "docks": (_ROAD, '<dock name="d#" road="r" at="5" reach="5" storehouse="h" kind="load"/>', ""),
            "docks of unknown roads": (
                _ROAD,
                '<dock name="d#" road="x#" at="5" reach="5" storehouse="h" kind="load"/>',
                "",
            ),
            "docks of one name": (_ROAD, '<dock name="d" road="r" at="5" reach="5" storehouse="h" kind="load"/>', ""),
            "storehouses": ("", '<storehouse name="h#" x="1" y="1" width="5" height="5" capacity="5"/>', ""),
            "storehouses with a dock each": (
                _ROAD,
                '<storehouse name="h#" x="1" y="1" width="5" height="5" capacity="5"/>'
                '<dock name="d#" road="r" at="5" reach="5" storehouse="h#" kind="load"/>',
                "",
            ),
            "roads with a dock each": (
                _ROAD,
                '<road name="r#" width="9"><point x="1" y="1"/><point x="99" y="1"/></road>'
                '<dock name="d#" road="r#" at="5" reach="5" storehouse="h" kind="load"/>',
                "",
            ),
            "docks with a start each": (
                _ROAD,
                '<dock name="d#" road="r" at="5" reach="5" storehouse="h" kind="load"/><start name="s#" dock="d#"/>',
                "",
            ),
            "starts": ("", '<start name="s#" x="5" y="5"/>', ""),
            "starts of one name": ("", '<start name="s" x="5" y="5"/>', ""),
            "starts on one road": (_ROAD, '<start name="s#" road="r" at="5"/>', ""),
            "starts on unknown roads": (_ROAD, '<start name="s#" road="x#" at="5"/>', ""),
            "starts at nothing": ("", '<start name="s#"/>', ""),
            "floors": ("", '<floor colour="red" x="1" y="1" width="5" height="5"/>', ""),
            "points of one floor": ('<floor colour="red">', '<point x="#" y="5"/><point x="5" y="#"/>', "</floor>"),
            "lines": ("", '<line colour="black" width="5"><point x="1" y="1"/><point x="9" y="1"/></line>', ""),
            "points of one line": ('<line colour="black" width="5">', '<point x="#" y="5"/>', "</line>"),
            "unknown things": ("", "<thing/>", ""),
        }.items()
    },
)


@shape("world.xml walls with a start each")
def _walls_and_starts(n: int) -> str:
    one = '<wall x1="{0}" y1="0" x2="{0}" y2="100"/><start name="s{0}" x="{1}" y="50"/>\n'
    return (
        '<world name="w" version="1" width="900000" height="2000">'
        + "".join(one.format(20 * at, 20 * at + 10) for at in range(n))
        + "</world>"
    )


# -- robots, constructors, tutorials

_ROBOT = '<robot name="r" version="1" tick="20" wait-unit="100">\n'
_SENSOR = (
    '<sensor name="S#" device="range"><operation name="LessThan" test="less">'
    '<parameter name="value" min="0" max="9"/></operation></sensor>'
)
_lines(
    "robot.xml",
    {
        what: (_ROBOT + before, one + "\n", after + "</robot>\n")
        for what, (before, one, after) in {
            "sensors": ("", '<sensor name="S#" device="range"/>', ""),
            "sensors of one name": ("", '<sensor name="S" device="range"/>', ""),
            "sensors with tests": ("", _SENSOR, ""),
            "sensors of unknown devices": ("", '<sensor name="S#" device="d#"/>', ""),
            "actuators": ("", '<actuator name="A#" device="lamp"><procedure name="On"/></actuator>', ""),
            "procedures of one actuator": (
                '<actuator name="A" device="lamp">',
                '<procedure name="P#"/>',
                "</actuator>",
            ),
            "procedures that stop nothing": (
                '<actuator name="A" device="lamp">',
                '<procedure name="P#" completes="later" stop="Q#"/>',
                "</actuator>",
            ),
            "procedures that stop one another": (
                '<actuator name="A" device="lamp">',
                '<procedure name="P#" completes="later" stop="P0"/>',
                "</actuator>",
            ),
            "parameters of one procedure": (
                '<actuator name="A" device="lamp"><procedure name="P">',
                '<parameter name="p#" min="0" max="9"/>',
                "</procedure></actuator>",
            ),
            "variables": ("", '<variable name="V#" min="0" max="9" initial="0"/>', ""),
            "boolean variables": ("", '<variable name="V#" type="boolean" initial="true"/>', ""),
            "boards": ("", '<board name="b#"/>', ""),
            "unknown things": ("", "<thing/>", ""),
            "labels": ("", '<label xml:lang="l#">x</label>', ""),
        }.items()
    },
)

_GROUP = '<constructors version="1"><group name="G" colour="loop">\n'
_lines(
    "constructors.xml",
    {
        what: (
            '<constructors version="1"><group name="G" colour="loop">\n' + before,
            one + "\n",
            after + "</group></constructors>\n",
        )
        for what, (before, one, after) in {
            "constructors": ("", '<constructor name="C#"><code>3*(WAIT(1);)</code></constructor>', ""),
            "constructors of one name": (
                "",
                '<constructor name="C"><code>3*(WAIT(1);)</code></constructor>',
                "",
            ),
            "constructors with slots": (
                "",
                '<constructor name="C#"><flow name="body"/><code>3*({body})</code></constructor>',
                "",
            ),
            "slots of one constructor": (
                '<constructor name="C">',
                '<flow name="s#"/>',
                "<code>3*({s0})</code></constructor>",
            ),
            "holes that are no slots": (
                '<constructor name="C"><code>',
                "3*({s#});",
                "</code></constructor>",
            ),
            "constructors with a hole twice": (
                "",
                '<constructor name="C#"><flow name="s"/><code>{s}{s}</code></constructor>',
                "",
            ),
            "codes that are no LLL": ("", '<constructor name="C#"><code>?(</code></constructor>', ""),
            "groups": ("", '</group><group name="K#" colour="loop">', ""),
            "unknown things": ("", "<thing/>", ""),
        }.items()
    },
)

_STEP = "<step><label>Do</label><help>Do it.</help><contains><code>Wheel.Advance({speed})</code></contains></step>"
_lines(
    "tutorial.xml",
    {
        what: ('<tutorial version="1"><label>T</label><help>T.</help>\n' + before, one + "\n", after + "</tutorial>\n")
        for what, (before, one, after) in {
            "steps": ("", _STEP, ""),
            "steps that are empty": ("", "<step/>", ""),
            "unknown things": ("", "<thing/>", ""),
            "patterns of one step": (
                "<step><label>Do</label><help>Do it.</help>",
                "<contains><code>Wheel.Stop()</code></contains>",
                "</step>",
            ),
            "ranges of one pattern": (
                "<step><label>Do</label><help>Do it.</help><contains><code>Wheel.Advance({s})</code>",
                '<hole name="h#" min="1" max="2"/>',
                "</contains></step>",
            ),
            "instructions of one pattern": (
                "<step><label>Do</label><help>Do it.</help><contains><code>",
                "Wheel.Stop();",
                "</code></contains></step>",
            ),
        }.items()
    },
)

_lines(
    "xml",
    {
        "comments before the first element": ("", "<!-- -->", "<robot/>"),
        "instructions before the first element": ("", "<?x y?>", "<robot/>"),
        "comments that do not end": ("", "<!-- ", ""),
        "document types": ("", "<!DOCTYPE x [", ""),
        "entities": ("<robot>", "&amp;", "</robot>"),
        "unknown entities": ("<robot>", "&x;", "</robot>"),
        "elements in one another": ("", "<robot>", ""),
        "spaces": ("", " ", ""),
        "angles": ("", "<", ""),
    },
)

# -- inputs

_lines(
    "csv",
    {
        "rows": ("tick,Captor\n", "#,5\n", ""),
        "rows of one tick": ("tick,Captor\n", "5,5\n", ""),
        "rows that go back": ("tick,Captor\n9999999,5\n", "#,5\n", ""),
        "rows with too few cells": ("tick,Captor\n", "#\n", ""),
        "rows without numbers": ("tick,Captor\n", "x,y\n", ""),
        "rows with values that are no numbers": ("tick,Captor\n", "#,y\n", ""),
        "blank lines": ("tick,Captor\n", "\n", ""),
        "carriage returns": ("tick,Captor\n", "\r", ""),
        "spaces": ("tick,Captor\n", " ", ""),
        "columns": ("tick", ",Captor#", "\n0\n"),
        "columns of one name": ("tick", ",Captor", "\n0\n"),
        "columns of one unknown name": ("tick", ",Captorr", "\n0\n"),
        "columns of no name": ("tick", ",", "\n0\n"),
        "done columns": ("tick", ",done:Motor#", "\n0\n"),
        "cells of one row": ("tick,Captor\n0", ",5", "\n"),
        "quotation marks": ("tick,Captor\n0,", '"', "\n"),
        "quotation marks with a space": ("tick,Captor\n0,", '" ', "\n"),
        "quoted cells": ("tick,Captor\n", '"#","5"\n', ""),
        "quoted cells that do not end": ("tick,Captor\n0", ',"', "\n"),
        "spaces in a cell": ("tick,Captor\n0,", " ", "5\n"),
        "spaces before a quotation mark": ("tick,Captor\n0,", " ", '"5\n'),
        "letters of a column": ("tick,Captor", "r", "\n0,5\n"),
        "digits": ("tick,Captor\n0,", "9", "\n"),
    },
)

# -- listings and images

_KRA = ".robot 0000000000000000\n.tick 20\n.wait-unit 100\n"
_lines(
    "kra",
    {
        "comments": (_KRA, "; a comment\n", ""),
        "cells": (_KRA, ".cell 0\n", ""),
        "slots": (_KRA, ".slot - 0 0 1\n", ""),
        "directives that nobody knows": (_KRA, ".x\n", ""),
        "spaces": (_KRA, " ", ""),
    },
)


@shape("kra instructions")
def _listing(n: int) -> str:
    from kitrobot.compiler import compile_text
    from kitrobot.image import disassemble
    from kitrobot.primitives import load_catalogue

    image = compile_text("Wheel.Stop();\n" * min(n, 8000), load_catalogue([]).robot("mini-robot")).image
    assert image is not None
    return disassemble(image)


@shape("kra parallels")
def _parallel_listing(n: int) -> str:
    from kitrobot.compiler import compile_text
    from kitrobot.image import disassemble
    from kitrobot.primitives import load_catalogue

    text = "//(Wheel.Stop();, WAIT(5););\n" * min(n, 100)
    image = compile_text(text, load_catalogue([]).robot("mini-robot")).image
    assert image is not None
    return disassemble(image)


# -- pictures

_lines(
    "svg",
    {
        "shapes": ("<svg>", "<path/>", "</svg>"),
        "comments": ("<svg>", "<!-- x -->", "</svg>"),
        "beginnings of a mission": ("<svg>", "<metadata>", "</svg>"),
        "missions": ("<svg>", '<metadata><kitrobot version="1"/></metadata>', "</svg>"),
    },
)


def _png(chunks: Iterable[tuple[bytes, bytes]]) -> bytes:
    found = b"\x89PNG\r\n\x1a\n"
    for kind, data in chunks:
        found += struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return found


@shape("png chunks")
def _chunks(n: int) -> bytes:
    one = _png([(b"tEXt", b"a\0b")])[8:]
    return _png([(b"IHDR", bytes(13))]) + one * n + _png([(b"IEND", b"")])[8:]


@shape("png bytes of a text")
def _text_chunk(n: int) -> bytes:
    return _png([(b"IHDR", bytes(13)), (b"iTXt", b"kitrobot\0" + b"a" * n), (b"IEND", b"")])


_lines(
    "pdf",
    {
        "objects": ("%PDF-1.7\n", "# 0 obj\n<< /Type /X >>\nendobj\n", "%%EOF"),
        "beginnings of objects": ("%PDF-1.7\n", "1 0 obj <<", "%%EOF"),
        "beginnings of dictionaries": ("%PDF-1.7\n1 0 obj ", "<<", "%%EOF"),
        "beginnings of arrays": ("%PDF-1.7\n1 0 obj ", "[", "%%EOF"),
        "beginnings of texts": ("%PDF-1.7\n1 0 obj ", "(", "%%EOF"),
        "streams": ("%PDF-1.7\n", "# 0 obj\n<< /Length 1 >>\nstream\nx\nendstream\nendobj\n", "%%EOF"),
        "streams that do not end": ("%PDF-1.7\n", "# 0 obj\n<< /Length 99 >>\nstream\n", "%%EOF"),
        "streams of compressed objects": (
            "%PDF-1.7\n",
            "# 0 obj\n<< /Type /ObjStm /N 1 /First 4 /Length 9 >>\nstream\n1 0 <<>> \nendstream\nendobj\n",
            "%%EOF",
        ),
        "ends": ("%PDF-1.7\n", "startxref\n9\n%%EOF\n", ""),
        "references": ("%PDF-1.7\n", "trailer << /Root # 0 R /Prev 9 >>\n", "%%EOF"),
        "embedded files": (
            "%PDF-1.7\n",
            "# 0 obj\n<< /Type /Filespec /F (a.krt) /EF << /F # 0 R >> >>\nendobj\n",
            "%%EOF",
        ),
        "comments": ("%PDF-1.7\n", "% x\n", "%%EOF"),
        "line feeds": ("%PDF-1.7\n", "\n", "%%EOF"),
    },
)


def content(made: str | bytes) -> bytes:
    """What is made, as the bytes of a file."""
    return made if isinstance(made, bytes) else made.encode()


__all__ = ["SHAPES", "content", "mission"]
