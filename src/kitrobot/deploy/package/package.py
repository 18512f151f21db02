"""The files of a board: the modules of `kitrobot_onboard` that it needs, and the drivers of a program's devices.

A small board has a flat folder, so every module becomes one file, minified, named by the start of the SHA-256 of its
content; its imports of other modules of ours are rewritten to such names first. So the name of the first module
identifies all of them, an unchanged module keeps its name, and two installations can exist side by side.

Drivers are found by the name in a robot's XML: shipped ones by family of boards, then those for any; a user's own
`NAME.driver.py` in the configuration folder and then in the mission's, of which the later one wins.
"""

from __future__ import annotations

import ast
import copy
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path
from threading import Lock

from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.minification.minifier import parsed
from kitrobot.deploy.minification.short_names import own_names, renamed
from kitrobot.deploy.minification.tree_shaking import UsedParts, trim_driver, trim_shared_module
from kitrobot.deploy.package.board_package import BoardPackage, LoopInstaller
from kitrobot.deploy.package.content_names import TEAM_DRIVER, name_of
from kitrobot.deploy.package.declarations import DriverDeclaration, read_declaration, without_declarations
from kitrobot.deploy.package.onboard_bundle import (
    ONBOARD,
    ROOT,
    minified_module,
    read_source,
    requests_file,
    short_text,
)
from kitrobot.text.sentences import COMMA, Sentence, Series

OWN_SUFFIX = ".driver.py"
_BUILDING = Lock()
"""Trees of Python are shared, and written to while they are made short."""

WITH_LINES = frozenset({"machine"})
"""Kinds of boards with room for drivers as their users wrote them, so that a fault names the line."""

TRIMMED = "drivers.microbit.shared"
"""The package of modules with what several drivers of the smallest board are, which are trimmed as a driver is."""

_REMEMBERED = 200
"""Drivers whose declarations are remembered."""

FAMILIES: Mapping[str, Sequence[str]] = {"microbit": ("microbit", "any"), "machine": ("machine", "any")}
"""Kinds of boards, with the folders of shipped drivers that they look into; each has its module in `ports`."""


@lru_cache(_REMEMBERED)
def _cached_declaration(text: str, path: str) -> DriverDeclaration:
    return read_declaration(parsed(text, path), path)


