"""What names mean for a robot: every rule where it speaks, and beside it where it does not."""

from __future__ import annotations

from functools import cache

import pytest

from kitrobot.compiler.compilation import compile_text
from kitrobot.compiler.program.checker import check
from kitrobot.lll.parse_results import parse
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from tests.lll.expectations import meets_expectations

HOUSE = """\
<robot name="house" version="1">
  <actuator name="Lift" device="drive">
    <procedure name="Go">
      <parameter name="floor" min="3" max="9" default="3"/><parameter name="fast" type="boolean"/>
    </procedure>
    <procedure name="Level"/>
  </actuator>
  <sensor name="Lift" device="range" min="0" max="9">
    <operation name="IsAt" test="equal"><parameter name="value" min="0" max="9"/></operation>
    <operation name="Level2" value="yes"/>
  </sensor>
  <variable name="Depth" type="integer" min="-10" max="-5" initial="-7"/>
  <variable name="رفتار" type="integer" min="0" max="7" initial="0"/>
</robot>
"""


@cache
def robot(name: str) -> Robot:
    if name == "house":
        made, problems = read_robot(HOUSE.encode(), "house.robot.xml")
        assert made is not None, problems
        return made
    return load_catalogue().robots[name]


MINI = [
    ("nothing is wrong with a program that is right", "*[Run.IsTrue()](Wheel.Advance(50); Count.Add(1); WAIT(1););"),
    # names
    ("an unknown object", "Wheels.Stop();  #! unknown-object@1 the robot `mini-robot` has no `Wheels`"),
    ("case matters in an object", "wheel.Stop();  #! unknown-object@1"),
    (
        "an unknown method",
        "Wheel.Advanced(5);  #! unknown-method@7 `Wheel` of the robot `mini-robot` has no `Advanced`",
    ),
    ("case matters in a method", "Wheel.stop();  #! unknown-method@7"),
    ("a method of another object", "Wheel.Open();  #! unknown-method@7"),
    ("an unknown object in a condition", "[Captr.LessThan(3)](Wheel.Stop(););  #! unknown-object@2"),
    ("an unknown method in a parameter", "Wheel.Advance(Captor.Worth());  #! unknown-method@22"),
    ("parameters of an unknown call are looked at", "A.b(C.d());  #! unknown-object@1 || unknown-object@5"),
    ("an unknown call behind a mark", "//(°Wheel.Run()°;, WAIT(1););  #! unknown-method@11"),
    ("tests joined", "[A.b() & !(C.d() | E.f())]();  #! unknown-object@2 || unknown-object@12 || unknown-object@20"),
    # parameters
    ("no parameter of one", "Wheel.Advance();  #! parameter-count@1 `Wheel.Advance` takes 1 parameter, found 0"),
    ("two parameters of one", "Wheel.Advance(1, 2);  #! parameter-count@1 takes 1 parameter, found 2"),
    ("one parameter of two", "Motor.AbsoluteTurn(1);  #! parameter-count@1 takes 2 parameters, found 1"),
    ("one parameter of none", "Wheel.Stop(1);  #! parameter-count@1 takes 0 parameters, found 1"),
    ("too few parameters of a test", "[Captor.LessThan()]();  #! parameter-count@2"),
    ("too few parameters of a value", "Wheel.Advance(Captor.Value(3));  #! parameter-count@15"),
    (
        "a wrong number of parameters does not hide a wrong one",
        "Wheel.Advance(101, 1);  #! parameter-count || out-of-range@15",
    ),
    # ranges
    ("a procedure's smallest and largest", "Wheel.Advance(0); WAIT(1); Wheel.Advance(100);"),
    ("beyond a procedure's largest", "Wheel.Advance(101);  #! out-of-range@15 expected a speed from 0 to 100"),
    ("the second parameter", "Motor.AbsoluteTurn(5, 101);  #! out-of-range@23 for `Motor.AbsoluteTurn`, found 101"),
    ("Set's smallest and largest", "Count.Set(0); Count.Set(100);"),
    ("beyond Set's largest", "Count.Set(101);  #! out-of-range@11 expected a value from 0 to 100 for `Count.Set`"),
    ("a boolean's two numbers", "Flag.Set(0); Flag.Set(1);"),
    ("a boolean's third number", "Flag.Set(2);  #! out-of-range@10 from 0 to 1"),
    ("a test compares with any number", "[Captor.LessThan(65535) & Count.EqualTo(101)](Wheel.Stop(););"),
    ("what is added may be any number", "Count.Add(101); Count.Sub(65535);"),
    ("a marked action's parameter", "//(°Wheel.Advance(101)°;, WAIT(1););  #! out-of-range@19"),
    # tests and values
    ("a value for a number", "Wheel.Advance(Captor.Value()); Count.Set(Level.Value());"),
    ("a test for a boolean", "Flag.Set(Button.IsPressed());"),
    (
        "a test for a number",
        "Wheel.Advance(Button.IsPressed());  #! test-for-value@15 expected a number as the speed of `Wheel.Advance`",
    ),
    ("a test for what is added", "Count.Add(Run.IsTrue());  #! test-for-value@11"),
    ("a test inside a test", "[Captor.LessThan(Button.IsPressed())]();  #! test-for-value@18"),
    ("a value for a boolean", "Flag.Set(Count.Value());  #! value-for-test@10 expected a test, 0 or 1 for `Flag.Set`"),
    ("a value for a test", "[Count.Value()]();  #! value-for-test@2 expected a test, found `Count.Value`"),
    ("a value in a joined test", "*[Run.IsTrue() & Captor.Value()](WAIT(1););  #! value-for-test@18"),
    ("a value in an event", "<Captor.Value()>();  #! value-for-test@2"),
    ("an action for a test", "[Wheel.Stop()]();  #! procedure-for-value@2 expected a test, found `Wheel.Stop`"),
    ("an action for a number", "Wheel.Advance(Door.Open());  #! procedure-for-value@15 expected a number"),
    ("an action for a boolean", "Flag.Set(Door.Open());  #! procedure-for-value@10 expected a test"),
    ("Set for a test", "[Flag.Set(1)]();  #! procedure-for-value@2"),
    ("a test as an instruction", "Button.IsPressed();  #! value-as-instruction@1 only reads something"),
    ("a value as an instruction", "Captor.Value();  #! value-as-instruction@1"),
    ("the fault can be read and cleared", "[Fault.IsRaised()](Fault.Clear(););"),
    # where things stand
    ("BREAK in each loop", "3*(BREAK;); *[Run.IsTrue()](BREAK;);"),
    ("BREAK deep in a loop", "*[Run.IsTrue()]([Flag.IsTrue()](<Run.IsTrue()>(BREAK;););WAIT(1););"),
    ("BREAK in the program", "BREAK;  #! break-outside-loop@1 so it ends the program"),
    ("BREAK in a choice", "[Run.IsTrue()](BREAK;);  #! break-outside-loop@16"),
    ("BREAK in a branch", "//(BREAK;, WAIT(1););  #! break-outside-loop@4 so it ends the branch"),
    ("BREAK in a branch in a loop", "2*(//(BREAK;, WAIT(1);););  #! break-outside-loop@7 so it ends the branch"),
    ("BREAK in a loop in a branch", "//(2*(BREAK;);, WAIT(1););"),
    ("a mark in a branch", "//(°Wheel.Stop()°;, WAIT(1););"),
    ("a mark deep in a branch", "//(2*([Run.IsTrue()](°Wheel.Stop()°;););, WAIT(1););"),
    ("a mark in the program", "°Wheel.Stop()°;  #! mark-outside-parallel@1"),
    ("a mark in a loop", "2*(°Wheel.Stop()°;);  #! mark-outside-parallel@4"),
    # branches
    ("two branches and two actuators", "//(Wheel.Stop();, Motor.Stop(););"),
    ("one branch may drive an actuator twice", "//(Wheel.Stop(); WAIT(1); Wheel.Advance(1);, Motor.Stop(););"),
    (
        "two branches and one actuator",
        "//(Wheel.Stop();, Wheel.Advance(1););  #! shared-actuator@19 `Wheel` is driven by",
    ),
    (
        "an actuator is told once",
        "//(Wheel.Stop();, Wheel.Stop();, Wheel.Stop(); WAIT(1); Wheel.Stop(););  #! shared-actuator@19",
    ),
    (
        "each actuator is told",
        "//(Wheel.Stop(); Door.Open();, Door.Close(); Wheel.Stop(););  #! shared-actuator@32 || shared-actuator@46",
    ),
    ("deep in branches", "//(2*(Wheel.Stop(););, [Run.IsTrue()]()!(°Wheel.Stop()°;););  #! shared-actuator@43"),
    ("a parallel in a branch", "//(//(Wheel.Stop();, WAIT(1););, Wheel.Stop(););  #! shared-actuator@34"),
    ("one after the other is not shared", "//(Wheel.Stop();, WAIT(1);); //(Wheel.Stop();, WAIT(1););"),
    ("variables may be shared", "//(Count.Add(1);, Count.Add(1););"),
    ("sensors may be shared", "//(<Button.IsPressed()>();, <Button.IsPressed()>(););"),
    # commands that give way
    ("two commands in a tick", "Wheel.Advance(50); Wheel.Stop();  #! overwritten@1 `Wheel.Stop` takes its place"),
    ("three", "Wheel.Advance(50); Wheel.Advance(6); Wheel.Stop();  #! overwritten@1 || overwritten@20"),
    ("marked ones", "//(°Wheel.Advance(50)°; °Wheel.Stop()°;, WAIT(1););  #! overwritten@5 `Wheel.Stop`"),
    ("another between them", "Wheel.Advance(50); Light.LightOn(); Count.Add(1); Wheel.Stop();  #! overwritten@1"),
    ("a choice between them", "Wheel.Stop(); [Run.IsTrue()](Count.Add(1);); Wheel.Stop();  #! overwritten@1"),
    ("a wait between them", "Wheel.Advance(50); WAIT(0); Wheel.Stop();"),
    ("an event between them", "Wheel.Advance(50); <Run.IsTrue()>(); Wheel.Stop();"),
    ("a parallel between them", "Wheel.Advance(50); //(); Wheel.Stop();"),
    ("a loop between them", "Wheel.Advance(50); 2*(Count.Add(1);); Wheel.Stop();"),
    ("a loop of no times between them", "Wheel.Advance(50); 0*(); Wheel.Stop();  #! overwritten@1"),
    ("one that takes its time", "Door.Open(); Door.Close();"),
    ("behind one that takes its time", "Door.Open(); Wheel.Advance(50); Door.Close(); Wheel.Stop();"),
    ("a choice that takes one back", "Wheel.Advance(50); [Run.IsTrue()](Wheel.Stop(););"),
    ("sides of a choice", "[Run.IsTrue()](Wheel.Advance(50);)!(Wheel.Stop(););"),
    ("passes of a loop that may end", "*[Run.IsTrue()](Wheel.Stop(); WAIT(1); Wheel.Advance(50););"),
    ("passes of a loop without end", "*(Wheel.Stop(); WAIT(1); Wheel.Advance(50););  #! overwritten@26"),
    ("passes that cost a tick", "*(Wheel.Stop(); [Run.IsTrue()](WAIT(1);); Wheel.Advance(50););"),
    ("one command again and again", "*(Wheel.Advance(50); WAIT(1););"),
    ("variables", "Count.Set(1); Count.Set(2);"),
    # loops without end
    ("an empty loop without end", "*();  #! idle-loop@1 the robot stays as it is"),
    ("an empty loop whose test always holds", "*[Run.IsTrue() | !(Run.IsTrue())]();  #! idle-loop@1 the robot stays"),
    ("an empty loop whose test may fail", "*[Run.IsTrue() | !(Flag.IsTrue())]();"),
    ("a loop without end that only looks", "*([Run.IsTrue()](););  #! idle-loop@1 the robot stays as it is"),
    ("a loop without end that does the same in every tick", "*(Count.Add(1););  #! idle-loop@1 every 20 ms"),
    ("a loop without end that looks", "*([Run.IsTrue()](Count.Add(1);););"),
    ("a loop without end that gives what it reads", "*(Count.Set(Captor.Value()););"),
    ("a loop without end that takes time", "*(WAIT(1);); *(Door.Open(););  #! never-runs@14"),
    ("a loop without end that is left", "*([Run.IsTrue()](BREAK;);); Wheel.Stop();"),
    ("behind a loop without end", "*(WAIT(1);); Wheel.Stop(); BREAK;  #! never-runs@14 || break-outside-loop@28"),
    ("behind a loop whose test always holds", "*[Captor.LessThan(500)](WAIT(1);); Wheel.Stop();  #! never-runs@36"),
    ("behind a choice of loops without end", "[Run.IsTrue()](*(WAIT(1);))!(*(WAIT(2);)); WAIT(3);  #! never-runs@44"),
    ("behind a parallel that never ends", "//(*(WAIT(1););, WAIT(1);); Wheel.Stop();  #! never-runs@29"),
    ("behind a parallel that is forced", "//(*(°Wheel.Stop()°; WAIT(1););, WAIT(1);); Wheel.Stop();"),
    ("behind a single marked branch", "//(*(°Wheel.Stop()°; WAIT(1););); Wheel.Stop();  #! never-runs@35"),
    # never
    ("behind a BREAK", "2*(BREAK; WAIT(1);)  #! never-runs@11 this can never run"),
    ("told once for what follows", "2*(BREAK; WAIT(1); WAIT(2);)  #! never-runs@11"),
    ("behind a choice that leaves on both sides", "2*([Run.IsTrue()](BREAK;)!(BREAK;); WAIT(1););  #! never-runs@37"),
    ("behind a choice that leaves on one side", "2*([Run.IsTrue()](BREAK;); WAIT(1););"),
    ("behind a loop that is left", "2*(2*(BREAK;); WAIT(1););"),
    ("behind an event that leaves", "2*(<Run.IsTrue()>(BREAK;); WAIT(1););  #! never-runs@28"),
    ("a loop of no times", "0*(WAIT(1););  #! never-runs@4 a loop of 0 times never runs its body"),
    ("an empty loop of no times", "0*();"),
    ("behind a loop of no times", "2*(0*(); WAIT(1););"),
    ("behind a BREAK in a branch", "//(BREAK; WAIT(1);, WAIT(2););  #! break-outside-loop@4 || never-runs@11"),
]

