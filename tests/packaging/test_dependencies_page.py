"""Each dependency has its line in docs/decisions/dependencies.md, and each line its dependency."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_the_page_names_exactly_the_dependencies_there_are() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    package = json.loads((ROOT / "web" / "package.json").read_text(encoding="utf-8"))
    requirements = project["dependencies"] + [
        line for extra in project["optional-dependencies"].values() for line in extra
    ]
    wanted = {re.match(r"[\w.-]+", line)[0] for line in requirements}  # type: ignore[index]
    wanted |= package["dependencies"].keys() | package["devDependencies"].keys()

    page = (ROOT / "docs" / "decisions" / "dependencies.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`[^|]*) \|", page, flags=re.MULTILINE)
    named = {name for row in rows for name in re.findall(r"`([^`]+)`", row)}
    assert named == wanted
