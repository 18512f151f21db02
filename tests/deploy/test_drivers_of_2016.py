"""A micro:bit of 2016 has a stack for five nested calls: a driver that brings helpers along ends it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from kitrobot.deploy.package.onboard_bundle import ONBOARD
from kitrobot.primitives.kit import Kit, KitPart
from tools.microbit_kits import small_kits

FOLDER = ONBOARD / "drivers" / "microbit"
DRIVERS = sorted(
    path
    for path in FOLDER.rglob("*.py")
    if path.name != "__init__.py" and "CHIP = " not in path.read_text(encoding="utf-8")
)
"""Without those of a V2."""

NESTED = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp, ast.Lambda)
"""Each is a function of its own to MicroPython."""


def functions(tree: ast.Module) -> dict[str, ast.FunctionDef]:
    """All functions and methods of a driver, by their names."""
    return {node.name: node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}


def calls_itself(tree: ast.Module) -> Iterator[str]:
    """Every call, in a driver's methods, of a function of the driver that calls one of them again, and every function
    without a name, but where a device is made: nothing else is called then.
    """
    known = functions(tree)

    def called(function: ast.FunctionDef) -> set[str]:
        found = set()
        for node in ast.walk(function):
            match node:
                case ast.Call(func=ast.Name(id=name)) if name in known:
                    found.add(name)
                case ast.Call(func=ast.Attribute(value=ast.Name(id="self"), attr=name)) if name in known:
                    found.add(name)
        return found

    for name, function in known.items():
        for other in called(function):
            if again := called(known[other]):
                yield f"{name} calls {other}, which calls {', '.join(sorted(again))}"
        if name not in ("__init__", "make") and any(isinstance(node, NESTED) for node in ast.walk(function)):
            yield f"{name} has a function without a name in it"


@pytest.mark.parametrize("path", DRIVERS, ids=lambda path: path.relative_to(FOLDER).as_posix())
def test_a_driver_of_a_micro_bit_calls_no_function_that_calls_another(path: Path) -> None:
    assert list(calls_itself(ast.parse(path.read_text(encoding="utf-8")))) == []


@pytest.mark.parametrize("path", DRIVERS, ids=lambda path: path.relative_to(FOLDER).as_posix())
def test_a_driver_of_a_micro_bit_brings_no_helpers_but_those_that_are_in_its_space(path: Path) -> None:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("kitrobot_onboard"):
            assert (node.module or "").startswith("kitrobot_onboard.drivers.microbit.shared."), node.module


def claimed() -> list[tuple[Kit, KitPart]]:
    return [(kit, part) for kit in small_kits().values() for part in kit.parts if not part.is_missing]


def test_every_part_that_a_kit_of_a_micro_bit_claims_has_such_a_driver() -> None:
    own = {path.stem for path in DRIVERS}
    for kit, part in claimed():
        for device in part.devices:
            assert (part.board.driver or device).replace("-", "_") in own, (kit.name, device)
