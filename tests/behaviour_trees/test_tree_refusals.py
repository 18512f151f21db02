"""What no program says, and what is no tree: each is refused with a sentence, its line and a way out."""

from __future__ import annotations

import pytest

from kitrobot.behaviour_trees.calls import call_ids
from kitrobot.behaviour_trees.lll_to_tree import lll_to_tree
from kitrobot.behaviour_trees.tree_to_lll import tree_to_lll
from kitrobot.behaviour_trees.tree_writer import write_tree
from kitrobot.behaviour_trees.tree_xml import MAX_NODES, read_trees
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.primitives.catalogue import load_catalogue

ROBOT = load_catalogue([]).robots["mini-robot"]
ACT, ASK, LATER = "<Wheel.Stop/>", "<Button.IsPressed/>", "<Door.Open/>"
MIXED = f"<Sequence>{ACT}{ASK}</Sequence>"
REFUSED = {
    "an action that fails has no other way": (f"<Fallback>\n{LATER}{ACT}</Fallback>", 4, "“Door.Open” never fails"),
    "a way that fails after acting": (f"<Fallback>\n{MIXED}{ACT}</Fallback>", 4, "after it has begun to act"),
    "a failure in the middle": (
        f"<Sequence>\n<IfThenElse>{ASK}{ACT}</IfThenElse>{ACT}</Sequence>",
        4,
        "what stands behind it would not be done",
    ),
    "a branch that fails": (f"<Parallel>\n{MIXED}{ACT}</Parallel>", 4, "“Sequence” can fail"),
    "a loop that fails in a loop": (
        f'<Repeat num_cycles="-1">\n<Repeat num_cycles="2">{MIXED}</Repeat></Repeat>',
        4,
        "the loop around it would end too",
    ),
    "a number of attempts": (f'\n<RetryUntilSuccessful num_attempts="3">{ASK}</RetryUntilSuccessful>', 4, "never fail"),
    "attempts at an action": (f'<RetryUntilSuccessful num_attempts="-1">{ACT}</RetryUntilSuccessful>', 3, "never fail"),
    "an interruption": (f"<ReactiveSequence>{ASK}{LATER}</ReactiveSequence>", 3, "stops what is under way"),
    "an interruption by another way": (f"<ReactiveFallback>{ASK}{LATER}</ReactiveFallback>", 3, "stops what is under"),
    "a while that is asked each tick": (f"<WhileDoElse>{ASK}{ACT}</WhileDoElse>", 3, "stops what is under way"),
    "a failure on purpose": (f"<ForceFailure>{ACT}</ForceFailure>", 3, "counts on actions that fail"),
    "a script": ('<Script code="x:=1"/>', 3, "works with the blackboard"),
    "a script on a node": ('<Wheel.Stop\n_skipIf="x"/>', 4, "_skipIf on <Wheel.Stop> is a script"),
    "the blackboard": ('<Wheel.Advance\nspeed="{goal}"/>', 4, "read from the blackboard"),
    "a node of nobody": ("<Wheel.Stopp/>", 3, "“Wheel.Stopp” is no call of the robot `mini-robot`"),
    "a node of several parts": ("<Stop/>", 3, "“Stop” is no call"),
    "a kind without a counterpart": (f"<RunOnce>{ACT}</RunOnce>", 3, "has no counterpart"),
    "an action that asks": ('<Action ID="Button.IsPressed"/>', 3, "cannot be an action"),
    "a condition that acts": ('<Condition ID="Wheel.Stop"/>', 3, "cannot be a condition"),
    "a value as an action": ('<Action ID="Captor.Value"/>', 3, "cannot be an action"),
    "an action turned round": (f"<Inverter>{ACT}</Inverter>", 3, "there is an action in it"),
    "a choice by an action": (f"<IfThenElse>{ACT}{ACT}</IfThenElse>", 3, "must be a condition"),
    "a port of nobody": ('<Wheel.Advance spede="5"/>', 3, "has no port “spede”"),
    "a number that is none": ('<Wheel.Advance speed="fast"/>', 3, "expected a whole number from 0 to 100 in speed"),
    "a number outside its range": ('<Wheel.Advance speed="101"/>', 3, "found “101”"),
    "a value that is more": ('<Wheel.Advance speed="Captor.Value(); Wheel.Stop()"/>', 3, "expected a whole number"),
    "nodes in an action": (f"<Wheel.Stop>{ASK}</Wheel.Stop>", 3, "a call of the robot holds none"),
    "a time between two units": ('<Sleep msec="150"/>', 3, "expected a multiple of 100 in msec"),
    "no time": ("<Sleep/>", 3, "in msec"),
    "no number of times": (f"<Repeat>{ACT}</Repeat>", 3, "in num_cycles"),
    "less than for ever": (f'<Repeat num_cycles="-2">{ACT}</Repeat>', 3, "in num_cycles"),
    "too few nodes": ("<Sequence/>", 3, "expected ≥ 1, found 0"),
    "too many nodes": (f"<Inverter>{ASK}{ASK}</Inverter>", 3, "expected 1, found 2"),
    "branches that are stopped": (f'<Parallel success_count="1">{ACT}{ACT}</Parallel>', 3, "success_count -1"),
    "no such tree": ('<SubTree ID="Other"/>', 3, "there is no tree “Other”"),
    "a tree in itself": ('<SubTree ID="T"/>', 3, "the tree “T” is inside itself"),
}


