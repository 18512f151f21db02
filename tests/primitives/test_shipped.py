"""What is shipped: the paper's constructors and robot objects, in words people understand, valid by the schemas."""

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
import xmlschema

import kitrobot.primitives
from kitrobot.lll.parse_results import parse_template
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.constructors import Group
from kitrobot.primitives.levels import Level
from kitrobot.primitives.robot import Robot
from kitrobot.translation.languages import TEXT_LANGUAGES, TRANSLATED

PRIMITIVES = Path(kitrobot.primitives.__file__).parent
PACKAGE = PRIMITIVES.parent
REPOSITORY = Path(__file__).parents[2]
SCHEMAS = PRIMITIVES / "schemas"
KINDS = {
    "beginnings.xml": "beginnings",
    "examples.xml": "examples",
    "bench.xml": "bench",
    ".tutorial.xml": "tutorial",
    ".exercise.xml": "exercise",
    "constructors.xml": "constructors",
    ".board.xml": "board",
    ".robot.xml": "robot",
    ".world.xml": "world",
    ".krt": "mission",
}


def shipped_files() -> list[Path]:
    places = [*PACKAGE.glob("*/shipped/*.xml"), *(REPOSITORY / "examples").glob("**/*.krt")]
    return sorted([*places, *(REPOSITORY / "examples").glob("**/*.xml")])


@cache
def _schema(kind: str) -> xmlschema.XMLSchema:
    return xmlschema.XMLSchema(SCHEMAS / f"{kind}.xsd")


def schema_of(path: Path) -> xmlschema.XMLSchema:
    [kind] = [kind for ending, kind in KINDS.items() if path.name.endswith(ending)]
    return _schema(kind)


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_CONFIG", str(REPOSITORY / "no-such-folder"))
        return load_catalogue()


@pytest.mark.parametrize("path", shipped_files(), ids=lambda path: path.name)
def test_a_shipped_file_is_valid_by_its_schema(path: Path) -> None:
    schema_of(path).validate(path)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("constructors.xml", '<constructors version="1"><group name="G" colour="pink"/></constructors>'),
        ("constructors.xml", '<constructors version="1"><group name="G" colour="loop"><loop/></group></constructors>'),
        ("x.robot.xml", '<robot name="a b" version="1"/>'),
        ("x.robot.xml", '<robot name="a" version="1"><variable name="V" max="536870912"/></robot>'),
        ("x.world.xml", '<world version="1" name="w" width="-1" height="1"/>'),
        ("x.krt", '<kitrobot version="1"><program name="p" robot="r"><arc from="a"/></program></kitrobot>'),
    ],
)
def test_a_schema_refuses_what_the_reader_refuses(name: str, text: str) -> None:
    assert not schema_of(Path(name)).is_valid(text)


def at_level(catalogue: Catalogue, level: Level) -> list[Group]:
    """The groups with what stands in programs of a level; groups that have nothing of it are left out."""
    held = [
        replace(one, constructors=tuple(c for c in one.constructors if level.holds(c.level)))
        for one in catalogue.groups
    ]
    return [group for group in held if group.constructors]


def test_the_papers_constructors_are_there_in_their_groups(catalogue: Catalogue) -> None:
    papers = {
        "Loops": ["Repetition", "While", "Break"],
        "Choices": ["If Then", "If Then Else", "When", "Wait"],
        "Parallel": ["Parallelism", "Branch", "Interrupt"],
        "Conditions": ["And", "Or", "No"],
    }
    groups = at_level(catalogue, Level.AGENT)
    found = {group.name: [constructor.name for constructor in group.constructors] for group in groups}
    assert list(found) == list(papers)
    for group, expected in papers.items():
        assert found[group][: len(expected)] == expected


def test_each_construct_of_the_language_has_one_constructor(catalogue: Catalogue) -> None:
    assert sorted(constructor.name for constructor in catalogue.inverse.values()) == sorted(
        {
            "Repetition",
            "While",
            "Forever",
            "Break",
            "If Then",
            "If Then Else",
            "When",
            "Wait",
            "Parallelism",
            "Interrupt",
        }
        | {"And", "Or", "No"}
        | {"SeqOfPar", "ParOfSeq", "Where", "Where Else", "Program", "Move", "Any", "All", "Most"}
    )


