"""What a program is on a board: the pieces of Python that `kitrobot_onboard.boot` does one by one, and the arrays.

They name every file that the program needs. They are written for one kind of board and one set of drivers, so that the
board has nothing to look up: it compiles the interpreter first, while there is most room, then the loop, then the
drivers, each from large to small, and then reads the arrays, which need no more room than they keep. Of the orders that
were tried on the micro:bit of 2016 this one leaves the most room in one piece (docs/reference/boards.md).
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator, Sequence

from kitrobot.deploy.errors import PackageError
from kitrobot.deploy.package import MODULE, Built, pieces, short, words
from kitrobot.deploy.program_file import LIMIT_S, UNUSED, Device, ProgramFile
from kitrobot.image import Image
from kitrobot_onboard import state
from kitrobot_onboard.image import load

_NAME = re.compile(r"\$(\w+)")
_MOST = 9999
"""Bytes that a piece may have."""


def board_file(program: ProgramFile | None, built: Built) -> bytes:
    """The program file for a board with this package. Without a program it has the loop, and nothing to do."""
    return b"".join(_parts(program, built))


def _parts(program: ProgramFile | None, built: Built) -> Iterator[bytes]:
    yield _piece(f"from {built.interpreter} import $tick")
    yield _file(built.port, built)
    yield _piece(f"$asked={built.asked!r};$package={built.module[len(MODULE) :]!r}")
    yield from map(_entry, pieces("begin"))
    if program is not None:
        yield from _numbers(program)
    yield from map(_entry, words())
    for name in built.loop:
        yield _file(name, built)
    if program is not None:
        for _, parts in sorted(_devices(program.devices, built), key=lambda job: -job[0]):
            yield from parts
        yield from _arrays(program)
    yield _piece("$file=$file.close()")


def _devices(devices: Sequence[Device], built: Built) -> Iterator[tuple[int, list[bytes]]]:
    """Each driver with its size, and what is made of it: a driver that is not needed any more is forgotten then."""
    actuators = places = -1
    lines: dict[str, list[str]] = {}
    for device in devices:
        actuators += device.kind == "a"
        if device.driver == UNUSED:
            continue
        places += device.kind == "a"
        given = 2 if device.kind == "a" else 3
        settings = dict(word.split("=", 1) for word in device.words[given:])
        if device.kind == "a":
            limit = int(float(settings.get("limit", LIMIT_S)) * 1000)
            done = "0" if device.words[0] == "-" else device.words[0]
            where = f"a{actuators} {device.driver} "
            kept = f"$robot[{state.ACTUATORS}].append([$driver,{done},{limit},None,65535,{places},{actuators}])"
        else:
            cell, least, most = device.words[:3]
            if built.wants_range[device.driver]:
                settings = {"min": least, "max": most} | settings
            where = f"s{cell} {device.driver} "
            kept = f"$robot[{state.SENSORS}].append((getattr($driver,'read',$driver),{cell},{least},{most}))"
        make = f"$where={_literal(where)};$driver=$space['make']({_literal(settings)})"
        lines.setdefault(device.driver, []).extend([make, kept])
    for driver, made in lines.items():
        name = built.drivers[driver]
        size = len(built.files[name])
        first = f"{made[0].partition(';')[0]};$space={{}};exec(open({name!r}).read({size}),$space)"
        yield size, list(map(_piece, [first, *made, "$driver=$space=$where=0"]))


def _numbers(program: ProgramFile) -> Iterator[bytes]:
    """What stands in the list beside the arrays."""
    image = Image.from_bytes(program.image)
    names = [name for _, name, _, _ in program.commands]
    kinds = [2 * count + later for _, _, count, later in program.commands]
    while names and not names[-1]:
        names.pop()
        kinds.pop()
    visible = 1 + image.inputs + image.variables
    for place, value in (
        (state.PROCEDURES, tuple(names)),
        (state.KINDS, bytes(kinds)),
        (state.INPUTS, image.inputs),
        (state.VISIBLE, visible),
        (state.PERIOD, image.tick_ms),
        (state.STATE, 2),
    ):
        yield _piece(f"$robot[{place}]={_literal(value)}")


def _arrays(program: ProgramFile) -> Iterator[bytes]:
    image = Image.from_bytes(program.image)
    code, cells, threads, pars, out = load(program.image)
    # Only actuators that are used have a place in `out`.
    places = {number: place for place, number in enumerate(program.used_actuators)}
    first = len(pars) - len(image.commands)
    width = pars[3]
    pars[first:] = [width * places.get(actuator, 0) for actuator in image.commands]
    del out[width * len(places) :]
    threads[:] = [-1, 0] * (len(threads) // 2)
    threads[0] = pars[5]
    first = 1 + image.inputs
    yield _piece("from array import array")
    yield _array(state.CELLS, "i", cells)
    yield _array(state.FIRST, "i", cells[first : first + image.variables + image.counters])
    yield _array(state.PARS, "h" if max(pars) < 1 << 15 else "i", pars)
    yield _array(state.THREADS, "i", threads)
    yield _array(state.OUT, "i", out)
    yield _piece(f"$robot[{state.CODE}]=$file.read({len(code)});del array") + bytes(code)


def _array(place: int, form: str, numbers: Sequence[int]) -> bytes:
    data = struct.pack(f"<{len(numbers)}{form}", *numbers)
    return _piece(f"$robot[{place}]=array({form!r},$file.read({len(data)}))") + data


def _piece(text: str) -> bytes:
    """A piece, in which `$NAME` is what the package's modules call that on a board."""
    names = short()
    return _entry(_NAME.sub(lambda found: names.get(found[1], found[1]), text))


def _literal(value: object) -> str:
    return repr(value).replace("$", r"\x24")


def _file(name: str, built: Built) -> bytes:
    return _piece(f"exec(open({name!r}).read({len(built.files[name])}))")


def _entry(text: str) -> bytes:
    found = text.encode()
    if len(found) > _MOST:
        raise PackageError("the settings of a device are too long for a board", "make them shorter in the robot's XML")
    return b"%04d" % len(found) + found
