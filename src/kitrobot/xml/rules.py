"""The rules of every XML file: what can be wrong with one, each with the page that explains it."""

from __future__ import annotations

from kitrobot.diagnostics.model import Severity, rule

NOT_WELL_FORMED = rule(
    "xml-not-well-formed",
    Severity.ERROR,
    "The file is not XML",
    "Every element that is opened is closed again, in the opposite order; attribute values stand in quotes; in text, "
    "`<` and `&` are written `&lt;` and `&amp;`. A file that was cut off while it was copied shows up here as well.",
)
ENCODING = rule(
    "xml-encoding",
    Severity.ERROR,
    "The file is not UTF-8",
    "Files are read as UTF-8, or as UTF-16 when they begin with a byte order mark. Save the file again as UTF-8.",
)
FORBIDDEN = rule(
    "xml-forbidden",
    Severity.ERROR,
    "The file holds a DTD",
    "A document type or an entity of one's own (`<!DOCTYPE …>`, `<!ENTITY …>`) is never read: entities can make a "
    "small file explode or pull in other files, and nothing here needs them.",
)
TOO_DEEP = rule(
    "xml-too-deep",
    Severity.ERROR,
    "Elements are nested too deep",
    "No file of ours needs more than a handful of levels. Deeper ones are damaged or made to hurt.",
)
TOO_LARGE = rule(
    "xml-too-large",
    Severity.ERROR,
    "The file is too large",
    "A file above the limit is not read at all.",
)
WRONG_ROOT = rule(
    "xml-wrong-root",
    Severity.ERROR,
    "The file is of another kind",
    "The first element says what a file is: `<constructors>`, `<robot>`, `<kitrobot>` for a mission, `<world>`.",
)
NEWER_VERSION = rule(
    "xml-newer-version",
    Severity.ERROR,
    "The file was made by a newer KitRobot",
    "`version` in the first element counts the changes of the format. A file of a version this KitRobot does not know "
    "is not touched, so that nothing in it is lost.",
)
UNKNOWN_ELEMENT = rule(
    "xml-unknown-element",
    Severity.WARNING,
    "An element is not known here",
    "The element is left out, or kept word for word where the message says so; everything else is used.",
)
UNKNOWN_ATTRIBUTE = rule(
    "xml-unknown-attribute",
    Severity.WARNING,
    "An attribute is not known here",
    "The attribute is left out; everything else is used.",
)
UNKNOWN_LANGUAGE = rule(
    "xml-unknown-language",
    Severity.WARNING,
    "A text is in a language that is not spoken here",
    "Texts are shown in the languages of the page; without `xml:lang` they are English. One in another language is "
    "kept, and nobody is shown it.",
)
LONG_TEXT = rule(
    "xml-long-text",
    Severity.ERROR,
    "A text is too long",
    "A label stands beside others on a card or in a list, and a help below it: what is longer than the limit has no "
    "room there.",
)
STRAY_TEXT = rule(
    "xml-stray-text",
    Severity.WARNING,
    "Text stands where none belongs",
    "The text is left out; everything else is used.",
)
MISSING = rule(
    "xml-missing",
    Severity.ERROR,
    "Something that must be there is missing",
    "An element lacks an attribute or a part that it cannot do without.",
)
BAD_VALUE = rule(
    "xml-bad-value",
    Severity.ERROR,
    "An attribute's value cannot be used",
    "The message says what was expected: a number in a range, one of a few words, a name.",
)
DUPLICATE = rule(
    "xml-duplicate",
    Severity.ERROR,
    "A name is used twice",
    "Things of one kind need different names, else nobody can say which one is meant.",
)
TOO_MANY = rule(
    "xml-too-many-problems",
    Severity.WARNING,
    "More problems than are shown",
    "Only the first problems of a file are listed. Mend those and look again.",
)