HOUSED = [
    ("a range that does not begin at 0", "Lift.Go(2, 1);  #! out-of-range@9 expected a floor from 3 to 9"),
    ("a boolean parameter takes a test", "Lift.Go(3, Lift.IsAt(3));"),
    ("a boolean parameter takes 0 and 1", "Lift.Go(3, 0); WAIT(1); Lift.Go(3, 1);"),
    ("a boolean parameter takes nothing else", "Lift.Go(3, 2);  #! out-of-range@12"),
    ("a boolean parameter takes no value", "Lift.Go(3, Lift.Level2());  #! value-for-test@12"),
    ("an actuator and a sensor of one name", "[Lift.IsAt(3)](Lift.Level(); WAIT(1); Lift.Go(Lift.Level2(), 0););"),
    ("a range below 0 takes no literal", "Depth.Set(0);  #! out-of-range@11 from -10 to -5"),
    ("a range below 0 takes a value", "Depth.Set(Depth.Value());"),
    ("names of any script", "رفتار.Set(7); رفتار.Set(8);  #! out-of-range@25"),
]

PROGRAMS = [("mini-robot", *row) for row in MINI] + [("house", *row) for row in HOUSED]


@pytest.mark.parametrize(
    ("name", "text"), [(row[0], row[2]) for row in PROGRAMS], ids=[f"{row[1]} ({row[0]})" for row in PROGRAMS]
)
def test_what_is_wrong_or_odd_is_told_at_its_place(name: str, text: str) -> None:
    parsed = parse(text)
    assert parsed.ok
    meets_expectations(text, check(parsed.program, robot(name), parsed.source))


