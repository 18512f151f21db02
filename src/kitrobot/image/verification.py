"""Whether an image can be run: nothing an interpreter does with it can leave an array or fail to end.

What holds of a verified image: every operand names a cell, command, stop or parallel that exists; constants are never
written; a jump stays within its own slot; code does not run past its slot's end; every way round blocks; ADD and SUB
are clamped by the very next instruction, so that no value grows past `LARGEST_VALUE`; slots and parallels form one tree
in reading order, and each slot forks only its own parallels. `tick` relies on all of it and checks none of it.
"""

from __future__ import annotations

from itertools import pairwise

from kitrobot.image.instructions import ADD, ARM, BY_NUMBER, CLAMP, FORK, JOIN, SUB, Op, Role
from kitrobot.image.model import (
    LARGEST_VALUE,
    MOST_ARGUMENTS,
    MOST_CELLS,
    MOST_COMMANDS,
    MOST_INSTRUCTIONS,
    MOST_PARALLELS,
    MOST_SLOTS,
    MOST_STOPS,
    Image,
    ImageError,
)
from kitrobot.text.sentences import Sentence

_ANYWHERE = frozenset(
    number for number, op in BY_NUMBER.items() if not op.jumps and number not in (ADD, SUB, FORK, JOIN, ARM)
)
"""Instructions that, where they may stand once, may stand anywhere but at the end of a slot."""

_Operands = dict[int, tuple[Op, list[tuple[Role, range]]]]
"""Each instruction by its number: what the operands that name something are, and may be."""


def verify(image: Image) -> None:
    """Raises ImageError with the first thing that is wrong; returns when the image is safe to run."""
    _check_sizes(image)
    _check_tree(image)
    regions = _regions(image)
    operands = _operands(image)
    code = image.code
    fine: set[bytes] = set()
    for slot, (start, end) in enumerate(regions):
        for at in range(start, end):
            row = code[4 * at : 4 * at + 4]
            if row in fine and at + 1 < end:
                continue
            _check_instruction(image, operands, at, slot, start, end)
            if row[0] in _ANYWHERE:
                fine.add(row)
        most_instructions(image, start, end)


def most_instructions_a_tick(image: Image) -> int:
    """The most instructions one tick of a verified image can take, all slots together."""
    return sum(most_instructions(image, start, end) for start, end in _regions(image))


def _refuse(sentence: str) -> ImageError:
    return ImageError(
        Sentence("this image cannot be run: {sentence}", sentence), Sentence("make it again with `kitrobot convert`")
    )


def _check_sizes(image: Image) -> None:
    cells = len(image.cells)
    if cells != image.first_constant + image.constants or not 1 <= cells <= MOST_CELLS:
        raise _refuse(f"it has {cells} cells, and 1 to {MOST_CELLS} are possible")
    if any(abs(value) > LARGEST_VALUE for value in image.cells):
        raise _refuse(f"a cell's value is outside ±{LARGEST_VALUE}")
    if len(image.code) % 4 or not 1 <= image.instructions <= MOST_INSTRUCTIONS:
        raise _refuse("it has no whole instructions")
    slots, parallels, stops = len(image.slots), len(image.parallels), len(image.stops)
    if not 1 <= slots <= MOST_SLOTS or parallels > MOST_PARALLELS or stops > MOST_STOPS:
        raise _refuse("it has too many slots, parallels or stops")
    if len(image.commands) > MOST_COMMANDS or image.actuators > 256 or image.most_arguments > MOST_ARGUMENTS:
        raise _refuse("it has too many commands, actuators or arguments")
    if any(actuator >= image.actuators for actuator in image.commands):
        raise _refuse("a command belongs to an actuator that does not exist")
    if not image.tick_ms >= 1 or not image.wait_unit_ms >= 1:
        raise _refuse("its tick and wait unit must be at least 1 ms")


def _check_tree(image: Image) -> None:
    """Slots in preorder; a parallel's branches are all slots between its first and its end that name it."""
    slots, count = image.slots, len(image.slots)
    if slots[0].parallel is not None or slots[0].end != count or slots[0].marked:
        raise _refuse("slot 0 is not the program")
    for number, slot in enumerate(slots[1:], 1):
        if slot.parallel is None or slot.parallel >= len(image.parallels) or not number < slot.end <= count:
            raise _refuse(f"slot {number} is not a branch of a parallel")
    filled = 1
    for number, parallel in enumerate(image.parallels):
        if not (parallel.parent < parallel.first < parallel.end <= slots[min(parallel.parent, count - 1)].end):
            raise _refuse(f"parallel {number} does not lie inside its slot")
        if number and parallel.first <= image.parallels[number - 1].first:
            raise _refuse("the parallels are not in reading order")
        branch = parallel.first
        while branch < parallel.end:
            if slots[branch].parallel != number or slots[branch].end > parallel.end:
                raise _refuse(f"slot {branch} does not belong to parallel {number}")
            branch = slots[branch].end
            filled += 1
    if filled != count:
        raise _refuse("a slot belongs to no parallel")
    for stop in image.stops:
        if stop.slot >= count or stop.command >= len(image.commands) or slots[stop.slot].parallel is None:
            raise _refuse("a stop names a slot or command that does not exist")


