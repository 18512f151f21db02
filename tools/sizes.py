"""Files and functions that are too large to be read at once.

    python tools/sizes.py            lists them; exits with 1 when there is one

A function's lines are those from its `def` to its end; `self` and `cls` are no parameters. What is larger for a reason
is in `EXCEPTIONS`, with that reason.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ROOMS = ("src", "benchmarks", "tools")

MOST = {"lines of a file": 400, "lines": 60, "parameters": 8}

EXCEPTIONS = {
    (
        "src/kitrobot_onboard/interpreter.py: tick",
        "lines",
    ): "one loop: calls cost too much on a small board",
    **dict.fromkeys(
        (
            ("src/kitrobot/cli/agent.py: run_agent", "parameters"),
            ("src/kitrobot/cli/bench.py: try_parts", "parameters"),
            ("src/kitrobot/cli/classroom.py: open_class", "parameters"),
            ("src/kitrobot/cli/deploy.py: deploy_program", "parameters"),
            ("src/kitrobot/cli/judge.py: judge_files", "parameters"),
            ("src/kitrobot/cli/probability.py: estimate_probability", "parameters"),
            ("src/kitrobot/cli/experiments.py: sweep_missions", "parameters"),
            ("src/kitrobot/cli/run.py: run_mission", "parameters"),
            ("src/kitrobot/cli/team.py: run_team", "parameters"),
            ("src/kitrobot/cli/verify.py: verify_mission", "parameters"),
        ),
        "the options of a command, which Typer reads from parameters only",
    ),
}


def sizes(root: Path = ROOT) -> Iterator[tuple[str, str, int]]:
    """The size of every file and function: its place, a kind of `MOST`, and how many."""
    for room in ROOMS:
        for path in sorted((root / room).rglob("*.py")):
            where, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
            yield where, "lines of a file", len(text.splitlines())
            for node in ast.walk(ast.parse(text)):
                if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                    name = f"{where}: {node.name}"
                    yield name, "lines", (node.end_lineno or node.lineno) - node.lineno + 1
                    yield name, "parameters", len(_parameters(node.args))


def _parameters(arguments: ast.arguments) -> list[str]:
    listed = [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs, arguments.vararg, arguments.kwarg]
    return [one.arg for one in listed if one is not None and one.arg not in ("self", "cls")]


def problems(root: Path = ROOT) -> list[str]:
    """A sentence for everything that is too large, and for each exception that is not."""
    found = {(where, kind): count for where, kind, count in sizes(root) if count > MOST[kind]}
    needless = EXCEPTIONS.keys() - found.keys() if root == ROOT else set()
    return [
        *(
            f"{where}: {count} {kind}, at most {MOST[kind]}; CONTRIBUTING.md, How we write"
            for (where, kind), count in found.items()
            if (where, kind) not in EXCEPTIONS
        ),
        *(f"{where}: is an exception without need; {kind}, at most {MOST[kind]}" for where, kind in sorted(needless)),
    ]


if __name__ == "__main__":
    found = problems()
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)
