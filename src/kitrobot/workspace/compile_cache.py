"""A cache of compiled programs, for the next question about the same mission.

Between two edits most of a mission stays as it was, and a typed text is compared with the very graph whose report was
requested a moment ago. A cached program is found only when it is equal and everything it is compiled with is the same
object: robots and constructors that were read again are other objects. So no entry is ever out of date; it may only be
evicted, and is then compiled again. Each entry has a name that no other cache gives, so that a request about an edit
need not send the whole program. Safe to use from many threads; cached values must not be changed.
"""

from __future__ import annotations

import itertools
import secrets
import threading
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from kitrobot.compiler.compilation import Compiled, compile_program
from kitrobot.compiler.graph_to_lll import Translation, graph_to_lll
from kitrobot.compiler.retranslation import graph_to_lll_again
from kitrobot.graph.model import Program, Vertex
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.crew import Crew
from kitrobot.primitives.own_xml import OwnVariable
from kitrobot.workspace.program_report import ProgramReport, program_report

MOST_VERTICES = 20_000
"""Of all cached programs together: some 50 MB."""
MOST_STATES = 2
"""Of one program: as it is, and as it was before the last edit. More would only be further away in memory."""
MOST_NAMED = 10
"""Times `MOST_VERTICES`, of all programs that have a name: states of a program share what did not change in them."""
MOST_CATALOGUES = 16

_Key = tuple[int, int]
"""The ids of a program and its catalogue; they are not reused while the cache holds the objects."""


class CachedProgram:
    """A program, its catalogue, and its compilation results, each computed on first use."""

    def __init__(
        self,
        program: Program,
        catalogue: Catalogue,
        translation: Translation | None = None,
        *,
        sound: bool = False,
        before: Translation | None = None,
    ) -> None:
        self._before = before
        self.program = program
        self.catalogue = catalogue
        self.name = ""
        """By which the program is found again for some time."""
        self._given = translation
        self._sound = sound

    @cached_property
    def translation(self) -> Translation:
        """The program as LLL. Raises KitRobotError when its robot is not at hand."""
        before, self._before = self._before, None
        if self._given is not None:
            return self._given
        if before is None:
            return graph_to_lll(self.program, self.catalogue)
        return graph_to_lll_again(before, self.program, self.catalogue)

    @cached_property
    def compiled(self) -> Compiled:
        """The program compiled. Raises KitRobotError when its robot is not at hand."""
        return self._made[0]

    @cached_property
    def report(self) -> ProgramReport:
        """Its report. Raises KitRobotError when its robot is not at hand."""
        return self._made[1]

    @cached_property
    def _made(self) -> tuple[Compiled, ProgramReport]:
        translation = self.translation
        with translation.lineage.lock:  # the places of its nodes are those of this state for so long
            compiled = compile_program(self.program, self.catalogue, translation, sound=self._sound)
            report = program_report(self.program.name, compiled, translation.lineage)
        return replace(compiled, shared=not self.program.level.is_team), report


@dataclass(frozen=True)
class _Extended:
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
        self._programs: OrderedDict[_Key, CachedProgram] = OrderedDict()
        self._named: OrderedDict[str, Program] = OrderedDict()
        """Programs outlive their results here, so that several windows may edit programs of one name."""
        self._named_vertices = 0
        self._names = (f"{secrets.token_hex(4)}-{number}" for number in itertools.count())
        self._vertices = 0
        self._catalogues: list[_Extended] = []

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
            self._catalogues.append(_Extended(common, tuple(constructors), tuple(variables), crew, made))
        return made

    def of(
        self, program: Program, catalogue: Catalogue, translation: Translation | None = None, *, sound: bool = False
    ) -> CachedProgram:
        """The cached program; it is added if it is missing. `translation` and `sound` as for `compile_program`."""
        key = (id(program), id(catalogue))
        with self._lock:
            others = [
                other
                for (_, of), other in self._programs.items()
                if of == id(catalogue) and other.program.name == program.name
            ]
            cached = self._programs.get(key) or next((one for one in others if _is_equal(one.program, program)), None)
            if cached is not None:
                self._programs.move_to_end((id(cached.program), id(catalogue)))
                return cached
            before = others[-1].__dict__.get("translation") if others else None
            cached = self._programs[key] = CachedProgram(program, catalogue, translation, sound=sound, before=before)
            self._assign_name(cached)
            self._vertices += len(program.vertices)
            states = [one for one, other in self._programs.items() if other.program.name == program.name]
            for old in states[:-MOST_STATES]:
                self._evict(old)
            while self._vertices > self._most_vertices:
                self._evict(next(iter(self._programs)))
        return cached

    def named(self, name: str) -> Program | None:
        """The program of that name; None when it was evicted."""
        with self._lock:
            found = self._named.get(name)
            if found is not None:
                self._named.move_to_end(name)
        return found

    def report_of(self, name: str) -> ProgramReport | None:
        """The report of the program of that name; None when it was evicted."""
        with self._lock:
            cached = next((one for one in self._programs.values() if one.name == name), None)
        made = None if cached is None else cached.__dict__.get("_made")
        return None if made is None else replace(made[1], known=name)

    def reports(self, programs: Sequence[Program], catalogue: Catalogue) -> list[ProgramReport]:
        """The report of each program, with the cache names of those that can be found again."""
        known = [one.level.is_team or one.target in catalogue.robots for one in programs]
        cached = [self.of(one, catalogue) if is_known else None for one, is_known in zip(programs, known, strict=True)]
        made = [
            program_report(one.name, None) if found is None else found.report
            for one, found in zip(programs, cached, strict=True)
        ]
        with self._lock:
            return [
                one if found is None or found.name not in self._named else replace(one, known=found.name)
                for one, found in zip(made, cached, strict=True)
            ]

    def _assign_name(self, cached: CachedProgram) -> None:
        cached.name = next(self._names)
        self._named[cached.name] = cached.program
        self._named_vertices += len(cached.program.vertices)
        while self._named_vertices > MOST_NAMED * self._most_vertices:
            self._named_vertices -= len(self._named.popitem(last=False)[1].vertices)

    def _evict(self, key: _Key) -> None:
        gone = self._programs.pop(key)
        self._vertices -= len(gone.program.vertices)


def _is_equal(one: Program, other: Program) -> bool:
    """Whether two programs are equal, order included; the order of settings matters for unknown elements."""
    return (
        (one.target, one.level, len(one.vertices), len(one.arcs))
        == (other.target, other.level, len(other.vertices), len(other.arcs))
        and all(map(_same_vertex, one.vertices, other.vertices))
        and one.arcs == other.arcs
    )


def _same_vertex(one: Vertex, other: Vertex) -> bool:
    return one is other or (one == other and [*one.settings] == [*other.settings])


def _are_identical(cached: Sequence[object], given: Sequence[object]) -> bool:
    return len(cached) == len(given) and all(one is other for one, other in zip(cached, given, strict=True))
