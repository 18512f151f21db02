"""What numbers mean: units with a scale, named choices, fields; read, limited, written and shipped."""

from __future__ import annotations

import pytest

from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.meaning import Choice, Meaning
from kitrobot.primitives.own_xml import read_own, write_constructor
from kitrobot.primitives.robot import Parameter
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.primitives.value_format import format_value
from kitrobot.sim.devices.display import IMAGES, SIDE
from kitrobot.translation.languages import TEXT_LANGUAGES
from tests.primitives.samples import messages, robot


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return load_catalogue()


def parameter(inside: str) -> Parameter:
    made, problems = read_robot(
        robot(f'<actuator name="M"><procedure name="Go">{inside}</procedure></actuator>').encode(), "f.xml"
    )
    assert problems == []
    assert made is not None
    return made.actuators[0].methods[0].parameters[0]


def test_a_number_has_a_unit_with_a_scale_a_field_and_choices_in_languages() -> None:
    made = parameter(
        '<parameter name="n" max="2" unit="s" scale="0.5" field="slider"><unit xml:lang="ur">سیکنڈ</unit>'
        '<choice value="0" icon="heart"><label>heart</label><label xml:lang="fr">cœur</label></choice>'
        '<choice value="1" lights="09090 99999 99999 09990 00900"><label>lit</label></choice>'
        '<choice value="2" colour="#1c8548"><label>green</label></choice></parameter>'
    )
    choices = (
        Choice(0, {"": "heart", "fr": "cœur"}, icon="heart"),
        Choice(1, {"": "lit"}, lights="09090 99999 99999 09990 00900"),
        Choice(2, {"": "green"}, colour="#1c8548"),
    )
    assert made == Parameter("n", 0, 2, 0, unit="s", meaning=Meaning("0.5", {"ur": "سیکنڈ"}, "slider", choices))


def test_a_number_of_which_nothing_is_said_means_nothing() -> None:
    assert parameter('<parameter name="n" unit="%"/>').meaning is None


def test_what_a_sensor_is_compared_with_means_what_the_sensor_means_unless_it_says_otherwise() -> None:
    made, problems = read_robot(
        robot(
            '<sensor name="S" unit="cm" field="ruler"><operation name="A" test="less"><parameter name="v"/></operation>'
            '<operation name="B" test="less"><parameter name="v" unit="m" scale="0.01"/></operation></sensor>'
        ).encode(),
        "f.xml",
    )
    assert problems == []
    assert made is not None
    [sensor] = made.sensors
    one, other = (method.parameters[0] for method in sensor.methods)
    assert (sensor.unit, one.unit, other.unit) == ("cm", "cm", "m")
    assert sensor.meaning == one.meaning == Meaning(field="ruler")
    assert other.meaning == Meaning("0.01")
    assert sensor.settings == {}


@pytest.mark.parametrize(
    ("inside", "says"),
    [
        ('scale="0"', "a number above 0, such as 3.6, or wait-unit in scale"),
        ('scale="-1"', "a number above 0"),
        ('scale="1e3"', "a number above 0"),
        ('scale="123456"', "a number above 0"),
        ('field="wheel"', "expected slider, time, dial"),
        (f'unit="{"x" * 21}"', "at most 20 characters in unit"),
        ('field="lights"', "the field lights needs choices with lights"),
        ('field="choices"', "expected a <choice> for the field choices, found none"),
    ],
)
def test_what_makes_no_sense_is_one_sentence_with_its_place(inside: str, says: str) -> None:
    text = robot(f'<actuator name="M"><procedure name="Go"><parameter name="n" {inside}/></procedure></actuator>')
    made, problems = read_robot(text.encode(), "f.xml")
    assert made is None
    [problem] = problems
    assert says in problem.message
    assert problem.place is not None
    assert problem.place.line > 0


@pytest.mark.parametrize(
    ("inside", "says"),
    [
        ('<choice value="9"><label>x</label></choice>', "expected a number from 0 to 2 in value, found 9"),
        ('<choice value="1"/>', "expected a <label> in the choice, found none"),
        ('<choice value="1" icon="x" colour="#000000"><label>x</label></choice>', "found icon and colour"),
        ('<choice value="1" lights="0 0"><label>x</label></choice>', "five rows of five digits"),
        ('<choice value="1" colour="red"><label>x</label></choice>', "a colour such as #1c8548"),
        ('<choice value="1"><label>x</label></choice>' * 2, "a choice with the value 1 already"),
    ],
)
def test_a_choice_that_makes_no_sense_is_reported(inside: str, says: str) -> None:
    text = robot(
        '<actuator name="M"><procedure name="Go"><parameter name="n" max="2">'
        f"{inside}</parameter></procedure></actuator>"
    )
    assert read_robot(text.encode(), "f.xml")[0] is None
    assert says in messages(read_robot, text)[0]


@pytest.mark.parametrize(("count", "is_read"), [(64, True), (65, False)])
def test_a_number_has_64_choices_at_most(count: int, is_read: bool) -> None:
    choices = "".join(f'<choice value="{at}"><label>n{at}</label></choice>' for at in range(count))
    text = robot(
        f'<actuator name="M"><procedure name="Go"><parameter name="n">{choices}</parameter></procedure></actuator>'
    )
    assert (read_robot(text.encode(), "f.xml")[0] is not None) is is_read


