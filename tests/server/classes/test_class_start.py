"""What the terminal says when a class opens: who can reach it, where programs run, how pupils come in.

A class that is open as a process is in `test_data_protection`.
"""

from __future__ import annotations

import subprocess
import tomllib
from pathlib import Path

import pytest

from kitrobot.server.classroom.class_server import reach_sentence
from kitrobot.server.classroom.qr_codes import qr_rows
from kitrobot.server.studio_server import ServerError

FINDER = ["1111111", "1000001", "1011101", "1011101", "1011101", "1000001", "1111111"]
"""What a QR code has in three of its corners (ISO/IEC 18004)."""


def a_class_that_opens_says_what_a_teacher_has_to_tell(process: subprocess.Popen[str], folder: Path) -> str:
    """Where pupils reach it. `process`: the class, in English; `folder`: its own."""
    assert process.stdout is not None
    assert process.stderr is not None
    address = process.stdout.readline().strip().partition("teacher?")[0]
    said = []
    for line in process.stderr:
        said.append(line.strip())
        if "Ctrl-C" in line:
            break
    code = tomllib.loads((folder / "class.toml").read_text())["code"]
    words = "\n".join(said)
    assert f"Pupils open {address}\nand type the code {code[:3]} {code[3:]}" in words
    assert "Only this machine can reach the class; for pupils at others start it with `--host" in words
    assert f"Programs of pupils run on this machine. For more than a few pupils write a site into {folder}" in words
    assert f"The work of the class is in the folder {folder}." in words
    return address


@pytest.mark.parametrize(
    ("address", "secure", "words"),
    [
        ("127.0.0.1", False, "Only this machine can reach the class"),
        ("::1", True, "Only this machine can reach the class"),
        ("192.168.4.20", False, "What is sent can be read in that network: `--https` prevents it."),
        ("0.0.0.0", False, "What is sent can be read in that network: `--https` prevents it."),
        (
            "192.168.4.20",
            True,
            "Everybody in the network of this machine can reach the class; who has the code comes in.",
        ),
    ],
)
def test_it_is_said_who_can_reach_a_class(address: str, secure: bool, words: str) -> None:
    assert words in reach_sentence(address, secure)


@pytest.mark.parametrize("host", ["school.example", "", "300.1.1.1", "192.168.4.20:80", "-"])
def test_an_address_that_is_none_is_a_sentence(tmp_path: Path, host: str) -> None:
    from kitrobot.server.classroom.class_server import ClassSettings, serve_class

    with pytest.raises(ServerError, match="is no address of this machine") as found:
        serve_class(ClassSettings(tmp_path / "Class", host))
    assert "number in the network" in found.value.help
    assert not (tmp_path / "Class").exists()


def test_the_picture_of_the_address_is_a_qr_code() -> None:
    rows = qr_rows("http://192.168.4.20:8765/")
    size = len(rows)
    assert {len(row) for row in rows} == {size}
    assert (size - 17) % 4 == 0
    corners = [[row[:7] for row in rows[:7]], [row[-7:] for row in rows[:7]], [row[:7] for row in rows[-7:]]]
    assert corners == [FINDER] * 3
