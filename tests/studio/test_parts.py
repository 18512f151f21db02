"""Files with robots, constructors and worlds: dropped on the window, chosen from the menu, edited on disk meanwhile."""

from __future__ import annotations

import base64
import json
import shutil
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import EXAMPLES, Studio
from tests.studio.looks import choose, find_nothing
from tests.studio.test_variables import forgive_refusals, row

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
SQUARE = "square/square.krt"

ROBOT = """<robot name="rover" version="1">
  <label>Rover</label>
  <actuator name="Lamp"><procedure name="Shine"/></actuator>
  <sensor name="Dust" type="boolean"><operation name="Seen" test="equal" to="1"/></sensor>
</robot>
"""
CONSTRUCTORS = """<constructors version="1">
  <group name="Mine" colour="loop">
    <constructor name="Twice"><flow name="body" loop="yes"/><code>2*({body})</code></constructor>
  </group>
</constructors>
"""

KIT = '<board name="tank" version="1"><actuator device="lamp" driver="led" pin="3"/></board>'
DROP = """([files, padding]) => {
    const carried = new DataTransfer();
    for (const [name, data] of files) {
        const bytes = Uint8Array.from(atob(data), (sign) => sign.charCodeAt(0));
        carried.items.add(new File([bytes, new Uint8Array(padding).fill(32)], name));
    }
    const target = document.querySelector('.studio');
    for (const kind of ['dragenter', 'dragover', 'drop']) {
        target.dispatchEvent(new DragEvent(kind, { dataTransfer: carried, bubbles: true, cancelable: true }));
    }
}"""


def drop(studio: Studio, *, padding: int = 0, **files: str | bytes) -> None:
    """Drops files on the window; `_` in a name stands for a dot, `padding` is a count of spaces at the end of each."""
    sent = [
        (name.replace("_", "."), base64.b64encode(data.encode() if isinstance(data, str) else data).decode())
        for name, data in files.items()
    ]
    studio.page.evaluate(DROP, [sent, padding])


def a_dropped_robot_is_beside_the_mission_and_a_program_is_added_for_it(studio: Studio) -> None:
    drop(studio, rover_robot_xml=ROBOT)
    expect(studio.at("banner")).to_contain_text("The robot rover is there now.")
    assert (studio.folder / "rover.robot.xml").read_text() == ROBOT
    studio.page.get_by_role("button", name="Add a program for it").click()
    expect(studio.page.locator('[data-testid="part-Lamp.Shine"]')).to_be_visible()
    studio.at("part-Lamp.Shine").click()
    studio.expect_code("Lamp.Shine()")


def constructors_and_a_world_are_dropped_together(studio: Studio) -> None:
    world = (EXAMPLES / "stripes" / "stripes.world.xml").read_text(encoding="utf-8")
    drop(studio, mine_xml=CONSTRUCTORS, yard_world_xml=world)
    expect(studio.at("part-Twice")).to_be_visible()
    studio.at("part-Twice").click()
    studio.expect_code("2*(")
    studio.page.keyboard.press("Alt+t")
    expect(studio.at("world-yard")).to_be_visible()


def a_world_that_was_dropped_can_be_used_at_once(studio: Studio) -> None:
    drop(studio, field_xml='<world version="1" name="Yard" width="1000" height="800"/>')
    studio.page.get_by_role("button", name="Use this world").click()
    expect(studio.at("world-field").locator("input")).to_be_checked()
    expect(studio.page.locator(".arena")).to_contain_text("Yard")


@pytest.mark.thorough(
    "web/src/features/import-files/take.test.tsx: taken, used, a program added; server/test_parts.py: put beside "
    "the mission; dropped in a browser: test_a_file_that_is_dropped_and_changes_on_disk_is_followed"
)
def test_robots_worlds_and_constructors_are_chosen_or_dropped_and_used(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE)
    parts_are_chosen_from_the_menu(studio)
    constructors_and_a_world_are_dropped_together(studio)
    a_world_that_was_dropped_can_be_used_at_once(studio)
    a_dropped_robot_is_beside_the_mission_and_a_program_is_added_for_it(studio)


@pytest.mark.thorough(
    "tests/server/test_parts.py: parts of a new mission and of an example are in the folder of missions"
)
def test_parts_of_an_example_go_into_the_folder_of_missions(open_studio: OpenStudio) -> None:
    studio = open_studio(None)
    expect(studio.page.locator("h1")).to_be_visible()
    drop(studio, mine_xml=CONSTRUCTORS)
    expect(studio.at("part-Twice")).to_be_visible()
    assert (studio.folder / "mine.xml").is_file()


