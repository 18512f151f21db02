"""The program file as the board executes it: the pieces of Python for `kitrobot_onboard.boot`, and the arrays.

The pieces name every file that the program needs. They are generated for one family of boards and one set of drivers,
so that the board looks nothing up: after the start that all programs share (`kitrobot.deploy.package.start_script`) the
devices are made, from large to small, and then the arrays are read, which need no more memory than they keep. Of the
orders that were measured on the micro:bit of 2016 this one leaves the largest free block (docs/reference/boards.md).
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence

from kitrobot.deploy.package.board_package import BoardPackage
from kitrobot.deploy.package.content_names import MODULE
from kitrobot.deploy.package.onboard_bundle import join_statements
from kitrobot.deploy.package.program_file import LIMIT_S, UNUSED, Device, ProgramFile
from kitrobot.deploy.package.start_script import begun, piece
from kitrobot.image.model import Image
from kitrobot_onboard import state
from kitrobot_onboard.image import load

_MADE = f"$robot[{state.ACTUATORS}][-1]"
"""The actuator that was made last."""

_TENDED = f"{_MADE}[0].stop();$robot[{state.TENDS}].append(({_MADE},{_MADE}[0].tend))"
"""One that does something by itself stands still before it does."""


def board_file(program: ProgramFile | None, built: BoardPackage) -> bytes:
    """The program file for a board with this package. Without a program it has the loop, and nothing to do."""
    return b"".join(_parts(program, built))


def _parts(program: ProgramFile | None, built: BoardPackage) -> Iterator[bytes]:
    yield begun(built.start, built.module[len(MODULE) :])
    if program is not None:
        yield from _numbers(program)
        if program.is_member:
            yield piece(f"exec(open({built.member!r}).read({len(built.files[built.member])}))")
        for _, parts in sorted(_devices(program.devices, built), key=lambda job: -job[0]):
            yield from parts
        yield piece("$space=$where=0")
        yield from _arrays(program)
    yield piece("$file=$file.close()")


def _devices(devices: Sequence[Device], built: BoardPackage) -> Iterator[tuple[int, list[bytes]]]:
    """Each driver with its size, and what is made of it: a driver that is not needed any more is forgotten then."""
    actuators = places = -1
    lines: dict[str, list[tuple[str, str]]] = {}
    for device in devices:
        actuators += device.kind == "a"
        if device.driver == UNUSED or device.kind == "t":
            continue
        places += device.kind == "a"
        given = 2 if device.kind == "a" else 3
        settings = dict(word.split("=", 1) for word in device.words[given:])
        if device.kind == "a":
            limit = int(float(settings.get("limit", LIMIT_S)) * 1000)
            done = 0 if device.words[0] == "-" else int(device.words[0])
            where, add = f"a{actuators} {device.driver} ", "$add_actuator"
            kept = f"{done},{limit},{places},{actuators}"
        else:
            cell, least, most = device.words[:3]
            if built.wants_range[device.driver]:
                settings = {"min": least, "max": most} | settings
            where, add = f"s{cell} {device.driver} ", "$add_sensor"
            kept = f"{cell},{least},{most}"
        made = f"{add}($robot,$space['make']({_literal(settings)}),({kept}))"
        pieces = lines.setdefault(device.driver, [])
        pieces.append((f"$where={_literal(where)};", made))
        if device.kind == "a" and device.driver in built.tends:
            pieces.append(("", _TENDED))
    based: dict[str, list[bytes]] = {}
    for driver, made_of_it in lines.items():
        base = built.bases.get(driver, "")
        job = based.setdefault(base or driver, [])
        where, executed = made_of_it[0][0], _executed(built.drivers[driver], built, built.in_lines.get(driver, ""))
        if not base:
            executed = f"$space={{}};{executed}"
        elif not job:
            job.append(piece(f"{where}$space={{}};{_executed(base, built)}"))
        job.append(piece(where + executed))
        job.extend(piece(where + made) for where, made in made_of_it)
    for name, job in based.items():
        yield len(built.files[built.drivers.get(name, name)]), job


def _executed(name: str, built: BoardPackage, called: str = "") -> str:
    """Executes a driver's file; `called`: with the numbers of its lines, under that name."""
    read = f"open({name!r}).read({len(built.files[name])})"
    if not called:
        return f"exec({read},$space)"
    level = "import micropython;micropython.opt_level"
    return f"{level}(0);exec(compile({read},{_literal(called)},'exec'),$space);micropython.opt_level(3)"


def _numbers(program: ProgramFile) -> Iterator[bytes]:
    """What stands in the list beside the arrays."""
    image = Image.from_bytes(program.image)
    names = [name for _, name, _, _ in program.commands]
    kinds = [2 * count + later for _, _, count, later in program.commands]
    while names and not names[-1]:
        names.pop()
        kinds.pop()
    visible = 1 + image.inputs + image.variables
    values = {
        state.PROCEDURES: tuple(names),
        state.KINDS: bytes(kinds),
        state.INPUTS: image.inputs,
        state.VISIBLE: visible,
        state.PERIOD: image.tick_ms,
        state.STATE: 1 if program.is_member else 2,
    }
    yield from map(piece, join_statements([f"$robot[{place}]={_literal(value)}" for place, value in values.items()]))


def _arrays(program: ProgramFile) -> Iterator[bytes]:
    image = Image.from_bytes(program.image)
    code, cells, _, pars, _ = load(program.image)
    # Only actuators that are used have a place in `out`.
    places = {number: place for place, number in enumerate(program.used_actuators)}
    first = len(pars) - len(image.commands)
    width = pars[3]
    pars[first:] = [width * places.get(actuator, 0) for actuator in image.commands]
    first = 1 + image.inputs
    yield piece("from array import array")
    yield _array(state.CELLS, "i", cells)
    yield piece(f"$robot[{state.FIRST}]=$robot[{state.CELLS}][{first}:{first + image.variables + image.counters}]")
    yield _array(state.PARS, "h" if max(pars) < 1 << 15 else "i", pars)
    yield piece(f"$robot[{state.THREADS}]=array('i',[{pars[5]}, 0]+[-1,0]*{pars[0] - 1})")
    yield piece(f"$robot[{state.OUT}]=array('i',[0]*{width * len(places)})")
    yield piece(f"$robot[{state.CODE}]=$file.read({len(code)});del array") + bytes(code)


def _array(place: int, form: str, numbers: Sequence[int]) -> bytes:
    """An array of that form; in the file, small numbers have two bytes each."""
    stored = "h" if all(-(1 << 15) <= number < 1 << 15 for number in numbers) else form
    data = struct.pack(f"<{len(numbers)}{stored}", *numbers)
    read = f"array({stored!r},$file.read({len(data)}))"
    return piece(f"$robot[{place}]={read if stored == form else f'array({form!r},{read})'}") + data


def _literal(value: object) -> str:
    return repr(value).replace("$", r"\x24")
