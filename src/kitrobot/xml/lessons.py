"""What tutorials and exercises have in common as files: they begin with a mission beside them, and have a name.

<tutorial version="1" start="first.krt" icon="flag"><label>First steps</label>…</tutorial>
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

from kitrobot.diagnostics.model import Rule
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import ICON, Attribute, Kind, needed, optional, version, whole
from kitrobot.xml.element import LONGEST_NAME, Element, Tag
from kitrobot.xml.texts import TEXTS

LAST: Final = 1000
"""The order of a lesson that says none."""

_START: Final = re.compile(r"""[^\\/:*?"<>|\x00-\x1f]+\.krt""", re.IGNORECASE)
_MISSION_NAME: Final = Kind(
    longest=LONGEST_NAME,
    pattern=r"""[^\\/:*?"<>|]+\.[kK][rR][tT]""",
    fits=_START.fullmatch,
    words=Sentence("the name of a .krt in the same folder"),
)


def lesson_tag(newest: int, children: Mapping[str, Tag], more: Mapping[str, Attribute], about: str) -> Tag:
    """The first element of such a file, whose newest version is `newest`; `more` are the attributes that it adds."""
    own = {
        "version": version(newest),
        "start": needed(_MISSION_NAME, about="The mission to begin with, in the same folder."),
        "icon": optional(ICON),
        "order": optional(whole(0, LAST), str(LAST), about="Its place on the path to learn, among those of a folder."),
    }
    return Tag(
        None,
        {**own, **more},
        {**TEXTS, **children},
        open=lambda element: element.version(newest),
        least=1,
        about=about,
    )


def require_label(root: Element, rule: Rule, help: Sentence) -> None:
    """Reports that there is no label in English."""
    if "" not in root.texts.get("label", {}):
        root.report(rule, Sentence("expected a <label> in English, found none"), help=help)
