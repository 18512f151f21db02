"""Write docs/kits.md and the wiring pictures beside it: what kits there are, and which program runs on which; and what
kits say of themselves in other languages, docs/kits.fr.md and so on.

python -m tools.kit_pages            write them
python -m tools.kit_pages --check    only say which are not current; status 1 if there is one
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from kitrobot.boards.kit_pictures import pin_name, wiring_picture
from kitrobot.boards.kits import mission_on_kit
from kitrobot.primitives.kit import CHIP_OF_V2, Kit, KitEvidence
from kitrobot.translation.languages import LANGUAGES, TRANSLATED
from kitrobot.workspace.kit_files import kits_at_hand
from kitrobot.workspace.mission_loader import open_mission
from tools.kit_texts import page_in

REPOSITORY = Path(__file__).resolve().parents[1]
PAGE = REPOSITORY / "docs" / "kits.md"
PICTURES = REPOSITORY / "docs" / "pictures"
SMALL = Path(__file__).with_name("microbit-2016.json")
TICKS_2016 = Path(__file__).with_name("microbit-ticks.json")
ORDER = (
    "pico",
    "cardboard",
    "esp32",
    "xrp",
    "xrp-beta",
    "pololu-3pi",
    "alvik",
    "maqueen",
    "cutebot",
    "move-motor",
    "microbit",
    "microbit-v2",
)
_TRIED = {
    KitEvidence.DOCUMENTS: "from its documents: nobody has reported yet that it was tried",
    KitEvidence.EMULATOR: "in an emulator: its drivers on a current MicroPython (WebAssembly) whose pins only remember",
    KitEvidence.HAND: "in the hand, as reported by {by}",
}
_ON_V2 = (
    "in part: its drivers on a current MicroPython (WebAssembly) with a module `microbit` of the tests' own; no V2 was "
    "in a hand"
)
_FIRMWARE = "in an emulator: its drivers on the firmware of the micro:bit of 2016, in QEMU"
_HEAD = """# Kits

