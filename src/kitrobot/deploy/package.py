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
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import kitrobot_onboard
from kitrobot.deploy.constants import Constants, constants_of, told_in_place
from kitrobot.deploy.declarations import Declared, declared, without_declarations
from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.naming import renamed, short_names, with_short_parameters
from kitrobot.deploy.shortening import parsed, shortened
from kitrobot_onboard.asked import ASKED

ONBOARD = Path(kitrobot_onboard.__file__).parent
_ROOT = "kitrobot_onboard"
MODULE, PROGRAM, DIGITS = "kr", "kp", 8
OWN_SUFFIX = ".driver.py"
_MOST_BYTES = 200_000

FAMILIES: Mapping[str, Sequence[str]] = {"microbit": ("microbit", "any"), "machine": ("machine", "any")}
"""Kinds of boards, with the folders of shipped drivers that they look into; each has its module in `ports`."""

FIRST_TO_LAST = ("+start", "-", "+whole", "-", "+device", "+equip", "+perform", "-", "+arrays", "+load", "-")
STAYING = ("robot", "hearing", "obeying", "sensing", "acting", "link", "reaction", "perform")
"""Modules of the package in the order in which a board takes them, as `kitrobot_onboard.boot` says: the largest first,
because there is less and less room to compile them."""

_NOT_CARRIED = ("__init__.py", "boot.py", "krboot.py", "image.py", "receiver.py")
"""Modules of `kitrobot_onboard` that no other module on a board imports."""


def name_of(content: bytes, kind: str = MODULE) -> str:
    """The name of something by its content."""
    return kind + hashlib.sha256(content).hexdigest()[:DIGITS]


@dataclass(frozen=True)
class Built:
    """A package for one kind of board: `files` by name, the first `module`, the `drivers`' modules, `main.py`."""

    files: Mapping[str, bytes]
    module: str
    drivers: Mapping[str, str]
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

    def built(self, family: str, drivers: Iterable[str]) -> Built:
        """The package for a kind of board, with these drivers.

        Raises:
            PackageError: a driver is missing, or is no Python.
        """
        making = _Making()
        first = making.add_port(ONBOARD / "ports" / f"{family}.py")
        modules = {}
        for driver in dict.fromkeys(drivers):
            path = self.driver_file(driver, family)
            if path is None:
                raise missing_driver(driver, self, family)
            modules[driver] = making.add(path)
        main, choosing = (shortened(parsed(_read(ONBOARD / name), name)).encode() for name in ("boot.py", "krboot.py"))
        making.files["krboot.py"] = choosing
        return Built(making.files, first, modules, main)


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

    def add(self, path: Path) -> str:
        """Adds a module and those that it imports; its name."""
        if path in self.names:
            return self.names[path]
        if path in self.open:
            raise PackageError(f"`{path.name}` imports itself through others", "undo the circle of imports")
        self.open.append(path)
        tree = parsed(_read(path), str(path))
        if path in _carried():
            tree = told_in_place(tree, constants_of(tree), _constants())
            tree = renamed(tree, _names())
        else:
            tree = without_declarations(tree)
        tree = _Imports(self, path).visit(tree)
        self.open.pop()
        return self._file(tree, path)

    def add_port(self, path: Path) -> str:
        """Adds the first module, which tells what else there is: what only starts, what stays, what is asked."""
        tree = parsed(_read(path), str(path))
        told = {
            "FILES": self._stored("".join(map(self.add_part, (*FIRST_TO_LAST, *STAYING))).encode()) + ".py",
            "ASKED": self._stored(asked_file()) + ".py",
        }
        tree.body = [statement for statement in tree.body if not _is_for_the_package(statement)]
        interpreter = self.add(ONBOARD / "interpreter.py")  # the largest, while there is room
        tree.body[:0] = [
            ast.Import([ast.alias(interpreter)]),
            *(ast.Assign([ast.Name(name)], ast.Constant(text)) for name, text in told.items()),
        ]
        return self._file(renamed(tree, _names()), path)

    def add_part(self, part: str) -> str:
        """Adds a file whose names share a space with those of others, so that it needs no imports of ours; its word."""
        mark, name = (part[0], part[1:]) if part[0] in "+-" else ("=", part)
        if not name:
            return f"{mark:18}"
        path = ONBOARD / f"{name}.py"
        name = self.names[path] = self._stored(_part(path))
        return f"{mark}{name}.py{len(_part(path)):04}"

    def _file(self, tree: ast.Module, path: Path) -> str:
        name = self.names[path] = self._stored(_short(ast.unparse(ast.fix_missing_locations(tree))).encode())
        return name

    def _stored(self, content: bytes) -> str:
        name = name_of(content)
        self.files[name + ".py"] = content
        return name


@cache
def _part(path: Path) -> bytes:
    tree = parsed(_read(path), str(path))
    tree = renamed(told_in_place(tree, constants_of(tree), _constants()), _names())
    for statement in tree.body[:]:
        if isinstance(statement, ast.ImportFrom) and (statement.module or "").startswith(_ROOT):
            if statement.module == f"{_ROOT}.interpreter":
                statement.module = _Making().add(ONBOARD / "interpreter.py")
            else:
                tree.body.remove(statement)
    return _short(ast.unparse(ast.fix_missing_locations(with_short_parameters(tree)))).encode()


def asked_file() -> bytes:
    """What a board reads when it is asked: each answer behind its letter and its size."""
    parts = {kind: _part(ONBOARD / "asked" / f"{name}.py") for kind, name in ASKED.items()}
    return b"".join(f"{kind} {len(part)}\n".encode() + part for kind, part in parts.items())


def _is_for_the_package(statement: ast.stmt) -> bool:
    match statement:
        case ast.Assign(targets=[ast.Name(id="FILES"), *_]):
            return True
    return False


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
def _names() -> Mapping[str, str]:
    trees = [parsed(_read(path), path.name) for path in sorted(_carried())]
    return short_names(trees, parsed(_read(ONBOARD / "boot.py"), "boot.py"))


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
            for alias in node.names:
                short = _names().get(alias.name)
                if short is not None and place.with_suffix(".py") in _carried():
                    alias.name, alias.asname = short, alias.asname or alias.name
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
