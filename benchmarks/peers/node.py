"""Runs the peers that come from npm, under the Node that builds the page too.

They are a set of packages of their own (`benchmarks/package.json`), installed on first use and never shipped.
"""

from __future__ import annotations

import hashlib
import json
import sys
import tempfile
from pathlib import Path
from typing import Any

from tools import page

_FOLDER = Path(__file__).resolve().parent.parent
_STAMP = _FOLDER / "node_modules" / ".installed-from"


def run_peer(script: str, given: dict[str, Any]) -> dict[str, Any] | None:
    """What `peers/SCRIPT` measured; None, with a sentence on standard error, when it cannot be run here."""
    try:
        _install()
        with tempfile.TemporaryDirectory() as folder:
            asked, answered = Path(folder, "given.json"), Path(folder, "result.json")
            asked.write_text(json.dumps(given), encoding="utf-8")
            page.node(str(_FOLDER / "peers" / script), str(asked), str(answered))
            result: dict[str, Any] = json.loads(answered.read_text(encoding="utf-8"))
            return result
    except page.WebToolError as problem:
        print(f"benchmarks: {script} was left out: {problem}", file=sys.stderr)
        return None


def installed(package: str) -> Path | None:
    """The folder of an npm package; None, with a sentence on standard error, when it cannot be had."""
    try:
        _install()
    except page.WebToolError as problem:
        print(f"benchmarks: {package} was left out: {problem}", file=sys.stderr)
        return None
    return _FOLDER / "node_modules" / package


def version(package: str) -> str:
    """The version of an installed npm package."""
    described = json.loads((_FOLDER / "node_modules" / package / "package.json").read_text(encoding="utf-8"))
    return str(described["version"])


def _install() -> None:
    wanted = hashlib.sha256((_FOLDER / "package-lock.json").read_bytes()).hexdigest()
    if not _STAMP.exists() or _STAMP.read_text(encoding="ascii") != wanted:
        page.npm("--prefix", str(_FOLDER), "ci", "--fetch-retries=1")
        _STAMP.write_text(wanted, encoding="ascii")
