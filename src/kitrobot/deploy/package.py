"""What lands on a board: the modules of `kitrobot_onboard` that it needs, and the drivers of a program's devices.

A small board has a flat folder, so every module becomes one file, shortened, named by the start of the SHA-256 of what
is in it; its imports of other modules of ours are rewritten to such names first. So the name of the first module stands
for all of them, a module that did not change keeps its name, and two installations can lie side by side.

Drivers are looked for by the name that a robot's XML gives: shipped ones by family of boards, then those for any; a
user's own `NAME.driver.py` in the configuration folder and then in the mission's, of which the later one wins.
"""

from __future__ import annotations

import ast
import hashlib
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import kitrobot_onboard
from kitrobot.deploy.constants import Constants, constants_of, told_in_place
from kitrobot.deploy.declarations import Declared, declared, without_declarations
from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.known import GLOBALS, LOCALS
from kitrobot.deploy.naming import own_names, renamed, short_names
from kitrobot.deploy.shortening import parsed, shortened
from kitrobot.deploy.trimming import Asked, trimmed
from kitrobot_onboard.asked import ASKED, BY_FAMILY

ONBOARD = Path(kitrobot_onboard.__file__).parent
_ROOT = "kitrobot_onboard"
MODULE, PROGRAM, DIGITS = "kr", "kp", 8
OWN_SUFFIX = ".driver.py"
_MOST_BYTES = 200_000
_LARGE = "wTi"
"""Requests that only boards with more room answer."""

_WORDS = 8
_PIECE = 90
"""Letters of a piece of a script, where a statement needs no more."""

FAMILIES: Mapping[str, Sequence[str]] = {"microbit": ("microbit", "any"), "machine": ("machine", "any")}
"""Kinds of boards, with the folders of shipped drivers that they look into; each has its module in `ports`."""

LOOP = ("reaction", "robot", "link", "obeying", "hearing", "acting")
"""Modules of the loop in the order in which a board compiles them: the largest first, because there is less and less
room for it."""

_SCRIPTED = ("asked", "driver", "error", "package", "space", "where")
"""Names of variables that only a program file has."""

_NOT_CARRIED = ("__init__.py", "arrays.py", "image.py", "receiver.py")
"""Modules of `kitrobot_onboard` that share no names with the others on a board."""


def name_of(content: bytes, kind: str = MODULE) -> str:
    """The name of something by its content."""
    return kind + hashlib.sha256(content).hexdigest()[:DIGITS]


@dataclass(frozen=True)
class Built:
    """A package for one kind of board.

    Args:
        files: by name, without `main`, which is `main.py`.
        module: what the whole is called.
        interpreter: the name of its module.
        port, loop, asked: names of files; the loop's in the order in which a board takes them.
        drivers: names of files by names of drivers.
        wants_range: of each driver, whether it reads the settings `min` and `max`, which every sensor has.
    """

    files: Mapping[str, bytes]
    module: str
    interpreter: str
    port: str
    loop: Sequence[str]
    asked: str
    drivers: Mapping[str, str]
    wants_range: Mapping[str, bool]
    main: bytes


@dataclass(frozen=True)
class Package:
    """The package, with the folders in which drivers of the user are looked for, the one that wins last."""

    folders: Sequence[Path] = ()

    def looked_for(self, driver: str, family: str) -> list[Path]:
        """Where a driver may be, the one that wins first."""
        plain = driver.replace("-", "_")
        own = [folder / f"{name}{OWN_SUFFIX}" for folder in self.folders for name in dict.fromkeys((plain, driver))]
        shipped = [ONBOARD / "drivers" / folder / f"{plain}.py" for folder in FAMILIES[family]]
        return [*reversed(own), *shipped]

    def driver_file(self, driver: str, family: str) -> Path | None:
        """The file of a driver, or None. A name that could lead elsewhere has none."""
        if not driver.replace("-", "_").isidentifier():
            return None
        return next((path for path in self.looked_for(driver, family) if path.is_file()), None)

    def missing(self, drivers: Iterable[str], family: str | None = None) -> list[str]:
        """Those drivers that are there for no board, or not for this family."""
        families = (family,) if family is not None else tuple(FAMILIES)
        return [one for one in dict.fromkeys(drivers) if all(self.driver_file(one, each) is None for each in families)]

    def declared(self, driver: str, family: str) -> Declared:
        """What a driver says of itself; nothing when there is none.

        Raises:
            PackageError: it says that as it should not, or is no Python.
        """
        path = self.driver_file(driver, family)
        return declared(parsed(_read(path), str(path)), str(path)) if path is not None else Declared()

    def built(self, family: str, drivers: Mapping[str, Asked | None]) -> Built:
        """The package for a kind of board, with these drivers, each with what is asked of it; None: everything.

        Raises:
            PackageError: a driver is missing, or is no Python.
        """
        making = _Making()
        modules = {}
        wants_range = {}
        for driver, asked in drivers.items():
            path = self.driver_file(driver, family)
            if path is None:
                raise missing_driver(driver, self, family)
            modules[driver] = making.add(path, asked) + ".py"
            wants_range[driver] = re.search(rb"""["']m(in|ax)["']""", making.files[modules[driver]]) is not None
        return _built(family, making, modules, wants_range)