def _regions(image: Image) -> list[tuple[int, int]]:
    """The stretch of code of each slot: from its entry to the next slot's."""
    entries = [slot.entry for slot in image.slots]
    if entries[0] != 0 or any(low >= high for low, high in pairwise(entries)):
        raise _refuse("the slots' code is not in reading order")
    if entries[-1] >= image.instructions:
        raise _refuse("a slot begins behind the last instruction")
    return list(zip(entries, [*entries[1:], image.instructions], strict=True))


def _check_instruction(image: Image, operands: _Operands, at: int, slot: int, start: int, end: int) -> None:
    number, a, b, c = image.code[4 * at : 4 * at + 4]
    known = operands.get(number)
    if known is None:
        raise _refuse(f"instruction {at} has the unknown number {number}")
    op, places = known
    if op.jumps and not start <= b + 256 * c < end:
        raise _refuse(f"instruction {at} jumps out of its slot")
    for value, (role, allowed) in zip((a, b, c), places, strict=False):
        if value not in allowed or (role is Role.COUNT and b + value > len(image.cells)):
            raise _refuse(f"instruction {at} ({op.name}) has the operand {value}, which names nothing it may use")
    if op.falls_through and at + 1 >= end:
        raise _refuse(f"instruction {at} runs past the end of its slot")
    if number in (ADD, SUB) and tuple(image.code[4 * at + 4 : 4 * at + 6]) != (CLAMP, a):
        raise _refuse(f"instruction {at} ({op.name}) is not followed by the CLAMP of its sum")
    if number == CLAMP and image.cells[b] > image.cells[c]:
        raise _refuse(f"instruction {at} clamps to an empty range")
    if number in (FORK, JOIN) and image.parallels[a].parent != slot:
        raise _refuse(f"instruction {at} ({op.name}) uses a parallel of another slot")
    if number == ARM and image.stops[a].slot != slot:
        raise _refuse(f"instruction {at} arms the stop of another slot")


def _operands(image: Image) -> _Operands:
    """Each instruction, and what its operands may be; a COUNT may also not lead past the last cell."""
    cells = len(image.cells)
    allowed = {
        Role.WRITTEN: range(image.first_constant),
        Role.READ: range(cells),
        Role.CONSTANT: range(image.first_constant, cells),
        Role.COMMAND: range(len(image.commands)),
        Role.FIRST: range(cells + 1),
        Role.COUNT: range(image.most_arguments + 1),
        Role.STOP: range(len(image.stops)),
        Role.PARALLEL: range(len(image.parallels)),
        Role.UNUSED: range(1),
    }
    roles = {number: (op.a,) if op.jumps else (op.a, op.b, op.c) for number, op in BY_NUMBER.items()}
    return {number: (op, [(role, allowed[role]) for role in roles[number]]) for number, op in BY_NUMBER.items()}


def most_instructions(image: Image, start: int, end: int) -> int:
    """The longest way through a slot's code without blocking. Raises ImageError when a way round never blocks."""
    code = image.code
    longest = [0] * (end - start)
    for at in range(end - 1, start - 1, -1):
        op = BY_NUMBER[code[4 * at]]
        if op.blocks:
            longest[at - start] = 1
            continue
        if not op.jumps and op.falls_through:
            beyond = longest[at + 1 - start]
            longest[at - start] = 1 + beyond if beyond else 0
            continue
        # Most ways lead on: then all that is behind is known already.
        most = 0
        for way in _successors(op, code, at):
            beyond = longest[way - start] if way > at else 0
            if beyond == 0:
                break
            most = max(most, beyond)
        else:
            longest[at - start] = 1 + most
    for root in range(start, end):
        if longest[root - start]:
            continue
        waiting = [root]
        while waiting:
            at = waiting[-1]
            known = longest[at - start]
            if known > 0:
                waiting.pop()
                continue
            ways = _successors(BY_NUMBER[code[4 * at]], code, at)
            if known == 0:
                longest[at - start] = -1
                for way in ways:
                    beyond = longest[way - start]
                    if beyond == -1:
                        raise _refuse(f"instruction {at} goes round to {way} without ever giving up the tick")
                    if beyond == 0:
                        waiting.append(way)
            else:
                waiting.pop()
                longest[at - start] = 1 + max((longest[way - start] for way in ways), default=0)
    return max(longest, default=0)


def _successors(op: Op, code: bytes, at: int) -> list[int]:
    """Where control can go from an instruction in the same tick."""
    if op.blocks:
        return []
    ways = [at + 1] if op.falls_through else []
    if op.jumps:
        ways.append(code[4 * at + 2] + 256 * code[4 * at + 3])
    return ways
