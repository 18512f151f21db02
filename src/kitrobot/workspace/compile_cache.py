"""A cache of compiled programs, by their value.

Between two edits most of a mission stays as it was, and a typed text is compared with the very graph whose report was
requested a moment ago. A cached program is found only when it is equal and everything it is compiled with is the same
object: robots and constructors that were read again are other objects. So no entry is ever out of date; it may only be
evicted, and is then compiled again. Safe to use from many threads; cached values must not be changed.
"""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Hashable, Sequence
from dataclasses import dataclass

from kitrobot.compiler.compilation import CheckResult, CompiledProgram, compile_program
from kitrobot.compiler.graph.graph_to_lll import Translation, graph_to_lll
from kitrobot.graph.model import Program
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.crew import Crew
from kitrobot.primitives.own_xml import OwnVariable

MOST_VERTICES = 20_000
"""Of all cached programs together: some 50 MB."""
MOST_STATES = 2
"""Of one program: as it is, and as it was before the last edit. More would only be further away in memory."""
MOST_CATALOGUES = 16


class CachedProgram:
    """A program, its catalogue, and its compilation results, each computed once, on first use."""

    def __init__(
        self, program: Program, catalogue: Catalogue, translation: Translation | None, checked: CheckResult | None
    ) -> None:
        self.program = program
        self.catalogue = catalogue
        self._checked = checked
        self._lock = threading.RLock()
        self._translation = translation
        self._compiled: CompiledProgram | None = None

    @property
    def translation(self) -> Translation:
        """The program as LLL. Raises KitRobotError when its robot is not at hand."""
        with self._lock:
            if self._translation is None:
                self._translation = graph_to_lll(self.program, self.catalogue)
            return self._translation

    @property
    def compiled(self) -> CompiledProgram:
        """The program compiled. Raises KitRobotError when its robot is not at hand."""
        with self._lock:
            if self._compiled is None:
                self._compiled = compile_program(self.program, self.catalogue, self.translation, self._checked)
            return self._compiled


@dataclass(frozen=True)
class _CatalogueExtension:
    common: Catalogue
    constructors: tuple[Constructor, ...]
    variables: tuple[OwnVariable, ...]
    crew: Crew | None
    catalogue: Catalogue

    def is_of(
        self,
        common: Catalogue,
        constructors: Sequence[Constructor],
        variables: Sequence[OwnVariable],
        crew: Crew | None,
    ) -> bool:
        same = _are_identical(self.constructors, constructors) and _are_identical(self.variables, variables)
        return self.common is common and same and self.crew == crew


class CompileCache:
    """The newest states of the newest programs, up to `most_vertices` in all."""

    def __init__(self, most_vertices: int = MOST_VERTICES) -> None:
        self._most_vertices = most_vertices
        self._lock = threading.Lock()
        self._programs: OrderedDict[Hashable, CachedProgram] = OrderedDict()
        self._vertices = 0
        self._catalogues: list[_CatalogueExtension] = []

    def catalogue(
        self,
        common: Catalogue,
        constructors: Sequence[Constructor],
        variables: Sequence[OwnVariable],
        crew: Crew | None = None,
    ) -> Catalogue:
        """`common.extended(…)`: the same object for the same parts."""
        with self._lock:
            for cached in self._catalogues:
                if cached.is_of(common, constructors, variables, crew):
                    return cached.catalogue
        made = common.extended(constructors, variables, crew)
        with self._lock:
            del self._catalogues[: -MOST_CATALOGUES + 1]
            self._catalogues.append(_CatalogueExtension(common, tuple(constructors), tuple(variables), crew, made))
        return made

    def of(
        self,
        program: Program,
        catalogue: Catalogue,
        translation: Translation | None = None,
        checked: CheckResult | None = None,
    ) -> CachedProgram:
        """The cached program; it is added if it is missing. `translation` and `checked` as for `compile_program`."""
        with self._lock:
            key = self._key(program, catalogue)
            cached = self._programs.get(key)
            if cached is not None:
                self._programs.move_to_end(key)
                return cached
            cached = self._programs[key] = CachedProgram(program, catalogue, translation, checked)
            self._vertices += len(program.vertices)
            states = [
                one
                for one, other in self._programs.items()
                if other.catalogue is catalogue and other.program.name == program.name
            ]
            for old in states[:-MOST_STATES]:
                self._evict(old)
            while self._vertices > self._most_vertices:
                self._evict(next(iter(self._programs)))
        return cached

    def _key(self, program: Program, catalogue: Catalogue) -> Hashable:
        for key, one in self._programs.items():
            if one.program is program and one.catalogue is catalogue:
                return key
        return id(catalogue), _value(program)

    def _evict(self, key: Hashable) -> None:
        self._vertices -= len(self._programs.pop(key).program.vertices)


def _value(program: Program) -> Hashable:
    """All that a program says, order included; the order of settings matters for unknown elements."""
    vertices = tuple(
        (
            one.id,
            one.element,
            tuple(one.settings.items()),
            tuple((note.text, note.at) for note in one.notes),
            one.unknown,
        )
        for one in program.vertices
    )
    arcs = tuple((one.source, one.out, one.target, one.at) for one in program.arcs)
    return program.name, program.target, program.level, vertices, arcs


def _are_identical(cached: Sequence[object], given: Sequence[object]) -> bool:
    return len(cached) == len(given) and all(one is other for one, other in zip(cached, given, strict=True))
