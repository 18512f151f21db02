"""Robots from XML."""

import pytest

from kitrobot.primitives.robot import Board, Category, Kind, Parameter, Robot, ValueType
from kitrobot.primitives.robot_xml import read_robot
from tests.primitives.samples import ROBOT, messages, robot


def read_one(inside: str) -> Robot:
    made, problems = read_robot(robot(inside).encode(), "f.xml")
    assert problems == []
    assert made is not None
    return made


def test_a_robot_keeps_the_order_of_its_file() -> None:
    made, problems = read_robot(ROBOT.encode(), "f.xml")
    assert problems == []
    assert made is not None
    assert [part.name for part in made.objects] == ["Wheel", "Button", "Count", "Fault"]
    assert (made.name, made.tick_ms, made.wait_unit_ms) == ("tiny", 20, 100)


def test_a_procedure_says_when_it_completes_and_what_stops_it() -> None:
    made = read_one(
        '<actuator name="M"><procedure name="Go" completes="later" stop="Stop"/><procedure name="Stop"/></actuator>'
    )
    go, stop = made.actuators[0].methods
    assert (go.completes_later, go.stop, stop.completes_later, stop.stop) == (True, "Stop", False, None)


def test_numbers_that_give_no_range_go_from_0_to_100() -> None:
    made = read_one(
        '<actuator name="M"><procedure name="Go"><parameter name="n"/></procedure></actuator>'
        '<sensor name="S"/><variable name="V"/>'
    )
    assert made.actuators[0].methods[0].parameters == (Parameter("n", 0, 100, 0),)
    assert (made.sensors[0].minimum, made.sensors[0].maximum) == (0, 100)
    assert (made.variables[0].minimum, made.variables[0].maximum, made.variables[0].initial) == (0, 100, 0)


def test_settings_of_a_device_are_kept_as_they_are() -> None:
    made = read_one('<sensor name="S" device="range" max="50" reach="400 mm" noise="0.1"/>')
    assert made.sensors[0].settings == {"reach": "400 mm", "noise": "0.1"}
    assert made.sensors[0].device == "range"


def test_what_the_real_robots_driver_is_told_is_kept_in_order() -> None:
    made = read_one(
        '<actuator name="A" device="wheel" side="left"><board driver="pwm-motor" forward="2" backward="3"/></actuator>'
        '<sensor name="S" device="range"><board trigger="GP14" echo="é"/></sensor>'
    )
    assert made.actuators[0].board == Board("pwm-motor", {"forward": "2", "backward": "3"})
    assert list(made.actuators[0].board.settings) == ["forward", "backward"]
    assert made.actuators[0].settings == {"side": "left"}
    assert made.sensors[0].board == Board("range", {"trigger": "GP14", "echo": "é"})


def test_without_a_board_element_the_driver_is_the_device() -> None:
    made = read_one('<actuator name="A" device="my wheel"/><sensor name="S"/><variable name="V"/>')
    assert [part.board for part in made.objects] == [Board("my wheel"), Board(), Board(), Board()]


@pytest.mark.parametrize(
    ("value", "right"),
    [
        ("x", True),
        ("x" * 60, True),
        ("x" * 61, False),
        ("", False),
        (" ", False),
        ("1 2", False),
        ("1&#10;2", False),
        ("1&#9;2", False),
        ("1&#160;2", False),
        ("1&#x202e;2", False),
        ("&#127;", False),
        ("a=b", False),
        ("&quot;", False),
        ("a,b;c/d:e'", True),
    ],
)
def test_a_setting_of_a_driver_fits_into_a_line_of_words(value: str, right: bool) -> None:
    made, problems = read_robot(robot(f'<sensor name="S"><board pin="{value}"/></sensor>').encode(), "f.xml")
    assert (made is not None) == right == (not problems)


@pytest.mark.parametrize(("count", "right"), [(24, True), (25, False)])
def test_a_driver_has_few_settings(count: int, right: bool) -> None:
    settings = " ".join(f's{number}="1"' for number in range(count))
    made, problems = read_robot(robot(f'<sensor name="S"><board {settings}/></sensor>').encode(), "f.xml")
    assert (made is not None) == right == (not problems)


