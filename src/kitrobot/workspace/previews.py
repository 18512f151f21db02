"""Previews: the first seconds of a mission, recorded from a real run and cached by the mission's content.

A preview is whole numbers, frame by frame: poses of agents, what displays show, the stock of storehouses, and what pens
drew. Its key is a digest of the mission, its world, and the files of parts that it brings along, so a change of any of
them gives another key. Previews of shipped missions are made by `tools/previews.py` and shipped in one file; others are
made on first request and cached in memory. A stretch of any run is recorded alike. Left to others:
which missions are shown, and drawing.
"""

from __future__ import annotations

import hashlib
import json
import math
import threading
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from functools import cache
from pathlib import Path
from typing import Any

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.mission.writer import write_mission
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.pens import pens_of
from kitrobot.trace.drawing import Drawing
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.mission_run import RunOptions, prepare
from kitrobot.workspace.traces import parts_of
from kitrobot.world.xml_writer import write_world

VERSION = 1
"""Part of each key: another one where previews are made in another way."""

MOST_S = 30.0
"""Simulated seconds that a preview shows, at most."""
TICKS_A_POINT = 5
"""Steps of the simulator between two snapshots: a tenth of a second."""
MOST_FRAMES = 80
"""A longer run is shown in fewer frames: it plays faster."""
MOST_CACHED = 200
"""Previews in memory."""
MOST_STRETCH = 1_500
MOST_POSES = 12_000
"""Frames, and poses of all agents together, of a stretch of a run."""

SHIPPED_PREVIEWS = Path(__file__).parent / "shipped" / "previews.jsonl"
"""A line each: the key, a space, the preview as JSON."""


@dataclass(frozen=True)
class Hand:
    """What somebody does with a sensor in a preview: it says `value` from a moment on, for so many seconds."""

    agent: str
    sensor: str
    value: int
    at_s: float
    seconds: float


@dataclass(frozen=True)
class Preview:
    """The first seconds of a run in `frames` pictures.

    Attributes:
        agents: of each its name, program, robot and number within its kind.
        seconds: how long the run took that is shown.
        frames: how many there are.
        ways: of each agent five numbers a frame: x and y in mm, the heading in thousandths of a radian, load, flags; of
            one that never changes only the first five.
        shown: (frame, agent, actuator, numbers): from that frame on it shows them.
        stock: (frame, storehouse, boxes): from that frame on there are so many.
        things: of each thing that can be pushed x and y in mm, as `ways`.
        pens: of each pen the agent that has it.
        marks: (frame, pen, what, x, y, colour, width): points of lines, as `trace.Mark`.
    """

    agents: list[list[Any]]
    seconds: float
    frames: int
    ways: list[list[int]]
    shown: list[list[Any]]
    stock: list[list[Any]]
    things: list[list[int]]
    pens: list[int]
    marks: list[list[int]]


@dataclass(frozen=True)
class _Snapshot:
    """A moment of a run, in whole numbers."""

    poses: list[list[int]]
    shown: list[Mapping[str, list[int]]]
    stock: Mapping[str, int]
    things: list[list[int]]


def key_of(opened: OpenMission, seconds: float, hands: Sequence[Hand] = ()) -> str:
    """By what a preview is known; its mission has a world."""
    assert opened.world is not None
    parts = [(part.file, part.text) for part in parts_of(opened)]
    digest = hashlib.sha256(write_mission(opened.mission) + write_world(opened.world))
    digest.update(repr((VERSION, seconds, [asdict(hand) for hand in hands], parts)).encode(errors="surrogatepass"))
    return digest.hexdigest()[:32]


def make_preview(opened: OpenMission, seconds: float = MOST_S, hands: Sequence[Hand] = ()) -> Preview:
    """Runs a mission and records it.

    Raises:
        KitRobotError: it cannot run.
    """
    run = prepare(opened, RunOptions(seconds=seconds)).simulation
    run.stays_plain = True
    drawing = Drawing(pens_of(run.members))
    snapshots = [_snapshot(run)]
    while run.outcome is None:
        _hold(run, hands)
        run.advance(TICKS_A_POINT)
        drawing.add(run.drawn)
        snapshots.append(_snapshot(run))
    apart = max(1, math.ceil((len(snapshots) - 1) / (MOST_FRAMES - 1)))
    # The end belongs to what is shown.
    chosen = [*snapshots[:-1:apart], snapshots[-1]]
    return _preview_of(run, chosen, drawing, 0, TICKS_A_POINT * apart)


def record_stretch(run: Simulation, first: int, last: int, apart: int) -> tuple[Preview, list[Event]]:
    """Records a run between two of its steps, and what happened from there on; it stands before its first step.

    `apart`: how many steps lie between two frames (`stretch_apart`). There are fewer frames where the run ends sooner.
    """
    drawing = Drawing(pens_of(run.members))
    while run.tick < first and run.outcome is None:
        run.advance(first - run.tick)
        drawing.add(run.drawn)
    snapshots, events = [_snapshot(run)], []
    while run.tick < last and run.outcome is None:
        run.advance(apart)
        drawing.add(run.drawn)
        snapshots.append(_snapshot(run))
        events += run.events
    return _preview_of(run, snapshots, drawing, first, apart), events


