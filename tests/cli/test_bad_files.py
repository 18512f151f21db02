"""Every command, with everything that can lie where a file is wanted: a sentence and a status, never a traceback."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import EXAMPLE
from tests.effort import cases

NOBODY = ("--to", "socket://127.0.0.1:9")
ROBOT = ("--robot", "mini-robot")
FORMS = ("krt", "lll", "kri", "kra", "svg", "png", "pdf", "hex")
READS = {
    **{f"check {form}": ("check", f"bad.{form}") for form in FORMS},
    **{
        f"check {kind}": ("check", f"bad.{kind}.xml")
        for kind in ("robot", "constructors", "world", "tutorial", "exercise")
    },
    **{f"convert {form}": ("convert", f"bad.{form}", "out.kra", *ROBOT) for form in FORMS},
    "check behaviour tree": ("check", "bad.xml", *ROBOT),
    "convert behaviour tree": ("convert", "bad.xml", "out.kra", *ROBOT),
    "check robot of a text": ("check", "good.lll", "--robot", "bad.robot.xml"),
    "format": ("format", "bad.lll"),
    "format --write": ("format", "--write", "bad.lll"),
    "run": ("run", "bad.krt"),
    "run recorded": ("run", EXAMPLE, "--seconds", "0.1", "--trace", "bad.krtrace"),
    "verify": ("verify", "bad.krt", "--seconds", "1"),
    "verify a recording": ("verify", "bad.krtrace"),
    "walk": ("walk", "bad.krt"),
    "judge": ("judge", "bad.krt", "--property", "done", "--by", "run", "--seconds", "1"),
    "judge a recording": ("judge", "bad.krtrace", "--property", "done"),
    "probability": ("probability", "bad.krt", "done", "--precision", "0.2"),
    "sweep": ("sweep", "bad.krt", "--seeds", "1"),
    "replay": ("replay", "bad.krtrace"),
    "replay --at": ("replay", "bad.krtrace", "--at", "1"),
    "diff ours": ("diff", "bad.krt", EXAMPLE),
    "diff theirs": ("diff", EXAMPLE, "bad.krt"),
    "diff texts": ("diff", "bad.lll", "good.lll"),
    "agent": ("agent", "bad.krt", "--as", "robot-1"),
    "agent on a board": ("agent", "bad.krt", "--as", "robot-1", "--board", NOBODY[1]),
    "team": ("team", "bad.krt"),
    "team with a board": ("team", "bad.krt", "--board", f"robot-1={NOBODY[1]}"),
    "merge base": ("merge", "bad.krt", EXAMPLE, EXAMPLE, "-o", "out.krt"),
    "merge ours": ("merge", EXAMPLE, "bad.krt", EXAMPLE, "-o", "out.krt"),
    "merge theirs": ("merge", EXAMPLE, EXAMPLE, "bad.krt", "-o", "out.krt"),
    "merge output": ("merge", EXAMPLE, EXAMPLE, EXAMPLE, "-o", "bad.krt"),
    "exec text": ("exec", "bad.lll", *ROBOT, "--ticks", "1"),
    "exec image": ("exec", "bad.kri", *ROBOT, "--ticks", "1"),
    "exec mission": ("exec", "bad.krt", "--ticks", "1"),
    "exec inputs": ("exec", "good.lll", *ROBOT, "--ticks", "1", "--inputs", "bad.csv"),
    "exec robot": ("exec", "good.lll", "--robot", "bad.robot.xml", "--ticks", "1"),
    "deploy": ("deploy", "bad.krt", *NOBODY),
    "deploy to a file": ("deploy", "bad.krt", "--file", "out.hex"),
    "deploy firmware": ("deploy", EXAMPLE, "--board", "pico", "--file", "out.uf2", "--firmware", "bad.uf2"),
    "check uf2": ("check", "bad.uf2"),
    "convert uf2": ("convert", "bad.uf2", "out.krt"),
    "deploy team": ("deploy", "bad.krt", "--team", "--board", f"robot-1={NOBODY[1]}"),
    "deploy text": ("deploy", "bad.lll", "--robot", "microbit", *NOBODY),
    "bench robot": ("bench", NOBODY[1], "--all", "--robot", "bad.robot.xml"),
    "bench board": ("bench", NOBODY[1], "--all", "--board", "bad.board.xml"),
    "calibrate": ("calibrate", NOBODY[1], "--board", "bad.board.xml"),
    "flash": ("flash", "bad.uf2"),
    "grade": ("grade", "bad.krt"),
    "grade exercise": ("grade", EXAMPLE, "--exercise", "bad.exercise.xml"),
    "watch": ("watch", "--mission", "bad.krt", *NOBODY),
    "log": ("log", "--mission", "bad.krt", *NOBODY),
    "studio": ("studio", "bad.krt"),
    "studio recording": ("studio", "bad.krtrace"),
}
WRITES = ("run recorded", "merge output")
DEVICES = ("endless device", "nothing")
WITH_JSON = (
    "check",
    "run",
    "judge",
    "verify",
    "walk",
    "replay",
    "diff",
    "exec",
    "deploy",
    "watch",
    "log",
    "grade",
    "bench",
    "calibrate",
    "flash",
)
MAY_BE_RIGHT = {"empty", "cut off", "nothing", "odd name"}
"""An empty text is a program that does nothing, and half of one may be another."""


def whole(file: Path) -> bytes:
    """Something that is right in a file of that form, as far as there is."""
    examples = EXAMPLE.parents[1]
    if file.suffix == ".krt":
        return (examples / "square" / "square.krt").read_bytes()
    return b'<kitrobot version="1"><program name="p" robot="mini-robot">' + b" " * 50 + b"</program></kitrobot>"


def unreadable(file: Path) -> None:
    file.write_bytes(whole(file))
    file.chmod(0)


def behind_a_file(file: Path) -> None:
    file.with_name("no-folder").touch()
    file.symlink_to("no-folder/x")


KINDS: dict[str, Callable[[Path], object]] = {
    "missing": lambda file: None,
    "folder": Path.mkdir,
    "empty": Path.touch,
    "cut off": lambda file: file.write_bytes(whole(file)[:-20]),
    "binary": lambda file: file.write_bytes(bytes(range(256)) * 40),
    "no UTF-8": lambda file: file.write_bytes(b"# \xff\xfe\x80\n" + whole(file)),
    "zeros": lambda file: file.write_bytes(bytes(4000)),
    "pipe": os.mkfifo,
    "endless device": lambda file: file.symlink_to("/dev/zero"),
    "nothing": lambda file: file.symlink_to("/dev/null"),
    "link to itself": lambda file: file.symlink_to(file.name),
    "behind a file": behind_a_file,
    # Who may read everything is refused nothing.
    **({} if os.geteuid() == 0 else {"unreadable": unreadable}),
}


def _pairs(third: bool) -> list[tuple[str, str]]:
    """Each command with each third kind of file, another third than the command before; or the other pairs."""
    return [
        (name, kind) for row, name in enumerate(READS) for at, kind in enumerate(KINDS, row) if (at % 3 == 0) == third
    ]


@pytest.mark.parametrize(("name", "kind"), cases(_pairs(True), _pairs(False)))
def test_what_is_no_file_of_its_kind_is_told_in_a_sentence(kitrobot, here: Path, name: str, kind: str) -> None:
    (here / "good.lll").write_text("Wheel.Stop();\n", encoding="utf-8")
    words = [str(word) for word in READS[name]]
    bad = next(word for word in words if word.startswith("bad."))
    if name in WRITES and kind in DEVICES:
        return  # whoever runs this may be allowed to spoil the system: test_files has a pipe in their place
    KINDS[kind](here / bad)
    opened: list[object] = []
    said = kitrobot(*words, studio=lambda *given, **more: opened.append(given))
    assert said.status in (0, 1, 2), said
    if said.status == 0:
        assert kind in MAY_BE_RIGHT or "studio" in name or name in ("run recorded", "merge output"), said
    else:
        assert "\n" in said.err or said.out, said
        assert not (here / "out.krt").exists(), "nothing is written"
        assert not (here / "out.kra").exists(), "nothing is written"
    if words[0] not in WITH_JSON:
        return
    if (here / bad).is_file() and name == "run recorded":
        (here / bad).unlink()
        KINDS[kind](here / bad)
    with_json = kitrobot(*words, "--json")
    assert with_json.status == said.status
    for value in [with_json.json] if words[0] != "exec" or with_json.status else with_json.lines:
        json.dumps(value)
    if with_json.status and words[0] != "check" and isinstance(with_json.json, dict):
        assert "error" in with_json.json or "outcome" in with_json.json, with_json


def test_every_command_that_reads_a_file_is_tried() -> None:
    from kitrobot.cli.app import app

    names = {command.name for command in app.registered_commands if command.name}
    others = {"boards", "class", "desktop", "maze", "site", "start", "stop"}
    assert names - {words[0] for words in READS.values()} == others


def test_a_file_that_may_not_be_replaced_is_told(kitrobot, here: Path) -> None:
    shutil.copy(EXAMPLE, here / "ours.krt")
    (here / "out.krt").mkdir()
    said = kitrobot("merge", "ours.krt", "ours.krt", "ours.krt", "-o", "out.krt")
    assert said.status == 2, said