def found_in(xml: str) -> list[Diagnostic]:
    file, found = read_trees(xml.encode(), "t.xml")
    if file is None:
        return found
    program, refused = tree_to_lll(file, ROBOT)
    assert not refused or program.items == []
    return found + refused


def tree(inside: str) -> str:
    return f'<root BTCPP_format="4">\n<BehaviorTree ID="T">\n{inside}\n</BehaviorTree>\n</root>'


@pytest.mark.parametrize("name", REFUSED)
def test_what_no_program_says_is_refused_at_its_line(name: str) -> None:
    inside, line, words = REFUSED[name]
    found = found_in(tree(inside))
    assert [item.is_error for item in found] == [True], found
    assert found[0].place is not None
    assert (found[0].place.line, words in found[0].message) == (line, True), found


TAKEN = {
    f"<ReactiveSequence>{ASK}{ACT}</ReactiveSequence>": "[Button.IsPressed()]( Wheel.Stop(); );\n",
    f'<ParallelAll max_failures="1">{ACT}{LATER}</ParallelAll>': "//(\n  Wheel.Stop();,\n  Door.Open();\n);\n",
    f"<KeepRunningUntilFailure>{LATER}</KeepRunningUntilFailure>": "*( Door.Open(); );\n",
    f'<RetryUntilSuccessful num_attempts="-1"><Sequence>{ASK}{ACT}</Sequence></RetryUntilSuccessful>': (
        "<Button.IsPressed()>( Wheel.Stop(); );\n"
    ),
    f'<Repeat num_cycles="-1"><Sequence>{ASK}{LATER}</Sequence></Repeat>': "*[Button.IsPressed()]( Door.Open(); );\n",
    f'<Repeat num_cycles="3"><Sequence>{LATER}{ASK}</Sequence></Repeat>': (
        "3*(\n  Door.Open();\n  [!(Button.IsPressed())]( BREAK; );\n);\n"
    ),
    '<Control ID="Sequence"><Action ID="Flag.Set" value="true"/></Control>': "Flag.Set(1);\n",
    '<Wheel.Advance speed="Captor.Value()"/>': "Wheel.Advance(Captor.Value());\n",
    '<PenUp _description="up" name="x"/>': "Pen.PenUp();\n",
    f'<Repeat num_cycles="2"><Fallback><Sequence>{ASK}{ACT}</Sequence>{ASK}<Light.IsRed/></Fallback></Repeat>': (
        "2*(\n  [Button.IsPressed()](\n    Wheel.Stop();\n  )!(\n"
        "    [!(Button.IsPressed() | Light.IsRed())]( BREAK; );\n  );\n);\n"
    ),
    '<Wheel_Advance speed="7"/>': "Wheel.Advance(7);\n",
    '<Sleep msec="0"/>': "WAIT(0);\n",
}