One robot definition runs on many kits: `NAME.board.xml` says how the parts of robots are wired on one. `kitrobot
deploy MISSION --board NAME` sends a program to it, `kitrobot check MISSION --board NAME` says part by part what it has.
[Robots' XML](xml.md#kits) explains how to write such a file. `python -m tools.kit_pages` makes this page. The texts of
the kits are also in LANGUAGES.

Each kit says how it is tested. None of them is tested on a physical board yet. Pins, addresses and
protocols come from the documents that the kit names. These figures have no document; they are **guesses** until you
look at your own robot with *Try the parts* or [`kitrobot calibrate`](boards.md#measured):

| figure | of which kits | the guess |
|---|---|---|
| `rate`, degrees a second of a turn by the clock at full speed | all without a gyroscope or encoders | 150 or 180 |
| `open`, `closed`, `time` of a servo | all with a servo | 90°, 0°, 1000 to 2000 ms (pen: 300 ms) |
| `threshold` of an eye for the ground | alvik, pololu-3pi, move-motor, xrp, xrp-beta | the middle of its readings |
| `dark="high"` of eyes for the ground that you choose yourself | pico, esp32 | high on a dark line |
| pins that the builder is free to choose | pico, cardboard, esp32, microbit, microbit-v2 | as listed |

An eye of a Maqueen (ROB0148) reads 0 on a dark line, according to Zephyr's line follower for it. A later Maqueen with
a key to calibrate its eyes reads 1, according to a course for it: write `dark="high"` into a copy of the file for that.

The motors and sensors of an Arduino Alvik are connected to a second chip, an STM32, with its own firmware. A program
restarts that chip at its start and waits up to six seconds for its answer; a robot that is switched off or falls silent
is a fault. The STM32 turns by an angle at its own speed. Its colour sensor exists in two versions: for a robot whose
board has the revision 1.6 write `revision="1.6"` into a copy of the file. A servo of an Alvik cannot be released: after
STOP it goes to its last angle.

The bumper of a Pololu 3pi+ works with light: nothing may press it while a program starts. The motors of its Hyper
Edition turn the other way: write `left-flipped="yes"` and `right-flipped="yes"` into a copy of the file.

The encoders of an XRP keep it straight: while it turns once around on the spot, one channel of both together gives 1511
edges, computed from the figures of its sources. The encoders of a 3pi+ are not used: its maker says what they count,
but not how far apart its wheels are. The STM32 of an Alvik keeps its wheels at their rates by its own encoders.

None of these kits has its motors behind an I²C chip at a board with `machine`; a file of your own may, with
`motors="pca9685"` instead of pins, as for the motor boards of Adafruit and Waveshare
([how](drivers.md#another-chip-for-motors)).

A kit with a colour sensor may read a `sign` from patches of colour (`patches`) instead of bars beside the road
(`marks`).

The kits of a micro:bit are for a V2, which nobody has tried in a hand, and, but for `microbit-v2`, for the one of 2016,
whose firmware runs in QEMU in the tests: it has 16 kB of memory. KitRobot refuses a program that certainly does not fit
before it sends it, and one that nearly fits after the board has tried it; in both cases the board keeps its earlier
program, except with `--fresh` ([figures](benchmarks.md)).
"""


@dataclass(frozen=True)
class TickRow:
    """How a program runs on a micro:bit of 2016. In ms, as median, 99 of 100 and worst: `late_ms`, by how much
    a late tick was done after the next one was due; `takes_ms`, a tick by itself; `off_ms`, how far the beginnings of
    two ticks are from a period. `free`: bytes of memory after its start and at the end. `flash`: bytes of files.
    """

    ticks: int
    late: int
    late_ms: list[int]
    takes_ms: list[float]
    off_ms: list[float]
    free: list[int]
    flash: int


def shown_kits() -> list[Kit]:
    """Those that the pages tell of."""
    found = kits_at_hand()
    return [found[name] for name in ORDER]


def pages(runs: dict[str, dict[str, str]] | None = None) -> dict[Path, str]:
    """What there has to be, by its file. `runs`: what `what_runs` says of the kits, where it was asked before."""
    kits = shown_kits()
    written = {PICTURES / f"wiring-{kit.name}.svg": wiring_picture(kit) for kit in kits if kit.supplies}
    written[PAGE] = "\n".join(
        [_head(), *_table(kits, runs or what_runs(kits)), *(line for kit in kits for line in _kit(kit))]
    )
    for language in TRANSLATED:
        written[PAGE.with_suffix(f".{language}.md")] = page_in(language, kits)
    return written


def _head() -> str:
    *front, last = (f"[{LANGUAGES[code].english}](kits.{code}.md)" for code in TRANSLATED)
    return _HEAD.replace("LANGUAGES", f"{', '.join(front)} and {last}")


def missions() -> list[Path]:
    """The missions of the gallery, of the tutorials and of the exercises."""
    return sorted((REPOSITORY / "examples").rglob("*.krt"))


def key_of(path: Path) -> str:
    """The place of a mission among the examples."""
    return path.relative_to(REPOSITORY / "examples").with_suffix("").as_posix()


def title_of(key: str) -> str:
    """What a mission is called in the table."""
    return key.rpartition("/")[2] if key.startswith(("exercises", "tutorials")) else key.partition("/")[0]


def what_runs(kits: Sequence[Kit]) -> dict[str, dict[str, str]]:
    """By mission and kit: "" when every program of it runs there, else the parts that are missing. What tutorials and
    exercises begin with uses no parts, and is left out.
    """
    rows: dict[str, dict[str, str]] = {}
    for path in missions():
        opened = open_mission(path)
        if not any(one.is_used for program in mission_on_kit(opened, kits[0]) for one in program.parts):
            continue
        row = rows[key_of(path)] = {}
        for kit in kits:
            missing: dict[str, None] = {}
            for program in mission_on_kit(opened, kit):
                if program.problem is None:
                    continue
                parts = [one.part.name for one in program.parts if one.is_used and one.is_missing]
                missing |= dict.fromkeys(parts or [program.problem.message])
            row[kit.name] = ", ".join(missing)
    return rows


def measured_2016() -> Mapping[str, Mapping[str, Mapping[str, int | str]]]:
    """What `tools.microbit_kits` found, by mission and kit: `free` bytes, or the `problem`."""
    found: Mapping[str, Mapping[str, Mapping[str, int | str]]] = json.loads(SMALL.read_text(encoding="utf-8"))
    return found


def ticks_2016() -> Mapping[str, Mapping[str, TickRow]]:
    """What `benchmarks.microbit_ticks` found, by kit and mission."""
    found = json.loads(TICKS_2016.read_text(encoding="utf-8"))
    return {kit: {mission: TickRow(**row) for mission, row in rows.items()} for kit, rows in found.items()}


def _runs(on_2016: Mapping[str, int | str] | None) -> str:
    """What a cell says of a mission that a kit has all parts for."""
    return f"V2; {on_2016['problem']}" if on_2016 is not None and "problem" in on_2016 else "yes"


def _table(kits: Sequence[Kit], runs: dict[str, dict[str, str]]) -> Iterator[str]:
    yield "## Which program runs on which kit"
    yield ""
    yield "*yes*: every program of the mission can be sent, each to a robot of that kit; else what the kit lacks. A"
    yield "test starts each *yes* of the gallery on a current MicroPython with recorded pins: its drivers begin, its"
    yield "first sixty ticks are done, with sensors that see nothing. What it gets done on the floor no test says."
    yield "*V2*: not on a micro:bit of 2016, where there is no room in its *memory* or *flash*. On its own firmware in"
    yield "QEMU each *yes* of those kits was started, stopped and started again (`python -m tools.microbit_kits`)."
    yield ""
    yield "| mission | " + " | ".join(f"[{kit.name}](#{kit.name})" for kit in kits) + " |"
    yield "|---" * (len(kits) + 1) + "|"
    small = measured_2016()
    for name, row in runs.items():
        cells = (row[kit.name] or _runs(small.get(name, {}).get(kit.name)) for kit in kits)
        yield f"| {title_of(name)} | " + " | ".join(cells) + " |"
    yield ""


def _kit(kit: Kit) -> Iterator[str]:
    yield f"## {kit.name}"
    yield ""
    yield f"**{kit.label['']}.** {kit.help['']}"
    yield ""
    is_v2 = kit.chip == CHIP_OF_V2
    firmware = kit.tried is KitEvidence.EMULATOR and kit.family == "microbit"
    tried = (_ON_V2 if is_v2 else _FIRMWARE) if firmware else _TRIED[kit.tried].format(by=kit.tried_by)
    yield f"- Known to work: *{tried}*."
    board = "MicroPython with the module `machine`"
    if kit.family == "microbit":
        board = "a micro:bit V2" if is_v2 else "a micro:bit"
    yield f"- Board: {board}" + (f", {kit.micropython} or later." if kit.micropython else ".")
    for source in kit.sources:
        yield f"- Source: [{source.text}]({source.href})"
    yield ""
    if kit.supplies:
        yield "You need:"
        yield ""
        yield from (f"- {text['']}" for text in kit.supplies)
        yield ""
        yield f"![How the parts are wired](pictures/wiring-{kit.name}.svg)"
        yield ""
        yield from _wires(kit)
        yield from (f"{number}. {text['']}" for number, text in enumerate(kit.steps, 1))
        yield ""
    yield from _ticks(kit)
    yield "| devices | driver | settings |"
    yield "|---|---|---|"
    for part in kit.parts:
        which = " ".join(f"`{device}`" for device in part.devices)
        which += f" ({' '.join(part.names)})" if part.names else ""
        which += f" where `{part.when}`" if part.when else ""
        if part.is_missing:
            yield f"| {which} | – | missing: {part.help.get('', '')} |"
        else:
            settings = " ".join(f"{name}={value}" for name, value in part.board.settings.items())
            told = f"{settings}: {part.help['']}".removeprefix(": ") if part.help else settings
            yield f"| {which} | {part.board.driver or 'as the device'} | {told} |"
    yield ""


def _wires(kit: Kit) -> Iterator[str]:
    """The picture in words: a row for each wire of the modules."""
    if not kit.modules:
        return
    names = {module.name: module.label[""] for module in kit.modules}
    yield "| from | terminal | to |"
    yield "|---|---|---|"
    for module in kit.modules:
        for wire in module.wires:
            other, _, terminal = wire.to.partition(" ")
            target = f"{names[other]}, {terminal}" if other in names else pin_name(wire.to)
            yield f"| {module.label['']} | {wire.terminal} | {target} |"
    yield ""


def _ticks(kit: Kit) -> Iterator[str]:
    rows = ticks_2016().get(kit.name, {})
    if not rows:
        if kit.family != "microbit":
            yield "Ticks and free memory on its board: *not yet measured*."
            yield ""
        return
    yield "The slowest board is the micro:bit of 2016, here in an emulator that is faster than the board"
    yield "([figures](benchmarks.md)):"
    yield ""
    yield "| program | late ticks | by, ms | a tick takes, ms | off the tick, ms | memory left, B | flash left, B |"
    yield "|---|---|---|---|---|---|---|"
    for mission, row in rows.items():
        times = " | ".join(" · ".join(f"{one:g}" for one in times) for times in (row.late_ms, row.takes_ms, row.off_ms))
        memory = " → ".join(map(str, row.free))
        yield f"| {title_of(mission)} | {row.late} of {row.ticks} | {times} | {memory} | {row.flash} |"
    yield ""


def stale(made: Mapping[Path, str]) -> list[Path]:
    """The files that say something else than what was made, or are missing."""
    return [path for path, text in made.items() if not path.is_file() or path.read_text(encoding="utf-8") != text]


def main() -> int:
    with tempfile.TemporaryDirectory() as nobody:
        os.environ["KITROBOT_CONFIG"] = nobody
        made = pages()
        wrong = stale(made)
        for path in wrong:
            if "--check" not in sys.argv:
                path.write_text(made[path], encoding="utf-8", newline="\n")
            print(path.name, "is not current" if "--check" in sys.argv else "written")
    return int(bool(wrong) and "--check" in sys.argv)


if __name__ == "__main__":
    raise SystemExit(main())
