"""Random teams for tests: robots of every device with random settings, random programs, walls, lines and roads."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from functools import cache

from kitrobot.compiler.compilation import CompiledProgram, compile_text
from kitrobot.graph.model import empty_program
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.mission.radio import Radio
from kitrobot.mission.trial import Failure
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot import Robot
from kitrobot.sim.simulation import Simulation
from kitrobot.world.geometry import Corner, Pose
from kitrobot.world.model import (
    COLOURS,
    WARM,
    ZONE_KINDS,
    ColouredLine,
    Dock,
    Floor,
    Road,
    Section,
    Start,
    Storehouse,
    Wall,
    World,
    Zone,
)
from tests.sim.building import avatar

SIZE = 3000.0
ROADS = (
    Road(
        "ring",
        100,
        True,
        (Corner(300, 300, 200), Corner(2700, 300, 200), Corner(2700, 2700, 200), Corner(300, 2700, 200)),
        (Section(7, 0, 1500), Section(8, 1500, 4000), Section(9, 4000, 9000)),
    ),
    Road("lane", 100, False, (Corner(1500, 200), Corner(1500, 2800))),
)
DOCKS = (Dock("in", "ring", 1000, 60, "A", "load"), Dock("out", "lane", 900, 60, "B", "unload"))


def _tests(name: str, least: int, most: int, device: str, settings: str) -> str:
    return f"""<sensor name="{name}" device="{device}" min="{least}" max="{most}" {settings}>
      <operation name="LessThan" test="less"><parameter name="value" min="{least}" max="{most}"/></operation>
      <operation name="EqualTo" test="equal"><parameter name="value" min="{least}" max="{most}"/></operation>
      <operation name="Value" value="yes"/></sensor>"""


def _settings(rng: random.Random, noise: int) -> str:
    words = []
    if rng.random() < 0.3:
        words.append(f'latency="{rng.choice((10, 20, 60, 130))}"')
    if rng.random() < 0.3:
        words.append(f'dropout="{rng.choice((5, 50))}"')
    if rng.random() < 0.3 and noise:
        words.append(f'noise="{rng.randint(1, noise)}"')
    return " ".join(words)


def _board_parts(rng: random.Random) -> list[str]:
    """What is on a small board: a display, a buzzer, a pin each way, a key, an accelerometer, chance; devices of one's
    own.
    """
    moments = " ".join(f"{at / 10}:{rng.randint(0, 100)}" for at in range(0, 20, 4))

    def parameters(*names: str) -> str:
        return "".join(f'<parameter name="{name}" min="0" max="100"/>' for name in names)

    return [
        f"""<actuator name="Display" device="display" delay="{rng.choice((10, 35))}" {_settings(rng, 0)}>
        <procedure name="Clear"/><procedure name="Image">{parameters("number")}</procedure>
        <procedure name="Number">{parameters("value")}</procedure>
        <procedure name="Scroll" completes="later" stop="Clear">{parameters("value")}</procedure>
        <procedure name="Pixel" completes="later">{parameters("x", "y", "brightness")}</procedure></actuator>""",
        f"""<actuator name="Music" device="music" {_settings(rng, 0)}>
        <procedure name="Tone" completes="later" stop="Stop">{parameters("frequency", "duration")}</procedure>
        <procedure name="Play" completes="later" stop="Stop">{parameters("melody")}</procedure>
        <procedure name="Stop"/></actuator>""",
        f"""<actuator name="Pin" device="pin-out" {_settings(rng, 0)}>
        <procedure name="Write">{parameters("value")}</procedure>
        <procedure name="Servo">{parameters("angle")}</procedure></actuator>""",
        _tests("Key", 0, 1, "key", _settings(rng, 20)),
        _tests("Tilt", -2000, 2000, "accelerometer", _settings(rng, 20) + rng.choice((' axis="z"', ' what="shake"'))),
        _tests("Wire", 0, 1023, "pin-in", _settings(rng, 20)),
        _tests("Chance", 1, 6, "random", _settings(rng, 0)),
        f"""<actuator name="Gauge" device="indicator" shows="{rng.choice(("lamp", "bar", "sound", "number"))}"
        time="{rng.choice((0, 110))}" {_settings(rng, 20)}><procedure name="Rest"/><procedure name="Full"/>
        <procedure name="Show" completes="{rng.choice(("now", "later"))}" stop="Rest">{parameters("value")}</procedure>
        </actuator>""",
        _tests("Knob", 0, 100, "slider", _settings(rng, 20) + ' initial="7"'),
        _tests("Day", 0, 100, "schedule", f'values="{moments}" between="{rng.choice(("line", "steps"))}" repeat="1.9"'),
        _tests("Luck", 0, 1, "chance", _settings(rng, 0) + ' period="70"'),
    ]


@cache
def robot(number: int) -> Robot:
    """A robot kind: the devices of a carrier, of someone at a dock, or of one that drives where it likes."""
    rng = random.Random(number)

    def some(noise: int = 20) -> str:
        return _settings(rng, noise)

    parts = [
        '<variable name="Own" type="integer" min="0" max="100"/>',
        '<variable name="All" type="integer" min="0" max="50" shared="yes"/>',
        '<variable name="Go" type="boolean" initial="true" shared="yes"/>',
    ]
    kind = number % 3
    if kind == 2:
        parts.append(
            f"""<actuator name="Arm" device="arm" time="{rng.choice((100, 300))}" {some()}>
            <procedure name="Load" completes="later"/><procedure name="Unload" completes="later"/></actuator>"""
        )
        parts.append(_tests("Presence", 0, 1, "presence", some() + ' carrier="any"'))
        parts.append(_tests("Store", 0, 50, "store", some(3)))
    else:
        guide = 'guide="road"' if kind == 1 else ""
        if kind == 0 and number % 2:
            for side in ("left", "right"):
                parts.append(
                    f"""<actuator name="{side.title()}" device="wheel" side="{side}" speed="{rng.choice((200, 900))}"
                    track="{rng.choice((40, 80))}" length="{rng.choice((60, 120))}" {some()}>
                    <procedure name="Forward" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
                    <procedure name="Backward" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
                    <procedure name="Stop"/></actuator>"""
                )
        else:
            parts.append(
                f"""<actuator name="Wheel" device="drive" {guide} speed="{rng.choice((200, 900))}"
                length="{rng.choice((60, 120))}" width="50" {some()}>
                <procedure name="Advance" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
                <procedure name="Reverse" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
                <procedure name="DriveBy" completes="later" stop="Stop">
                <parameter name="distance" min="0" max="100"/></procedure>
                <procedure name="BackBy" completes="later" stop="Stop">
                <parameter name="distance" min="0" max="100"/></procedure>
                <procedure name="Stop"/></actuator>"""
            )
            parts.append(
                f"""<actuator name="Motor" device="turn" rate="{rng.choice((90, 720))}" {some()}>
                <procedure name="AbsoluteTurn" completes="later" stop="Stop">
                <parameter name="angle" min="0" max="100"/><parameter name="speed" min="0" max="100"/></procedure>
                <procedure name="Turn" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
                <procedure name="RightBy" completes="later" stop="Stop">
                <parameter name="angle" min="0" max="360"/></procedure>
                <procedure name="Stop"/></actuator>"""
            )
        parts.append(
            f"""<actuator name="Door" device="door" time="{rng.choice((50, 400))}" {some()}>
            <procedure name="Open" completes="later"/><procedure name="Close" completes="later"/></actuator>"""
        )
        parts.append(_tests("Captor", 0, 100, "range", f'{some()} angle="{rng.randint(-90, 90)}"'))
        parts.append(_tests("Floor", 0, 3, "colour", f'{some()} ahead="{rng.randint(0, 60)}"'))
        parts.append(_tests("Near", 0, 1, "collision", some()))
        parts.append(_tests("Cargo", 0, 1, "cargo", some()))
        if kind == 1:
            parts.append(_tests("Sign", 0, 9, "sign", some(2)))
    parts.append(
        f"""<actuator name="Lamp" device="lamp" {_settings(rng, 0)}>
        <procedure name="LightOn" stop="LightOff"/><procedure name="LightOff"/></actuator>"""
    )
    parts.append(
        f"""<actuator name="Switch" device="switch" {_settings(rng, 0)}>
        <procedure name="SwitchOn"/><procedure name="SwitchOff"/></actuator>"""
    )
    parts.append(_tests("Button", 0, 1, "button", some()))
    parts += [_tests(f"Feels{at}", 0, 90, name, "") for at, name in enumerate(("temperature", "sound", "brightness"))]
    if rng.random() < 0.6:
        parts += _board_parts(rng)
    parts.sort(key=lambda part: ("<actuator" not in part, "<sensor" not in part))
    return avatar(*parts, tick=rng.choice((10, 20, 20, 30)), name=f"kind-{number}")


def program(rng: random.Random, of: Robot) -> str:
    """A program that ends only sometimes, and never reacts for ever without waiting."""
    return f"*[Go.IsTrue()]( {_body(rng, of, 0)} [Own.EqualTo(100)]( Own.Set(0); ) );"


def _test(rng: random.Random, of: Robot) -> str:
    sensor = rng.choice(of.sensors)
    name, value = sensor.name, max(0, rng.randint(sensor.minimum, sensor.maximum))
    return rng.choice((f"{name}.LessThan({value})", f"{name}.EqualTo({value})", f"Own.LessThan({rng.randint(1, 99)})"))


def _call(rng: random.Random, of: Robot) -> str:
    if rng.random() < 0.3:
        return rng.choice(
            (
                "Own.Add(1);",
                f"All.Set({rng.randint(0, 50)});",
                "All.Add(1);",
                f"WAIT({rng.randint(1, 3)});",
                f"Own.Set({rng.randint(0, 100)});",
            )
        )
    actuator = rng.choice(of.actuators)
    method = rng.choice(actuator.methods)
    return f"{actuator.name}.{method.name}({', '.join(str(rng.randint(0, 100)) for _ in method.parameters)});"


def _body(rng: random.Random, of: Robot, depth: int) -> str:
    parts = []
    for _ in range(rng.randint(1, 4)):
        kind = rng.random()
        if depth > 2 or kind < 0.55:
            parts.append(_call(rng, of))
        elif kind < 0.8:
            parts.append(f"[{_test(rng, of)}]( {_body(rng, of, depth + 1)} )!( {_body(rng, of, depth + 1)} )")
        elif kind < 0.9:
            parts.append(f"{rng.randint(2, 3)}*( {_body(rng, of, depth + 1)} );")
        else:
            parts.append(f"//( {_body(rng, of, depth + 1)}, {_body(rng, of, depth + 1)} );")
    return " ".join(parts)


def random_team(
    seed: int, robots: int, failures: Sequence[Failure] = (), fail_rate: float = 0.0, radio: Radio | None = None
) -> Simulation:
    """A run of so many robots before its first step; the same for the same numbers."""
    rng = random.Random(seed)
    side = max(4, math.ceil(math.sqrt(robots)) + 1)
    spacing = max(150.0 if robots > 50 else 350.0, SIZE / (side + 1))
    size = max(SIZE, spacing * (side + 1))
    walls = [Wall(0, 0, size, 0), Wall(size, 0, size, size), Wall(size, size, 0, size), Wall(0, size, 0, 0)]
    places = [((n % side + 1) * spacing, (n // side + 1) * spacing) for n in range(side * (side - 1))]
    rng.shuffle(places)
    for _ in range(rng.choice((0, 3, 30)) if robots < 50 else robots // 4):
        x, y = rng.choice(places)
        walls.append(Wall(x + spacing / 2, y, x + spacing / 2, y + 70))
    mission, images, catalogue = (
        Mission(team=Team(), failures=list(failures), radio=radio),
        dict[ImageName, CompiledProgram](),
        Catalogue(robots={}),
    )
    kinds = [robot(rng.randrange(30)) for _ in range(min(robots, 6))]
    for number, kind in enumerate(kinds):
        mission.programs.append(empty_program(f"p{number}", kind.name))
        images[ImageName(f"p{number}")] = compiled = compile_text(program(rng, kind), kind)
        assert compiled.ok, compiled.diagnostics
        catalogue.robots[kind.name] = kind
    starts: list[Start] = []
    taken: list[tuple[float, float]] = []
    for n in range(robots):
        number = n % len(kinds)
        guided = any(part.settings.get("guide") == "road" for part in kinds[number].actuators)
        if any(part.device == "arm" for part in kinds[number].actuators):
            starts.append(Start(f"r{n}", dock=rng.choice(("in", "out"))))
        else:
            road = rng.choice(ROADS)
            at, (x, y) = 130.0 * (n % 20), places[n]
            if guided:
                pose = road.line.pose_at(at)
                x, y = pose.x_mm, pose.y_mm
            if any(math.hypot(x - other_x, y - other_y) < 125 for other_x, other_y in taken):
                continue
            taken.append((x, y))
            pose = Pose(x, y, rng.uniform(-3, 3))
            starts.append(Start(f"r{n}", road=road.name, at_mm=at) if guided else Start(f"r{n}", pose=pose))
        mission.team.agents.append(Agent(f"r{n}", f"p{number}"))
    lines = tuple(
        ColouredLine(colour, 40, (Corner(rng.uniform(50, 900), 50), Corner(rng.uniform(900, 2500), 2500)))
        for colour in rng.sample(tuple(COLOURS), rng.randrange(4))
    )
    floors = tuple(
        Floor(colour, tuple(Corner(x + dx, y + dy, 90) for dx, dy in ((0, 0), (300, 0), (300, 300), (0, 300))))
        for colour, (x, y) in zip((*COLOURS,)[::2], places[: rng.randrange(3)], strict=False)
    )
    houses = (Storehouse("A", 0, 0, 100, 100, 9, 4), Storehouse("B", 500, 0, 100, 100, 9, 1))
    zones = tuple(
        Zone(kind, x, y, *((200, 0, 0) if kind == WARM else (0, 300, 200)), 80, rng.choice((0, 300)))
        for kind, (x, y) in zip(ZONE_KINDS, places[: rng.randrange(4)], strict=False)
    )
    world = World("anywhere", size, size, tuple(walls), lines, ROADS, DOCKS, houses, tuple(starts), floors, zones=zones)
    return Simulation(mission, world, images, catalogue, seed, 600, fail_rate)
