"""A kit as it was measured: wheels, distance, turn; and the simulator, which then agrees with the floor."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from kitrobot.boards.calibration import (
    Answers,
    MeasureError,
    WheelTurn,
    calibrated,
    left_out,
    measuring_steps,
    own_place,
    write_kit_file,
)
from kitrobot.files.disk import read_text
from kitrobot.primitives.catalogue import SHIPPED
from kitrobot.primitives.kit import Kit, Measurement
from kitrobot.primitives.kit_xml import read_kit, write_kit
from kitrobot.workspace.conversion import convert
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.mission_run import RunOptions

TICK_MS = 20
SPEED, RATE = 287.0, 143.0
"""Of the floor: full speed in mm/s and degrees a second, while the kit's file says something else."""


def kit_named(name: str) -> Kit:
    path = SHIPPED / f"{name}.board.xml"
    kit, found = read_kit(path.read_bytes(), str(path))
    assert kit is not None, found
    return kit


def settings(kit: Kit, device: str) -> dict[str, str]:
    return dict(next(part.board.settings for part in kit.parts if device in part.devices and not part.when))


def measured(kit: Kit) -> dict[str, dict[str, str]]:
    return {one.devices[0]: dict(one.settings) for one in kit.measured}


# -- what the answers change


def test_a_motor_that_is_wired_backward_is_flipped_and_once_more_is_as_it_was() -> None:
    kit = kit_named("pico")
    seen = {"left": WheelTurn("left", False), "right": WheelTurn("right", True)}
    made = calibrated(kit, Answers(seen))
    assert settings(made, "drive")["left-flipped"] == "yes"
    assert "right-flipped" not in settings(made, "drive")
    roads = [part.board.settings for part in made.parts if part.board.driver == "road"]
    assert [one["left-flipped"] for one in roads] == ["yes"]
    assert calibrated(made, Answers(seen)) == kit
    assert calibrated(kit, Answers({"left": WheelTurn("left", True)})) == kit


def test_wheels_that_are_each_other_s_are_exchanged_with_what_belongs_to_a_motor() -> None:
    kit = kit_named("cardboard")
    was = settings(kit, "drive")
    made = settings(
        calibrated(kit, Answers({"left": WheelTurn("right", True), "right": WheelTurn("left", False)})), "drive"
    )
    for name in ("forward", "backward", "power"):
        assert (made[f"left-{name}"], made[f"right-{name}"]) == (was[f"right-{name}"], was[f"left-{name}"])
    assert made["left-flipped"] == "yes"
    assert "right-flipped" not in made


def test_what_cannot_be_is_refused_with_a_way_out() -> None:
    pico = kit_named("pico")
    for answers, says in (
        (Answers({"left": WheelTurn("left", True), "right": WheelTurn("left", True)}), "both times the left wheel"),
        (Answers(distances=[0.0]), "1 to 20000 millimetres"),
        (Answers(distances=[math.nan]), "found nan"),
        (Answers(turns=[1e9]), "1 to 3600 degrees"),
        (Answers(turns=[-90.0]), "found -90"),
    ):
        with pytest.raises(MeasureError, match=says) as refused:
            calibrated(pico, answers)
        assert refused.value.help
    with pytest.raises(MeasureError, match="has no word for that"):
        calibrated(kit_named("maqueen"), Answers({"left": WheelTurn("left", False)}))
    with pytest.raises(MeasureError, match="no wheels"):
        measuring_steps(kit_named("microbit"))


def test_distance_and_turn_become_speed_and_rate_and_what_lies_between_the_answers_is_noise() -> None:
    made = calibrated(kit_named("pico"), Answers(distances=[290.0, 310.0], turns=[300.0]))
    assert measured(made)["drive"] == measured(made)["wheel"] == {"speed": "300", "noise": "4.7"}
    assert measured(made)["turn"] == {"rate": "150"}
    assert settings(made, "turn")["rate"] == "150"
    again = calibrated(made, Answers(turns=[370.0, 350.0]))
    assert measured(again)["drive"] == measured(made)["drive"]
    assert settings(again, "turn")["rate"] == "150"


def test_a_robot_that_counts_edges_gets_their_number_and_one_with_a_gyroscope_keeps_its_file() -> None:
    kit = kit_named("pico")
    for more, name, value in (({"counts": "400"}, "counts", "480"), ({"gyro": "lsm6dso"}, "rate", "180")):
        parts = tuple(
            replace(part, board=replace(part.board, settings={**part.board.settings, **more}))
            if "turn" in part.devices
            else part
            for part in kit.parts
        )
        made = calibrated(replace(kit, parts=parts), Answers(turns=[300.0]))
        assert settings(made, "turn")[name] == value
        assert "turn" not in measured(made)


def test_what_was_measured_is_written_read_and_put_beside_the_missions_and_never_into_what_is_shipped(
    tmp_path: Path,
) -> None:
    kit = kit_named("pico")
    made = calibrated(kit, Answers(distances=[300.0], turns=[300.0]))
    assert read_kit(write_kit(made).encode(), "pico.board.xml")[0] == made
    assert own_place("pico", kit, tmp_path) == tmp_path / "pico.board.xml"
    assert own_place(str(SHIPPED / "pico.board.xml"), kit, tmp_path) == tmp_path / "pico.board.xml"
    own = tmp_path / "mine.board.xml"
    assert own_place(str(own), kit, tmp_path) == own
    write_kit_file(made, own)
    assert read_kit(read_text(own).encode(), "x")[0] == made


