"""Small files to break, and the readers that must not break on them."""

from collections.abc import Callable

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.exercise.exercise_xml import read_exercise
from kitrobot.graph.graph_xml import PROGRAM
from kitrobot.graph.model import Program
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.tutorial.tutorial_xml import read_tutorial
from kitrobot.xml.attributes import version
from kitrobot.xml.element import Tag
from kitrobot.xml.reader import Reader

CONSTRUCTORS = """<constructors version="1">
  <group name="Loops" colour="loop">
    <constructor name="While" icon="rotate-cw">
      <help>Ä test &lt; — ✓</help>
      <condition name="condition"/>
      <flow name="body" loop="yes"/>
      <code>*[{condition}]({body})</code>
    </constructor>
  </group>
</constructors>
"""
ROBOT = """<robot name="tiny" version="1">
  <actuator name="Wheel" device="drive">
    <procedure name="Advance" stop="Stop"><parameter name="speed" max="100"/></procedure>
    <procedure name="Stop"/>
  </actuator>
  <sensor name="Button" type="boolean"><operation name="IsPressed" test="equal" to="1"/></sensor>
  <variable name="Count" initial="3"/>
</robot>
"""
MISSION = """<kitrobot version="1">
  <program name="p" robot="tiny">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wheel.Advance"><set name="speed">50</set><note>slowly ✓</note></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
</kitrobot>
"""
TUTORIAL = """<tutorial version="1" start="x.krt">
  <label>First steps ✓</label>
  <step>
    <label>Drive</label>
    <help>Drag Advance onto the line &lt; here.</help>
    <point part="Wheel.Advance"/>
    <contains><code>*[{test}](Wheel.Advance({speed}))</code><hole name="speed" min="30"/></contains>
    <event name="run-done"/>
  </step>
</tutorial>
"""


EXERCISE = """<exercise version="1" start="x.krt" icon="square" seconds="60">
  <label>A square ✓</label>
  <help>Once around &lt; here.</help>
  <seed value="1"/>
  <seed value="7" hidden="yes"/>
  <done points="2"><label>It ends</label><label xml:lang="fr">Il finit</label></done>
  <draws corners="4" side="150"><label>A square</label></draws>
  <parts most="12" hidden="yes"><label>At most 12 parts</label></parts>
  <holds property="deadlock"><label>Never stuck</label></holds>
</exercise>
"""


def read_programs(data: bytes, name: str) -> tuple[list[Program], list[Diagnostic]]:
    """The programs of a mission, as the mission's reader will find them."""
    reader = Reader(data, name)
    root = reader.read({"kitrobot": Tag(attributes={"version": version(1)}, children={"program": PROGRAM})})
    return (root.found(Program) if root is not None else []), reader.diagnostics


Read = Callable[[bytes, str], tuple[object, list[Diagnostic]]]

KINDS: list[tuple[str, str, Read]] = [
    ("constructors", CONSTRUCTORS, read_constructors),
    ("robot", ROBOT, read_robot),
    ("kitrobot", MISSION, read_programs),
    ("tutorial", TUTORIAL, read_tutorial),
    ("exercise", EXERCISE, read_exercise),
]


def constructors(inside: str) -> str:
    """A file with one group."""
    return f'<constructors version="1"><group name="G" colour="loop">{inside}</group></constructors>'


def robot(inside: str) -> str:
    """A file with one robot."""
    return f'<robot name="tiny" version="1">{inside}</robot>'


def messages(read: Read, text: str) -> list[str]:
    """What is wrong with a file of one line: `GUILTY | code | message`."""
    _, problems = read(text.encode(), "f.xml")
    places = [(problem.place, problem) for problem in problems if problem.place is not None]
    return [f"{text[p.column - 1 : p.end_column - 1]} | {each.code} | {each.message}" for p, each in places]
