"""Parts of kinds that are nobody's but the robot's XML: what stands for them in the simulator is what a check knows."""

from __future__ import annotations

import pytest

from kitrobot.checking.verification import VerificationOptions, verify_runs
from kitrobot.checking.verification_result import Verification
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.model.timing import Timing
from tests.sim.building import empty_world, run_of

GARDENER = b"""<robot name="gardener" version="1">
  <help>Waters a bed when it is dry, by day.</help>
  <actuator name="Pump" device="water-pump">
    <simulate as="indicator" shows="bar" time="500"/>
    <procedure name="Run" stop="Rest"><parameter name="power" min="0" max="100"/></procedure>
    <procedure name="Rest"/>
  </actuator>
  <actuator name="Bell" device="bell">
    <simulate as="indicator" shows="sound" time="300"/>
    <procedure name="Ring" completes="later"/>
  </actuator>
  <sensor name="Moisture" device="soil-probe" min="0" max="100">
    <simulate as="slider" initial="10"/>
    <operation name="LessThan" test="less"><parameter name="value"/></operation>
  </sensor>
  <sensor name="Light" device="photo-cell" min="0" max="100">
    <simulate as="schedule" values="0:0 5:90 15:90 20:0" between="line" repeat="24"/>
    <operation name="MoreThan" test="greater"><parameter name="value"/></operation>
  </sensor>
</robot>"""
WATERS = "<Moisture.LessThan(30)>( Bell.Ring(); ); //( WAIT(2); <Light.MoreThan(%s)>(%s);, \xb0Pump.Run(80)\xb0; );"


def checked(light: int, then: str, timing: Timing) -> Verification:
    robot, problems = read_robot(GARDENER, "gardener.robot.xml")
    assert robot is not None, problems

    def fresh(seed: int) -> Simulation:
        return run_of({"a": (robot, WATERS % (light, then))}, empty_world(a=(200.0, 200.0, 0.0)), seed=seed)

    return verify_runs(fresh, 1, VerificationOptions((), (timing,), seconds=None))


@pytest.mark.parametrize("timing", Timing)
def test_sensors_may_read_anything_and_actuators_end_at_any_time(timing: Timing) -> None:
    made = checked(20, "", timing)
    assert [str(limit) for limit in made.limits] == ["Light of a is taken to read anything at any time"]
    assert {one.verdict.property.name: one.verdict.answer.value for one in made.columns[0].findings} == {
        "deadlock": "holds",
        "stopped": "holds",
    }


@pytest.mark.parametrize(("light", "is_shown"), [(20, True), (95, False)])
def test_what_goes_wrong_is_told_with_what_they_read_and_confirmed_where_the_simulator_reads_so(
    light: int, is_shown: bool
) -> None:
    """On the schedule of its XML it never is brighter than 90."""
    [column] = checked(light, "Pump.Run(10);", Timing.LOCKSTEP).columns
    [finding] = [one for one in column.findings if one.verdict.property.name == "stopped"]
    assert finding.verdict.answer.value == "broken"
    assert (finding.confirmed is not None) == is_shown
    told = [str(text) for _, text in finding.story]
    assert told[0].startswith("a reads Moisture = ")
    assert told[1:3] == ["a has done what takes it longer", f"a reads Light = {light + 1}"]
    assert (told[3:] == []) == is_shown
