"""The list of a set of boards, and the labels that boards are found by; nothing is sent here."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import pytest
from serial.tools import list_ports

from kitrobot.boards.class_set import MOST_BOARDS, BoardOrder, SetError, prepare_set, read_set
from kitrobot.boards.labels import LabelError, labels_of, store_label
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.examples import examples_folder

EXAMPLES = examples_folder()
assert EXAMPLES is not None
HEART = EXAMPLES / "heart" / "heart.krt"


@dataclass(frozen=True)
class Usb:
    """A port as pyserial lists it."""

    device: str
    serial_number: str | None
    vid: int | None = 0x0D28
    product: str = "micro:bit"
    description: str = "BBC micro:bit"


@pytest.fixture
def plugged(monkeypatch, tmp_path):
    """Says what is plugged in from now on."""
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    monkeypatch.delenv("KITROBOT_BOARDS", raising=False)

    def plug(*ports: Usb) -> None:
        monkeypatch.setattr(list_ports, "comports", lambda: list(ports))

    plug()
    return plug


def written(folder: Path, text: str | bytes) -> Path:
    path = folder / "class.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def test_a_board_keeps_its_label_at_another_port(plugged):
    plugged(Usb("/dev/ttyACM0", "9900A"), Usb("/dev/ttyACM1", "9900B"))
    assert store_label("/dev/ttyACM0", "  Red   1 ") == "Red 1"
    plugged(Usb("/dev/ttyACM0", "9900B"), Usb("/dev/ttyACM7", "9900A"))
    assert labels_of(["/dev/ttyACM0", "/dev/ttyACM7"]) == {"/dev/ttyACM7": "Red 1"}
    store_label("/dev/ttyACM0", "RED 1")
    assert labels_of(["/dev/ttyACM0", "/dev/ttyACM7"]) == {"/dev/ttyACM0": "RED 1"}, "a label is one board's"
    store_label("/dev/ttyACM0", "")
    assert labels_of(["/dev/ttyACM0", "/dev/ttyACM7"]) == {}


def test_a_board_that_cannot_be_known_again_gets_no_label(plugged):
    plugged(Usb("/dev/ttyUSB0", None))
    with pytest.raises(LabelError, match="no number of its own"):
        store_label("/dev/ttyUSB0", "A")
    with pytest.raises(LabelError, match="no number of its own"):
        store_label("/dev/ttyACM9", "A")


@pytest.mark.parametrize("label", ["x" * 41, "\x1b[31mred", "\ud800"])
def test_what_is_no_label_is_refused(plugged, label):
    with pytest.raises(LabelError, match="is no name for a label"):
        store_label("socket://h:1", label)
    assert labels_of(["socket://h:1"]) == {}


@pytest.mark.parametrize("kept", [b"", b"[]", b"{", b"[" * 100_000, b'{"socket://h:1": 7, "x": ""}', b"\xff"])
def test_damaged_labels_are_none(plugged, tmp_path, kept):
    path = tmp_path / "state" / "boards" / "labels"
    path.parent.mkdir(parents=True)
    path.write_bytes(kept)
    assert labels_of(["socket://h:1"]) == {}
    assert store_label("socket://h:1", "x" * 40) == "x" * 40


@pytest.mark.parametrize(
    "text",
    [
        "label,mission,port\nA1,heart.krt,\nB 2,sub/h.krt,COM7\n",
        "\ufefflabel;mission;port\r\nA1;heart.krt;\r\n\r\nB 2; sub/h.krt ;COM7\r\n",
        'Mission,LABEL,port\n"heart.krt",A1\nsub/h.krt,"B 2",COM7',
    ],
)
def test_a_list_is_read_as_spreadsheets_write_it(tmp_path, text):
    assert read_set(written(tmp_path, text)) == [
        BoardOrder("A1", tmp_path / "heart.krt"),
        BoardOrder("B 2", tmp_path / "sub" / "h.krt", port="COM7"),
    ]


@pytest.mark.parametrize(
    ("text", "says", "line"),
    [
        ("", "names its columns", 1),
        ("label,mission\n", "names no board", None),
        ("label\nA", "names its columns", 1),
        ("label,label,mission\n", "names its columns", 1),
        ("label,mision\nA,b", "no column `mision`", 1),
        ("label,mission\nA,b,c", "more cells", 2),
        ("label,mission\nA,", "names no mission", 2),
        ("label,mission\n,a.krt", "is no name for a label", 2),
        ("label,mission\nA,a.krt\n\na ,b.krt", "`a` stands in the list twice", 4),
        ("label,mission,port\nA,a.krt,COM1\nB,b.krt,COM1", "`COM1` stands in the list twice", 3),
        ('label,mission\n"A,a.krt', "is no table", None),
        ("label,mission\nA," + "x" * 200_000, "is no table", None),
        (b"label,mission\n\xff,a", "UTF-8", 2),
        ("label,mission\n" + "".join(f"L{k},a.krt\n" for k in range(MOST_BOARDS + 1)), "at most 200 boards", None),
    ],
)
def test_a_list_that_cannot_be_used_is_told_with_its_line(tmp_path, text, says, line):
    with pytest.raises(KitRobotError, match=says) as caught:
        read_set(written(tmp_path, text))
    place = getattr(caught.value, "place", None)
    assert (place.line if place else None) == line


def test_a_folder_names_a_board_by_each_mission_in_it(tmp_path):
    with pytest.raises(SetError, match="no mission in the folder"):
        read_set(tmp_path)
    for name in ("B2.krt", "A1.KRT", "notes.txt"):
        (tmp_path / name).write_bytes(HEART.read_bytes())
    assert read_set(tmp_path) == [BoardOrder("A1", tmp_path / "A1.KRT"), BoardOrder("B2", tmp_path / "B2.krt")]


def test_each_board_gets_its_own_and_what_is_wrong_with_one_holds_up_no_other(plugged, tmp_path):
    plugged(
        *(Usb(f"/dev/ttyACM{k}", f"99{k}") for k in range(4)),
        Usb("/dev/ttyACM8", "twin"),
        Usb("/dev/ttyACM9", "twin"),
    )
    for port, label in (("0", "A"), ("1", "B"), ("2", "C"), ("8", "T")):
        store_label(f"/dev/ttyACM{port}", label)
    (tmp_path / "bad.krt").write_text("<kitrobot")
    wanted = [
        BoardOrder("a", HEART),
        BoardOrder("B", tmp_path / "bad.krt"),
        BoardOrder("C", HEART, kit="no-such-kit"),
        BoardOrder("gone", HEART),
        BoardOrder("T", HEART),
        BoardOrder("again", HEART, port="/dev/ttyACM0"),
        BoardOrder("far", HEART, port="socket://h:1"),
        BoardOrder("nul", tmp_path / "\0.krt", port="socket://h:2"),
    ]
    found = prepare_set(wanted)
    assert found.addresses == ["/dev/ttyACM0", "socket://h:1"]
    assert found.members[0].program is found.members[6].program, "made once for all who get the same"
    said = [str(one.error.message) if one.error is not None else "" for one in found.members]
    assert [bool(one) for one in said] == [False, True, True, True, True, True, False, True]
    assert "no board with the label `gone`" in said[3]
    assert "several boards have the label `T`: /dev/ttyACM8, /dev/ttyACM9" in said[4]
    assert "`a` and `again` are both given the board on `/dev/ttyACM0`" in said[5]
    assert found.others == ("/dev/ttyACM3", "/dev/ttyACM8", "/dev/ttyACM9")
    assert json.loads((tmp_path / "state" / "boards" / "labels").read_text(encoding="utf-8"))["usb 990"] == "A"
