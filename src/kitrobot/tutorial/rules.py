"""The rules of tutorials: what can be wrong with one beyond its XML."""

from __future__ import annotations

from kitrobot.diagnostics.model import Severity, rule

PATTERN = rule(
    "tutorial-pattern",
    Severity.ERROR,
    "A tutorial's pattern cannot be looked for",
    "`<contains>` and `<matches>` hold one `<code>`: LLL with holes, at most 20 levels deep. Each `<hole>` beside it "
    "names a hole of that code, with `min` at most `max`.",
)
POINT = rule(
    "tutorial-point",
    Severity.ERROR,
    "A step points at nothing, or at several things",
    "A `<point>` has one of `part`, `vertex`, `button`, `panel`, `program` and `group`; beside `vertex` may stand "
    "`setting` or `slot`, beside `group` may stand `failure`, to point inside it.",
)
START = rule(
    "tutorial-start",
    Severity.ERROR,
    "A tutorial has nothing to begin with",
    "`start` is the file name of a `.krt` in the folder of the tutorial.",
)
