"""A robot that any board can play: its drivers, beside the program, take every command and move nothing."""

from __future__ import annotations

from pathlib import Path

from kitrobot.boards.programs import load_board_program
from kitrobot.primitives.robot import Robot
from kitrobot.robots.program import BoardProgram
from kitrobot.workspace.robots import find_robot

ROBOT = """<robot name="bench" version="1" tick="20" wait-unit="20">
  <actuator name="Motor" device="any"><board driver="stores" pin="1"/>
    <procedure name="Turn" completes="later" stop="Stop">
      <parameter name="angle" min="0" max="100" default="25"/>
    </procedure>
    <procedure name="Stop"/>
  </actuator>
  <actuator name="Wheel" device="any"><board driver="stores" pin="2"/>
    <procedure name="Advance" stop="Stop"><parameter name="speed" min="0" max="100" default="50"/></procedure>
    <procedure name="Stop"/>
  </actuator>
  <sensor name="Captor" device="any" min="0" max="100"><board driver="zero"/>
    <operation name="LessThan" test="less"><parameter name="value" min="0" max="100" default="50"/></operation>
    <operation name="GreaterThan" test="greater"><parameter name="value" min="0" max="100" default="50"/></operation>
  </sensor>
  <variable name="Count" type="integer" min="-1000" max="1000" initial="0"/>
  <variable name="Run" type="boolean" initial="true"/>
</robot>
"""
STORES = """class Stores:
    def __init__(self, settings):
        self.settings = settings
        self.mark = {mark!r}

    def do(self, procedure, arguments):
        pass

    def done(self):
        return True

    def stop(self):
        pass


def make(settings):
    return Stores(settings)
"""
ZERO = """class Zero:
    def read(self):
        return 0


def make(settings):
    return Zero()
"""
ONE = "*[Run.IsTrue()]([Captor.LessThan(90)](Count.Add(1); )!(Wheel.Advance(20); ); Motor.Turn(5); WAIT(2); );\n"
OTHER = """*[Run.IsTrue()](
  [Captor.LessThan(10)](Motor.Turn(25); )!(Wheel.Advance(50); Count.Add(3); );
  [Captor.GreaterThan(90)](Wheel.Stop(); )!();
);
"""
TURNS = """//(
  *[Run.IsTrue()]([Captor.GreaterThan(50)](Wheel.Advance(80); )!(Motor.Turn(90); ); WAIT(1); ),
  *[Run.IsTrue()](Count.Add(7); [Captor.LessThan(20)](Wheel.Stop(); )!(); WAIT(3); )
);
"""
PROGRAMS = (ONE, OTHER, TURNS, "Wheel.Advance(30); WAIT(4); Motor.Turn(10); Wheel.Stop();")


def bench_program(folder: Path, text: str = ONE, mark: str = "one") -> BoardProgram:
    """A program for it, ready to be sent; another `mark` makes its driver another one."""
    folder.mkdir(exist_ok=True)
    (folder / "bench.robot.xml").write_text(ROBOT, encoding="utf-8")
    (folder / "stores.driver.py").write_text(STORES.format(mark=mark), encoding="utf-8")
    (folder / "zero.driver.py").write_text(ZERO, encoding="utf-8")
    path = folder / "program.lll"
    path.write_text(text, encoding="utf-8")
    return load_board_program(path, robot=str(folder / "bench.robot.xml"))


def bench_robot(folder: Path) -> Robot:
    """The robot of programs that were made in a folder."""
    return find_robot(str(folder / "bench.robot.xml"))