@pytest.mark.parametrize("inside", TAKEN)
def test_what_a_program_says_is_taken(inside: str) -> None:
    file, found = read_trees(tree(inside).encode(), "t.xml")
    assert file is not None, found
    program, found = tree_to_lll(file, ROBOT)
    assert found == []
    assert print_program(program) == TAKEN[inside]


@pytest.mark.parametrize(
    ("xml", "words"),
    [
        ("<root/>", 'expected BTCPP_format="4" on <root>, found none'),
        ('<root BTCPP_format="3"/>', "found “3”"),
        ('<root BTCPP_format="4"/>', "expected a <BehaviorTree>"),
        ('<root BTCPP_format="4"><BehaviorTree ID="T"/></root>', "expected 1, found 0"),
        (tree(ACT).replace("<root", '<root main_tree_to_execute="U"'), "there is no tree “U”"),
        (tree(ACT).replace("</root>", f'<BehaviorTree ID="U">{ACT}</BehaviorTree></root>'), "several trees"),
        (tree(ACT).replace("</root>", f'<BehaviorTree ID="T">{ACT}</BehaviorTree></root>'), "is there already"),
        (tree(ACT).replace("</root>", '<include path="more.xml"/></root>'), "files inside files are not read"),
        ('<robot name="x"/>', "expected <root> as the first element"),
        (tree("<Action/>"), 'expected ID="…" on <Action>'),
        (tree(ACT)[:-20], "found the end of the file"),
        ('<!DOCTYPE root [<!ENTITY a "b">]>' + tree(ACT), "found a <!DOCTYPE …>"),
        (tree("<Sequence>" * 70 + ACT + "</Sequence>" * 70), "elements inside one another"),
        (tree(f"<Sequence>{ACT * (MAX_NODES + 1)}</Sequence>"), f"expected at most {MAX_NODES} nodes"),
        ("", "found an empty file"),
        ("\0" * 100, "zero"),
    ],
)
def test_what_is_no_tree_is_told(xml: str, words: str) -> None:
    found = found_in(xml)
    assert found[0].is_error
    assert words in found[0].message, found


def test_trees_that_hold_each_other_twice_do_not_grow_without_end() -> None:
    levels = "".join(
        f'<BehaviorTree ID="T{at}"><Sequence>' + f'<SubTree ID="T{at + 1}"/>' * 2 + "</Sequence></BehaviorTree>"
        for at in range(40)
    )
    xml = tree('<SubTree ID="T0"/>').replace("</root>", f'{levels}<BehaviorTree ID="T40">{ACT}</BehaviorTree></root>')
    (found,) = found_in(xml.replace("<root", '<root main_tree_to_execute="T"'))
    assert found.code == "tree-size"


@pytest.mark.parametrize("kind", ["Sequence", "Fallback"])
def test_very_many_conditions_are_a_sentence(kind: str) -> None:
    pair = f"{ASK}<Fallback>{ASK}{ACT}</Fallback>" if kind == "Sequence" else ASK
    (found,) = found_in(tree(f"<{kind}>{pair * 900}{ACT}</{kind}>"))
    assert found.code == "tree-size"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("//(°Wheel.Stop()°;, WAIT(1););", "a marked action"),
        ("WAIT(1); BREAK;", "`BREAK` outside a loop"),
        ("Button.IsPressed();", "`Button.IsPressed` as an instruction"),
        ("*(" * 61 + "WAIT(1);" + ");" * 61, "inside one another"),
    ],
)
def test_what_no_tree_says_is_told_at_its_place(text: str, words: str) -> None:
    parsed = parse(text)
    _, found = lll_to_tree(parsed.program, ROBOT, parsed.source, "p")
    assert words in found[0].message, found
    assert found[0].program == "p"


def test_the_palette_is_all_that_the_robot_does_and_is_asked() -> None:
    text = write_tree(lll_to_tree(parse("").program, ROBOT, parse("").source)[0], "main", ROBOT)
    assert '<Action ID="Motor_Stop">\n      <MetadataFields><Metadata kitrobot="Motor.Stop"/>' in text
    assert '<Condition ID="Captor_LessThan">\n      <input_port name="value" type="int"' in text
    assert "Captor.Value" not in text
    assert len(set(call_ids(ROBOT).values())) == len(ROBOT.calls)
