"""Every program of the gallery has a body, and starts on each that it has: the table of docs/kits.md, run.

All pairs of a program and a kit that can be sent run one after the other in one current MicroPython whose pins and
buses only remember: the drivers of the kit are made, then come sixty ticks with sensors that see nothing. Programs of a
whole team are started as each of their robots, without a host, so they wait. What a micro:bit shows is tried on its
firmware (test_microbit).
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import suppress

import pytest

from kitrobot.boards.programs import board_program
from kitrobot.boards.teams import agent_program
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.examples import examples_folder
from kitrobot.primitives.kit import Kit
from kitrobot.robots.program import BoardProgram
from kitrobot.workspace.example_list import shipped_examples
from kitrobot.workspace.kit_files import kits_at_hand
from kitrobot.workspace.mission_loader import OpenMission, open_mission
from tests.boards.alvik import NOTHING
from tests.boards.modern import onboard_files, run
from tests.effort import THOROUGH

TICKS = 60

PROGRAM = b"""
import binascii, json, machine, microbit, time
from kitrobot_onboard.drivers.microbit.display import NAMES as PICTURES
from kitrobot_onboard.device_setup import add_actuator, add_sensor
from kitrobot_onboard.image import load
from kitrobot_onboard.actuation import stop
from kitrobot_onboard.reaction import react
from kitrobot_onboard.state import *

machine.PINS = 48  # as an RP2350 has
machine.volts[26], machine.volts[27] = 9929, 11915  # a TMP36 at 0 degrees, a SEN0232 where it is quiet
machine.widths[16] = machine.widths[17] = 300  # the flaps of a bumper that nothing presses
machine.registers[0x29] = {}  # a colour sensor that sees nothing
machine.registers[107] = {0x0F: b"\\x6c"}  # a gyroscope LSM6DSO that lies still
SEEN_NOTHING = open("alvik.bin", "rb").read()  # by the STM32 of an Alvik
machine.partners[1] = lambda data: b"" if data else SEEN_NOTHING
for picture in PICTURES.split(","):
    setattr(microbit.Image, picture or "NONE", microbit.Image(picture))
cases = json.load(open("cases.json"))

def made(driver, settings):
    name = "kitrobot_onboard.drivers." + driver
    module = __import__(name)
    for word in name.split(".")[1:]:
        module = getattr(module, word)
    return module.make(settings)

def ran(case):
    machine.log.clear()
    machine.levels[13] = 1  # an Alvik is switched on
    robot = [None] * LENGTH
    robot[:5] = load(binascii.unhexlify(case["image"]))
    robot[SEEN] = b""
    robot[TICKS], robot[DIFF], robot[ADD] = time.ticks_ms, time.ticks_diff, time.ticks_add
    robot[SENSORS], robot[ACTUATORS], robot[FORCED] = [], [], []
    robot[COUNT], robot[STATE] = 0, 2
    robot[PROCEDURES] = [name for name, _ in case["commands"]]
    robot[KINDS] = [kind for _, kind in case["commands"]]
    for place, (kind, driver, settings, part) in enumerate(case["devices"]):
        if kind == "s":
            add_sensor(robot, made(driver, settings), part)
        elif driver:
            add_actuator(robot, made(driver, settings), part)
    while robot[COUNT] < case["ticks"] and robot[STATE] == 2 and not robot[FAILED]:
        react(robot)
    ended, failed = robot[STATE] == 3, robot[FAILED]
    robot[FAILED] = None
    stop(robot)
    failed = failed or robot[FAILED]
    return [robot[COUNT], ended, repr(failed) if failed else ""]

def step():
    if not cases:
        return False
    case = cases.pop(0)
    try:
        found = ran(case)
    except Exception as error:
        found = [0, False, repr(error)]
    print(json.dumps([case["name"]] + found))
    return True
"""


def programs(opened: OpenMission, kit: Kit) -> Iterator[tuple[str, BoardProgram]]:
    """The programs of a mission on a kit, that of a team for each of its kinds of robots."""
    folder = opened.path.parent if opened.path is not None else None
    for program in opened.mission.programs:
        if program.level.is_team:
            agents = {agent.robot: agent.name for agent in opened.mission.team.agents if agent.program == program.name}
            for kind, agent in agents.items():
                yield f"{program.name} of {kind}", agent_program(opened, agent, folder, kit)
        else:
            yield program.name, board_program(opened, program.name, folder, kit)


Bodies = dict[str, dict[str, list[tuple[str, BoardProgram]]]]
"""By mission and kit the programs that can be sent there; only kits that have all that they use."""


@pytest.fixture(scope="module")
def bodies(tmp_path_factory: pytest.TempPathFactory) -> Bodies:
    """Those of the gallery, on kits that come along: in the usual profile each mission on one of them, by turns."""
    folder = examples_folder()
    assert folder is not None
    found: Bodies = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_CONFIG", str(tmp_path_factory.mktemp("nobody")))
        kits = list(kits_at_hand().items())
        for number, mission in enumerate(shipped_examples().examples):
            opened, there = open_mission(folder / mission), found.setdefault(mission, {})
            first = number % len(kits)
            for name, kit in kits[first:] + kits[:first]:
                with suppress(KitRobotError):
                    there[name] = list(programs(opened, kit))
                    if not THOROUGH:
                        break
    return found


def case_of(name: str, family: str, ready: BoardProgram) -> dict[str, object]:
    """What MicroPython needs to begin a program."""
    devices = []
    for place, device in enumerate(ready.file.devices):
        if device.kind == "t":
            continue
        words = device.words
        settings = dict(word.split("=", 1) for word in words[2 if device.kind == "a" else 3 :])
        shared = device.driver in ("random", "team")
        driver = f"{'any' if shared else family}.{device.driver.replace('-', '_')}"
        if device.kind == "s":
            part = [int(word) for word in words[:3]]
            settings = {"min": words[1], "max": words[2], **settings}
        else:
            part = [0 if words[0] == "-" else int(words[0]), 30_000, place, place]
            driver = "" if device.driver == "unused" else driver
        devices.append((device.kind, driver, settings, part))
    commands = [(call, 2 * count + later) for _, call, count, later in ready.file.commands]
    return {
        "name": name,
        "image": ready.file.image.hex(),
        "devices": devices,
        "commands": commands,
        "ticks": TICKS,
    }


def test_every_mission_of_the_gallery_has_a_body(bodies: Bodies) -> None:
    folder = examples_folder()
    assert folder is not None
    shown = {path.relative_to(folder).as_posix() for path in folder.glob("*/*.krt")}
    assert {mission for mission in shown if not mission.startswith("exercises/")} == bodies.keys()
    assert [mission for mission, there in bodies.items() if not any(there.values())] == []


def test_every_program_of_the_gallery_starts_on_each_of_its_bodies_and_does_ticks_without_a_fault(
    bodies: Bodies,
) -> None:
    kits = kits_at_hand()
    cases = [
        case_of(f"{mission} · {name} on {kit}", kits[kit].family, ready)
        for mission, there in bodies.items()
        for kit, ready_ones in there.items()
        for name, ready in ready_ones
    ]
    given = {"cases.json": json.dumps(cases).encode(), "alvik.bin": NOTHING, "gallery.py": PROGRAM}
    files = onboard_files() | given
    found = [json.loads(line) for line in run(files, "gallery.py").splitlines()]
    assert [name for name, *_ in found] == [case["name"] for case in cases]
    assert [(name, problem) for name, _, _, problem in found if problem] == []
    assert [name for name, ticks, ended, _ in found if ticks < TICKS and not ended] == []