def test_one_object_s_name_in_two_categories_offers_both_objects_methods() -> None:
    text = "Light.LightOn(); [Light.IsRed()](Light.LightOff(););\nLight.IsLit();  #! unknown-method@7"
    parsed = parse(text)
    found = check(parsed.program, robot("mini-robot"), parsed.source)
    meets_expectations(text, found)


HELPS = [
    ("Wheels.Stop();", "did you mean Wheel?"),
    ("Captr.LessThan(3);", "did you mean Captor?"),
    ("Wheel.Advanced(5);", "did you mean Advance?"),
    ("[Button.IsPresed()]();", "did you mean IsPressed?"),
    ("Wheel.Xyzzy();", "there is Advance, BackBy, DriveBy, Reverse, Stop"),
    ("Light.Xyzzy();", "there is IsBlue, IsGreen, IsRed, LightOff, LightOn"),
    ("Wheel.Advance();", "write Wheel.Advance(speed)"),
    ("Motor.AbsoluteTurn(1);", "write Motor.AbsoluteTurn(angle, speed)"),
    ("Wheel.Advance(101);", "write a number from 0 to 100"),
    ("[Count.Value()]();", "`Count` has `EqualTo`, `LessThan`, `GreaterThan`"),
    ("Wheel.Advance(Captor.LessThan(3));", "`Captor` has `Value`"),
    ("Wheel.Advance(Button.IsPressed());", ""),
    ("[Light.LightOn()]();", "`Light` has `IsRed`, `IsGreen`, `IsBlue`"),
    ("[Wheel.Stop()]();", ""),
    ("Button.IsPressed();", "use it in a condition or as a parameter"),
    ("°Wheel.Stop()°;", "take the ° away, or put the action into a branch"),
]


