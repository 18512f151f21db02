"""What a driver declares to the host: the settings that it accepts, and the procedures that it can execute.

A driver may have, at its top level,

    SETTINGS = {"pin": "pin", "time": "1..60000 = 1000", "active": "high|low = high", "threshold": "1..65535?"}
    PROCEDURES = "Open Close"

A setting is a `pin` (a number or a name), a `shared` pin, to which several parts may be wired whose settings have the
same name (a bus, the motors of two drivers), a pin that is only read and so an `input` of several parts, a `text`, a
whole number in a range, or one of several words; `= VALUE` is the default, `?` marks an optional setting. Both are read
without running the driver and are left out of what is installed on a board. A driver without declarations gets all
settings of the XML, unchecked. `WAVES` says which pins get square waves (waves). `CHIP` names the chip without whose
board there is no such device: `"nrf52833"` that of the micro:bit V2.

What a setting is may depend on another one,

    SETTINGS = {"motors": "pins|pca9685 = pins", "forward": "channel 0..15 where motors=pca9685; shared"}

the first that holds counts, and none: the driver does not know the setting then. A `channel` is an output of the chip
at the I2C bus `sda`, `scl` and the address that the setting NAME`-address` says, where `where NAME=…` names the chip.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from kitrobot.deploy.errors import PackageError
from kitrobot.primitives.kit import CHIPS
from kitrobot.text.sentences import COMMA, Sentence, Series

ALWAYS = frozenset({"limit"})
"""Settings of actuators that the robot's loop understands itself."""

_NAMES = ("SETTINGS", "PROCEDURES", "WAVES", "CHIP")
_PINS = ("pin", "shared", "input")
_KIND = re.compile(
    r"(?P<kind>pin|shared|input|text|(?P<channel>channel\s+)?(?P<least>-?[0-9]{1,9})\.\.(?P<most>-?[0-9]{1,9})"
    r"|(?P<words>[^\s|?=]+(\|[^\s|?=]+)+))"
    r"(?P<optional>\s*\?|\s*=\s*\S+)?"
    r"(\s+where\s+(?P<where>[^\s=]+)=(?P<value>[^\s=]+))?"
)


@dataclass(frozen=True)
class Setting:
    """One setting: a whole number from `least` to `most`, one of `words`, or, without either, any word.

    `usual`: what it is when it is not given. `joined`: how other parts may be wired to the same pin, `shared`, `input`
    or "" for not at all. `where`: the name and the value of another setting, without which it is `otherwise`, or not
    known. `is_channel`: it is an output of a chip, to which other parts may be wired as to a `shared` pin.
    """

    is_pin: bool
    needed: bool
    least: int | None = None
    most: int | None = None
    words: tuple[str, ...] = ()
    joined: str = ""
    usual: str = ""
    is_channel: bool = False
    where: tuple[str, str] | None = None
    otherwise: Setting | None = None


@dataclass(frozen=True)
class Wire:
    """What a setting of a part is wired to, `target`: a pin, or a channel of a chip. Two wires that lead to one
    thing have the same `place`.
    """

    name: str
    target: str
    place: tuple[str, ...]
    setting: Setting


@dataclass(frozen=True)
class DriverDeclaration:
    """The declaration of a driver; None where it declares nothing. `chip`: the only one that it is for; "": any."""

    settings: Mapping[str, Setting] | None = None
    procedures: tuple[str, ...] | None = None
    waves: Mapping[str, str] = field(default_factory=dict)
    chip: str = ""

    def known(self, given: Mapping[str, str]) -> dict[str, Setting]:
        """The settings beside those that are `given`; none for a driver that declares nothing."""
        found: dict[str, Setting] = {}
        for name, first in (self.settings or {}).items():
            setting: Setting | None = first
            while setting is not None and setting.where is not None and not self._is(*setting.where, given):
                setting = setting.otherwise
            if setting is not None:
                found[name] = setting
        return found

    def _is(self, name: str, value: str, given: Mapping[str, str]) -> bool:
        usual = (self.settings or {}).get(name)
        return given.get(name, usual.usual if usual is not None else "") == value


def read_declaration(tree: ast.Module, path: str) -> DriverDeclaration:
    """What a driver declares.

    Raises:
        PackageError: a declaration is not written as it should be.
    """
    settings: dict[str, Setting] | None = None
    procedures: tuple[str, ...] | None = None
    waves: dict[str, str] = {}
    chip = ""
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
            case ast.Assign(targets=[ast.Name(id="CHIP")], value=value):
                chip = _chip(_literal(value), path, statement.lineno)
    return DriverDeclaration(settings, procedures, waves, chip)


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
    part: str,
    driver: str,
    declaration: DriverDeclaration,
    procedures: Sequence[str] | None,
    settings: Mapping[str, str],
) -> None:
    """Checks the settings and procedures of a part against its driver's declaration. `procedures`: None for a sensor.

    Raises:
        PackageError: the first thing that the driver does not understand.
    """
    for procedure in procedures or ():
        if declaration.procedures is not None and procedure not in declaration.procedures:
            raise PackageError(
                Sentence(
                    "`{part}` has the procedure `{procedure}`, which the driver `{driver}` cannot do",
                    part,
                    procedure,
                    driver,
                ),
                Sentence("it can do {procedures}", _listed(declaration.procedures)),
            )
    if declaration.settings is None:
        return
    refuse_conditions(part, declaration, settings)
    known = declaration.known(settings)
    for name, value in settings.items():
        if name in known:
            _refuse_value(part, name, value, known[name])
        elif procedures is None or name not in ALWAYS:
            raise PackageError(
                Sentence(
                    "`{part}` has the setting `{setting}`, which the driver `{driver}` does not know",
                    part,
                    name,
                    driver,
                ),
                counts_only([declaration], name)
                or (Sentence("it knows {settings}", _listed(known)) if known else Sentence("it knows none")),
            )
    for name, setting in known.items():
        if setting.needed and name not in settings:
            raise PackageError(
                Sentence(
                    "`{part}` does not say its `{setting}`, which the driver `{driver}` needs", part, name, driver
                ),
                Sentence('write {setting}="…" into its <board> in the robot’s XML, or name a kit (--board)', name),
            )