@pytest.mark.parametrize(
    ("driver", "right"),
    [("a", True), ("a" * 60, True), ("a" * 61, False), ("9", False), ("../boot", False), ("", False)],
)
def test_a_drivers_name_is_that_of_a_module(driver: str, right: bool) -> None:
    made, problems = read_robot(robot(f'<sensor name="S"><board driver="{driver}"/></sensor>').encode(), "f.xml")
    assert (made is not None) == right == (not problems)


def test_operations_are_tests_or_values() -> None:
    made = read_one(
        """<sensor name="S" min="-5" max="5">
          <operation name="IsThree" test="equal" to="3"/>
          <operation name="Below" test="less"><parameter name="n"/></operation>
          <operation name="Value" value="yes"/>
        </sensor>"""
    )
    three, below, value = made.sensors[0].methods
    assert (three.kind, three.test, three.to, three.phrase) == (Kind.TEST, "equal", 3, {"": "{object} is three"})
    assert (below.kind, below.test, below.to, below.phrase) == (Kind.TEST, "less", None, {"": "{object} < {n}"})
    assert below.parameters == (Parameter("n", -5, 5, 0),)
    assert (value.kind, value.phrase) == (Kind.VALUE, {"": "{object}"})


def test_an_integer_variable_gets_its_methods() -> None:
    [count] = read_one('<variable name="Count" min="2" max="9" initial="4" shared="yes"/>').variables
    assert count.shared
    assert [(method.name, method.kind.value, method.action, method.test) for method in count.methods] == [
        ("Set", "procedure", "set", ""),
        ("Add", "procedure", "add", ""),
        ("Sub", "procedure", "sub", ""),
        ("Value", "value", "", ""),
        ("EqualTo", "test", "", "equal"),
        ("LessThan", "test", "", "less"),
        ("GreaterThan", "test", "", "greater"),
    ]
    ranges = [[(p.minimum, p.maximum) for p in method.parameters] for method in count.methods]
    assert ranges == [[(2, 9)], [(-7, 7)], [(-7, 7)], [], [(2, 9)], [(2, 9)], [(2, 9)]]
    assert [method.phrase[""] for method in count.methods[4:]] == [
        "{object} = {value}",
        "{object} < {value}",
        "{object} > {value}",
    ]


def test_a_boolean_variable_gets_its_methods() -> None:
    [run] = read_one('<variable name="Run" type="boolean" initial="true"/>').variables
    assert (run.type, run.minimum, run.maximum, run.initial) == (ValueType.BOOLEAN, 0, 1, 1)
    setting, true, false = run.methods
    assert (setting.name, setting.action) == ("Set", "set")
    [value] = setting.parameters
    assert (value.type, value.minimum, value.maximum) == (ValueType.BOOLEAN, 0, 1)
    assert (true.name, true.test, true.to, true.phrase[""]) == ("IsTrue", "equal", 1, "{object} is true")
    assert (false.name, false.test, false.to, false.phrase[""]) == ("IsFalse", "equal", 0, "{object} is false")


def test_every_robot_has_a_fault_flag() -> None:
    made = read_one("")
    [fault] = made.system
    assert (fault.name, fault.category) == ("Fault", Category.SYSTEM)
    assert [(m.name, m.kind, m.test, m.to, m.action) for m in fault.methods] == [
        ("IsRaised", Kind.TEST, "equal", 1, ""),
        ("Clear", Kind.PROCEDURE, "", None, "clear"),
    ]


@pytest.mark.parametrize(
    ("tick", "unit", "right"),
    [(1, 1, True), (1000, 10_000, True), (0, 1, False), (1, 0, False), (1001, 1, False), (1, 10_001, False)],
)
def test_tick_and_wait_unit_are_allowed_up_to_their_limits(tick: int, unit: int, right: bool) -> None:
    text = f'<robot name="r" version="1" tick="{tick}" wait-unit="{unit}"/>'
    made, problems = read_robot(text.encode(), "f.xml")
    assert (made is not None) == right == (not problems)


