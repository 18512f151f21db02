"""Make the wheel `kitrobot_site_parts` in dist/: what `kitrobot site` needs and KitRobot's own wheel does not have.

    python -m tools.site_parts_wheel            make it, and print its path; status 1 if a part cannot be had

It holds Pyodide (from web/node_modules) and pydantic_core's wheel for it (`tools.site_parts`), both unchanged. Whoever
installs it beside KitRobot needs neither npm nor a network to write a site.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from kitrobot import __version__
from kitrobot.packaging.site_parts import INSTALLED, RUNTIME, SiteError, find_parts
from tools.site_parts import PARTS, ROOT, fetch

PROJECT = """[build-system]
requires = ["hatchling"]
build-backend = "hatchling.build"

[project]
name = "kitrobot-site-parts"
version = "{version}"
description = "What `kitrobot site` puts beside the studio: Pyodide, and pydantic_core compiled for it"
requires-python = ">=3.11"
license = "MPL-2.0 AND MIT"

[tool.hatch.build.targets.wheel]
packages = ["{package}"]
"""
ABOUT = '"""Pyodide and pydantic_core\'s wheel for it, unchanged, for `kitrobot site`."""\n'


def make_wheel(folder: Path) -> Path:
    """The path of the wheel, in that folder.

    Raises:
        SiteError: Pyodide or pydantic_core's wheel is not in this checkout.
        CalledProcessError: hatchling cannot make it.
    """
    pyodide, wheel = find_parts([ROOT / "web", PARTS])
    with tempfile.TemporaryDirectory() as place:
        package = Path(place, INSTALLED)
        (package / "pyodide").mkdir(parents=True)
        (package / "__init__.py").write_text(ABOUT, encoding="utf-8")
        for name in (*RUNTIME, "package.json", "README.md"):
            shutil.copyfile(pyodide / name, package / "pyodide" / name)
        shutil.copyfile(wheel, package / wheel.name)
        project = PROJECT.format(version=__version__, package=INSTALLED)
        Path(place, "pyproject.toml").write_text(project, encoding="utf-8")
        command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder.resolve())]
        subprocess.run(command, cwd=place, check=True, capture_output=True)
    return folder / f"{INSTALLED}-{__version__}-py3-none-any.whl"


def main() -> int:
    """Makes it in dist/."""
    fetch()
    try:
        print(make_wheel(ROOT / "dist"))
    except SiteError as error:
        print(f"{error.message}\n{error.help}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