@pytest.mark.parametrize(("text", "help"), HELPS, ids=[row[0] for row in HELPS])
def test_a_mistake_comes_with_a_way_out(text: str, help: str) -> None:
    parsed = parse(text)
    assert [item.help for item in check(parsed.program, robot("mini-robot"), parsed.source)] == [help]


def test_an_object_like_none_gets_a_list_of_what_there_is() -> None:
    parsed = parse("Xyzzy.b();")
    (mistake,) = check(parsed.program, robot("mini-robot"), parsed.source)
    assert mistake.help == "there is Button, Captor, Count, Door, Fault, Flag, Level, Light …"


def test_only_errors_keep_a_program_from_being_compiled() -> None:
    hints = "BREAK; °Wheel.Stop()°; Button.IsPressed(); 0*(WAIT(1););"
    compiled = compile_text(hints, robot("mini-robot"))
    assert compiled.ok
    assert {item.severity.value for item in compiled.diagnostics} == {"hint"}
    assert not compile_text("Wheel.Advance(101);", robot("mini-robot")).ok


def test_mistakes_of_syntax_and_of_meaning_are_told_together_in_reading_order() -> None:
    text = """\
Wheel.Advance(101);   #! out-of-range@15
Wheel.Advance(;       #! syntax@15
Whel.Stop();          #! unknown-object@1
[Count.Value(](       #! syntax@14
  Door.Opn();         #! unknown-method@8
);
"""
    compiled = compile_text(text, robot("mini-robot"), "mine.lll")
    assert not compiled.ok
    assert compiled.image is None
    meets_expectations(text, compiled.diagnostics)
    lines = [item.place.line for item in compiled.diagnostics if item.place]
    assert lines == sorted(lines)
    assert {item.place.file for item in compiled.diagnostics if item.place} == {"mine.lll"}


@pytest.mark.parametrize("text", ["a.b(;", "[§]();", "//(°;, 3;);", "WAIT(x);", "[[Run.IsTrue()](Wheel.Stop();)]();"])
def test_what_could_not_be_read_is_not_told_again(text: str) -> None:
    parsed = parse(text)
    assert not parsed.ok
    assert check(parsed.program, robot("mini-robot"), parsed.source) == []


def test_the_program_s_name_is_on_each_diagnostic() -> None:
    parsed = parse("A.b(); BREAK;")
    found = check(parsed.program, robot("mini-robot"), parsed.source, "carrier")
    assert [item.program for item in found] == ["carrier", "carrier"]