@pytest.mark.parametrize(("number", "right"), [(2**29 - 1, True), (2**29, False), (1 - 2**29, True), (-(2**29), False)])
def test_numbers_are_allowed_up_to_what_the_smallest_board_holds(number: int, right: bool) -> None:
    least, most = min(0, number), max(0, number)
    for inside in (
        f'<sensor name="S" min="{least}" max="{most}"/>',
        f'<variable name="V" min="{least}" max="{most}" initial="{number}"/>',
        '<actuator name="A"><procedure name="P">'
        f'<parameter name="n" min="{least}" max="{most}"/></procedure></actuator>',
    ):
        made, problems = read_robot(robot(inside).encode(), "f.xml")
        assert (made is not None) == right == (not problems)


def test_what_is_added_to_the_widest_variable_is_within_the_limit() -> None:
    [widest] = read_one(f'<variable name="V" min="{1 - 2**29}" max="{2**29 - 1}"/>').variables
    amount = widest.methods[1].parameters[0]
    assert (amount.minimum, amount.maximum) == (1 - 2**29, 2**29 - 1)


TO = '<operation name="O" test="equal" to="1"/>'
BAD = [
    ('<sensor name="S" min="5" max="3"/>', "5 | robot-range | expected min at most max, found 5 and 3"),
    ('<variable name="V" max="5" initial="6"/>', "6 | robot-range | expected a number from 0 to 5 in initial, found 6"),
    (
        '<variable name="V" initial="１"/>',
        "１ | xml-bad-value | expected a whole number from -536870911 to 536870911 in initial, found “１”",
    ),
    (
        '<variable name="V" initial="1_0"/>',
        "1_0 | xml-bad-value | expected a whole number from -536870911 to 536870911 in initial, found “1_0”",
    ),
    (
        '<variable name="V" type="boolean" initial="maybe"/>',
        "maybe | xml-bad-value | expected true, false, 1 or 0 in initial, found “maybe”",
    ),
    (
        '<variable name="V" shared="perhaps"/>',
        "perhaps | xml-bad-value | expected yes or no in shared, found “perhaps”",
    ),
    (
        '<variable name="WAIT"/>',
        "WAIT | xml-bad-value | expected a name of letters, digits and _ (not WAIT or BREAK) in name, found “WAIT”",
    ),
    (
        '<variable name="a b"/>',
        "a b | xml-bad-value | expected a name of letters, digits and _ (not WAIT or BREAK) in name, found “a b”",
    ),
    ('<variable name="Fault"/>', "Fault | xml-duplicate | every robot has a Fault already"),
    ('<variable name="V"/><variable name="V"/>', "V | xml-duplicate | the variable “V” is there already"),
    (
        '<sensor name="S"><operation name="O"/></sensor>',
        '<operation | robot-method | expected test="…" or value="yes" on <operation>, found neither',
    ),
    (
        '<sensor name="S"><operation name="O" test="equal"/></sensor>',
        '<operation | robot-method | expected either to="…" or one parameter on a test, found 0 parameters',
    ),
    (
        '<sensor name="S"><operation name="O" test="equal" to="101"/></sensor>',
        "101 | robot-range | expected a number from 0 to 100 in to, found 101",
    ),
    (
        '<sensor name="S"><operation name="O" test="equal" to="1"/><operation name="O" test="equal" to="1"/></sensor>',
        "O | xml-duplicate | the method “O” is there already",
    ),
    (
        '<sensor name="S"><operation name="O" test="equal" to="1"><parameter name="n"/></operation></sensor>',
        '<operation | robot-method | expected either to="…" or one parameter on a test, found to and 1 parameter',
    ),
    (
        '<sensor name="S"><operation name="O" value="yes" test="equal"/></sensor>',
        'equal | robot-method | expected no test beside value="yes", found one',
    ),
    (
        '<sensor name="S"><operation name="O" value="yes"><parameter name="n"/></operation></sensor>',
        "<operation | robot-method | expected no parameter on a value, found 1",
    ),
    (
        '<actuator name="A"><procedure name="Go" stop="Stpo"/><procedure name="Stop"/></actuator>',
        "Stpo | robot-stop | expected in stop a procedure of A without parameters, found “Stpo”",
    ),
    (
        '<actuator name="A"><procedure name="Go" stop="Go"><parameter name="n"/></procedure></actuator>',
        "Go | robot-stop | expected in stop a procedure of A without parameters, found “Go”",
    ),
    (
        '<actuator name="A"><procedure name="Go" completes="soon"/></actuator>',
        "soon | xml-bad-value | expected now or later in completes, found “soon”",
    ),
    (
        '<actuator name="A"><procedure name="Go"><parameter name="next"/></procedure></actuator>',
        "next | xml-bad-value | a parameter cannot be named next, a port of every vertex",
    ),
    (
        '<actuator name="A"><procedure name="Go"><parameter name="n" default="101"/></procedure></actuator>',
        "101 | robot-range | expected a number from 0 to 100 in default, found 101",
    ),
    (
        f'<actuator name="S"><procedure name="O"/></actuator><sensor name="S">{TO}</sensor>',
        "S | xml-duplicate | S.O is a method of the actuator S already",
    ),
    ('<sensor name="S"><board/><board/></sensor>', "<board | xml-duplicate | <sensor> holds a <board> already"),
    (
        '<sensor name="S"><board pin="GP 2"/></sensor>',
        "GP 2 | robot-board | expected 1 to 60 characters without spaces, = and quotation marks in pin, found “GP 2”",
    ),
    (
        f'<sensor name="S"><board {"p" * 61}="2"/></sensor>',
        f"2 | robot-board | expected at most 60 characters in the name of a setting, found “{'p' * 39}…”",
    ),
    (
        '<sensor name="S"><board driver="a/b"/></sensor>',
        "a/b | xml-bad-value | expected 1 to 60 of the letters a to z, digits, _ and -, a letter first in driver, "
        "found “a/b”",
    ),
]


