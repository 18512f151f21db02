"""The parts of a robot tried from a page, on a board with a current MicroPython."""

from __future__ import annotations

import shutil
from pathlib import Path

from kitrobot.boards.bench import bench_of
from kitrobot.boards.bench_run import BenchRun
from kitrobot.live.robot_bench import RobotBench, steps_message
from kitrobot.translation.reader_language import override_language, translate
from kitrobot.workspace.kit_files import find_kit
from kitrobot.workspace.robots import find_robot
from tests.boards.modern import ModernBoard
from tests.boards.test_bench import UNPLUGGED

ROBOT = """<robot name="harbour" version="1">
  <actuator name="Crane"><board driver="crane"/>
    <label>Crane arm</label><label xml:lang="ur">کرین کا بازو</label>
    <procedure name="Lift" completes="later"/></actuator>
  <sensor name="Eye" min="0" max="1"><board driver="eye"/><operation name="IsOpen" test="equal" to="1"/></sensor>
</robot>
"""
CRANE = """from machine import Pin
class Crane:
    def do(self, procedure, arguments): Pin(7, Pin.OUT).value(0)
    def done(self):
        if Pin(7).value(): raise OSError(5)
        return False
    def stop(self): pass
def make(settings): return Crane()
"""
EYE = """from machine import Pin
def make(settings):
    def read():
        Pin(7).value(1)
        return 1
    return read
"""
"""Once the eye is looked at, the crane, which still lifts, fails when it is asked whether it is done."""

SQUARE = Path(__file__).resolve().parents[2] / "examples" / "square" / "square.krt"


def test_each_step_runs_until_another_one_and_tells_its_value_or_what_is_broken(visit, folder) -> None:
    shutil.copy(SQUARE, folder)
    with ModernBoard({"lib/machine.py": UNPLUGGED}) as board, visit() as page:
        mission = page.client.get("/api/mission?path=square.krt").json()["mission"]
        asked = {"mission": mission, "path": "square.krt", "program": "square", "kit": "pico"}
        page.send("bench", board.address, **asked)
        told = page.until("steps")
        names = [step["call"] or step["part"] for step in told["steps"]]
        assert told["left_out"] == []
        assert told["steps"][names.index("Wheel.Advance(40)")]["seen"]["ur"]
        # The colour sensor is on no bus, so its driver does not start, and all else is there.
        said = page.until("board", lambda said: said["phase"] == "open" and said["bench"] is not None)
        while not said["held"]:
            said = page.board(phase="open")
        colour = [at for at, step in enumerate(told["steps"]) if step["part"] == "Light" and step["call"] == ""]
        assert [one["step"] for one in said["bench"]["failed"]] == colour
        assert (said["state"], said["program"]) == ("running", "bench")

        def tried(name: str) -> int:
            page.send("try", board.address, step=names.index(name))
            return names.index(name)

        at = tried("Wheel.Advance(40)")
        page.until("board", lambda said: said["bench"] is not None and said["bench"]["step"] == at)
        at = tried("Button")
        page.until("board", lambda said: said["bench"] is not None and said["bench"]["value"] in (0, 1))
        at = tried("Captor")
        said = page.until("board", lambda said: any(one["step"] == at for one in said["bench"]["failed"]))
        # As the page calls it, and its value has a unit.
        assert "`Distance sensor` failed" in next(
            one["message"] for one in said["bench"]["failed"] if one["step"] == at
        )
        assert told["steps"][at]["reads"] == {
            "type": "integer",
            "unit": "cm",
            "meaning": {"scale": "1", "units": {"ur": "سم"}, "field": "ruler", "choices": []},
        }
        at = tried("Wheel.Reverse(40)")
        page.until("board", lambda said: said["bench"]["step"] == at and said["state"] == "running")
        page.send("try", board.address, step=None)
        page.until("board", lambda said: said["bench"]["step"] is None)
        page.send("try", board.address, step=len(names))
        assert "no step" in page.until("board", lambda said: said["message"] != "")["message"]
        page.send("stop", board.address)
        page.board(state="ready")
        # A program of the mission takes its place.
        page.send("send", board.address, then="held", **asked)
        page.until("board", lambda said: said["program"] == "square" and said["bench"] is None)


def test_a_fault_that_names_another_part_than_the_tried_one_is_told_at_the_part_that_is_named(tmp_path) -> None:
    (tmp_path / "harbour.robot.xml").write_text(ROBOT)
    (tmp_path / "crane.driver.py").write_text(CRANE)
    (tmp_path / "eye.driver.py").write_text(EYE)
    bench = bench_of(find_robot("harbour", tmp_path), None, tmp_path)
    crane, eye = bench.steps
    with ModernBoard({"lib/machine.py": UNPLUGGED}) as board, BenchRun(board.address, bench) as run:
        run.begin(crane)
        run.watch(0.1)
        tried = RobotBench(run._hand.session, bench)
        tried.hand = run._hand
        tried.do(bench.steps.index(eye))
        while not (failed := tried.shape().failed):
            run._hand.session.poll(0.1)
            tried.check()
        assert [one.step for one in failed] == [bench.steps.index(crane)]
        assert str(failed[0].message).startswith("`Crane arm` failed")
        with override_language("ur"):
            assert translate(failed[0].message).startswith("`کرین کا بازو`")
        # Where nobody sees labels it is what LLL calls it.
        assert str(tried._broken[crane.key]).startswith("`Crane` failed")


def test_what_cannot_be_tried_is_refused_and_a_robot_whose_parts_nobody_tries_takes_no_step(visit, folder) -> None:
    shutil.copy(SQUARE, folder)
    with visit() as page:
        mission = page.client.get("/api/mission?path=square.krt").json()["mission"]
        asked = {"mission": mission, "path": "square.krt", "program": "square"}
        address = "socket://127.0.0.1:1"
        page.send("bench", address, kit="spaceship", **asked)
        assert "no kit named `spaceship`" in page.until("refused")["message"]
        page.send("bench", address, kit="microbit", **{**asked, "program": "circle"})
        assert page.until("refused")["message"]
        for step in (-1, 1000, "one", True):
            page.send("try", address, step=step)
            assert page.until("refused")["address"] == ""
        page.send("try", address, step=0)
        assert "Nobody talks with this robot" in page.until("refused")["message"]


def test_a_part_that_a_kit_lacks_and_the_steps_of_the_others_are_told_in_the_language_of_the_page() -> None:
    bench = bench_of(find_robot("mini-robot"), find_kit("pololu-3pi"))
    told = {"en": "It has no range finder.", "fr": "Il n’a pas de télémètre.", "ur": "اس میں فاصلہ پیما نہیں ہے۔"}
    none = {"en": "The kit `pololu-3pi` has none.", "fr": "Le kit `pololu-3pi` n'en a pas.", "ur": "کٹ"}
    for language, why in told.items():
        with override_language(language):
            message = steps_message("COM3", bench).model_dump(mode="json")
        left_out = {part["part"]: part["why"] for part in message["left_out"]}
        assert left_out["Captor"] == why
        assert left_out["Door"].startswith(none[language])
        assert all(step["seen"]["" if language == "en" else language] for step in message["steps"])
