"""Worlds."""

from __future__ import annotations

from tests.growth.shapes.registry import lines, shape

_WORLD = '<world name="w" version="1" width="3000" height="2000">\n'
_ROAD = (
    '<road name="r" width="100"><point x="10" y="10"/><point x="2990" y="10"/></road>'
    '<storehouse name="h" x="10" y="50" width="50" height="50" capacity="5"/>'
)
lines(
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