def _built(family: str, making: _Making, drivers: Mapping[str, str], wants_range: Mapping[str, bool]) -> Built:
    package = _Making()
    interpreter = package.stored(_interpreter())[: -len(".py")]
    loop = [package.stored(_part(ONBOARD / f"{name}.py")) for name in LOOP]
    port = package.stored(_part(ONBOARD / "ports" / f"{family}.py"))
    asked = package.stored(asked_file(family))
    main = _part(ONBOARD / "boot.py")
    package.files["krboot.py"] = _part(ONBOARD / "krboot.py")
    module = name_of(b"".join([*sorted(package.files.values()), main, *(text.encode() for text in pieces("begin"))]))
    return Built({**making.files, **package.files}, module, interpreter, port, loop, asked, drivers, wants_range, main)


def missing_driver(driver: str, package: Package, family: str) -> PackageError:
    """The error that names the files which were looked for."""
    files = [path for path in package.looked_for(driver, family) if ".." not in driver and "/" not in driver]
    own = driver.replace("-", "_") + OWN_SUFFIX
    where = ", ".join(dict.fromkeys(str(path.parent) for path in files if path.name.endswith(OWN_SUFFIX)))
    shipped = f"drivers/{family}/{driver.replace('-', '_')}.py"
    return PackageError(
        f"there is no driver `{driver}` for this kind of board: neither `{own}` in {where or 'the mission’s folder'}"
        f" nor `{shipped}` of KitRobot",
        f"write `{own}` beside the mission, or name another driver in the robot's XML",
    )


@dataclass
class _Making:
    """Files by name, and the names of the modules that were made already."""

    files: dict[str, bytes] = field(default_factory=dict)
    names: dict[Path, str] = field(default_factory=dict)
    open: list[Path] = field(default_factory=list)

    def add(self, path: Path, asked: Asked | None = None) -> str:
        """Adds a module and those that it imports; its name. `asked`: what of it, when it is a driver."""
        if path in self.names:
            return self.names[path]
        if path in self.open:
            raise PackageError(f"`{path.name}` imports itself through others", "undo the circle of imports")
        self.open.append(path)
        tree = parsed(_read(path), str(path))
        tree = without_declarations(tree)
        tree = _Imports(self, path).visit(tree if asked is None else trimmed(tree, asked))
        self.open.pop()
        if asked is not None:
            tree = renamed(tree, own_names(tree))
        name = self.stored(_short(ast.unparse(ast.fix_missing_locations(tree))).encode())[: -len(".py")]
        self.names[path] = name
        return name

    def stored(self, content: bytes) -> str:
        """Adds a file; its name."""
        name = name_of(content) + ".py"
        self.files[name] = content
        return name


def _interpreter() -> bytes:
    path = ONBOARD / "interpreter.py"
    return _short(ast.unparse(renamed(parsed(_read(path), path.name), short()))).encode()


@cache
def _tree(path: Path) -> ast.Module:
    """A module whose names share a space with those of others, so that it needs no imports of ours."""
    tree = parsed(_read(path), str(path))
    tree = renamed(told_in_place(tree, constants_of(tree), _constants()), short())
    tree.body = [
        statement
        for statement in tree.body
        if not (isinstance(statement, ast.ImportFrom) and (statement.module or "").startswith(_ROOT))
    ]
    return tree


@cache
def _part(path: Path) -> bytes:
    return _short(ast.unparse(_tree(path))).encode()