@pytest.mark.parametrize(("inside", "message"), BAD, ids=range(len(BAD)))
def test_a_wrong_robot_is_reported_and_left_out(inside: str, message: str) -> None:
    text = robot(inside)
    made, problems = read_robot(text.encode(), "f.xml")
    assert made is None
    assert problems
    assert messages(read_robot, text) == [message]


def test_an_actuator_and_a_sensor_may_share_a_name() -> None:
    made = read_one(f'<actuator name="L"><procedure name="On"/></actuator><sensor name="L">{TO}</sensor>')
    assert made.calls["L", "On"][0].category is Category.ACTUATOR
    assert made.calls["L", "O"][0].category is Category.SENSOR


def test_a_phrase_with_an_unknown_hole_is_a_warning() -> None:
    made, [problem] = read_robot(
        robot(
            '<sensor name="S"><operation name="O" value="yes"><phrase>{objekt}</phrase></operation></sensor>'
        ).encode(),
        "f",
    )
    assert made is not None
    assert not problem.is_error
    assert problem.help == "did you mean object?"


@pytest.mark.parametrize(
    ("name", "right"),
    [
        ("store-manager", True),
        ("机器人", True),
        ("", False),
        ("-x", False),
        ("a/b", False),
        ("..", False),
        ("x" * 100, True),
        ("x" * 101, False),
    ],
)
def test_a_robots_name_is_a_word(name: str, right: bool) -> None:
    made, _ = read_robot(f'<robot name="{name}" version="1"/>'.encode(), "f.xml")
    assert (made is not None) == right


def test_the_fingerprint_changes_with_what_an_image_depends_on() -> None:
    same = [read_one('<sensor name="S"><help>a</help></sensor>'), read_one('<sensor name="S" icon="x"/>')]
    same.append(read_one('<sensor name="S"><board driver="d" pin="1"/></sensor>'))
    other = [
        read_one('<sensor name="S" max="99"/>'),
        read_one('<sensor name="T"/>'),
        read_one('<sensor name="S"/><sensor name="T"/>'),
    ]
    assert len({one.fingerprint for one in same}) == 1
    assert len({one.fingerprint for one in same + other}) == 4
