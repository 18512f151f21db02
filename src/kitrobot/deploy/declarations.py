"""What a driver declares to the host: the settings that it accepts, and the procedures that it can execute.

A driver may have, at its top level,

    SETTINGS = {"pin": "pin", "time": "1..60000 = 1000", "active": "high|low = high", "threshold": "1..65535?"}
    PROCEDURES = "Open Close"

A setting is a `pin` (a number or a name), a `shared` pin, to which several parts may be wired whose settings have the
same name (a bus, the motors of two drivers), a pin that is only read and so an `input` of several parts, a `text`, a
whole number in a range, or one of several words; `= VALUE` is the default, `?` marks an optional setting. Both are read
without running the driver and are left out of what is installed on a board. A driver without declarations gets all
settings of the XML, unchecked. `WAVES` says which pins get square waves (waves).
"""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from kitrobot.deploy.errors import PackageError
from kitrobot.text import COMMA, Sentence, Series

ALWAYS = frozenset({"limit"})
"""Settings of actuators that the robot's loop understands itself."""

_NAMES = ("SETTINGS", "PROCEDURES", "WAVES")
_PINS = ("pin", "shared", "input")
_KIND = re.compile(
    r"(?P<kind>pin|shared|input|text|(?P<least>-?[0-9]{1,9})\.\.(?P<most>-?[0-9]{1,9})|(?P<words>[^\s|?=]+(\|[^\s|?=]+)+))"
    r"(?P<optional>\s*\?|\s*=\s*\S+)?"
)


@dataclass(frozen=True)
class Setting:
    """One setting: a whole number from `least` to `most`, one of `words`, or, without either, any word.

    `usual`: what it is when it is not given. `joined`: how other parts may be wired to the same pin, `shared`, `input`
    or "" for not at all.
    """

    is_pin: bool
    needed: bool
    least: int | None = None
    most: int | None = None
    words: tuple[str, ...] = ()
    joined: str = ""
    usual: str = ""


@dataclass(frozen=True)
class Declared:
    """What a driver says of itself; None where it says nothing."""

    settings: Mapping[str, Setting] | None = None
    procedures: tuple[str, ...] | None = None
    waves: Mapping[str, str] = field(default_factory=dict)


def declared(tree: ast.Module, path: str) -> Declared:
    """What a driver declares.

    Raises:
        PackageError: a declaration is not written as it should be.
    """
    settings: dict[str, Setting] | None = None
    procedures: tuple[str, ...] | None = None
    waves: dict[str, str] = {}
    for statement in tree.body:
        match statement:
            case ast.Assign(targets=[ast.Name(id="SETTINGS")], value=value):
                settings = _settings(_literal(value), path, statement.lineno)
            case ast.Assign(targets=[ast.Name(id="PROCEDURES")], value=value):
                words = _literal(value)
                if not isinstance(words, str):
                    raise PackageError(
                        Sentence("`{path}` line {line}: PROCEDURES must be a text of names", path, statement.lineno),
                        Sentence('write it as in PROCEDURES = "Open Close"'),
                    )
                procedures = tuple(words.split())
            case ast.Assign(targets=[ast.Name(id="WAVES")], value=value):
                waves = _waves(_literal(value), path, statement.lineno)
    return Declared(settings, procedures, waves)


def without_declarations(tree: ast.Module) -> ast.Module:
    """The driver as a board needs it."""
    tree.body = [
        statement
        for statement in tree.body
        if not (
            isinstance(statement, ast.Assign)
            and isinstance(statement.targets[0], ast.Name)
            and statement.targets[0].id in _NAMES
        )
    ]
    return tree


