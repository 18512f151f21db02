"""Pictures of kits say what their files say."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest

from kitrobot.boards.kit_pictures import body_picture, wiring_picture
from kitrobot.primitives.kit import Kit
from kitrobot.workspace.kit_files import kits_at_hand
from tests.deploy.test_kits import kit_of as kit

WHEELS = '<actuator device="drive" left-forward="2" left-backward="3" right-forward="4" right-backward="5"/>'
RANGE = '<sensor device="range" driver="{}" trigger="6" echo="7"/>'


def classes(made: Kit) -> list[str]:
    return [one.get("class", "") for one in ElementTree.fromstring(body_picture(made)).iter() if one.get("class")]


@pytest.mark.parametrize("name", sorted(kits_at_hand()))
def test_every_kit_has_a_picture_that_can_be_read(name):
    assert ElementTree.fromstring(body_picture(kits_at_hand()[name])).tag.endswith("svg")


def test_what_the_file_has_is_in_the_picture_and_what_it_lacks_is_not():
    bare = kit("")
    assert "body" not in classes(bare)
    rolls = kit(WHEELS)
    assert classes(rolls).count("wheel") == 2
    assert "servo" not in classes(rolls)
    assert "servo" in classes(kit(WHEELS + '<actuator device="door" driver="servo" pin="9"/>'))
    assert "servo" not in classes(kit(WHEELS + '<missing kind="actuator" device="door"><help>None.</help></missing>'))
    assert "violet" in classes(kit(WHEELS.replace("/>", ' gyro="lsm6dso" sda="0" scl="1"/>')))


def test_an_ultrasonic_range_finder_has_two_eyes_and_one_of_light_has_not():
    assert classes(kit(WHEELS + RANGE.format("ultrasonic"))).count("metal") == 2
    assert classes(kit(WHEELS + '<sensor device="range" driver="vl53l0x" sda="6" scl="7"/>')).count("metal") == 0


def test_what_is_of_a_micro_bit_by_itself_is_in_its_picture_only_once():
    alone = kits_at_hand()["microbit"]
    assert "bit" in classes(alone)
    assert "yellow" not in classes(alone), "its lamp is its own lights"


def test_the_wiring_is_drawn_with_the_pins_of_the_file():
    drawn = wiring_picture(kit(WHEELS + RANGE.format("ultrasonic")))
    words = [one.text for one in ElementTree.fromstring(drawn).iter() if one.tag.endswith("text")]
    wheels = ["drive", "left-forward", "GP2", "left-backward", "GP3", "right-forward", "GP4", "right-backward", "GP5"]
    assert words[1:] == [*wheels, "range", "trigger", "GP6", "echo", "GP7"]


def test_modules_are_drawn_with_their_terminals_and_what_each_is_wired_to():
    modules = (
        '<module name="cells"><label>Three cells</label><wire terminal="+" to="board VM"/></module>'
        '<module name="board"><wire terminal="AIN1" to="2"/><wire terminal="VCC" to="3V3"/></module>'
    )
    drawn = wiring_picture(kit(WHEELS + modules))
    words = [one.text for one in ElementTree.fromstring(drawn).iter() if one.tag.endswith("text")]
    assert words[1:] == ["Three cells", "+", "→ board VM", "board", "AIN1", "GP2", "VCC", "3V3"]
