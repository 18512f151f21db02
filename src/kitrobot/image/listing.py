"""Image ↔ listing (`.kra`): three-address code as text, complete, so that assembling it gives the image byte for byte.

One directive or instruction a line; `;` begins a comment. Jumps name the instruction they go to.
"""

from __future__ import annotations

import re
from functools import lru_cache

from kitrobot.image.instructions import BY_NAME, BY_NUMBER, Role
from kitrobot.image.model import Image, ImageError, ParallelRecord, SlotRecord, StopRecord
from kitrobot.text.sentences import Sentence

_SIZES = ("inputs", "variables", "counters", "temporaries", "constants")
_ONCE = ("robot", "tick", "wait-unit", *_SIZES, "actuators", "arguments")
_VALUES = {
    "cell": 1,
    "slot": 4,
    "parallel": 3,
    "stop": 2,
    "command": 1,
    "code": 0,
    "bytes": 4,
    **dict.fromkeys(_ONCE, 1),
}
"""How many values each directive takes."""
_LINES = 16_384
"""Instructions whose line is remembered: the listing of an edited program is nearly the one before."""


def disassemble(image: Image) -> str:
    """The listing of an image. An instruction we do not know is written as its four bytes."""
    lines = [
        "; KitRobot three-address code. Cells: fault, inputs, variables, counters, temporaries, constants.",
        f".robot {image.fingerprint.hex()}",
        f".tick {image.tick_ms}",
        f".wait-unit {image.wait_unit_ms}",
        *(f".{size} {getattr(image, size)}" for size in _SIZES),
        f".actuators {image.actuators}",
        f".arguments {image.most_arguments}",
    ]
    kinds = ["fault"]
    for size in _SIZES:
        kinds += [f"{size[:-1] if size != 'temporaries' else 'temporary'} {n}" for n in range(getattr(image, size))]
    lines += [
        f".cell {value:<10} ; {at}: {kind}" for at, (value, kind) in enumerate(zip(image.cells, kinds, strict=True))
    ]
    lines += [
        f".slot {'-' if slot.parallel is None else slot.parallel} {slot.entry} {int(slot.marked)} {slot.end}"
        f"  ; {number}: parallel, entry, marked, end"
        for number, slot in enumerate(image.slots)
    ]
    lines += [
        f".parallel {' '.join(map(str, parallel))}  ; {number}: parent, first, end"
        for number, parallel in enumerate(image.parallels)
    ]
    lines += [f".stop {stop.slot} {stop.command}  ; {number}: slot, command" for number, stop in enumerate(image.stops)]
    lines += [f".command {actuator}  ; {number}: actuator" for number, actuator in enumerate(image.commands)]
    lines.append(".code")
    four = iter(image.code)
    lines += [f"{_instruction(*one):<24} ; {at}" for at, one in enumerate(zip(four, four, four, four, strict=True))]
    return "\n".join(lines) + "\n"


@lru_cache(_LINES)
def _instruction(number: int, a: int, b: int, c: int) -> str:
    op = BY_NUMBER.get(number)
    if op is None:
        return f"    .bytes {number} {a} {b} {c}"
    if op.jumps:
        operands = [a] if op.a is not Role.UNUSED else []
        operands.append(b + 256 * c)
        exact = op.a is not Role.UNUSED or a == 0
    else:
        pairs = [(op.a, a), (op.b, b), (op.c, c)]
        operands = [value for role, value in pairs if role is not Role.UNUSED]
        exact = all(value == 0 for role, value in pairs if role is Role.UNUSED)
    if not exact:
        return f"    .bytes {number} {a} {b} {c}"
    return f"    {op.name:<6}" + " ".join(map(str, operands)) if operands else f"    {op.name}"


def assemble(text: str, name: str = "listing.kra") -> Image:
    """The image of a listing; raises ImageError with FILE:LINE when it is not one."""
    return _Assembler(name).read(text)