@dataclass(frozen=True)
class Package:
    """The package, with the folders in which drivers of the user are looked for, the one that wins last."""

    folders: Sequence[Path] = ()

    def candidates(self, driver: str, family: str) -> list[Path]:
        """Where a driver may be, the one that wins first."""
        plain = driver.replace("-", "_")
        own = [folder / f"{name}{OWN_SUFFIX}" for folder in self.folders for name in dict.fromkeys((plain, driver))]
        shipped = [ONBOARD / "drivers" / folder / f"{plain}.py" for folder in FAMILIES[family]]
        return [*reversed(own), *shipped]

    def driver_file(self, driver: str, family: str) -> Path | None:
        """The file of a driver, or None. A name that could lead elsewhere has none."""
        if not driver.replace("-", "_").isidentifier():
            return None
        return next((path for path in self.candidates(driver, family) if path.is_file()), None)

    def missing(self, drivers: Iterable[str], family: str | None = None) -> list[str]:
        """Those drivers that are there for no board, or not for this family."""
        families = (family,) if family is not None else tuple(FAMILIES)
        return [one for one in dict.fromkeys(drivers) if all(self.driver_file(one, each) is None for each in families)]

    def declared(self, driver: str, family: str) -> DriverDeclaration:
        """The declaration of a driver; an empty one when there is none.

        Raises:
            PackageError: its declaration is malformed, or it is no Python.
        """
        path = self.driver_file(driver, family)
        return _cached_declaration(read_source(path), str(path)) if path is not None else DriverDeclaration()

    def build(self, family: str, drivers: Mapping[str, UsedParts | None], installer: LoopInstaller) -> BoardPackage:
        """The package for a kind of board, with these drivers, each with its used parts; None: everything. From
        any thread.

        Raises:
            PackageError: a driver is missing, or is no Python.
        """
        with _BUILDING:
            return self._build(family, drivers, installer)

    def _build(self, family: str, drivers: Mapping[str, UsedParts | None], installer: LoopInstaller) -> BoardPackage:
        builder = _PackageBuilder(shared=self._shared(family, drivers))
        modules = {}
        wants_range = {}
        in_lines = {}
        for driver, used in drivers.items():
            path = self.driver_file(driver, family)
            if path is None:
                raise missing_driver(driver, self, family)
            text = builder.in_lines(path) if family in WITH_LINES and path.name.endswith(OWN_SUFFIX) else None
            if text is not None:
                modules[driver], in_lines[driver] = builder.store(text), path.name
            else:
                modules[driver] = builder.add(path, used) + ".py"
            wants_range[driver] = re.search(rb"""["']m(in|ax)["']""", builder.files[modules[driver]]) is not None
        tends = frozenset(driver for driver in drivers if self._tends(driver, family))
        bases = {
            driver: builder.bases[path]
            for driver in drivers
            if (path := self.driver_file(driver, family)) in builder.bases
        }
        built = replace(
            _built(family, builder, modules, wants_range, installer), tends=tends, bases=bases, in_lines=in_lines
        )
        if TEAM_DRIVER not in drivers:
            return built
        member = minified_module(ONBOARD / "member.py")
        name = name_of(member) + ".py"
        return replace(built, files={name: member, **built.files}, member=name)

    def _shared(self, family: str, drivers: Mapping[str, UsedParts | None]) -> dict[Path, UsedParts]:
        """The used parts of the modules that only drivers import."""
        found: dict[Path, UsedParts] = {}
        whole: set[Path] = set()
        for driver, used in drivers.items():
            for path in self._shared_by(driver, family):
                if used is None:
                    whole.add(path)
                else:
                    found[path] = found.get(path, UsedParts()) | used
        return {path: used for path, used in found.items() if path not in whole}

    def _shared_by(self, driver: str, family: str) -> list[Path]:
        """The shared modules with whole devices that a driver imports (see `TRIMMED`)."""
        path = self.driver_file(driver, family)
        if path is None:
            return []
        text = read_source(path)
        folder = ONBOARD.joinpath(*TRIMMED.split("."))
        named = dict.fromkeys(re.findall(rf"{re.escape(f'{ROOT}.{TRIMMED}.')}(\w+) ", text))
        return [folder / f"{name}.py" for name in named if (folder / f"{name}.py").is_file()]

    def _tends(self, driver: str, family: str) -> bool:
        path = self.driver_file(driver, family)
        return any(
            "def tend(" in read_source(one) for one in [*self._shared_by(driver, family), *([path] if path else [])]
        )


def _built(
    family: str,
    builder: _PackageBuilder,
    drivers: Mapping[str, str],
    wants_range: Mapping[str, bool],
    installer: LoopInstaller,
) -> BoardPackage:
    package = _PackageBuilder()
    requests = package.store(requests_file(family))
    loop = installer.build_files(family, requests, package.store)
    start = package.store(loop.start)
    main = package.files["main.py"] = minified_module(ONBOARD / "boot.py")
    package.files["krboot.py"] = minified_module(ONBOARD / "krboot.py")
    module = name_of(b"".join(sorted(package.files.values())))
    del package.files["main.py"]
    files = {**builder.files, **package.files}
    return BoardPackage(
        family, files, module, loop.interpreter, start, loop.compiled, drivers, wants_range, main, installer
    )


def missing_driver(driver: str, package: Package, family: str) -> PackageError:
    """The error that names the files which were looked for."""
    files = [path for path in package.candidates(driver, family) if ".." not in driver and "/" not in driver]
    own = driver.replace("-", "_") + OWN_SUFFIX
    where = Series(COMMA, dict.fromkeys(str(path.parent) for path in files if path.name.endswith(OWN_SUFFIX)))
    shipped = f"drivers/{family}/{driver.replace('-', '_')}.py"
    return PackageError(
        Sentence(
            "there is no driver `{driver}` for this kind of board: neither `{own}` in {where} nor "
            "`{shipped}` of KitRobot",
            driver,
            own,
            where or Sentence("the mission’s folder"),
            shipped,
        ),
        Sentence("write `{own}` beside the mission, or name another driver in the robot's XML", own),
    )