def a_file_of_that_name_is_replaced_only_after_a_question(studio: Studio) -> None:
    file = studio.folder / "mine.xml"
    file.write_text(CONSTRUCTORS.replace("Twice", "Thrice"))
    expect(studio.at("part-Thrice")).to_be_visible()
    drop(studio, mine_xml=CONSTRUCTORS)
    expect(studio.at("banner")).to_contain_text("There is another mine.xml in this folder.")
    studio.page.get_by_role("button", name="Leave it").click()
    expect(studio.at("banner")).to_be_hidden()
    assert "Thrice" in file.read_text()
    drop(studio, mine_xml=CONSTRUCTORS)
    studio.page.get_by_role("button", name="Replace it").click()
    expect(studio.at("part-Twice")).to_be_visible()
    expect(studio.at("part-Thrice")).to_have_count(0)
    assert file.read_text() == CONSTRUCTORS
    forgive_refusals(studio)


def what_is_different_in_a_kit_is_shown_before_the_answer(studio: Studio) -> None:
    file = studio.folder / "tank.board.xml"
    file.write_text(KIT)
    drop(studio, tank_board_xml=KIT.replace('pin="3"', 'pin="5"'))
    expect(studio.at("banner")).to_contain_text("There is another tank.board.xml in this folder.")
    studio.page.get_by_role("button", name="Show the difference").click()
    expect(studio.at("differences")).to_have_text("The kit: actuator lamp: pin 3 → 5")
    studio.page.keyboard.press("Escape")
    expect(studio.at("difference-dialog")).to_be_hidden()
    assert file.read_text() == KIT
    studio.page.get_by_role("button", name="Replace it").click()
    expect(studio.at("banner")).to_contain_text("The kit tank is there now.")
    assert 'pin="5"' in file.read_text()
    forgive_refusals(studio)


def what_holds_no_parts_is_refused_in_a_sentence(studio: Studio) -> None:
    before = {path.name for path in studio.folder.iterdir()} | {".kitrobot"}
    for file, data, padding, says in (
        ("song_xml", b"\x89PNG\r\n\x1a\n\x00\xff", 0, "is no XML"),
        ("drawing_xml", b"<svg/>", 0, "begins with <svg>"),
        ("bomb_xml", b"<!DOCTYPE robot [<!ENTITY a 'b'>]><robot name='&a;'/>", 0, "cannot be read"),
        ("short_robot_xml", b"<robot name='x'><actuator", 0, "cannot be read"),
        ("film_xml", b"<robot/>", 50 * 1024 * 1024, "is larger than 4 MB"),
    ):
        drop(studio, padding=padding, **{file: data})
        told = studio.at("banner").filter(has_text=file.replace("_xml", ".xml").replace("_robot", ".robot"))
        expect(told).to_contain_text(says)
        assert {path.name for path in studio.folder.iterdir()} | {".kitrobot"} == before
    forgive_refusals(studio)


