"""The program file: what is used of a robot, and nothing else."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler import compile_text
from kitrobot.deploy import DeployError, Package, make_program_file, read_program_file, refuse_what_fits_no_board
from kitrobot.deploy.program_file import UNUSED, ProgramFile
from kitrobot.primitives import load_catalogue

MICROBIT = load_catalogue().robots["microbit"]


def file_of(text: str) -> ProgramFile:
    image = compile_text(text, MICROBIT).image
    assert image is not None
    return make_program_file(image, MICROBIT)


def used(text: str) -> list[str]:
    return [device.part for device in file_of(text).devices if device.driver != UNUSED]


def test_what_a_program_neither_reads_nor_commands_is_left_out() -> None:
    assert used("WAIT(1);") == []
    assert used("Display.Clear();") == ["Display"]
    assert used("*[ButtonA.IsPressed()](Display.Number(Dice.Value()););") == ["Display", "ButtonA", "Dice"]
    assert used("Count.Set(TiltX.Value());") == ["TiltX"]


def test_the_stop_of_a_marked_action_is_a_use_of_its_device() -> None:
    assert used("//(<ButtonB.IsPressed()>();, °Display.Image(0)°;);") == ["Display", "ButtonB"]


def test_actuators_keep_their_places_and_commands_their_numbers() -> None:
    devices = file_of("Pin1.Write(1);").devices
    assert [device.part for device in devices] == [part.name for part in MICROBIT.actuators]
    for device, part in zip(devices, MICROBIT.actuators, strict=True):
        assert len(device.words[1].split(",")) == len(part.methods)


def test_one_pin_serves_programs_that_use_it_in_different_ways_but_not_one_that_does_both() -> None:
    package = Package()
    for text in ("Pin0.Write(1);", "<Pin0.IsHigh()>();"):
        refuse_what_fits_no_board(file_of(text), package)
    with pytest.raises(DeployError, match="both wired to the pin"):
        refuse_what_fits_no_board(file_of("Pin0.Write(1); <Pin0.IsHigh()>();"), package)


@given(st.integers(0, 400), st.binary(min_size=1, max_size=3))
def test_a_file_reads_back_and_damage_is_told(at: int, damage: bytes) -> None:
    made = file_of("*[ButtonA.IsPressed()](Display.Number(Dice.Value()););")
    data = made.to_bytes()
    read = read_program_file(data)
    assert [device[:3] for device in read.devices] == [device[:3] for device in made.devices]
    assert read.image == made.image
    at %= len(data)
    broken = data[:at] + damage + data[at + len(damage) :]
    if broken != data:
        with pytest.raises(DeployError):
            read_program_file(broken)
