"""Kits held against the drivers: pins that a board does not have or that are used twice, settings, missing parts."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.compiler.compilation import compile_text
from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.kits.kits import fit_to_kit, kit_problems, parts_on_kit, refuse_what_is_missing
from kitrobot.deploy.package.package import Package
from kitrobot.primitives.catalogue import SHIPPED, load_catalogue
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.kit_xml import read_kit
from kitrobot.robots.program import program_of

MOTORS = 'left-forward="2" left-backward="3" right-forward="4" right-backward="5"'


def kit_of(parts: str, pins: str = "0..22 LED") -> Kit:
    text = f'<board name="k" version="1" pins="{pins}">{parts}</board>'
    kit, found = read_kit(text.encode(), "k.board.xml")
    assert kit is not None, found
    return kit


def problems(parts: str, pins: str = "0..22 LED") -> list[str]:
    return [str(problem) for _, problem in kit_problems(kit_of(parts, pins), Package())]


@pytest.mark.parametrize("path", sorted(SHIPPED.glob("*.board.xml")), ids=lambda path: path.name)
def test_the_wiring_of_a_shipped_kit_is_right(path: Path) -> None:
    kit, _ = read_kit(path.read_bytes(), str(path))
    assert kit is not None
    assert [str(problem) for _, problem in kit_problems(kit, Package())] == []


@pytest.mark.parametrize("name", ["cardboard"])
def test_modules_are_wired_to_pins_of_drivers_and_each_pin_once(name: str) -> None:
    kit, _ = read_kit((SHIPPED / f"{name}.board.xml").read_bytes(), name)
    assert kit is not None
    modules = {module.name: {wire.terminal for wire in module.wires} for module in kit.modules}
    pins = [wire.to for module in kit.modules for wire in module.wires if wire.to.isdigit()]
    assert len(set(pins)) == len(pins)
    package = Package()
    driven: set[str] = set()
    for part in kit.parts:
        for device in part.devices if not part.is_missing else ():
            known = package.declared(part.board.driver or device, kit.family).known(part.board.settings)
            driven |= {value for key, value in part.board.settings.items() if key in known and known[key].is_pin}
    assert set(pins) <= driven
    motors = next(part for part in kit.parts if "drive" in part.devices).board.settings
    assert {value for key, value in motors.items() if key.endswith(("forward", "backward", "power"))} <= set(pins)
    for module in kit.modules:
        for wire in module.wires:
            other = wire.to.partition(" ")[0]
            assert wire.to in (*pins, "3V3", "GND", "VSYS") or other in modules


def test_an_eye_of_a_maqueen_reads_0_on_a_dark_line() -> None:
    kit, _ = read_kit((SHIPPED / "maqueen.board.xml").read_bytes(), "maqueen")
    assert kit is not None
    eyes = [part for part in kit.parts if part.board.driver == "line"]
    assert [part.board.settings["dark"] for part in eyes] == ["low", "low"]


@pytest.mark.parametrize(
    ("parts", "says"),
    [
        (f'<actuator device="drive" {MOTORS.replace("5", "99")}/>', "the pin `99`, which this board does not have"),
        (f'<actuator device="drive" {MOTORS.replace("5", "4")}/>', "the pin `4` for two different things"),
        (f'<actuator device="drive" {MOTORS}/><sensor device="button" driver="key" pin="3"/>', "wired to the pin `3`"),
        (f'<actuator device="drive" {MOTORS} colour="red"/>', "knows the setting `colour`"),
        (f'<actuator device="drive" {MOTORS} frequency="0"/>', "from 10 to 100000"),
        ('<actuator device="drive" driver="rocket"/>', "no driver `rocket`"),
        ('<actuator device="door" driver="servo"/>', "does not say its `pin`"),
    ],
)
def test_a_wiring_that_cannot_be_is_told(parts: str, says: str) -> None:
    (found,) = problems(parts)
    assert says in found


CHIP = (
    'motors="pca9685" sda="0" scl="1" left-forward="10" left-backward="9" left-power="8"'
    ' right-forward="11" right-backward="12" right-power="13"'
)
"""Motors behind a chip, at its channels."""

OTHER = CHIP.replace("10", "14").replace('"8"', '"10"')
"""The same with the power of the left one where the other has its forward."""


@pytest.mark.parametrize(
    ("parts", "says"),
    [
        (f'<actuator device="drive turn wheel" {CHIP}/>', ""),
        (f'<actuator device="drive turn" {CHIP} frequency="24" motors-address="119" bus="1" rate="90"/>', ""),
        (f'<actuator device="drive" {CHIP}/><sensor device="button" driver="key" pin="10"/>', ""),
        (f'<actuator device="turn" {CHIP} gyro="lsm6dso"/><sensor device="a" driver="tcs34725" sda="0" scl="1"/>', ""),
        (
            f'<actuator device="drive turn" {CHIP}/><actuator device="drive" when="guide=road" driver="road" {CHIP}'
            ' left-eye="16" right-eye="17"/>',
            "",
        ),
        (f'<actuator device="drive" {CHIP} frequency="23"/>', "`frequency` of `drive` must be a whole number from 24"),
        (f'<actuator device="drive" {CHIP} frequency="1527"/>', "from 24 to 1526, and it is `1527`"),
        (f'<actuator device="drive" {CHIP} motors-address="63"/>', "from 64 to 119, and it is `63`"),
        (f'<actuator device="drive" {CHIP} motors-address="120"/>', "from 64 to 119, and it is `120`"),
        (f'<actuator device="drive" {CHIP.replace("13", "16")}/>', "from 0 to 15, and it is `16`"),
        (f'<actuator device="drive" {CHIP.replace("13", "LED")}/>', "from 0 to 15, and it is `LED`"),
        (f'<actuator device="drive" {CHIP.replace("13", "9")}/>', "`drive` says the channel `9` for two different"),
        (f'<actuator device="drive" {CHIP.replace("13", "+9")}/>', "says the channel `+9` for two different things"),
        (
            f'<actuator device="drive" {CHIP}/><actuator device="turn" {OTHER}/>',
            "`drive` and `turn` both use the channel `10` of one chip",
        ),
        (
            f'<actuator device="drive" {CHIP}/><actuator device="turn" {OTHER} motors-address="65"/>',
            "",
        ),
        (
            f'<actuator device="drive" {CHIP}/><actuator device="turn" motors-address="64" {OTHER}/>',
            "both use the channel `10` of one chip",
        ),
        (f'<actuator device="drive" {CHIP.replace("scl", "scI")}/>', "no driver of `drive` knows the setting `scI`"),
        (f'<actuator device="drive" {CHIP.replace("scl=", "bus=")}/>', "`drive` does not say its `scl`"),
        (f'<actuator device="drive" {CHIP.replace("pca9685", "pca9686")}/>', "must be one of `pins`, `pca9685`"),
        (f'<actuator device="drive" {CHIP}/><sensor device="button" driver="key" pin="1"/>', "wired to the pin `1`"),
    ],
)
def test_motors_behind_a_chip_name_its_channels_and_pins_of_its_bus(parts: str, says: str) -> None:
    found = problems(parts)
    assert len(found) == bool(says), found
    assert all(says in one for one in found)


def test_a_setting_that_counts_only_with_another_one_is_told_with_that() -> None:
    for wires in (MOTORS, f'{MOTORS} motors="pins"'):
        kit = kit_of(f'<actuator device="drive" {wires} motors-address="64"/>')
        ((_, problem),) = kit_problems(kit, Package())
        assert problem.message == "no driver of `drive` knows the setting `motors-address`"
        assert problem.help == 'it counts only with motors="pca9685"'


def test_a_channel_gives_no_square_wave_of_the_board() -> None:
    text = (
        f'<board name="k" version="1" chip="rp2040" pins="0..28"><actuator device="drive" {CHIP}/>'
        '<actuator device="door" driver="servo" pin="24"/></board>'
    )
    kit, _ = read_kit(text.encode(), "k.board.xml")
    assert kit is not None
    assert kit_problems(kit, Package()) == []


def test_a_part_is_told_nothing_of_a_bus_that_its_motors_are_not_on() -> None:
    wires = f'{MOTORS} gyro="lsm6dso" sda="8" scl="9"'
    robot = load_catalogue().robots["mini-robot"]
    told = {}
    for name, given in (("pins", wires), ("chip", f'{CHIP} gyro="lsm6dso"')):
        fit = fit_to_kit(robot, kit_of(f'<actuator device="drive turn" {given}/>'), Package())
        told[name] = {part.name: part.board.settings for part in fit.actuators}
    assert "sda" not in told["pins"]["Wheel"]
    assert told["pins"]["Motor"]["sda"] == "8"
    assert told["chip"]["Wheel"]["sda"] == told["chip"]["Motor"]["sda"] == "0"


@pytest.mark.parametrize(
    ("chip", "parts", "says"),
    [
        ("rp2040", '<actuator device="door" driver="servo" pin="18"/>', "pins that are 16 apart have one wave"),
        ("rp2040", '<actuator device="door" driver="servo" pin="19"/>', "the two pins have one frequency"),
        ("rp2040", '<actuator device="music" driver="buzzer" pin="21"/>', "the two pins have one frequency"),
        ("rp2350", '<actuator device="door" driver="servo" pin="18"/>', "pins that are 16 apart have one wave"),
        ("rp2350", '<actuator device="door" driver="servo" pin="34"/>', ""),
        ("rp2040", '<actuator device="door" driver="servo" pin="22"/>', ""),
        ("rp2040", '<actuator device="lamp" driver="led" pin="18"/>', ""),
        (
            "rp2040",
            '<actuator device="door" driver="servo" pin="8"/><actuator device="arm" pin="9"/>'
            '<actuator device="music" driver="buzzer" pin="10"/><actuator device="pen" pin="11"/>',
            "the two pins have one frequency",
        ),
    ],
)
def test_square_waves_that_a_chip_cannot_give_at_once_are_told(chip: str, parts: str, says: str) -> None:
    motors = f'<actuator device="drive turn" {MOTORS}/>'
    text = f'<board name="k" version="1" chip="{chip}" pins="0..47">{motors}{parts}</board>'
    kit, found = read_kit(text.encode(), "k.board.xml")
    assert kit is not None, found
    told = [(problem.message, problem.help) for _, problem in kit_problems(kit, Package())]
    assert bool(told) == bool(says)
    assert all(says in help and "square wave" in message for message, help in told)
    other, _ = read_kit(text.replace(f'chip="{chip}" ', "").encode(), "k.board.xml")
    assert other is not None
    assert kit_problems(other, Package()) == []


def test_a_motor_whose_inputs_are_levels_has_a_wave_at_its_power_only() -> None:
    wires = " ".join(f'{side}-{name}="{pin}"' for side, name, pin in (
        ("left", "forward", 2), ("left", "backward", 3), ("left", "power", 4),
        ("right", "forward", 6), ("right", "backward", 7), ("right", "power", 8),
    ))  # fmt: skip
    for pin, works in ((18, True), (23, True), (20, False), (9, False)):
        parts = f'<actuator device="drive" {wires}/><actuator device="door" driver="servo" pin="{pin}"/>'
        text = f'<board name="k" version="1" chip="rp2040">{parts}</board>'
        kit, _ = read_kit(text.encode(), "k.board.xml")
        assert kit is not None
        assert (kit_problems(kit, Package()) == []) is works, pin


@pytest.mark.parametrize("waves", ['"50"', "{1: 2}", '{"pin": 50}', '{"pin": ""}', "unknown"])
def test_waves_that_are_not_written_as_they_should_be_are_told_with_their_line(waves: str, tmp_path: Path) -> None:
    (tmp_path / "mine.driver.py").write_text(f"WAVES = {waves}\n\n\ndef make(settings):\n    pass\n")
    kit = kit_of('<actuator device="mine"/>')
    ((_, problem),) = kit_problems(kit, Package((tmp_path,)))
    assert "line 1: WAVES" in problem.message


def test_a_bus_the_motors_and_pins_that_are_only_read_may_be_named_twice() -> None:
    assert (
        problems(
            f'<actuator device="drive" {MOTORS}/><actuator device="turn" {MOTORS} gyro="lsm6dso" sda="8" scl="9"/>'
            '<sensor device="colour" driver="tcs34725" sda="8" scl="9"/>'
            '<sensor device="colour" part="LeftEye" driver="line" pin="16"/>'
            f'<actuator device="drive" when="guide=road" driver="road" {MOTORS} left-eye="16" right-eye="17"/>'
        )
        == []
    )
    assert len(problems('<sensor device="a" driver="tcs34725" sda="8" scl="9"/>'
                        '<sensor device="b" driver="tcs34725" sda="9" scl="7"/>')) == 1  # fmt: skip


def test_a_part_is_told_the_settings_that_its_driver_knows_and_what_it_shares_with_the_simulator() -> None:
    kit = kit_of(f'<actuator device="drive turn wheel" {MOTORS} rate="90"/><sensor device="range" part="Captor"'
                 ' driver="ultrasonic" trigger="14" echo="15"/>')  # fmt: skip
    robots = load_catalogue().robots
    mini = fit_to_kit(robots["mini-robot"], kit, Package())
    settings = {part.name: part.board.settings for part in (*mini.actuators, *mini.sensors)}
    assert "rate" in settings["Motor"]
    assert "rate" not in settings["Wheel"]
    assert settings["Captor"]["reach"] == "1000"
    line = fit_to_kit(robots["line-follower"], kit, Package())
    assert [part.board.settings.get("side") for part in line.actuators] == ["left", "right", None]


def test_a_program_that_uses_what_a_kit_lacks_is_refused_with_every_part_and_the_reason() -> None:
    kit = kit_of(f'<actuator device="drive turn" {MOTORS}/>'
                 '<missing kind="actuator" device="door"><help>There is no servo.</help></missing>')  # fmt: skip
    robot = load_catalogue().robots["mini-robot"]
    fits = compile_text("Wheel.Advance(50); Motor.AbsoluteTurn(25, 50); Wheel.Stop();", robot)
    assert fits.image is not None
    refuse_what_is_missing(robot, kit, fits.image)
    assert program_of("fits", robot, fits, kit=kit).file.drivers.keys() == {"drive", "turn"}
    not_here = compile_text("Door.Open(); Light.LightOn(); Wheel.Advance(50);", robot)
    assert not_here.image is not None
    with pytest.raises(PackageError) as refused:
        program_of("not here", robot, not_here, kit=kit)
    assert "`Door`, `Light`" in refused.value.message
    assert refused.value.help == "There is no servo."
    looked = {one.part.name: one for one in parts_on_kit(robot, kit, Package(), not_here.image)}
    assert (looked["Door"].is_used, looked["Door"].is_missing, looked["Wheel"].is_missing) == (True, True, False)


def test_the_kit_of_a_micro_bit_lacks_what_a_v2_has_and_names_the_kit_of_a_v2() -> None:
    kits = {
        name: read_kit((SHIPPED / f"{name}.board.xml").read_bytes(), name)[0] for name in ("microbit", "microbit-v2")
    }
    robot = load_catalogue().robots["microbit"]
    compiled = compile_text("[Logo.IsTouched()](Music.Play(0); )!(Display.Number(Loudness.Value()); );", robot)
    with pytest.raises(PackageError) as refused:
        program_of("touch", robot, compiled, kit=kits["microbit"])
    assert refused.value.message == "the kit `microbit` lacks what the program uses: `Logo`, `Loudness`"
    assert "name the kit `microbit-v2`" in str(refused.value.help)
    drivers = program_of("touch", robot, compiled, kit=kits["microbit-v2"]).file.drivers
    assert drivers.keys() == {"display", "speaker", "logo", "microphone"}


def test_a_kit_of_another_family_refuses_drivers_that_it_does_not_have() -> None:
    text = '<board name="k" version="1" family="microbit"><actuator device="lamp" driver="rgb" pin="8"/></board>'
    kit, _ = read_kit(text.encode(), "k.board.xml")
    assert kit is not None
    ((_, problem),) = kit_problems(kit, Package())
    assert "no driver `rgb` for this kind of board" in problem.message


ESP32 = '<board name="e" version="1" chip="esp32">{}</board>'


@pytest.mark.parametrize(
    ("part", "words"),
    [
        ('<actuator device="lamp" driver="led" pin="34"/>', "`lamp` is wired to the pin `34`, which can only be read"),
        ('<sensor device="button" driver="key" pin="39"/>', "can only be read and has no pull-up"),
        ('<sensor device="range" driver="ultrasonic" trigger="36" echo="18"/>', "can only be read"),
        ('<actuator device="switch" pin="1"/>', "over which the board talks with the computer"),
        ('<sensor device="colour" driver="line" pin="3"/>', "over which the board talks with the computer"),
        ('<actuator device="door" driver="servo" pin="6"/>', "belongs to the flash"),
        ('<sensor device="colour" driver="line" pin="34"/>', ""),
        ('<sensor device="range" driver="ultrasonic" trigger="5" echo="35"/>', ""),
        ('<sensor device="range" driver="analog-range" pin="36" near="9" far="1"/>', ""),
    ],
)
def test_pins_of_an_esp32_that_are_not_like_the_others_are_found(part: str, words: str) -> None:
    kit, problems = read_kit(ESP32.format(part).encode(), "e.board.xml")
    assert kit is not None, problems
    found = [problem.message for _, problem in kit_problems(kit, Package())]
    assert [words in message for message in found] == ([True] if words else []), found
