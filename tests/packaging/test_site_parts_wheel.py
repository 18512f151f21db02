"""The wheel with the parts of a site: whole, the same each time, and found where it is installed."""

from __future__ import annotations

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from kitrobot.packaging.site_parts import INSTALLED, RUNTIME, find_parts
from tools.site_parts import PARTS, ROOT
from tools.site_parts_wheel import make_wheel

pytestmark = pytest.mark.site


def test_it_brings_what_a_site_needs_unchanged_and_is_found_where_it_is_installed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wheel = make_wheel(tmp_path / "dist")
    assert make_wheel(tmp_path / "again").read_bytes() == wheel.read_bytes()
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
    assert {f"{INSTALLED}/pyodide/{name}" for name in RUNTIME} <= set(names)
    place = tmp_path / "installed"
    command = [
        sys.executable,
        "-m",
        "pip",
        "install",
        "--quiet",
        "--no-index",
        "--no-deps",
        "--disable-pip-version-check",
    ]
    subprocess.run([*command, "--target", str(place), str(wheel)], check=True)
    monkeypatch.syspath_prepend(str(place))
    pyodide, core = find_parts()
    there, core_there = find_parts([ROOT / "web", PARTS])
    assert pyodide.is_relative_to(place)
    assert core.read_bytes() == core_there.read_bytes()
    assert all((pyodide / name).read_bytes() == (there / name).read_bytes() for name in RUNTIME)