def refuse_conditions(part: str, declaration: DriverDeclaration, settings: Mapping[str, str]) -> None:
    """Raises a PackageError when a setting is invalid on which others depend, instead of one about these others."""
    for name, setting in (declaration.settings or {}).items():
        if setting.where is not None and setting.where[0] in settings and setting.where[0] != name:
            condition = declaration.known(settings).get(setting.where[0])
            if condition is not None:
                _refuse_value(part, setting.where[0], settings[setting.where[0]], condition)


def counts_only(declarations: Iterable[DriverDeclaration], name: str) -> Sentence | None:
    """The help for a setting that drivers know, but not beside the others that are given; None: they know it never."""
    for declaration in declarations:
        setting = (declaration.settings or {}).get(name)
        if setting is not None and setting.where is not None:
            return Sentence('it counts only with {setting}="{value}"', *setting.where)
    return None


def wires_of(known: Mapping[str, Setting], settings: Mapping[str, str]) -> list[Wire]:
    """The wires of a part, by its driver's declaration."""
    found = []
    for name, value in settings.items():
        setting = known.get(name)
        if setting is not None and setting.is_pin:
            found.append(Wire(name, value, (value,), setting))
        elif setting is not None and setting.is_channel and setting.where is not None:
            address = f"{setting.where[0]}-address"
            usual = known[address].usual if address in known else ""
            numbers = (_plain(value), _plain(settings.get(address, usual)))
            found.append(Wire(name, value, (settings.get("sda", ""), settings.get("scl", ""), *numbers), setting))
    return found


def _plain(number: str) -> str:
    """A number written in the shortest way; another text stays what it is."""
    return str(int(number)) if re.fullmatch(r"[+-]?[0-9]{1,12}", number) else number


def refuse_wire(part: str, wire: Wire, other: str | None, help: Sentence) -> None:
    """Raises a PackageError: a part is wired to what it, or the `other` one, is wired to already."""
    if wire.setting.is_channel:
        raise PackageError(
            Sentence("`{part}` says the channel `{channel}` for two different things", part, wire.target)
            if other is None
            else Sentence(
                "`{part}` and `{other}` both use the channel `{channel}` of one chip", other, part, wire.target
            ),
            Sentence("give one of them another channel"),
        )
    raise PackageError(
        Sentence("`{part}` says the pin `{pin}` for two different things", part, wire.target)
        if other is None
        else Sentence("`{part}` and `{other}` are both wired to the pin `{pin}`", other, part, wire.target),
        help,
    )


def may_join(one: Wire, other: Wire) -> bool:
    """Whether two parts may be wired to one pin or channel, by the names and the declarations of their settings."""
    if one.setting.joined == other.setting.joined == "input":
        return True
    shared = one.setting.joined == other.setting.joined == "shared" or one.setting.is_channel
    return shared and one.name == other.name


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
        kinds = [_KIND.fullmatch(one.strip()) for one in text.split(";")] if isinstance(text, str) else []
        setting = _setting(kinds)
        if setting is None or not isinstance(name, str):
            raise PackageError(
                Sentence("`{path}` line {line}: SETTINGS must say of each setting what it is", path, line),
                Sentence('write it as in SETTINGS = {"pin": "pin", "time": "1..60000 = 1000", "active": "high|low?"}'),
            )
        found[name] = setting
    return found


def _setting(kinds: Sequence[re.Match[str] | None]) -> Setting | None:
    """What is written as several kinds, the first that holds counts; None: it is not written so."""
    found: Setting | None = None
    for number, kind in enumerate(reversed(kinds)):
        if kind is None or (kind["where"] is None and (number or kind["channel"])):
            return None
        least, most = kind["least"], kind["most"]
        found = Setting(
            kind["kind"] in _PINS,
            kind["optional"] is None,
            int(least) if least is not None else None,
            int(most) if most is not None else None,
            tuple(kind["words"].split("|")) if kind["words"] else (),
            kind["kind"] if kind["kind"] in _PINS[1:] else "",
            (kind["optional"] or "").partition("=")[2].strip(),
            kind["channel"] is not None,
            (kind["where"], kind["value"]) if kind["where"] is not None else None,
            found,
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


def _chip(value: object, path: str, line: int) -> str:
    if isinstance(value, str) and value in CHIPS:
        return value
    raise PackageError(
        Sentence("`{path}` line {line}: CHIP must be one of {chips}", path, line, _listed(CHIPS)),
        Sentence("leave it out where the driver is for every board of its kind"),
    )


def _literal(value: ast.expr) -> object:
    try:
        return ast.literal_eval(value)
    except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
        return None


def _listed(names: Sequence[str] | Mapping[str, object]) -> str:
    return Series(COMMA, (f"`{name}`" for name in names))
