"""Fetch what a static site needs and no installation has: pydantic_core's wheel for Pyodide, into build/site-parts.

    python -m tools.site_parts            print the folder; status 1 if the wheel cannot be had
    python -m tools.site_parts --quiet    only say so where it cannot be had: its tests are left out then

Its version is the installed one, and pip compares its hash with the index. Pyodide itself is in web/node_modules.
"""

from __future__ import annotations

import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

from kitrobot.packaging.site_parts import PYTHON, WHEEL_TAGS

ROOT = Path(__file__).resolve().parent.parent
PARTS = ROOT / "build" / "site-parts"


def wheel() -> Path:
    """Where the wheel belongs."""
    return PARTS / f"pydantic_core-{version('pydantic_core')}-{WHEEL_TAGS}.whl"


def fetch() -> bool:
    """Fetches the wheel unless it is there; whether it is there now."""
    if not wheel().is_file():
        python, abi, platform = WHEEL_TAGS.split("-")
        asked = ["--only-binary", ":all:", "--implementation", python[:2], "--python-version", PYTHON]
        asked += ["--abi", abi, "--platform", platform, "--no-deps", "--disable-pip-version-check", "--quiet"]
        what = f"pydantic_core=={version('pydantic_core')}"
        command = [sys.executable, "-m", "pip", "download", *asked, "--dest", str(PARTS), what]
        subprocess.run(command, check=False)
    return wheel().is_file()


def main(arguments: list[str]) -> int:
    """Fetches it."""
    there = fetch()
    if arguments == ["--quiet"]:
        if not there:
            print(f"tests of the static site left out: {wheel().name} could not be fetched")
        return 0
    print(PARTS if there else f"{wheel().name} could not be fetched")
    return 0 if there else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