def stretch_apart(first: int, last: int, agents: int) -> int:
    """How many steps lie between two frames of a stretch: one, as long as they are not too many."""
    most = max(2, min(MOST_STRETCH, MOST_POSES // max(1, agents)))
    return max(1, math.ceil((last - first) / (most - 1)))


def _preview_of(run: Simulation, chosen: Sequence[_Snapshot], drawing: Drawing, first: int, apart: int) -> Preview:
    """These moments of a run, the first after step `first`, `apart` steps from one to the next."""
    return Preview(
        agents=[[one.name, one.program, one.robot.name, one.number] for one in run.members],
        seconds=round(run.seconds, 2),
        frames=len(chosen),
        ways=[_way([snapshot.poses[at] for snapshot in chosen]) for at in range(len(run.members))],
        shown=[
            [frame, at, name, numbers]
            for at in range(len(run.members))
            for frame, name, numbers in _changes([snapshot.shown[at] for snapshot in chosen])
        ],
        stock=[list(change) for change in _changes([snapshot.stock for snapshot in chosen])],
        things=[_way([snapshot.things[at] for snapshot in chosen]) for at in range(len(chosen[0].things))],
        pens=[pen.agent for pen in drawing.pens],
        marks=[
            [min(len(chosen) - 1, max(0, math.ceil((mark.tick - first) / apart))), *mark[1:]] for mark in drawing.marks
        ],
    )


def _hold(run: Simulation, hands: Sequence[Hand]) -> None:
    """Holds and lets go of what somebody holds at this moment."""
    for hand in hands:
        since = run.seconds - hand.at_s
        if 0 <= since < hand.seconds:
            run.force(hand.agent, hand.sensor, hand.value)
        elif hand.seconds <= since < hand.seconds + 0.2:
            run.force(hand.agent, hand.sensor, None)


def _snapshot(run: Simulation) -> _Snapshot:
    things = run.state.pushables.floats
    return _Snapshot(
        [[round(x), round(y), round(heading * 1000), load, flags] for x, y, heading, load, flags in run.poses()],
        [one.shown for one in run.agents],
        dict(run.stock),
        [[round(x), round(y)] for x, y in zip(things[0], things[1], strict=True)],
    )


def _way(points: list[list[int]]) -> list[int]:
    moves = any(point != points[0] for point in points)
    return [number for point in (points if moves else points[:1]) for number in point]


def _changes(snapshots: Sequence[Mapping[str, Any]]) -> list[tuple[int, str, Any]]:
    """(frame, name, value) wherever a value is another one than before."""
    found: list[tuple[int, str, Any]] = []
    known: dict[str, Any] = {}
    for frame, snapshot in enumerate(snapshots):
        for name, value in snapshot.items():
            plain = [int(number) for number in value] if isinstance(value, list | tuple) else value
            if name not in known or known[name] != plain:
                known[name] = plain
                found.append((frame, name, plain))
    return found


# -- found again


class Previews:
    """Previews by what the missions say. Safe to use from many threads: what two make at once is the same."""

    def __init__(self, shipped: Mapping[str, str] | None = None) -> None:
        self._shipped = shipped_previews() if shipped is None else shipped
        self._made: OrderedDict[str, Preview | None] = OrderedDict()
        self._lock = threading.Lock()
        self.runs = 0
        """How many had to be made."""

    def of(self, opened: OpenMission, seconds: float = MOST_S, hands: Sequence[Hand] = ()) -> Preview | None:
        """The preview of a mission; None of one that cannot run."""
        if opened.world is None:
            return None
        key = key_of(opened, seconds, hands)
        with self._lock:
            if key in self._made:
                self._made.move_to_end(key)
                return self._made[key]
        preview = preview_from(self._shipped.get(key, ""))
        if preview is None:
            self.runs += 1
            try:
                preview = make_preview(opened, seconds, hands)
            except KitRobotError:
                preview = None  # opening the mission says what is wrong
        with self._lock:
            self._made[key] = preview
            while len(self._made) > MOST_CACHED:
                self._made.popitem(last=False)
        return preview


def preview_text(preview: Preview) -> str:
    """A preview as a line of the file of those that ship."""
    return json.dumps(asdict(preview), separators=(",", ":"), ensure_ascii=False)


def preview_from(text: str) -> Preview | None:
    """A preview from its line; None of one that is damaged, or not there."""
    try:
        found = json.loads(text)
    except ValueError:
        return None
    names = {field.name for field in fields(Preview)}
    return Preview(**found) if isinstance(found, dict) and found.keys() == names else None


def read_previews(path: Path) -> dict[str, str]:
    """The lines of a file of previews by their keys; none of a file that is not there."""
    try:
        lines = path.read_text(encoding="utf-8").split("\n")
    except (OSError, UnicodeError):
        return {}
    return {key: text for key, _, text in (line.partition(" ") for line in lines) if text}


@cache
def shipped_previews() -> Mapping[str, str]:
    """Those that come with KitRobot."""
    return read_previews(SHIPPED_PREVIEWS)