def refuse_what_is_not_understood(
    part: str, driver: str, says: Declared, procedures: Sequence[str] | None, settings: Mapping[str, str]
) -> None:
    """Checks what a part of a robot says against what its driver understands. `procedures`: None for a sensor.

    Raises:
        PackageError: the first thing that the driver does not understand.
    """
    for procedure in procedures or ():
        if says.procedures is not None and procedure not in says.procedures:
            raise PackageError(
                Sentence(
                    "`{part}` has the procedure `{procedure}`, which the driver `{driver}` cannot do",
                    part,
                    procedure,
                    driver,
                ),
                Sentence("it can do {procedures}", _listed(says.procedures)),
            )
    if says.settings is None:
        return
    for name, value in settings.items():
        known = says.settings.get(name)
        if known is not None:
            _refuse_value(part, name, value, known)
        elif procedures is None or name not in ALWAYS:
            raise PackageError(
                Sentence(
                    "`{part}` has the setting `{setting}`, which the driver `{driver}` does not know",
                    part,
                    name,
                    driver,
                ),
                Sentence("it knows {settings}", _listed(says.settings)) if says.settings else Sentence("it knows none"),
            )
    for name, setting in says.settings.items():
        if setting.needed and name not in settings:
            raise PackageError(
                Sentence(
                    "`{part}` does not say its `{setting}`, which the driver `{driver}` needs", part, name, driver
                ),
                Sentence('write {setting}="…" into its <board> in the robot’s XML, or name a kit (--board)', name),
            )


def pins_of(says: Declared, settings: Mapping[str, str]) -> list[tuple[str, str, Setting]]:
    """The pins that a part is wired to: the name of the setting, the pin, and what the driver says of it."""
    known = says.settings or {}
    return [(name, value, known[name]) for name, value in settings.items() if name in known and known[name].is_pin]


def may_join(name: str, setting: Setting, other: str, other_setting: Setting) -> bool:
    """Whether two parts may be wired to one pin, by the names and the declarations of their settings."""
    if setting.joined != other_setting.joined or not setting.joined:
        return False
    return setting.joined == "input" or name == other


def _refuse_value(part: str, name: str, value: str, known: Setting) -> None:
    if known.words and value not in known.words:
        raise PackageError(
            Sentence(
                "`{setting}` of `{part}` must be one of {words}, and it is `{value}`",
                name,
                part,
                _listed(known.words),
                value,
            ),
            Sentence("mend it in the <board> in the robot’s XML"),
        )
    if known.least is None or known.most is None:
        return
    if not re.fullmatch(r"[+-]?[0-9]{1,12}", value) or not known.least <= int(value) <= known.most:
        raise PackageError(
            Sentence(
                "`{setting}` of `{part}` must be a whole number from {least} to {most}, and it is `{value}`",
                name,
                part,
                known.least,
                known.most,
                value,
            ),
            Sentence("mend it in the <board> in the robot’s XML"),
        )


def _settings(value: object, path: str, line: int) -> dict[str, Setting]:
    found = {}
    for name, text in value.items() if isinstance(value, dict) else [(None, None)]:
        kind = _KIND.fullmatch(text) if isinstance(text, str) else None
        if kind is None or not isinstance(name, str):
            raise PackageError(
                Sentence("`{path}` line {line}: SETTINGS must say of each setting what it is", path, line),
                Sentence('write it as in SETTINGS = {"pin": "pin", "time": "1..60000 = 1000", "active": "high|low?"}'),
            )
        least, most = kind["least"], kind["most"]
        found[name] = Setting(
            kind["kind"] in _PINS,
            kind["optional"] is None,
            int(least) if least is not None else None,
            int(most) if most is not None else None,
            tuple(kind["words"].split("|")) if kind["words"] else (),
            kind["kind"] if kind["kind"] in _PINS[1:] else "",
            (kind["optional"] or "").partition("=")[2].strip(),
        )
    return found


def _waves(value: object, path: str, line: int) -> dict[str, str]:
    found = value if isinstance(value, dict) else {0: 0}
    if all(isinstance(name, str) and isinstance(words, str) and words.strip() for name, words in found.items()):
        return dict(found)
    raise PackageError(
        Sentence("`{path}` line {line}: WAVES must say of each setting its frequency", path, line),
        Sentence('write it as in WAVES = {"pin": "50"}'),
    )


def _literal(value: ast.expr) -> object:
    try:
        return ast.literal_eval(value)
    except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
        return None


def _listed(names: Sequence[str] | Mapping[str, object]) -> str:
    return Series(COMMA, (f"`{name}`" for name in names))
