"""`kitrobot deploy LIST --set`: each board gets what the list names for its label, and a table says what runs where."""

from __future__ import annotations

import json
import re
import socket
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.boards.bench import ONE, OTHER, bench_program
from tests.boards.modern import ModernBoard
from tests.boards.test_microbit_v2 import board as micro_bit
from tests.boards.test_several import hang_up
from tests.boards.watching import called


def mission(folder: Path, name: str, text: str) -> None:
    bench_program(folder, text)
    made = called(
        "convert", str(folder / "program.lll"), str(folder / f"{name}.krt"), "--robot", str(folder / "bench.robot.xml")
    )
    assert made.returncode == 0, made.stderr


@pytest.fixture
def v2() -> Iterator[ModernBoard]:
    with micro_bit("nRF52833", (1, 28, 0)) as found:
        yield found


def test_a_class_set_has_each_its_program_and_one_that_fails_holds_up_no_other(
    v2: ModernBoard, board: ModernBoard, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mission(tmp_path, "one", ONE)
    mission(tmp_path, "other", OTHER)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        dead = f"socket://127.0.0.1:{listener.getsockname()[1]}"
        threading.Thread(target=hang_up, args=(listener,), daemon=True).start()
        there = [v2.address, board.address, "socket://127.0.0.1:1"]
        monkeypatch.setenv("KITROBOT_BOARDS", " ".join(there))
        assert called("boards", "--to", there[0], "--label", "Red 1").stderr == f"{there[0]}: the label is Red 1\n"
        assert json.loads(called("boards", "--to", there[1], "--label", "B", "--json").stdout)[0]["label"] == "B"
        table = tmp_path / "class.csv"
        table.write_text(f"label;mission;port\nred 1;one.krt;\nB;other.krt;\ndead;one.krt;{dead}\nlost;one.krt;\n")
        said = called("deploy", str(table), "--set")
    assert said.returncode == 1
    head, *rows = said.stdout.splitlines()
    assert re.split(r"\s{2,}", head)[:3] == ["label", "port", "program"]
    red, blue, *failed = [re.split(r"\s{2,}", row) for row in rows]
    assert red[:2] == ["red 1", there[0]]
    assert blue[:2] == ["B", there[1]]
    assert (red[3], blue[3]) == ("running", "running")
    assert red[2] != blue[2], "each has its own"
    assert red[5] != blue[5], "and its own firmware"
    assert [(row[0], row[-1]) for row in failed] == [("dead", "failed"), ("lost", "failed")]
    assert f"dead ({dead}):" in said.stderr
    assert "no board with the label `lost` is plugged in" in said.stderr
    assert "not in the list, and left as they are: socket://127.0.0.1:1" in said.stderr

    listed = json.loads(called("boards", "--to", there[0], "--to", there[1], "--json").stdout)
    assert [one["label"] for one in listed] == ["Red 1", "B"]
    assert [f"{one['name_of_program']} ({one['program']})" for one in listed] == [red[2], blue[2]]
    shown = called("boards", "--to", there[0], "--to", there[1]).stdout.splitlines()
    assert [line.split()[0] for line in shown] == ["label", "Red", "B"]

    folder = tmp_path / "missions"
    folder.mkdir()
    for name in ("bench.robot.xml", "stores.driver.py", "zero.driver.py"):
        (folder / name).write_bytes((tmp_path / name).read_bytes())
    (folder / "B.krt").write_bytes((tmp_path / "one.krt").read_bytes())
    again = called("deploy", str(folder), "--set", "--json")
    assert again.returncode == 0, again.stderr
    (found,) = json.loads(again.stdout)
    assert (found["label"], found["address"], found["ok"], found["state"]) == ("B", there[1], True, "running")
    assert found["program"] not in blue[2], "the folder's mission took the place of the list's"
    assert called("deploy", str(folder), "--set", "--to", there[1]).returncode == 2
