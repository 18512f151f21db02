"""The lock files install the same everywhere: complete for every platform, and tied to no machine."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
PACKAGE_LOCK = ROOT / "web" / "package-lock.json"


@pytest.fixture(scope="module")
def locked() -> dict[str, dict[str, Any]]:
    """Entries by their place, as in `node_modules/a/node_modules/b`."""
    packages: dict[str, dict[str, Any]] = json.loads(PACKAGE_LOCK.read_text(encoding="utf-8"))["packages"]
    return packages


def find_locked(locked: dict[str, dict[str, Any]], place: str, name: str) -> str | None:
    """Where Node finds package `name` from the package at `place`: beside it, or one folder further out."""
    while True:
        candidate = f"{place}/node_modules/{name}" if place else f"node_modules/{name}"
        if candidate in locked:
            return candidate
        if not place:
            return None
        place = place.rpartition("node_modules/")[0].rstrip("/")


def missing_dependencies(locked: dict[str, dict[str, Any]], kind: str) -> list[str]:
    return [
        f"{place or 'package.json'} -> {name}"
        for place, entry in locked.items()
        for name in entry.get(kind, {})
        if find_locked(locked, place, name) is None
    ]


@pytest.mark.parametrize("kind", ["dependencies", "devDependencies", "optionalDependencies"])
def test_every_dependency_in_the_web_lock_has_its_entry(locked: dict[str, dict[str, Any]], kind: str) -> None:
    # npm leaves out the platforms it was not run on when the lock is made carelessly: then `npm ci` fails there.
    if kind == "devDependencies":
        locked = {"": locked[""]} | {place: entry | {kind: {}} for place, entry in locked.items() if place}
    assert missing_dependencies(locked, kind) == []


def test_a_missing_platform_package_is_noticed() -> None:
    locked = {"": {}, "node_modules/bundler": {"optionalDependencies": {"@bundler/one": "1", "@bundler/two": "1"}}}
    locked["node_modules/@bundler/one"] = {}
    assert missing_dependencies(locked, "optionalDependencies") == ["node_modules/bundler -> @bundler/two"]


def test_the_web_lock_says_what_package_json_says(locked: dict[str, dict[str, Any]]) -> None:
    package = json.loads((ROOT / "web" / "package.json").read_text(encoding="utf-8"))
    for kind in ("dependencies", "devDependencies"):
        assert locked[""].get(kind, {}) == package.get(kind, {})


def test_the_web_lock_has_a_checksum_for_every_package_and_names_no_host(locked: dict[str, dict[str, Any]]) -> None:
    assert [place for place, entry in locked.items() if "resolved" in entry] == []
    unchecked = [
        place for place, entry in locked.items() if place and not entry.get("inBundle") and not entry.get("integrity")
    ]
    assert unchecked == []


def test_constraints_are_names_and_versions_only() -> None:
    lines = (ROOT / "constraints.txt").read_text(encoding="ascii").splitlines()
    versions = [line for line in lines if not line.startswith("#")]
    assert len(versions) > 30
    assert [line for line in versions if not re.fullmatch(r"[A-Za-z0-9_.-]+==[0-9][A-Za-z0-9.]*", line)] == []
