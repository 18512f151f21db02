"""What is shipped: the paper's constructors and robot objects, in words people understand, valid by the schemas."""

from pathlib import Path

import pytest
import xmlschema

import kitrobot.primitives
from kitrobot.lll import parse_template
from kitrobot.primitives import Catalogue, Robot, load_catalogue

PRIMITIVES = Path(kitrobot.primitives.__file__).parent
PACKAGE = PRIMITIVES.parent
REPOSITORY = Path(__file__).parents[2]
SCHEMAS = PRIMITIVES / "schemas"
KINDS = {
    ".tutorial.xml": "tutorial",
    "constructors.xml": "constructors",
    ".robot.xml": "robot",
    ".world.xml": "world",
    ".krt": "mission",
}


def shipped_files() -> list[Path]:
    places = [*PACKAGE.glob("*/shipped/*.xml"), *(REPOSITORY / "examples").glob("**/*.krt")]
    return sorted([*places, *(REPOSITORY / "examples").glob("**/*.xml")])


def schema_of(path: Path) -> xmlschema.XMLSchema:
    [kind] = [kind for ending, kind in KINDS.items() if path.name.endswith(ending)]
    return xmlschema.XMLSchema(SCHEMAS / f"{kind}.xsd")


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


def test_the_papers_constructors_are_there_in_their_groups(catalogue: Catalogue) -> None:
    papers = {
        "Loops": ["Repetition", "While", "Break"],
        "Choices": ["If Then", "If Then Else", "When", "Wait"],
        "Parallel": ["Parallelism", "Branch", "Interrupt"],
        "Conditions": ["And", "Or", "No"],
    }
    found = {group.name: [constructor.name for constructor in group.constructors] for group in catalogue.groups}
    assert list(found) == list(papers)
    for group, expected in papers.items():
        assert found[group][: len(expected)] == expected


def test_each_construct_of_the_language_has_one_constructor(catalogue: Catalogue) -> None:
    assert sorted(constructor.name for constructor in catalogue.inverse.values()) == sorted(
        {"Repetition", "While", "Break", "If Then", "If Then Else", "When", "Wait", "Parallelism", "Interrupt"}
        | {"And", "Or", "No"}
    )


def test_everything_about_constructors_is_said_in_three_languages(catalogue: Catalogue) -> None:
    for group in catalogue.groups:
        assert {"fr", "ur"} <= set(group.label)
        for constructor in group.constructors:
            assert {"", "fr", "ur"} <= set(constructor.help), constructor.name
            assert {"fr", "ur"} <= set(constructor.label), constructor.name
            assert constructor.icon
            for slot in constructor.slots:
                assert {"", "fr", "ur"} <= set(slot.label), f"{constructor.name} {slot.name}"


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


def test_the_mini_robot_has_every_object_of_the_paper(catalogue: Catalogue) -> None:
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
        "actuator Wheel.Advance(speed 0…100) → Stop",
        "actuator Wheel.Reverse(speed 0…100) → Stop",
        "actuator Wheel.Stop()",
        "actuator Door.Open() later",
        "actuator Door.Close() later",
        "actuator Light.LightOn() → LightOff",
        "actuator Light.LightOff()",
        "actuator Switch.SwitchOn() → SwitchOff",
        "actuator Switch.SwitchOff()",
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


def test_no_constructor_is_named_in_the_code_that_reads_them() -> None:
    names = ["Repetition", "If Then", "Parallelism", 'Interrupt"', "'Branch'", '"While"', '"Branch"']
    for path in sorted(PRIMITIVES.glob("*.py")):
        text = path.read_text(encoding="utf-8")
        assert not [name for name in names if name in text], path.name
