"""Pictures of a kit, drawn from its file: its parts seen from above, and their wiring.

Both are SVG with their own colours. A kit's file does not say where a part is on the real robot, so each kind of part
has a fixed place.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kitrobot.deploy.package.package import Package
from kitrobot.primitives.kit import Kit, KitPart, Module, Wire
from kitrobot.xml.writer import escape_text

ROW, WIDTH, BOARD, PART, OTHER = 26, 820, 150, 250, 290
_COLOURS = ("#b3261e", "#1565c0", "#2e7d32", "#6a1b9a", "#8d5a00", "#00695c")


def wiring_picture(kit: Kit) -> str:
    """The wiring: a box for each thing with its terminals on the left, the board on the right, a line for each wire.

    The things are the kit's modules; without any, its parts with the settings that name pins.
    """
    drawn: list[str] = []
    y = 56
    for number, (title, wires) in enumerate(_boxes(kit)):
        colour = _COLOURS[number % len(_COLOURS)]
        height = ROW * (len(wires) + 1)
        drawn.append(f'<rect x="16" y="{y}" width="{PART}" height="{height}" rx="8" class="part" stroke="{colour}"/>')
        drawn.append(f'<text x="28" y="{y + 19}" class="title">{escape_text(title)}</text>')
        for at, wire in enumerate(wires, 1):
            drawn += _wire(wire, y + ROW * at + 13, colour, {module.name: module for module in kit.modules})
        y += height + 12
    board = f'<rect x="{WIDTH - BOARD - 16}" y="16" width="{BOARD}" height="{y - 28}" rx="8" class="board"/>'
    label = f'<text x="{WIDTH - BOARD}" y="40" class="title pin">Raspberry Pi Pico</text>'
    style = (
        "text{font:14px sans-serif;fill:#1c1b1f}.title{font-weight:bold}.part{fill:#fff;stroke-width:2}"
        ".board{fill:#0b5d3b}.pin{fill:#fff}.wire{fill:none;stroke-width:3}.ground{fill:#f6f6f6}"
    )
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {y + 4}" role="img">'
    words = f"<title>How the parts of the kit {kit.name} are wired</title><style>{style}</style>"
    ground = f'<rect width="{WIDTH}" height="{y + 4}" class="ground"/>'
    return "\n".join([head, words, ground, board, label, *drawn, "</svg>"]) + "\n"


def _boxes(kit: Kit) -> list[tuple[str, tuple[Wire, ...]]]:
    """Titles of what is wired, each with its wires."""
    if kit.modules:
        return [(module.label.get("", module.name), module.wires) for module in kit.modules]
    package = Package()
    parts = [(part, _wires(part, kit, package)) for part in kit.parts if not part.is_missing]
    return [(" ".join(part.names or part.devices), wires) for part, wires in parts if wires]


def _wires(part: KitPart, kit: Kit, package: Package) -> tuple[Wire, ...]:
    """The settings of a part that are pins."""
    settings = part.board.settings
    known = {
        name: setting
        for device in part.devices
        for name, setting in package.declared(part.board.driver or device, kit.family).known(settings).items()
    }
    return tuple(Wire(name, pin) for name, pin in settings.items() if name in known and known[name].is_pin)


def _wire(wire: Wire, middle: int, colour: str, modules: Mapping[str, Module]) -> Iterator[str]:
    """A row of a box: a terminal, and the pin or the other module that it is wired to."""
    yield f'<text x="28" y="{middle + 5}">{escape_text(wire.terminal)}</text>'
    name, _, terminal = wire.to.partition(" ")
    if name in modules:
        end, target = WIDTH - BOARD - 16 - OTHER, f"{modules[name].label.get('', name)} {terminal}"
        yield f'<path d="M{PART + 16} {middle}H{end}" stroke="{colour}" class="wire"/>'
        yield f'<text x="{end + 6}" y="{middle + 5}">→ {escape_text(target)}</text>'
        return
    yield f'<path d="M{PART + 16} {middle}H{WIDTH - BOARD - 16}" stroke="{colour}" class="wire"/>'
    yield f'<text x="{WIDTH - BOARD}" y="{middle + 5}" class="pin">{escape_text(pin_name(wire.to))}</text>'


def pin_name(pin: str) -> str:
    """A pin as it is printed on a Pico."""
    return f"GP{pin}" if pin.isdigit() else pin


_STYLE = (
    ".body{fill:#d5dbe3;stroke:#8792a2;stroke-width:1.5}.box{fill:#d9b88a;stroke:#9a7544}.wheel{fill:#2b2f36}"
    ".board{fill:#1f7a55}.bit{fill:#20242b}.pin{fill:#e3c56b}.chip{fill:#14181d}.dark{fill:#20242b}.metal{fill:#b9c0c9}"
    ".servo{fill:#2f6fd0}.horn{stroke:#20242b;stroke-width:3;stroke-linecap:round}.red{fill:#d23b33}.green{fill:#2e9e5b}"
    ".blue{fill:#2f6fd0}.yellow{fill:#f2c02e}.violet{fill:#7a4fb5}.line{fill:none;stroke:#fff;stroke-width:1.5}"
    ".other{fill:#f7f8fa;stroke:#8792a2}.nib{fill:#8d5a00}.word{font:600 9px sans-serif;fill:#fff;text-anchor:middle}"
)
_CONTACTS = "".join(f'<path class="pin" d="M{x} 48h2v4h-2zM{x} 80h2v4h-2z"/>' for x in range(59, 101, 5))


def body_picture(kit: Kit) -> str:
    """What a kit is made of, seen from above, its front at the top: 160 wide, 130 high. A kit with a list of what is
    needed to build it has the colour of cardboard.
    """
    package = Package()
    there = [part for part in kit.parts if not (part.is_missing or _is_on_board(part, kit, package))]
    devices = {device for part in there for device in part.devices}
    rolls = bool(devices & {"drive", "turn", "wheel"})
    drawn = [*(_body(kit) if rolls else ()), *_board(kit)]
    drawn += [_PLACES[device] for device in _PLACES if device in devices]
    for part in there:
        drawn.extend(_sensor(part))
    if any("gyro" in part.board.settings for part in there):
        drawn.append('<rect class="violet" x="54" y="88" width="14" height="12" rx="2"/>')
        drawn.append('<path class="line" d="M58 96a4 4 0 1 1 5 0"/>')
    others = len(devices & _OTHERS)
    for at in range(others):
        drawn.append(f'<rect class="other" x="{80 - 6 * others + 12 * at}" y="106" width="9" height="8" rx="2"/>')
    seen = "0 0 160 130" if rolls else "24 16 112 100"
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{seen}"><style>{_STYLE}</style>'
    return head + "".join(drawn) + "</svg>"


_HEART = ("01010", "11111", "11111", "01110", "00100")
_OTHERS = frozenset({"switch", "cargo", "store", "sign", "temperature", "sound", "brightness", "accelerometer"})
"""Devices without a picture of their own; each is a small plate at the back."""

_PLACES = {
    "door": '<rect class="servo" x="106" y="22" width="12" height="18" rx="2"/><path class="horn" d="M112 28l11-9"/>',
    "arm": '<rect class="servo" x="42" y="22" width="12" height="18" rx="2"/><path class="horn" d="M48 28l-11-9"/>',
    "pen": '<circle class="nib" cx="80" cy="95" r="5"/><circle class="yellow" cx="80" cy="95" r="2"/>',
    "lamp": '<circle class="yellow" cx="48" cy="50" r="5"/>',
    "light": (
        '<circle class="red" cx="44" cy="64" r="3"/><circle class="green" cx="51" cy="64" r="3"/>'
        '<circle class="blue" cx="47.5" cy="70" r="3"/>'
    ),
    "button": '<circle class="metal" cx="112" cy="94" r="7"/><circle class="red" cx="112" cy="94" r="4"/>',
    "music": '<circle class="dark" cx="112" cy="68" r="7"/><circle class="metal" cx="112" cy="68" r="2"/>',
}
"""A drawing for each device of which a robot has one."""


def _is_on_board(part: KitPart, kit: Kit, package: Package) -> bool:
    """Whether a part belongs to a micro:bit by itself: it has no pin, and no kit around it is named."""
    return kit.family == "microbit" and "kit" not in part.board.settings and not _wires(part, kit, package)


def _body(kit: Kit) -> Iterator[str]:
    yield f'<rect class="{"body box" if kit.supplies else "body"}" x="36" y="16" width="88" height="104" rx="16"/>'
    yield from (f'<rect class="wheel" x="{x}" y="52" width="15" height="44" rx="5"/>' for x in (23, 122))


def _board(kit: Kit) -> Iterator[str]:
    if kit.family == "microbit":
        yield '<rect class="bit" x="56" y="46" width="48" height="40" rx="6"/>'
        lit = ((x, y) for y, row in enumerate(_HEART) for x, light in enumerate(row) if light == "1")
        yield from (f'<rect class="red" x="{70 + 4 * x}" y="{55 + 4 * y}" width="3" height="3"/>' for x, y in lit)
        yield from (f'<circle class="metal" cx="{x}" cy="64" r="3"/>' for x in (62, 98))
        yield "".join(f'<rect class="pin" x="{x}" y="80" width="5" height="6"/>' for x in (60, 69, 78, 87, 96))
        return
    yield f'<rect class="board" x="56" y="46" width="48" height="40" rx="4"/>{_CONTACTS}'
    yield '<rect class="chip" x="58" y="58" width="44" height="16" rx="2"/>'
    yield f'<text class="word" x="80" y="69.5">{escape_text(kit.chip.upper())}</text>'


def _sensor(part: KitPart) -> Iterator[str]:
    """The sensors that have a place of their own."""
    if "range" in part.devices:
        turn = ' transform="rotate(-90 80 66) translate(0 8)"' if part.names == ("Side",) else ""
        yield f'<g{turn}><rect class="blue" x="58" y="4" width="44" height="16" rx="3"/>'
        eyes = "".join(f'<circle class="metal" cx="{x}" cy="12" r="6.5"/>' for x in (69, 91))
        small = '<rect class="dark" x="70" y="8" width="20" height="8" rx="2"/>'
        yield (eyes if "ultrasonic" in part.board.driver else small) + "</g>"
    if "colour" in part.devices:
        for name, x in (("LeftEye", 62), ("RightEye", 88)):
            if name in part.names:
                yield f'<rect class="dark" x="{x}" y="26" width="10" height="10" rx="2"/>'
                yield f'<circle class="red" cx="{x + 5}" cy="31" r="2"/>'
        if not part.names:
            yield '<rect class="dark" x="73.5" y="24" width="13" height="14" rx="2"/>'
            yield from (
                f'<circle class="{colour}" cx="{x}" cy="{y}" r="2.2"/>'
                for colour, x, y in (("red", 77, 28), ("green", 83, 28), ("blue", 80, 34))
            )