def test_what_a_slot_means_is_written_and_read_again() -> None:
    text = (
        '<constructors version="1"><group name="G" colour="loop"><constructor name="C"><help>x</help>'
        '<number name="n" min="0" max="9" unit="s" scale="wait-unit" field="time"><unit xml:lang="ur">سیکنڈ</unit>'
        '<choice value="1" icon="heart"><label>a &amp; b</label><label xml:lang="fr">é</label></choice></number>'
        "<code>WAIT({n})</code></constructor></group></constructors>"
    )
    [group], problems = read_constructors(text.encode(), "f.xml")
    assert problems == []
    [made] = group.constructors
    slot = made.slots[0]
    assert slot.meaning == Meaning(
        "wait-unit", {"ur": "سیکنڈ"}, "time", (Choice(1, {"": "a & b", "fr": "é"}, icon="heart"),)
    )
    again, problems = read_own(write_constructor(made), "own.xml")
    assert problems == []
    assert again is not None
    assert again.slots == made.slots  # type: ignore[union-attr]


def test_the_angle_of_a_turn_is_shown_in_degrees_a_wait_in_seconds_and_a_distance_in_cm(catalogue: Catalogue) -> None:
    mini = catalogue.robots["mini-robot"]
    angle = mini.calls["Motor", "AbsoluteTurn"][1].parameters[0]
    assert angle.meaning is not None
    assert (angle.unit, float(angle.meaning.scale) * 25, angle.meaning.field) == ("°", 90.0, "dial")
    wait = catalogue.constructors["Wait"].slots[0]
    assert wait.meaning is not None
    assert (wait.unit, wait.meaning.scale) == ("s", "wait-unit")
    for name in ("mini-robot", "line-follower", "kit-robot"):
        sensor = next(one for one in catalogue.robots[name].sensors if one.name == "Captor")
        assert sensor.meaning is not None
        reach_cm = float(sensor.settings["reach"]) / 10
        assert sensor.maximum * float(sensor.meaning.scale) == reach_cm, name
        assert sensor.unit == "cm"
    side = next(one for one in catalogue.robots["line-follower"].sensors if one.name == "Side")
    assert side.meaning is not None
    assert side.maximum * float(side.meaning.scale) == float(side.settings["reach"]) / 10


def test_the_pictures_of_the_lights_are_those_that_the_simulator_shows(catalogue: Catalogue) -> None:
    number = catalogue.robots["microbit"].calls["Display", "Image"][1].parameters[0]
    assert number.meaning is not None
    shown = [
        " ".join(f"{row:05b}".replace("1", "9") for row in IMAGES[SIDE * at : SIDE * at + SIDE])
        for at in range(len(IMAGES) // SIDE)
    ]
    assert [choice.lights for choice in number.meaning.choices] == shown


def test_every_choice_and_unit_of_letters_that_is_shipped_speaks_each_language(catalogue: Catalogue) -> None:
    numbers: list[tuple[str, str, Meaning | None]] = []
    for robot_ in catalogue.robots.values():
        for part in robot_.objects:
            numbers.append((f"{robot_.name} {part.name}", part.unit, part.meaning))
            numbers += [
                (f"{robot_.name} {part.name}.{method.name}", one.unit, one.meaning)
                for method in part.methods
                for one in method.parameters
            ]
    for constructor in catalogue.constructors.values():
        numbers += [(f"{constructor.name}.{slot.name}", slot.unit, slot.meaning) for slot in constructor.slots]
    assert any(meaning is not None and meaning.choices for _, _, meaning in numbers)
    for where, unit, meaning in numbers:
        if unit.isalpha():
            assert meaning is not None, where
            assert "ur" in meaning.units, where
        for choice in meaning.choices if meaning is not None else ():
            assert set(TEXT_LANGUAGES) <= choice.label.keys(), where


@pytest.mark.parametrize(
    ("element", "label"),
    [
        ("Repetition", "Repeat"),
        ("No", "Not"),
        ("Parallelism", "At the same time"),
        ("Motor.AbsoluteTurn", "Turn by"),
        ("Wheel.Advance", "Keep driving"),
        ("Captor", "Distance sensor"),
    ],
)
def test_terms_of_the_paper_have_plain_labels_and_keep_their_names(
    catalogue: Catalogue, element: str, label: str
) -> None:
    mini = catalogue.robots["mini-robot"]
    part, _, method = element.partition(".")
    if part in catalogue.constructors:
        found = catalogue.constructors[part].label
    elif method:
        found = mini.calls[part, method][1].label
    else:
        found = next(one for one in mini.objects if one.name == part).label
    assert found[""] == label


@pytest.mark.parametrize(
    ("said", "value", "words"),
    [
        ('min="0" max="100" unit="cm"', 12, "12 cm"),
        ('min="0" max="100" unit="cm" scale="0.5"', 25, "12.5 cm"),
        ('min="0" max="100" unit="cm" scale="0.5"', 24, "12 cm"),
        ('min="-180" max="180" unit="°" scale="3.6"', -25, "-90°"),
        ('min="0" max="100" unit="s" scale="wait-unit" field="time"', 10, "2.0 s"),
        ('min="0" max="100" unit="s" scale="wait-unit" field="time"', 3, "0.6 s"),
        ('min="0" max="1000000" unit="mm"', 1000000, "1000000 mm"),
        ('min="0" max="9"', 7, "7"),
        ('type="boolean"', 1, "true"),
        ('type="boolean"', 0, "false"),
    ],
)
def test_a_terminal_shows_what_a_sensor_measures_with_its_unit(said: str, value: int, words: str) -> None:
    made, problems = read_robot(robot(f'<sensor name="Eye" device="range" {said}/>').encode(), "f.xml")
    assert made is not None, problems
    assert format_value(made.sensors[0], value, 200) == words


def test_a_named_value_is_shown_by_its_name() -> None:
    text = '<sensor name="Eye" device="colour" min="0" max="2"><choice value="1"><label>red</label></choice></sensor>'
    made, problems = read_robot(robot(text).encode(), "f.xml")
    assert made is not None, problems
    assert [format_value(made.sensors[0], value) for value in (0, 1)] == ["0", "red"]