@pytest.mark.thorough(
    "web/src/features/import-files/take.test.tsx: refused, and a question for a name that is taken; "
    "server/test_parts.py: what is no part, too large or different"
)
def test_what_holds_no_parts_is_refused_and_a_file_of_that_name_is_replaced_only_after_a_question(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(SQUARE)
    what_holds_no_parts_is_refused_in_a_sentence(studio)
    a_file_of_that_name_is_replaced_only_after_a_question(studio)
    what_is_different_in_a_kit_is_shown_before_the_answer(studio)


@pytest.mark.thorough("tests/server/test_parts.py: the mistake of a robot that is taken in has a file and a line")
def test_mistakes_of_a_dropped_robot_are_problems_with_file_and_line(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE)
    drop(studio, rover_robot_xml=ROBOT.replace('type="boolean"', 'min="9" max="1"'))
    studio.page.get_by_role("button", name="Show the problems").click()
    expect(studio.at("problem-1")).to_contain_text("rover.robot.xml:4")
    find_nothing(studio, "problems of a file")


def parts_are_chosen_from_the_menu(studio: Studio) -> None:
    with studio.page.expect_file_chooser() as chooser:
        studio.at("menu-File").click()
        studio.at("menu-file-parts").click()
    file = studio.folder.parent / "chosen.xml"
    file.write_text(CONSTRUCTORS.replace("Twice", "Again"))
    chooser.value.set_files([file])
    expect(studio.at("part-Again")).to_be_visible()


def test_a_file_that_is_dropped_and_changes_on_disk_is_followed(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE)
    file = studio.folder / "mine.xml"
    drop(studio, mine_xml=CONSTRUCTORS)
    studio.at("part-Twice").click()
    studio.expect_code("2*(")
    # The palette keeps what is searched for and who has the focus.
    studio.at("part-find").fill("while")
    studio.at("part-While").focus()
    file.write_text(CONSTRUCTORS.replace("2*(", "5*("))
    studio.expect_code("5*(")
    expect(studio.at("part-find")).to_have_value("while")
    expect(studio.at("part-While")).to_be_focused()
    studio.at("part-find").fill("")

    file.write_text("<constructors")
    expect(studio.at("part-Twice")).to_have_count(0)
    expect(studio.at("problems")).not_to_contain_text("Problems0")
    studio.at("problems").click()
    expect(studio.page.locator("#problem-list")).to_contain_text("mine.xml:1")
    expect(studio.page.locator("#problem-list")).to_contain_text("Twice")
    expect(studio.page.locator(".vertex", has_text="Twice")).to_be_visible()

    file.write_text(CONSTRUCTORS)
    expect(studio.at("part-Twice")).to_be_visible()
    studio.expect_code("2*(")
    file.unlink()
    expect(studio.at("part-Twice")).to_have_count(0)
    file.write_text(CONSTRUCTORS)
    studio.expect_code("2*(")


@pytest.mark.thorough(
    "tests/server/test_parts.py: the world belongs to the mission; test_a_file_that_is_dropped_and_changes_on_disk…"
)
def test_the_robot_and_the_world_of_the_mission_are_followed_too(open_studio: OpenStudio) -> None:
    studio = open_studio("stripes/stripes.krt")
    world = studio.folder / "stripes.world.xml"
    text = world.read_text(encoding="utf-8")
    name = json.loads(studio.page.evaluate("JSON.stringify(document.querySelector('.arena header').innerText)"))
    assert "Garden" not in name
    world.write_text(text.replace("<world ", "<world ", 1).replace('name="', 'name="Garden ', 1), encoding="utf-8")
    expect(studio.page.locator(".arena header")).to_contain_text("Garden")
    world.unlink()
    expect(studio.at("problems")).not_to_contain_text("Problems0")
    studio.page.keyboard.press("F8")
    expect(studio.at("team")).to_be_visible()
    expect(studio.page.locator(".team")).to_contain_text("stripes.world.xml is not there")
    world.write_text(text, encoding="utf-8")
    expect(studio.page.locator(".arena header")).not_to_contain_text("Garden")
    expect(studio.page.locator(".team")).not_to_contain_text("is not there")


@pytest.mark.thorough("test_a_file_that_is_dropped_and_changes_on_disk_is_followed: parts that come are taken up")
def test_a_robot_for_which_a_program_exists_is_taken_up(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE)
    file = studio.folder / "square.krt"
    file.write_text(file.read_text(encoding="utf-8").replace('robot="mini-robot"', 'robot="rover"'), encoding="utf-8")
    studio.page.get_by_role("button", name="Load it").click()
    expect(studio.at("problems")).not_to_contain_text("Problems0")
    shipped = EXAMPLES.parent / "src" / "kitrobot" / "primitives" / "shipped" / "mini-robot.robot.xml"
    robot = shipped.read_text(encoding="utf-8").replace('name="mini-robot"', 'name="rover"', 1)
    drop(studio, rover_robot_xml=robot)
    expect(studio.at("problems")).to_contain_text("0")
    expect(row(studio, "Count")).to_be_visible()
    expect(studio.at("code")).not_to_be_empty()


@pytest.mark.thorough("tests/server/test_languages.py; web/src/features/import-files/take.test.tsx")
def test_parts_are_dropped_in_urdu(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE)
    choose(studio, "ur")
    drop(studio, rover_robot_xml=ROBOT)
    expect(studio.at("banner")).to_contain_text("rover")
    find_nothing(studio, "the banner in Urdu")


@pytest.mark.thorough("tests/server/test_parts.py: a robot is put beside the mission and is there")
def test_two_missions_of_two_folders_have_their_own_parts(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE)
    inner = studio.folder / "inner"
    inner.mkdir()
    shutil.copy(studio.folder / "square.krt", inner / "other.krt")
    drop(studio, mine_xml=CONSTRUCTORS)
    expect(studio.at("part-Twice")).to_be_visible()
    studio.page.keyboard.press("Control+o")
    studio.page.get_by_text("inner/other.krt").click()
    expect(studio.page.locator("h1")).to_contain_text("other.krt")
    expect(studio.at("part-Twice")).to_have_count(0)
