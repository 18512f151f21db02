"""What a file holds that is not ours: unknown elements, attributes with a prefix, comments, instructions `<?…?>`.

All of it is text that is kept as it stood. An element takes the namespaces along that it needs (`bound`), so it means
the same wherever it is written again. What is written is always XML that other programs read: a prefix that nobody
declares gets a made-up namespace, and what is no XML stands in a comment.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache

from kitrobot.xml.expat_parser import DoctypeError, ExpatError, new_parser
from kitrobot.xml.writer import attributes, plain_characters

XMLNS = "xmlns"
_DECLARES = "xmlns:"
_ALWAYS = frozenset({"xml", "xmlns"})
_SCHEMA_INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
_NAME = re.compile(r"[^\W\d][\w.-]*:[^\W\d][\w.-]*|xmlns")
_START = re.compile(r"<[^\s/>!?]+")


def is_foreign(attribute: str) -> bool:
    """Whether an attribute has a prefix, or declares a namespace."""
    return ":" in attribute or attribute == XMLNS


def declares(attribute: str) -> bool:
    """Whether an attribute declares a namespace."""
    return attribute == XMLNS or attribute.startswith(_DECLARES)


def in_scope(around: Mapping[str, str], attributes: Mapping[str, str]) -> Mapping[str, str]:
    """Prefix → namespace inside an element with these attributes; "" is the prefix of names without one."""
    own = {name.removeprefix(XMLNS).removeprefix(":"): value for name, value in attributes.items() if declares(name)}
    return {**around, **own} if own else around


def bound(raw: str, scope: Mapping[str, str]) -> str:
    """An element, word for word, with the namespaces of `scope` that it uses and does not declare itself."""
    free = _free_prefixes(raw) if scope else None
    wanted = [
        (f"xmlns:{prefix}" if prefix else XMLNS, scope[prefix]) for prefix in sorted(free or ()) if prefix in scope
    ]
    start = _START.match(raw)
    return raw if start is None or not wanted else start.group() + attributes(*wanted) + raw[start.end() :]


def fragment(raw: str) -> str:
    """XML that is kept, as it is written inside an element; in a comment where it is no XML."""
    free = _free_prefixes(raw)
    if free is not None and _parses(f"<x{_declared(free)}>{raw}</x>"):
        return raw
    return as_comment(raw)


def remark(raw: str) -> str:
    """A comment or an instruction, as it is written before the first element; what is neither becomes a comment."""
    return raw if _parses(f" {raw}<x/>") else as_comment(raw)


def as_comment(text: str) -> str:
    """A comment that holds a text, whose hyphens are parted."""
    return f"<!-- {plain_characters(re.sub('-(?=-)', '- ', text))} -->"


def head(kept: Mapping[str, str], raws: Iterable[str] = ()) -> tuple[str, list[str]]:
    """What is foreign in a start tag, and comments with those attributes that cannot be written there.

    Args:
        kept: attributes with a prefix, and declarations of namespaces, by name.
        raws: what is kept inside the element; prefixes that it does not declare are declared here.
    """
    named = {name: value for name, value in kept.items() if _NAME.fullmatch(name)}
    free = {prefix for raw in raws for prefix in _free_prefixes(raw) or ()}
    free |= {name.partition(":")[0] for name in named if not declares(name)}
    free -= {name.removeprefix(_DECLARES) for name in named} | _ALWAYS
    whole = attributes(*named.items()) + _declared(free)
    if len(named) == len(kept) and _parses(f"<x{whole}/>"):
        return whole, []
    written, lost = _declared(free), []
    for name, value in kept.items():
        one = attributes((name, value))
        if name in named and _parses(f"<x{written}{one}/>"):
            written += one
        else:
            lost.append(as_comment(one.strip()))
    return written, lost


def _declared(prefixes: Iterable[str]) -> str:
    made = {prefix: _SCHEMA_INSTANCE if prefix == "xsi" else f"urn:kitrobot:prefix:{prefix}" for prefix in prefixes}
    return attributes(*((f"xmlns:{prefix}", made[prefix]) for prefix in sorted(made) if prefix))


@lru_cache(maxsize=256)
def _free_prefixes(raw: str) -> frozenset[str] | None:
    """The prefixes that XML uses and does not declare, "" for names without one; None where it is not well-formed."""
    scopes: list[frozenset[str]] = [_ALWAYS]
    free: set[str] = set()

    def start(name: str, attributes: dict[str, str]) -> None:
        declared = {one.removeprefix(XMLNS).removeprefix(":") for one in attributes if declares(one)}
        scopes.append(scopes[-1] | declared if declared else scopes[-1])
        if len(scopes) > 2:  # inside of the element that stands around it all
            used = {name.partition(":")[0] if ":" in name else ""}
            used.update(one.partition(":")[0] for one in attributes if ":" in one)
            free.update(used - scopes[-1])

    parser = new_parser("utf-8")
    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: scopes.pop() and None
    try:
        parser.Parse(f"<x>{raw}</x>".encode(), True)
    except (ExpatError, DoctypeError, UnicodeEncodeError):
        return None
    return frozenset(free)


@lru_cache(maxsize=256)
def _parses(text: str) -> bool:
    """Whether a program that knows namespaces reads it."""
    try:
        new_parser("utf-8", namespaces=True).Parse(text.encode(), True)
    except (ExpatError, DoctypeError, UnicodeEncodeError):
        return False
    return True
