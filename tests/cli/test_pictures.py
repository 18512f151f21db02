"""Every command takes a picture that carries a mission for the mission, and says clearly when there is none in it."""

from __future__ import annotations

import zlib
from typing import Any
from xml.sax.saxutils import escape

import pytest

from tests.cli.conftest import EXAMPLE
from tests.files.test_embedded_mission import pdf

KRT = EXAMPLE.read_bytes()
KINDS = ("svg", "png", "pdf")


def _chunk(kind: bytes, body: bytes) -> bytes:
    return len(body).to_bytes(4) + kind + body + zlib.crc32(kind + body).to_bytes(4)


def picture(kind: str, krt: bytes = KRT) -> bytes:
    if kind == "svg":
        metadata = f'<metadata id="kitrobot-mission">{escape(krt.decode())}</metadata>'
        return f'<svg xmlns="http://www.w3.org/2000/svg">{metadata}</svg>'.encode()
    if kind == "png":
        chunks = (b"IHDR", bytes(13)), (b"iTXt", b"kitrobot-mission\0\0\0\0\0" + krt), (b"IEND", b"")
        return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(*one) for one in chunks)
    return pdf(krt)


@pytest.fixture(params=KINDS)
def name(request, here):
    (here / f"m.{request.param}").write_bytes(picture(request.param))
    (here / "transport.krt").write_bytes(KRT)
    return f"m.{request.param}"


def test_convert_takes_the_mission_out(kitrobot, here, name):
    said = kitrobot("convert", name, "out.krt")
    assert (said.status, said.out) == (0, "")
    assert (here / "out.krt").read_bytes() == KRT


def test_convert_keeps_a_mission_that_it_replaces(kitrobot, here, name):
    (here / "out.krt").write_text("mine")
    assert kitrobot("convert", name, "out.krt").status == 0
    assert (here / "out.krt~").read_text() == "mine"


@pytest.mark.parametrize("ending", ["lll", "kri", "kra"])
def test_convert_goes_where_the_mission_goes(kitrobot, here, name, ending):
    for source in (name, "transport.krt"):
        assert kitrobot("convert", source, f"{source}.{ending}", "--program", "loader").status == 0
    assert (here / f"{name}.{ending}").read_bytes() == (here / f"transport.krt.{ending}").read_bytes()


def test_nothing_is_converted_into_a_picture(kitrobot, here, name):
    before = (here / name).read_bytes()
    said = kitrobot("convert", "transport.krt", name)
    assert said.status == 1
    assert "pictures are drawn by the studio" in said.err
    assert (here / name).read_bytes() == before


def test_check_looks_at_the_mission_in_it(kitrobot, here, name):
    assert kitrobot("check", name).status == 0
    broken = KRT.replace(b'element="Wheel.Stop"', b'element="Wheel.Fly"')
    (here / name).write_bytes(picture(name[2:], broken))
    said = kitrobot("check", name, "--json")
    assert said.status == 1
    assert {one["file"] for one in said.json if one["severity"] == "error"} == {name}
    assert "Fly" in said.out


def test_diff_and_run_take_it(kitrobot, here, name):
    said = kitrobot("diff", "transport.krt", name)
    assert (said.status, said.out) == (0, "")
    assert kitrobot("run", name, "--json").json["outcome"] == "done"


def test_exec_runs_a_program_of_it(kitrobot, here, name):
    said = kitrobot("exec", name, "--program", "loader", "--ticks", 3, "--json")
    assert len(said.lines) == 3


def test_the_studio_opens_it(kitrobot, here, name):
    opened: list[Any] = []
    assert kitrobot(name, studio=opened.append).status == 0
    assert opened[0].target.name == name


@pytest.mark.parametrize("command", [["convert", "FILE", "x.krt"], ["check", "FILE"], ["run", "FILE"], ["FILE"]])
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("spoilt", "sentence"),
    [
        (lambda whole: b"", "is empty"),
        (lambda whole: b"GIF89a", "is a picture (GIF): there is no mission inside"),
        (lambda whole: whole[: len(whole) // 2], "is damaged"),
    ],
    ids=["empty", "foreign", "cut off"],
)
def test_a_picture_without_a_mission_is_one_clear_sentence(kitrobot, here, command, kind, spoilt, sentence):
    (here / f"m.{kind}").write_bytes(spoilt(picture(kind)))
    opened: list[Any] = []
    words = [word.replace("FILE", f"m.{kind}") for word in command]
    said = kitrobot(*words, studio=opened.append)
    assert said.status == 1
    assert sentence in said.err + said.out
    assert "Traceback" not in said.err
    assert (opened, (here / "x.krt").exists()) == ([], False)


def test_merge_never_writes_over_a_picture(kitrobot, here, name):
    before = (here / name).read_bytes()
    assert kitrobot("merge", "transport.krt", name, "transport.krt").status == 2
    assert (here / name).read_bytes() == before