def test_what_speaks_of_several_robots_stands_in_programs_of_teams_only(catalogue: Catalogue) -> None:
    names = {level: {one.name for group in at_level(catalogue, level) for one in group.constructors} for level in Level}
    assert names[Level.SOCIAL] - names[Level.GROUP] == {"Move"}
    team = {"SeqOfPar", "ParOfSeq", "Where", "Where Else", "Program", "Any", "All", "Most"}
    assert names[Level.GROUP] - names[Level.AGENT] == team


def test_everything_about_constructors_is_said_in_each_language(catalogue: Catalogue) -> None:
    for group in catalogue.groups:
        assert set(TRANSLATED) <= set(group.label)
        for constructor in group.constructors:
            assert set(TEXT_LANGUAGES) <= set(constructor.help), constructor.name
            assert set(TRANSLATED) <= set(constructor.label), constructor.name
            assert constructor.icon
            for slot in constructor.slots:
                assert set(TEXT_LANGUAGES) <= set(slot.label), f"{constructor.name} {slot.name}"


def test_the_code_that_is_shown_is_the_template(catalogue: Catalogue) -> None:
    for constructor in catalogue.constructors.values():
        if constructor.template is not None:
            assert parse_template(constructor.code)[0] == constructor.template


def test_everything_of_every_robot_is_explained(catalogue: Catalogue) -> None:
    for robot in catalogue.robots.values():
        assert robot.help.get("")
        for part in robot.objects:
            assert part.help.get(""), f"{robot.name} {part.name}"
            for method in part.methods:
                assert method.help.get(""), f"{robot.name} {part.name}.{method.name}"
                for parameter in method.parameters:
                    assert parameter.help.get(""), f"{robot.name} {part.name}.{method.name} {parameter.name}"


def described(robot: Robot) -> list[str]:
    lines = []
    for part in robot.objects:
        for method in part.methods:
            names = ", ".join(f"{p.name} {p.minimum}…{p.maximum}" for p in method.parameters)
            how = " later" if method.completes_later else ""
            to = f" → {method.stop}" if method.stop else ""
            test = f" {method.test}" if method.test else ""
            number = f" {method.to}" if method.to is not None else ""
            lines.append(f"{part.category} {part.name}.{method.name}({names}){how}{to}{test}{number}")
    return lines


def test_the_mini_robot_has_every_object_of_the_paper_and_drives_and_turns_by_a_measure(catalogue: Catalogue) -> None:
    robot = catalogue.robot("mini-robot")
    assert (robot.tick_ms, robot.wait_unit_ms) == (20, 100)
    assert [(v.name, v.type.value, v.minimum, v.maximum, v.initial) for v in robot.variables] == [
        ("Count", "integer", 0, 100, 0),
        ("Level", "integer", 0, 100, 50),
        ("Run", "boolean", 0, 1, 1),
        ("Flag", "boolean", 0, 1, 0),
    ]
    assert [line for line in described(robot) if not line.startswith(("variable", "system"))] == [
        "actuator Motor.AbsoluteTurn(angle 0…100, speed 0…100) later → Stop",
        "actuator Motor.Turn(speed 0…100) → Stop",
        "actuator Motor.Stop()",
        "actuator Motor.LeftBy(angle 0…360) later → Stop",
        "actuator Motor.RightBy(angle 0…360) later → Stop",
        "actuator Wheel.Advance(speed 0…100) → Stop",
        "actuator Wheel.Reverse(speed 0…100) → Stop",
        "actuator Wheel.Stop()",
        "actuator Wheel.DriveBy(distance 0…500) later → Stop",
        "actuator Wheel.BackBy(distance 0…500) later → Stop",
        "actuator Door.Open() later",
        "actuator Door.Close() later",
        "actuator Light.LightOn() → LightOff",
        "actuator Light.LightOff()",
        "actuator Switch.SwitchOn() → SwitchOff",
        "actuator Switch.SwitchOff()",
        "actuator Pen.PenDown() later → PenUp",
        "actuator Pen.PenUp() later",
        "actuator Pen.Colour(colour 0…7) later",
        "actuator Pen.Width(width 1…50) later",
        "sensor Captor.EqualTo(value 0…100) equal",
        "sensor Captor.LessThan(value 0…100) less",
        "sensor Captor.GreaterThan(value 0…100) greater",
        "sensor Captor.Value()",
        "sensor Light.IsRed() equal 1",
        "sensor Light.IsGreen() equal 2",
        "sensor Light.IsBlue() equal 3",
        "sensor Button.IsPressed() equal 1",
        "sensor Button.IsReleased() equal 0",
    ]