def test_a_kit_of_ones_own_keeps_its_comments_and_what_it_loses_is_told(tmp_path: Path) -> None:
    path = tmp_path / "mine.board.xml"
    text = write_kit(replace(kit_named("pico"), name="mine"))
    path.write_text("<!-- Red wire to the left. -->\n" + text.replace("<tried", "<!-- by Ada --><tried to='me'", 1))
    kit, _ = read_kit(path.read_bytes(), path.name)
    assert kit is not None
    found, _ = left_out(path)
    assert [one.message for one in found] == ["<tried> has no attribute “to”; it is left out"]
    write_kit_file(calibrated(kit, Answers({"left": WheelTurn("left", False)})), path)
    for words in ("<!-- Red wire to the left. -->", "<!-- by Ada -->", "left-flipped"):
        assert words in path.read_text()
    assert left_out(path)[0] == left_out(tmp_path / "none")[0] == ()


@pytest.mark.parametrize(
    "text",
    ['<measured device="drive" speed="fast"/>', '<measured device="drive" speed="-1"/>', '<measured speed="1"/>'],
)
def test_a_measured_value_that_is_no_number_is_told_and_the_file_gives_no_kit(text: str) -> None:
    kit, found = read_kit(f'<board name="k" version="1">{text}</board>'.encode(), "k.board.xml")
    assert kit is None
    assert found


# -- the floor


def floor() -> Kit:
    """The body as it is, whatever a kit's file says of it."""
    return Kit(
        "floor",
        "machine",
        measured=(Measurement(("drive",), {"speed": str(SPEED)}), Measurement(("turn",), {"rate": str(RATE)})),
    )


def end_of(tmp_path: Path, text: str, kit: Kit) -> tuple[float, float, float]:
    """Where a simulated body stands after a program, from where it began: mm ahead, mm to the left, degrees."""
    robot = read_text(SHIPPED / "mini-robot.robot.xml").replace('name="mini-robot"', 'name="mini"', 1)
    robot = robot.replace('wait-unit="100"', f'wait-unit="{TICK_MS}"', 1)
    (tmp_path / "mini.robot.xml").write_text(robot, encoding="utf-8")
    (tmp_path / "drive.lll").write_text(text, encoding="utf-8")
    convert(tmp_path / "drive.lll", tmp_path / "drive.krt", robot="mini")
    run = open_mission(tmp_path / "drive.krt").prepare(RunOptions(seconds=60.0, kit=kit)).simulation
    x, y, heading = run.poses()[0][:3]
    while run.outcome is None:
        run.advance(50)
    to_x, to_y, to_heading = run.poses()[0][:3]
    ahead = (to_x - x) * math.cos(heading) + (to_y - y) * math.sin(heading)
    aside = (to_y - y) * math.cos(heading) - (to_x - x) * math.sin(heading)
    return ahead, aside, math.degrees(to_heading - heading) % 360


def by_the_clock(kit: Kit, degrees: int) -> str:
    """A turn as the driver `turn` of that kit does it: it ends in the first tick in which enough time has gone by."""
    ticks = math.ceil(degrees * 1000 / (int(settings(kit, "turn")["rate"]) * 0.5) / TICK_MS)
    return f"Motor.Turn(50); WAIT({ticks}); Motor.Stop();"


def square(turn: str) -> str:
    return f"4*( Wheel.Advance(40); WAIT({1000 // TICK_MS}); Wheel.Stop(); WAIT(25); {turn} WAIT(25); ); WAIT(25);"


def test_the_simulator_takes_speed_and_noise_from_what_was_measured(tmp_path: Path) -> None:
    drives = f"Wheel.Advance(100); WAIT({1000 // TICK_MS}); Wheel.Stop(); WAIT(50);"

    def distance(noise: str) -> float:
        values = {"speed": "300", "noise": noise}
        kit = Kit("k", "machine", measured=(Measurement(("drive",), values),))
        return end_of(tmp_path, drives, kit)[0]

    assert distance("0") == distance("0") == pytest.approx(300, rel=0.05)
    assert abs(distance("20") - distance("0")) > 1


def test_a_square_on_the_floor_and_in_the_simulator_agree_within_two_percent_after_calibrating(tmp_path: Path) -> None:
    kit = kit_named("pico")
    drives = f"Wheel.Advance(50); WAIT({2000 // TICK_MS}); Wheel.Stop(); WAIT(50);"
    distance, aside, _ = end_of(tmp_path, drives, floor())
    assert aside == pytest.approx(0, abs=1e-6)
    _, _, turned = end_of(tmp_path, by_the_clock(kit, 360), floor())
    made = calibrated(kit, Answers(distances=[distance], turns=[turned]))
    told = measured(made)
    assert float(told["drive"]["speed"]) == pytest.approx(SPEED, rel=0.005)
    assert float(told["turn"]["rate"]) == pytest.approx(RATE, rel=0.01)
    exact = square("Motor.AbsoluteTurn(25, 50);")
    way = 4 * 0.4 * SPEED
    for part in ("4*", "3*", "2*"):
        seen = end_of(tmp_path, square(by_the_clock(made, 90)).replace("4*", part, 1), floor())
        simulated = end_of(tmp_path, exact.replace("4*", part, 1), made)
        assert math.dist(seen[:2], simulated[:2]) < 0.02 * way, part
        assert abs((seen[2] - simulated[2] + 180) % 360 - 180) < 8, part
    before = end_of(tmp_path, square(by_the_clock(kit, 90)), floor())
    assert math.dist(before[:2], end_of(tmp_path, exact, kit)[:2]) > 0.1 * way
