"""What is made for a board: files named by their content, drivers found in order, names that fit together."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from kitrobot.compiler.compilation import compile_text
from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.installation.boot_records import StartLine, is_ours, needed, newest, read_line
from kitrobot.deploy.installation.loop_installers import LOOP_INSTALLERS
from kitrobot.deploy.microbit_2016.flash_loop import FLASH_LOOP
from kitrobot.deploy.package.board_package import LoopInstaller
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.content_names import name_of
from kitrobot.deploy.package.package import Package
from kitrobot.deploy.package.program_file import Device, ProgramFile
from kitrobot.deploy.package.script import board_file
from kitrobot.primitives.catalogue import load_catalogue

_COMPILED = compile_text("Display.Image(0);", load_catalogue().robots["microbit"]).image
assert _COMPILED is not None
IMAGE = _COMPILED.to_bytes()

DRIVER = "def make(settings):\n    # a remark that costs nothing on a board\n    return {word!r}\n"


def driver(folder: Path, name: str, word: str = "x") -> Path:
    folder.mkdir(exist_ok=True)
    path = folder / f"{name}.driver.py"
    path.write_text(DRIVER.format(word=word), encoding="utf-8")
    return path


@pytest.mark.parametrize(("family", "installer"), LOOP_INSTALLERS)
def test_every_file_is_named_by_what_is_in_it(family: str, installer: LoopInstaller) -> None:
    built = Package().build(family, {}, installer)
    assert built.files
    for name, content in built.files.items():
        if name != "krboot.py":  # which main.py imports, and which never changes
            assert name == name_of(content) + ".py"
            assert is_ours(name)


@pytest.mark.parametrize(("family", "installer"), LOOP_INSTALLERS)
def test_all_files_are_named_by_the_program_file(family: str, installer: LoopInstaller, tmp_path: Path) -> None:
    driver(tmp_path, "mine")
    built = Package((tmp_path,)).build(family, {"mine": None}, installer)
    program = ProgramFile((Device("s", "mine", ("1", "0", "1")),), IMAGE)
    files = {**built.files, "kp01234567": board_file(program, built)}
    found = needed([f"{built.interpreter}.py", "kp01234567"], files.get)
    in_flash = {f"{built.interpreter}.py"} if installer is FLASH_LOOP else set()
    assert found == set(files) - {"krboot.py"} | in_flash
    for content in files.values():
        for name in re.findall(rb"\bkr[0-9a-f]{8}\b", content):
            assert name.decode() + ".py" in files


def test_the_same_package_twice_is_the_same_to_the_byte() -> None:
    assert Package().build("microbit", {}, FLASH_LOOP) == Package().build("microbit", {}, FLASH_LOOP)


def test_a_driver_of_the_mission_wins_over_one_of_the_user_and_that_over_a_shipped_one(tmp_path: Path) -> None:
    user, mission = tmp_path / "user", tmp_path / "mission"
    user.mkdir()
    mission.mkdir()
    package = Package((user, mission))
    shipped = package.driver_file("key", "microbit")
    assert shipped is not None
    assert shipped.parent.name == "microbit"
    assert package.driver_file("key", "microbit") == shipped
    own = driver(user, "key", "user")
    assert package.driver_file("key", "microbit") == own
    beside = driver(mission, "key", "mission")
    assert package.driver_file("key", "microbit") == beside
    built = package.build("microbit", {"key": None}, FLASH_LOOP)
    content = built.files[built.drivers["key"]]
    assert b"mission" in content
    assert b"remark" not in content


@pytest.mark.parametrize("name", ["my-lamp", "my_lamp"])
def test_a_driver_with_a_hyphen_is_found_by_both_names_of_its_file(tmp_path: Path, name: str) -> None:
    assert Package((tmp_path,)).driver_file("my-lamp", "machine") is None
    path = driver(tmp_path, name)
    assert Package((tmp_path,)).driver_file("my-lamp", "machine") == path


@pytest.mark.parametrize("name", ["../key", "a b", "", "microbit/key", "..", "key.py"])
def test_a_name_that_leads_elsewhere_is_no_driver(tmp_path: Path, name: str) -> None:
    assert Package((tmp_path,)).driver_file(name, "microbit") is None
    with pytest.raises(PackageError, match="no driver"):
        Package((tmp_path,)).build("microbit", {name: None}, FLASH_LOOP)


def test_a_driver_that_is_no_python_is_told_with_its_line(tmp_path: Path) -> None:
    (tmp_path / "bad.driver.py").write_text("def make(settings):\n    return (\n")
    with pytest.raises(PackageError, match=r"bad\.driver\.py` line 2"):
        Package((tmp_path,)).build("microbit", {"bad": None}, FLASH_LOOP)


@pytest.mark.parametrize("content", [b"\xff\xfe", b"x = 1\n" * 60_000])
def test_a_driver_that_cannot_be_read_is_told(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "bad.driver.py").write_bytes(content)
    with pytest.raises(PackageError, match=r"bad\.driver\.py"):
        Package((tmp_path,)).build("microbit", {"bad": None}, FLASH_LOOP)


def test_a_driver_may_use_what_ours_use_and_nothing_that_is_not_there(tmp_path: Path) -> None:
    path = tmp_path / "mine.driver.py"
    path.write_text("from kitrobot_onboard.nothing import x\n\ndef make(settings):\n    return x\n")
    with pytest.raises(PackageError, match="line 1 imports"):
        Package((tmp_path,)).build("machine", {"mine": None}, COMPILED_LOOP)


def test_a_line_is_read_as_it_was_written() -> None:
    line = StartLine(7, "kr01234567", "kp89abcdef", 65535)
    assert read_line(line.to_bytes()) == line
    assert line.files == ["kr01234567.py", "kp89abcdef"]


def test_a_line_that_is_cut_or_changed_anywhere_does_not_count() -> None:
    data = StartLine(12, "kr01234567", "kp89abcdef", 10).to_bytes()
    for at in range(len(data)):
        assert read_line(data[:at]) is None
        for byte in (0, 0x30, 0x31, 0x61, 0xFF):
            changed = data[:at] + bytes((byte,)) + data[at + 1 :]
            assert changed == data or read_line(changed) is None


def test_the_larger_generation_counts() -> None:
    old, new = StartLine(9, "kr00000000", "kp00000000", 1), StartLine(10, "kr11111111", "kp11111111", 2)
    assert newest({"kr0": new, "kr1": old}) == ("kr0", new)
    assert newest({"kr0": old, "kr1": new}) == ("kr1", new)
    assert newest({}) is None


@pytest.mark.parametrize(
    "name", ["main.py", "kr0", "kr1", "kr1234567.py", "kr123456789.py", "krab.py", "xkr12345678.py"]
)
def test_files_of_others_are_not_ours(name: str) -> None:
    assert not is_ours(name)
