"""What a driver says of its settings and procedures is held against the robot's XML, before anything is sent."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

import kitrobot_onboard
from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.declarations import Setting, read_declaration, without_declarations
from kitrobot.deploy.package.driver_fit import refuse_misfits
from kitrobot.deploy.package.package import FAMILIES, Package
from kitrobot.deploy.package.program_file import Device, ProgramFile
from kitrobot.primitives.catalogue import load_catalogue

DRIVERS = Path(kitrobot_onboard.__file__).parent / "drivers"


def file_of(*lines: str) -> ProgramFile:
    """A program file with these devices."""
    words = [line.split(" ") for line in lines]
    return ProgramFile(
        tuple(Device(kind, driver, tuple(rest), f"Part{n}") for n, (kind, driver, *rest) in enumerate(words)), b""
    )


def refused(*lines: str, package: Package | None = None) -> PackageError:
    with pytest.raises(PackageError) as caught:
        refuse_misfits(file_of(*lines), package or Package(), "machine")
    return caught.value


def own(folder: Path, text: str) -> Package:
    (folder / "own.driver.py").write_text(text, encoding="utf-8")
    return Package([folder])


def test_settings_are_read_without_running_the_driver() -> None:
    text = """
raise SystemExit
SETTINGS = {"a": "pin", "b": "pin?", "c": "1..9 = 3", "d": "-5..5", "e": "x|y", "f": "x|y = x", "g": "text?"}
PROCEDURES = "Open Close"
"""
    says = read_declaration(ast.parse(text), "own.driver.py")
    assert says.procedures == ("Open", "Close")
    assert says.settings == {
        "a": Setting(True, True),
        "b": Setting(True, False),
        "c": Setting(False, False, 1, 9, usual="3"),
        "d": Setting(False, True, -5, 5),
        "e": Setting(False, True, words=("x", "y")),
        "f": Setting(False, False, words=("x", "y"), usual="x"),
        "g": Setting(False, False),
    }


def test_what_a_setting_is_may_depend_on_another_one() -> None:
    text = """SETTINGS = {
    "by": "pins|one|two = pins",
    "a": "channel 0..3? where by=one; 1..2 where by=two; pin",
    "by-address": "5..6 where by=one",
}"""
    says = read_declaration(ast.parse(text), "own.driver.py")
    found = {by: says.known({"by": by}) for by in ("pins", "one", "two")}
    assert [sorted(known) for known in found.values()] == [["a", "by"], ["a", "by", "by-address"], ["a", "by"]]
    assert (found["pins"]["a"].is_pin, found["pins"]["a"].is_channel) == (True, False)
    one = found["one"]["a"]
    assert (one.is_channel, one.is_pin, one.needed, one.least, one.most) == (True, False, False, 0, 3)
    assert (found["two"]["a"].least, found["two"]["a"].is_channel) == (1, False)
    assert says.known({}) == found["pins"]


@pytest.mark.parametrize(
    "line",
    [
        "SETTINGS = [1]",
        "SETTINGS = f()",
        "SETTINGS = {'a': 'pine'}",
        "SETTINGS = {'a': '1..'}",
        "SETTINGS = {'a': 1}",
        "SETTINGS = {1: 'pin'}",
        "SETTINGS = {'a': 'x|'}",
        "SETTINGS = {'a': 'channel 0..3'}",
        "SETTINGS = {'a': 'pin; channel 0..3 where b=c'}",
        "SETTINGS = {'a': 'pin where b'}",
        "SETTINGS = {'a': 'pin where b=c;'}",
        "PROCEDURES = ['Open']",
        "PROCEDURES = x + 1",
        "CHIP = 'nrf51822'",
        "CHIP = chip",
    ],
)
def test_a_declaration_that_cannot_be_read_is_named_with_its_line(line: str) -> None:
    with pytest.raises(PackageError, match=r"own.driver.py` line 2: ") as caught:
        read_declaration(ast.parse(f"\n{line}"), "own.driver.py")
    assert line.split(" ")[0] in f"{caught.value.message} {caught.value.help}"


def test_a_driver_says_for_which_chip_alone_it_is_and_does_not_say_it_on_the_board() -> None:
    for text, chip in (("CHIP = 'nrf52833'", "nrf52833"), ("SETTINGS = {}", "")):
        tree = ast.parse(text)
        assert read_declaration(tree, "own.driver.py").chip == chip
        assert without_declarations(tree).body == []


@pytest.mark.parametrize(
    ("line", "sentence", "help"),
    [
        ("a servo 1 Open/0+,Close/0+ open=90", "`Part0` does not say its `pin`", 'pin="…"'),
        ("a servo 1 Open/0+ pin=2 opened=90", "setting `opened`, which the driver `servo` does not know", "`closed`"),
        ("a servo 1 Open/0+ pin=2 open=181", "must be a whole number from 0 to 180, and it is `181`", "XML"),
        ("a servo 1 Open/0+ pin=2 open=-1", "from 0 to 180, and it is `-1`", "XML"),
        ("a servo 1 Open/0+ pin=2 time=1.5", "from 1 to 60000, and it is `1.5`", "XML"),
        ("a servo 1 Open/0+ pin=2 time=٣", "from 1 to 60000", "XML"),
        ("a led - LightOn/0 pin=2 active=up", "must be one of `high`, `low`, and it is `up`", "XML"),
        ("a led - Shine/1 pin=2", "procedure `Shine`, which the driver `led` cannot do", "`LightOn`, `LightOff`"),
        ("s key 1 0 1", "`Part0` does not say its `pin`", "XML"),
        ("s key 1 0 1 pin=2 limit=3", "does not know", "it knows `pin`"),
        ("s random 1 0 1 pin=2", "does not know", "it knows none"),
    ],
)
def test_what_a_driver_does_not_understand_is_refused(line: str, sentence: str, help: str) -> None:
    error = refused(line)
    assert sentence in str(error)
    assert help in error.help


def test_two_parts_on_one_pin_are_refused() -> None:
    error = refused("a led - LightOn/0 pin=2", "s key 1 0 1 pin=3", "a pwm-motor - Stop/0 forward=4 backward=3")
    assert error.message == "`Part1` and `Part2` are both wired to the pin `3`"
    channels = "left-forward=0 left-backward=1 right-forward=2 right-backward={}"
    bus = "motors=pca9685 sda=0 scl=1"
    drive = f"a drive - Stop/0 {bus} {channels}"
    refuse_misfits(file_of(drive.format(3), f"a turn - Stop/0 {bus} {channels.format(3)}"), Package(), "machine")
    assert refused(drive.format(0)).message == "`Part0` says the channel `0` for two different things"
    shifted = channels.replace("forward=2", "forward=4").format(2)
    error = refused(drive.format(3), f"a turn - Stop/0 {bus} {shifted}")
    assert error.message == "`Part0` and `Part1` both use the channel `2` of one chip"
    error = refused("a pwm-motor - Stop/0 forward=4 backward=4")
    assert error.message == "`Part0` says the pin `4` for two different things"


@pytest.mark.parametrize(
    "line",
    [
        "a servo 1 Open/0+,Close/0+ pin=2",
        "a servo 1 Open/0+ pin=GP2 open=0 closed=180 time=60000 limit=5",
        "a led - - pin=LED active=low",
        "s line 1 0 1 pin=26 threshold=30000",
        "s random 1 0 1",
        "s pin-in 1 0 1 pin=2\na pin-out - Write/1 pin=2",
    ],
)
def test_what_a_driver_understands_is_taken(line: str) -> None:
    refuse_misfits(file_of(*line.split("\n")), Package(), "machine")


def test_a_driver_that_says_nothing_is_told_anything(tmp_path: Path) -> None:
    package = own(tmp_path, "def make(settings):\n    return None\n")
    refuse_misfits(file_of("a own - Any/3 whatever=1 pin=2", "a own - Any/3 pin=2"), package, "machine")


def test_ones_own_driver_is_held_to_what_it_says(tmp_path: Path) -> None:
    package = own(tmp_path, "SETTINGS = {'speed': '1..3'}\ndef make(settings):\n    return None\n")
    assert "from 1 to 3" in str(refused("s own 1 0 1 speed=4", package=package))
    broken = own(tmp_path, "SETTINGS = 3\n")
    assert re.search(r"own\.driver\.py` line 1: SETTINGS", str(refused("s own 1 0 1", package=broken)))


def test_declarations_do_not_land_on_a_board() -> None:
    built = Package().build("machine", {"servo": None, "pin-in": None}, COMPILED_LOOP)
    for content in built.files.values():
        assert b"SETTINGS" not in content
        assert b"PROCEDURES" not in content


def words_of(path: Path) -> set[str]:
    """The texts in a driver and the modules that it imports, but for declarations; `-forward` is of two sides."""
    tree = without_declarations(ast.parse(path.read_text(encoding="utf-8")))
    found = {node.value for node in ast.walk(tree) if isinstance(node, ast.Constant) and isinstance(node.value, str)}
    found |= {side + word for word in found if word.startswith("-") for side in ("left", "right")}
    for node in ast.walk(tree):
        words = (node.module or "").split(".") if isinstance(node, ast.ImportFrom) else []
        if words[:2] == ["kitrobot_onboard", "drivers"]:
            found |= words_of(DRIVERS.joinpath(*words[2:]).with_suffix(".py"))
    return found


@pytest.mark.parametrize(
    "path",
    sorted(DRIVERS.glob("*/*.py")),
    ids=lambda path: f"{path.parent.name}/{path.stem}",
)
def test_every_shipped_driver_declares_its_settings(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    says = read_declaration(ast.parse(text), path.name)
    if "make" not in text:
        return
    assert says.settings is not None
    read = set(re.findall(r"settings(?:\.get\(|\[)\"([\w-]+)\"", text))
    assert read - {"min", "max"} <= set(says.settings), "it declares what it reads"
    assert set(says.settings) <= words_of(path), "it, or what it shares with others, reads what it declares"
    if " do(" in text:
        assert says.procedures


@pytest.mark.parametrize("robot", ["kit-robot", "microbit"])
def test_shipped_robots_fit_their_boards(robot: str) -> None:
    found = load_catalogue().robots[robot]
    package = Package()
    for part in (*found.actuators, *found.sensors):
        driver = part.board.driver or part.device
        family = next(family for family in FAMILIES if package.driver_file(driver, family))
        settings = [f"{name}={value}" for name, value in part.board.settings.items()]
        calls = ",".join(f"{method.name}/{len(method.parameters)}" for method in part.methods)
        words = ["a", driver, "-", calls] if part in found.actuators else ["s", driver, "1", "0", "1"]
        refuse_misfits(file_of(" ".join([*words, *settings])), package, family)