@dataclass
class _PackageBuilder:
    """Files by name, and the names of the modules that were made already: as drivers (True), and to be imported."""

    files: dict[str, bytes] = field(default_factory=dict)
    names: dict[tuple[Path, bool], str] = field(default_factory=dict)
    open: list[Path] = field(default_factory=list)
    shared: Mapping[Path, UsedParts] = field(default_factory=dict)
    bases: dict[Path, str] = field(default_factory=dict)

    def add(self, path: Path, used: UsedParts | None = None) -> str:
        """Adds a module and those that it imports; its name. `used`: its used parts, when it is a driver."""
        made = path, used is not None  # what is trimmed for being a driver, nobody can import names of
        if made in self.names:
            return self.names[made]
        if path in self.open:
            raise PackageError(
                Sentence("`{path}` imports itself through others", path.name), Sentence("undo the circle of imports")
            )
        self.open.append(path)
        tree = parsed(read_source(path), str(path))
        tree = without_declarations(tree)
        if used is None and path in self.shared:
            tree = trim_shared_module(tree, self.shared[path])
        tree = _Imports(self, path).visit(tree if used is None else trim_driver(tree, used))
        self.open.pop()
        if used is not None:
            tree = renamed(tree, own_names(tree))
        name = self.store(short_text(ast.unparse(ast.fix_missing_locations(tree))).encode())[: -len(".py")]
        self.names[made] = name
        return name

    def in_lines(self, path: Path) -> bytes | None:
        """A driver with every line where it is in its file; its imports of ours, which it adds, have the board's names.
        None when that cannot be said so: MicroPython knows no annotations of variables, and a line has one import.
        """
        text = read_source(path)
        tree = parsed(text, str(path))
        lines = text.split("\n")
        for node in ast.walk(tree):
            if isinstance(node, ast.AnnAssign):
                return None
            if isinstance(node, ast.Import | ast.ImportFrom):
                if isinstance(node, ast.ImportFrom) and node.module in ("__future__", "typing"):
                    return None
                made = _Imports(self, path).visit(copy.deepcopy(node))
                end = node.end_lineno or node.lineno
                there = "\n".join(lines[node.lineno - 1 : end])
                if there.strip() != (ast.get_source_segment(text, node) or ""):
                    return None
                words = ";".join(ast.unparse(one) for one in (made if isinstance(made, list) else [made]))
                lines[node.lineno - 1 : end] = [" " * node.col_offset + words, *[""] * (end - node.lineno)]
        return "\n".join(lines).encode()

    def store(self, content: bytes) -> str:
        """Adds a file; its name."""
        name = name_of(content) + ".py"
        self.files[name] = content
        return name


class _Imports(ast.NodeTransformer):
    """Rewrites imports of modules of ours to the names that these have on the board."""

    def __init__(self, builder: _PackageBuilder, path: Path) -> None:
        self.builder = builder
        self.path = path

    def visit_ImportFrom(self, node: ast.ImportFrom) -> ast.AST | list[ast.stmt]:
        words = (node.module or "").split(".")
        if node.level or words[0] != ROOT:
            return node
        place = ONBOARD.joinpath(*words[1:])
        if place.with_suffix(".py").is_file() and place != ONBOARD:
            node.module = self.builder.add(place.with_suffix(".py"))
            if ".".join(words[1:-1]) == TRIMMED:
                self.builder.bases[self.path] = f"{node.module}.py"
                return []  # its names are in the driver's space already
            return node
        found: list[ast.stmt] = []
        for alias in node.names:
            path = place / f"{alias.name}.py"
            if not path.is_file():
                raise self._unknown(f"{node.module}.{alias.name}", node)
            name = self.builder.add(path)
            found.append(ast.Import([ast.alias(name, alias.asname or alias.name)]))
        return found

    def visit_Import(self, node: ast.Import) -> ast.AST:
        for alias in node.names:
            if alias.name.split(".")[0] == ROOT:
                raise self._unknown(alias.name, node)
        return node

    def _unknown(self, name: str, node: ast.stmt) -> PackageError:
        return PackageError(
            Sentence(
                "`{path}` line {line} imports `{module}`, which cannot be brought onto a board so",
                self.path,
                node.lineno,
                name,
            ),
            Sentence("import it as `from kitrobot_onboard.MODULE import NAME`, from a module that is there"),
        )