def test_the_micro_bit_has_what_is_on_the_board(catalogue: Catalogue) -> None:
    robot = catalogue.robot("microbit")
    pins = [f"actuator Pin{n}.{what}" for n in range(3) for what in ("Write(value 0…1)", "Analog(value 0…1023)")]
    lines = described(robot)
    assert set(pins) < set(lines)
    assert [line for line in lines if "Pin" not in line and not line.startswith(("variable", "system"))] == [
        "actuator Display.Image(number 0…19) → Clear",
        "actuator Display.Number(value 0…9) → Clear",
        "actuator Display.Scroll(value -99999…99999) later → Clear",
        "actuator Display.Pixel(x 0…4, y 0…4, brightness 0…9) later",
        "actuator Display.Clear()",
        "actuator Music.Tone(frequency 0…10000, duration 0…10000) later → Stop",
        "actuator Music.Play(melody 0…11) later → Stop",
        "actuator Music.Stop()",
        "sensor ButtonA.IsPressed() equal 1",
        "sensor ButtonA.IsReleased() equal 0",
        "sensor ButtonB.IsPressed() equal 1",
        "sensor ButtonB.IsReleased() equal 0",
        "sensor Shake.IsShaken() equal 1",
        "sensor TiltX.IsLeft() less -300",
        "sensor TiltX.IsRight() greater 300",
        "sensor TiltX.Value()",
        "sensor TiltY.IsForward() less -300",
        "sensor TiltY.IsBackward() greater 300",
        "sensor TiltY.Value()",
        "sensor Dice.EqualTo(value 1…6) equal",
        "sensor Dice.LessThan(value 1…6) less",
        "sensor Dice.GreaterThan(value 1…6) greater",
        "sensor Dice.Value()",
        "sensor Random.EqualTo(value 0…99) equal",
        "sensor Random.LessThan(value 0…99) less",
        "sensor Random.GreaterThan(value 0…99) greater",
        "sensor Random.Value()",
        "sensor Logo.IsTouched() equal 1",
        "sensor Logo.IsReleased() equal 0",
        "sensor Loudness.GreaterThan(value 0…255) greater",
        "sensor Loudness.LessThan(value 0…255) less",
        "sensor Loudness.Value()",
    ]


def documented_drivers() -> dict[str, tuple[set[str], set[str]]]:
    """Driver → its settings, and the devices it works, as docs/xml.md has them."""
    page = (REPOSITORY / "docs" / "xml.md").read_text(encoding="utf-8")
    table = page[page.index("| driver | works |") : page.index("## Devices of the simulator")]
    found = {}
    for line in table.splitlines()[2:]:
        if not line.startswith("| `"):
            break
        driver, works, settings = (cell.strip() for cell in line.strip("|").split("|"))
        found[driver.strip("`")] = (set(re.findall(r"`([a-z]+)`", settings)), set(re.findall(r"`([a-z-]+)`", works)))
    return found


@pytest.mark.parametrize("name", ["microbit", "kit-robot"])
def test_what_a_real_robots_drivers_are_told_is_documented(catalogue: Catalogue, name: str) -> None:
    drivers = documented_drivers()
    robot = catalogue.robot(name)
    for part in (*robot.actuators, *robot.sensors):
        settings, devices = drivers[part.board.driver]
        assert part.device in devices, part.name
        assert set(part.board.settings) <= settings, part.name


def test_the_pins_of_the_kit_robot_are_its_own_and_no_servo_shares_a_timer_with_a_motor(catalogue: Catalogue) -> None:
    robot = catalogue.robot("kit-robot")
    pins = [
        (part.board.driver, int(value))
        for part in (*robot.actuators, *robot.sensors)
        for name, value in part.board.settings.items()
        if name in {"pin", "forward", "backward", "trigger", "echo"} and value.isdigit()
    ]
    assert len({pin for _, pin in pins}) == len(pins) == 12
    timers = {pin // 2 % 8: driver for driver, pin in pins if driver == "pwm-motor"}
    assert not [pin for driver, pin in pins if driver == "servo" and pin // 2 % 8 in timers]


def test_no_constructor_is_named_in_the_code_that_reads_them() -> None:
    names = ["Repetition", "If Then", "Parallelism", 'Interrupt"', "'Branch'", '"While"', '"Branch"']
    for path in sorted(PRIMITIVES.glob("*.py")):
        text = path.read_text(encoding="utf-8")
        assert not [name for name in names if name in text], path.name
