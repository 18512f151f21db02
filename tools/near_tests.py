"""Run the tests that changed files reach through imports, the nearest first, until one fails: `make near`.

    python -m tools.near_tests              of what has changed since the last commit
    python -m tools.near_tests main         since another commit
    python -m tools.near_tests --list       say which, a file a line, and run none

Tests that were changed come first, whole. Then the page's own, where a file of the page has changed; then those that
import what has changed, and at last those that reach it through others, both without what needs a browser or a board.
Imports among `src` are those of Grimp, which import-linter brings along; those of tests and tools are read here. A file
that is no Python counts as the modules of the folder that it lies in, or else as what is named in tests.
"""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path, PurePosixPath

import grimp

ROOT = Path(__file__).resolve().parents[1]
READ_HERE = ("tests", "tools", "benchmarks")
PACKAGES = ("kitrobot", "kitrobot_onboard")
NEARBY = "not browser and not firefox and not boards and not site and not slow"
"""What is run of tests that were not changed themselves."""
NONE_COLLECTED = 5
"""Pytest's status where nothing is left to run."""

Graph = dict[str, set[str]]
"""By module, which modules import it."""


def module_of(path: str) -> str:
    """The module of a Python file of the repository."""
    parts = PurePosixPath(path.removeprefix("src/")).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imported_names(source: str) -> Iterator[str]:
    """What a file imports: names of modules, some of which may be names within a module."""
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Import(names=names):
                yield from (one.name for one in names)
            case ast.ImportFrom(module=str(module), names=names, level=0):
                yield module
                yield from (f"{module}.{one.name}" for one in names)


def conftests_of(path: str, files: Mapping[str, str]) -> Iterator[str]:
    """The files of fixtures that pytest loads for a file of tests."""
    for folder in PurePosixPath(path).parents:
        if (found := f"{folder}/conftest.py") in files and found != path:
            yield module_of(found)


def importers_of(src: Mapping[str, Iterable[str]], files: Mapping[str, str]) -> Graph:
    """Who imports each module.

    Args:
        src: what each module of the product imports.
        files: the text of each Python file that is read here, by its path.
    """
    graph: Graph = {module: set() for module in (*src, *map(module_of, files))}
    for module, imported in src.items():
        for name in imported:
            graph.setdefault(name, set()).add(module)
    for path, text in files.items():
        for name in (*imported_names(text), *conftests_of(path, files)):
            if name in graph:
                graph[name].add(module_of(path))
    return graph


def distances(graph: Graph, changed: Iterable[str]) -> dict[str, int]:
    """By each module that reaches one of those that changed: through how many imports at least."""
    found = dict.fromkeys(changed, 0)
    border = list(found)
    while border:
        reached = [one for module in border for one in sorted(graph.get(module, ()))]
        border = [one for one in dict.fromkeys(reached) if one not in found]
        distance = max(found.values(), default=0) + 1
        found.update(dict.fromkeys(border, distance))
    return found


def changed_modules(paths: Iterable[str], files: Mapping[str, str], src: Iterable[str]) -> Iterator[str]:
    """The modules that changed files are, belong to, or are named in."""
    known = list(src)
    for path in paths:
        if path.endswith(".py"):
            yield module_of(path)
        elif path.startswith("src/"):
            folder = next(one for one in PurePosixPath(path).parents if (ROOT / one / "__init__.py").is_file())
            package = module_of(f"{folder}/__init__.py")
            yield from (one for one in known if one == package or one.rpartition(".")[0] == package)
        elif not path.startswith("web/"):
            name = PurePosixPath(path).name
            yield from (module_of(file) for file, text in files.items() if name in text)


def nearest_first(paths: Iterable[str], src: Mapping[str, Iterable[str]], files: Mapping[str, str]) -> dict[str, int]:
    """The files of tests that changed files reach, each with its distance; the nearest come first."""
    found = distances(importers_of(src, files), changed_modules(paths, files, src))
    tests = {path: found[module_of(path)] for path in files if _is_test(path) and module_of(path) in found}
    return dict(sorted(tests.items(), key=lambda one: (one[1], one[0])))


def _is_test(path: str) -> bool:
    return path.startswith("tests/") and PurePosixPath(path).name.startswith("test_")


def imports_of_src() -> dict[str, set[str]]:
    """What each module of the product imports of it."""
    graph = grimp.build_graph(*PACKAGES, cache_dir=str(ROOT / ".import_linter_cache"))
    return {module: graph.find_modules_directly_imported_by(module) for module in graph.modules}


def files_read_here() -> dict[str, str]:
    """The text of each Python file beside the product, by its path."""
    paths = [path for folder in READ_HERE for path in sorted((ROOT / folder).rglob("*.py"))]
    return {path.relative_to(ROOT).as_posix(): path.read_text("utf-8") for path in paths}


def changed_files(since: str) -> list[str]:
    """The files that are other ones than in a commit, and those that git does not know yet."""
    commands = (["diff", "--name-only", since, "--"], ["ls-files", "--others", "--exclude-standard"])
    said = [subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True) for words in commands]
    return sorted({line for one in said for line in one.stdout.splitlines()})


def main(arguments: list[str]) -> int:
    since = next((one for one in arguments if not one.startswith("-")), "HEAD")
    paths = changed_files(since)
    tests = nearest_first(paths, imports_of_src(), files_read_here())
    tests = {path: distance for path, distance in tests.items() if (ROOT / path).is_file()}
    if "--list" in arguments:
        print(*tests, sep="\n")
        return 0
    changed = [path for path in tests if path in paths]
    direct = [path for path, distance in tests.items() if distance <= 1 and path not in changed]
    others = [path for path, distance in tests.items() if distance > 1]
    pytest = [sys.executable, "-m", "pytest", "-q", "-x"]
    commands = [
        [*pytest, *changed] if changed else [],
        [sys.executable, "tools/page.py", "npm", "run", "test", "--", "--changed", since]
        if any(path.startswith("web/") for path in paths)
        else [],
        [*pytest, "-m", NEARBY, *direct] if direct else [],
        [*pytest, "-n", "auto", "-m", NEARBY, *others] if others else [],
    ]
    if not any(commands):
        print(f"nothing that has changed since {since} is reached by a test")
    for command in filter(None, commands):
        status = subprocess.run(command, cwd=ROOT, check=False).returncode
        if status not in (0, NONE_COLLECTED):
            return status
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
