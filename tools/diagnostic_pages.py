"""Write the pages in docs/diagnostics: one for each rule, and the list of all; they say what the rules in the code say.

python tools/diagnostic_pages.py            write them, and take away those whose rule is gone
python tools/diagnostic_pages.py --check    only say which are not current; status 1 if there is one
"""

from __future__ import annotations

import importlib
import pkgutil
import sys
from pathlib import Path

import kitrobot
from kitrobot.diagnostics.model import Rule, Severity, rules

FOLDER = Path(__file__).resolve().parents[1] / "docs" / "diagnostics"

# From the bottom of the stairs up: a rule belongs to the lowest room that has it. Rooms that are not named come last.
ROOMS = {
    "lll": "The text of a program",
    "xml": "XML files",
    "primitives": "Constructors, robots and own parts",
    "behaviour_trees": "Behaviour trees",
    "world": "Worlds",
    "tutorial": "Tutorials",
    "exercise": "Exercises",
    "compiler": "What a program means, and its graph",
    "mission": "Missions",
    "sim": "Starting a run",
    "files": "Files on disk",
    "workspace": "What is opened and checked",
    "checking": "What a check finds while you draw",
}

ONLY_IN_A_PAGE = "kitrobot.server.in_worker"
"""Imports what Pyodide alone has; it has no rules."""

SEVERITIES = {
    Severity.ERROR: "An error: the program does not run, or the file is not used, until it is mended.",
    Severity.WARNING: "A warning: everything runs; something was left out or may not do what was meant.",
    Severity.HINT: "A hint: everything runs; this is advice.",
}


def pages() -> dict[str, str]:
    """File name → text of every page there has to be."""
    rooms = _rooms()
    made = {f"{code}.md": _page(rule) for code, rule in rules().items()}
    lines = [
        "# Everything KitRobot can tell you",
        "",
        "Each message ends with its code in brackets, such as `[unknown-method]`; a code never changes. These pages",
        "are made from the rules in the code by `python tools/diagnostic_pages.py`.",
    ]
    for room, codes in rooms.items():
        lines += ["", f"## {ROOMS.get(room, room)}", "", "| code | | says |", "|---|---|---|"]
        for code in codes:
            rule = rules()[code]
            lines.append(f"| [`{code}`]({code}.md) | {rule.severity} | {_cell(rule.title)} |")
    made["README.md"] = "\n".join([*lines, ""])
    return made


def _page(rule: Rule) -> str:
    return f"# {rule.title}\n\n`{rule.code}` · {SEVERITIES[rule.severity]}\n\n{rule.explanation}\n"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def _rooms() -> dict[str, list[str]]:
    """Room → codes of its rules; makes all rules known by importing every room."""
    found: dict[str, str] = {}
    for module in pkgutil.walk_packages(kitrobot.__path__, "kitrobot."):
        if module.name.endswith("__main__") or module.name == ONLY_IN_A_PAGE:
            continue
        room = module.name.split(".")[1]
        for value in vars(importlib.import_module(module.name)).values():
            if isinstance(value, Rule):
                found[value.code] = min(room, found.get(value.code, room), key=_step)
    rooms: dict[str, list[str]] = {}
    for code in sorted(rules()):
        rooms.setdefault(found[code], []).append(code)
    return dict(sorted(rooms.items(), key=lambda item: (_step(item[0]), item[0])))


def _step(room: str) -> int:
    return list(ROOMS).index(room) if room in ROOMS else len(ROOMS)


def stale(folder: Path = FOLDER) -> list[str]:
    """Names of pages that are missing, differ, or have no rule any more."""
    wanted = pages()
    there = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.md")}
    return sorted(name for name in wanted.keys() | there.keys() if wanted.get(name) != there.get(name))


def write(folder: Path = FOLDER) -> list[str]:
    """Writes what is stale; the names of the pages it touched."""
    touched = stale(folder)
    wanted = pages()
    folder.mkdir(parents=True, exist_ok=True)
    for name in touched:
        if name in wanted:
            (folder / name).write_text(wanted[name], encoding="utf-8", newline="\n")
        else:
            (folder / name).unlink()
    return touched


def main(arguments: list[str]) -> int:
    checking = arguments == ["--check"]
    touched = stale() if checking else write()
    for name in touched:
        print(f"docs/diagnostics/{name} {'is not current' if checking else 'written'}")
    if checking and touched:
        print("help: python tools/diagnostic_pages.py")
    return 1 if checking and touched else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
