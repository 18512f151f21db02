"""`make near` runs what changed files reach, and the nearest first."""

from __future__ import annotations

import pytest

from tools.near_tests import (
    changed_modules,
    distances,
    files_read_here,
    importers_of,
    imports_of_src,
    module_of,
    nearest_first,
)

SRC = {"kitrobot.a": {"kitrobot.b"}, "kitrobot.b": {"kitrobot.c"}, "kitrobot.c": set[str](), "kitrobot.d": set[str]()}
FILES = {
    "tests/conftest.py": "import kitrobot.d\n",
    "tests/x/conftest.py": "",
    "tests/x/helper.py": "from kitrobot import b\n",
    "tests/x/test_a.py": "def test_it():\n    import kitrobot.a\n",
    "tests/x/test_b.py": "from tests.x.helper import made\n",
    "tests/x/test_c.py": "from kitrobot.c import thing\n",
    "tests/y/test_d.py": 'FILE = "drawn.krt"\n',
}


@pytest.mark.parametrize(
    ("changed", "reached"),
    [
        ("src/kitrobot/a.py", {"tests/x/test_a.py": 1}),
        ("src/kitrobot/b.py", {"tests/x/test_a.py": 2, "tests/x/test_b.py": 2}),
        ("src/kitrobot/c.py", {"tests/x/test_c.py": 1, "tests/x/test_a.py": 3, "tests/x/test_b.py": 3}),
        ("tests/x/test_b.py", {"tests/x/test_b.py": 0}),
        ("tests/x/conftest.py", {f"tests/x/test_{name}.py": 1 for name in "abc"}),
        ("examples/drawn.krt", {"tests/y/test_d.py": 0}),
        ("web/src/app/App.tsx", {}),
    ],
)
def test_a_file_reaches_what_imports_it_and_the_nearest_come_first(changed: str, reached: dict[str, int]) -> None:
    found = nearest_first([changed], SRC, FILES)
    assert found == reached
    assert list(found.values()) == sorted(found.values())


def test_fixtures_of_all_tests_reach_all_tests() -> None:
    assert len(nearest_first(["src/kitrobot/d.py"], SRC, FILES)) == 4


def test_a_circle_of_imports_ends() -> None:
    assert distances({"a": {"b"}, "b": {"a"}}, ["a"]) == {"a": 0, "b": 1}


def test_in_this_repository_a_module_reaches_its_tests_and_not_all() -> None:
    src, files = imports_of_src(), files_read_here()
    graph = importers_of(src, files)
    near = distances(graph, [module_of("src/kitrobot/world/geometry.py")])
    assert near["tests.world.test_geometry"] == 1
    assert near["tests.server.test_run"] > 1
    assert "tests.lll.test_grammar" not in near
    schemas = distances(graph, changed_modules(["src/kitrobot/primitives/shipped/mini-robot.robot.xml"], files, src))
    assert "tests.primitives.test_catalogue" in schemas
