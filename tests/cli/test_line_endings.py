"""Files as Windows keeps them: lines that end with CRLF, and a mark of byte order, mean the same."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.cli.conftest import EXAMPLE, LLL

EXCHANGE = EXAMPLE.parents[1] / "exchange" / "exchange.krt"
TEXTS = {".krt", ".xml", ".lll", ".kra", ".csv"}


def as_on_windows(folder: Path) -> list[Path]:
    """Every text in the folder with CRLF."""
    changed = []
    for path in sorted(folder.rglob("*")):
        if path.suffix in TEXTS:
            text = path.read_bytes().replace(b"\r\n", b"\n").replace(b"\n", b"\r\n")
            path.write_bytes(text)
            changed.append(path)
    return changed


def test_a_mission_and_its_world_run_the_same(kitrobot, here):
    plain = kitrobot("run", EXCHANGE, "--json").json
    shutil.copytree(EXCHANGE.parent, here / "copy")
    assert {path.suffix for path in as_on_windows(here / "copy")} == {".krt", ".xml"}
    mission = here / "copy" / EXCHANGE.name
    ran = kitrobot("run", mission, "--json").json
    assert ran | {"timing": None} == plain | {"timing": None}
    assert kitrobot("check", mission).status == 0
    assert kitrobot("diff", EXCHANGE, mission).status == 0


@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"], ids=["", "with a mark"])
def test_a_program_is_laid_out_compiled_and_listed_the_same(kitrobot, here, mark):
    (here / "a.lll").write_text(LLL, encoding="utf-8", newline="\n")
    (here / "b.lll").write_bytes(mark + (here / "a.lll").read_bytes().replace(b"\n", b"\r\n"))
    assert kitrobot("format", here / "b.lll").out == kitrobot("format", here / "a.lll").out
    for name in "ab":
        assert kitrobot("convert", here / f"{name}.lll", here / f"{name}.kri", "--robot", "mini-robot").status == 0
        assert kitrobot("convert", here / f"{name}.kri", here / f"{name}.kra").status == 0
    assert (here / "a.kri").read_bytes() == (here / "b.kri").read_bytes()
    assert (here / "a.kra").read_bytes() == (here / "b.kra").read_bytes()
    assert b"\r" not in (here / "b.kra").read_bytes(), "written alike on every system"


def test_a_mistake_has_the_same_place(kitrobot, here):
    (here / "p.lll").write_bytes(b"Wheel.Advance(50);\r\nWheel.Advence(50);\r\n")
    said = kitrobot("check", here / "p.lll", "--robot", "mini-robot")
    assert f"{here / 'p.lll'}:2:" in said.err + said.out