@cache
def pieces(name: str) -> Sequence[str]:
    """A script of the package in pieces, each short enough that a small board can compile it while a program runs."""
    found: list[str] = []
    room = 0
    for statement in _tree(ONBOARD / f"{name}.py").body:
        text = _short(ast.unparse(statement))
        if not text:
            continue  # a docstring
        plain = not isinstance(statement, ast.If | ast.For | ast.FunctionDef)
        if plain and found and len(text) < room:
            found[-1] += ";" + text
            room -= 1 + len(text)
        else:
            found.append(text)
            room = _PIECE - len(text) if plain else 0
    return found


@cache
def words() -> Sequence[str]:
    """What the answers that a small board compiles need names of, in pieces that do nothing but name them.

    A name is kept for ever, wherever there was room when it was first read; among the working memory of a program, it
    would cut that in two.
    """
    found: set[str | bytes] = set()
    for name in {name for kind, names in ASKED.items() if kind not in _LARGE for name in names}:
        for node in (one for piece in pieces(f"asked/{name}") for one in ast.walk(ast.parse(piece))):
            match node:
                case ast.Name(id=word) | ast.Attribute(attr=word) | ast.Constant(value=str(word) | bytes(word)):
                    found.add(word)
                case ast.Import():
                    found.update(alias.name for alias in node.names)
    listed = [repr(word) for word in sorted(found, key=repr) if word not in {*GLOBALS, *LOCALS}]
    return [",".join(listed[at : at + _WORDS]) for at in range(0, len(listed), _WORDS)]


def asked_file(family: str) -> bytes:
    """What a board reads when it is asked: each piece of an answer behind its letter and its size."""
    found = ""
    for kind, names in ASKED.items():
        for name in BY_FAMILY.get(family, {}).get(kind, names):
            found += "".join(f"{kind}{len(piece):03}{piece}" for piece in pieces(f"asked/{name}"))
    return found.encode()


@cache
def _carried() -> frozenset[Path]:
    """The modules that call one another; drivers are called by fixed names only."""
    return frozenset(
        path
        for folder in (ONBOARD, ONBOARD / "ports", ONBOARD / "asked")
        for path in folder.glob("*.py")
        if path.name not in _NOT_CARRIED
    )


@cache
def _constants() -> Mapping[str, Constants]:
    return {f"{_ROOT}.{path.stem}": constants_of(parsed(_read(path), path.name)) for path in _carried()}


@cache
def short() -> Mapping[str, str]:
    """What the names that the modules of the package share are on a board."""
    trees = [parsed(_read(path), path.name) for path in sorted(_carried())]
    return short_names([told_in_place(tree, constants_of(tree), _constants()) for tree in trees], _SCRIPTED)


@cache
def _short(text: str) -> str:
    return shortened(ast.parse(text))


def _read(path: Path) -> str:
    try:
        data = path.read_bytes()
        if len(data) > _MOST_BYTES:
            raise PackageError(f"`{path}` is too large for a board: {len(data)} bytes", "make it shorter")
        return data.decode("utf-8-sig")
    except OSError as error:
        raise PackageError(f"`{path}` cannot be read: {error.strerror}", "look at its rights") from error
    except UnicodeDecodeError:
        raise PackageError(f"`{path}` is no UTF-8 text", "save it as UTF-8") from None


class _Imports(ast.NodeTransformer):
    """Rewrites imports of modules of ours to the names that these have on the board."""

    def __init__(self, making: _Making, path: Path) -> None:
        self.making = making
        self.path = path

    def visit_ImportFrom(self, node: ast.ImportFrom) -> ast.AST | list[ast.stmt]:
        words = (node.module or "").split(".")
        if node.level or words[0] != _ROOT:
            return node
        place = ONBOARD.joinpath(*words[1:])
        if place.with_suffix(".py").is_file() and place != ONBOARD:
            node.module = self.making.add(place.with_suffix(".py"))
            return node
        found: list[ast.stmt] = []
        for alias in node.names:
            path = place / f"{alias.name}.py"
            if not path.is_file():
                raise self._unknown(f"{node.module}.{alias.name}", node)
            name = self.making.add(path)
            found.append(ast.Import([ast.alias(name, alias.asname or alias.name)]))
        return found

    def visit_Import(self, node: ast.Import) -> ast.AST:
        for alias in node.names:
            if alias.name.split(".")[0] == _ROOT:
                raise self._unknown(alias.name, node)
        return node

    def _unknown(self, name: str, node: ast.stmt) -> PackageError:
        return PackageError(
            f"`{self.path}` line {node.lineno} imports `{name}`, which cannot be brought onto a board so",
            "import it as `from kitrobot_onboard.MODULE import NAME`, from a module that is there",
        )
