"""What lands on boards, shortened as it is, compiles on the oldest MicroPython that is meant and on a current one."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import kitrobot_onboard
from kitrobot.deploy.microbit_2016.flash_loop import FLASH_LOOP, loop_block
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.package import FAMILIES, Package
from tests.boards.modern import run
from tests.onboard.test_board_syntax import mpy_cross

_PART = re.compile(rb"([a-zA-Z0-9])([0-9]{3})")
DRIVERS = Path(kitrobot_onboard.__file__).parent / "drivers"


def built(family: str) -> dict[str, bytes]:
    """All files for a kind of board, with all drivers that there are for it."""
    package = Package()
    names = {path.stem for folder in FAMILIES[family] for path in (DRIVERS / folder).glob("*.py")} - {
        "__init__",
        "pins",
    }
    installer = FLASH_LOOP if family == "microbit" else COMPILED_LOOP
    found = package.build(family, dict.fromkeys(sorted(names)), installer)
    groups = loop_block().groups if installer is FLASH_LOOP else ()
    in_flash = {f"flash{number}.py": text.encode() for number, (text, _) in enumerate(groups)}
    return {**found.files, **in_flash, "main.py": found.main}


def sources(family: str) -> dict[str, bytes]:
    """What of it is Python: a list of files is none, and one that holds several parts is taken apart."""
    found = {}
    for name, content in built(family).items():
        if not _PART.match(content):
            found[name] = content
        while part := _PART.match(content):
            end = part.end() + int(part[2])
            found[f"{part[1].decode()}{len(content)}_{name}"] = content[part.end() : end]
            content = content[end:]
    assert len(found) > 10
    return found


@pytest.mark.parametrize("family", FAMILIES)
def test_the_compiler_of_micropython_1_9_3_takes_every_file(family: str, tmp_path: Path) -> None:
    for name, content in sources(family).items():
        source = tmp_path / name
        source.write_bytes(content)
        result = mpy_cross(source, tmp_path / "out.mpy")
        assert (result.returncode, result.stderr) == (0, ""), name


@pytest.mark.parametrize("family", FAMILIES)
def test_a_current_micropython_takes_every_file(family: str) -> None:
    files = sources(family)
    lines = [f"compile(open({name!r}).read(), {name!r}, 'exec')" for name in files]
    program = "\n".join([*lines, "print('all')"]).encode()
    assert run({**files, "test.py": program}, "test.py") == "all\n"


def test_a_file_that_does_not_compile_would_be_found(tmp_path: Path) -> None:
    source = tmp_path / "new.py"
    source.write_text("x = f'{1}'\n")
    assert mpy_cross(source, tmp_path / "out.mpy").returncode != 0
    with pytest.raises(AssertionError, match="SyntaxError"):
        run({"new.py": b"x = = 1", "test.py": b"compile(open('new.py').read(), 'new.py', 'exec')"}, "test.py")