class _Assembler:
    def __init__(self, name: str) -> None:
        self.name = name
        self.line = 0
        self.given: set[str] = set()
        self.single: dict[str, int] = {}
        self.fingerprint: bytes | None = None
        self.cells: list[int] = []
        self.slots: list[SlotRecord] = []
        self.parallels: list[ParallelRecord] = []
        self.stops: list[StopRecord] = []
        self.commands: list[int] = []
        self.code = bytearray()

    def wrong(self, sentence: str) -> ImageError:
        return ImageError(Sentence(f"{self.name}:{self.line}: {sentence}"))

    def number(self, word: str, low: int = 0, high: int = 65535) -> int:
        if not re.fullmatch(r"-?[0-9]{1,10}", word) or not low <= int(word) <= high:
            raise self.wrong(f"expected a whole number from {low} to {high}, found `{word[:24]}`")
        return int(word)

    def read(self, text: str) -> Image:
        for self.line, line in enumerate(text.split("\n"), 1):
            words = line.partition(";")[0].split()
            if words:
                self.directive(words) if words[0].startswith(".") else self.instruction(words)
        missing = [f".{word}" for word in _ONCE if word not in self.given]
        if missing:
            raise self.wrong(f"the listing ends without {', '.join(missing)}")
        assert self.fingerprint is not None
        sizes = {size: self.single[size] for size in _SIZES}
        if len(self.cells) != 1 + sum(sizes.values()):
            raise self.wrong(f"the sizes ask for {1 + sum(sizes.values())} cells, and {len(self.cells)} are given")
        return Image(
            fingerprint=self.fingerprint,
            tick_ms=self.single["tick"],
            wait_unit_ms=self.single["wait-unit"],
            **sizes,
            cells=tuple(self.cells),
            slots=tuple(self.slots),
            parallels=tuple(self.parallels),
            stops=tuple(self.stops),
            commands=tuple(self.commands),
            actuators=self.single["actuators"],
            most_arguments=self.single["arguments"],
            code=bytes(self.code),
        )

    def directive(self, words: list[str]) -> None:
        word, values = words[0][1:], words[1:]
        wanted = _VALUES.get(word)
        if wanted is None:
            raise self.wrong(f"`.{word[:24]}` is no directive of a listing")
        if len(values) != wanted:
            raise self.wrong(f"`.{word}` takes {wanted} value{'s' * (wanted != 1)}, found {len(values)}")
        if word in _ONCE and word in self.given:
            raise self.wrong(f"`.{word}` is given twice")
        self.given.add(word)
        match word:
            case "robot":
                if not re.fullmatch("[0-9a-f]{16}", values[0]):
                    raise self.wrong("a robot's fingerprint is 16 hexadecimal digits")
                self.fingerprint = bytes.fromhex(values[0])
            case "cell":
                self.cells.append(self.number(values[0], -(2**31), 2**31 - 1))
            case "slot":
                parallel = None if values[0] == "-" else self.number(values[0], 0, 65534)
                marked = self.number(values[2], 0, 1) == 1
                self.slots.append(SlotRecord(parallel, self.number(values[1]), marked, self.number(values[3])))
            case "parallel":
                self.parallels.append(ParallelRecord(*(self.number(value) for value in values)))
            case "stop":
                self.stops.append(StopRecord(*(self.number(value) for value in values)))
            case "command":
                self.commands.append(self.number(values[0]))
            case "bytes":
                self.code += bytes(self.number(value, 0, 255) for value in values)
            case "code":
                pass
            case _:
                self.single[word] = self.number(values[0])

    def instruction(self, words: list[str]) -> None:
        op = BY_NAME.get(words[0])
        if op is None:
            raise self.wrong(f"`{words[0][:24]}` is no instruction")
        roles = [role for role in (op.a, op.b, op.c) if role is not Role.UNUSED]
        if len(words) - 1 != len(roles):
            raise self.wrong(f"{op.name} takes {len(roles)} operand{'s' * (len(roles) != 1)}, found {len(words) - 1}")
        values = iter(words[1:])
        operands = []
        for role in (op.a, op.b) if op.jumps else (op.a, op.b, op.c):
            if role is Role.UNUSED:
                operands.append(0)
            elif role is Role.TARGET:
                target = self.number(next(values))
                operands += [target % 256, target // 256]
            else:
                operands.append(self.number(next(values), 0, 255))
        self.code += bytes([op.number, *operands])
