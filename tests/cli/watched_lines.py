"""What `kitrobot watch --json` gives, read."""

from __future__ import annotations

import json


def objects(given: str) -> list[dict]:
    return [json.loads(line) for line in given.splitlines()]


def counts_of(lines: list[dict]) -> list[int]:
    return [line["variables"]["Count"] for line in lines if "Count" in line.get("variables", {})]


def vertices_of(lines: list[dict]) -> set[str]:
    return {place["vertex"] for line in lines for place in line.get("active", [])}
