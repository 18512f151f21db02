"""The trace of a program with scripted inputs, on CPython and on a current MicroPython: all arrays after every tick."""

from __future__ import annotations

import json
import random
from collections.abc import Sequence
from dataclasses import dataclass

from kitrobot.image.machine import Machine
from tests.boards.modern import onboard_files, run
from tests.strategies import TickInputs

Tick = list[list[int]]
"""out, cells, threads, pars, seen."""

PROGRAM = b"""
import binascii, json
from kitrobot_onboard.image import load
from kitrobot_onboard.interpreter import tick
number = 0

def step():
    global number
    try:
        file = open("case%d.json" % number)
    except OSError:
        return False
    number += 1
    case = json.load(file)
    file.close()
    code, cells, threads, pars, out = load(binascii.unhexlify(case["image"]))
    for inputs in case["inputs"]:
        cells[1 : 1 + len(inputs)] = inputs
        seen = [0] * (len(code) // 4) if case["watched"] else []
        tick(code, cells, threads, pars, out, seen)
        print(json.dumps([out, cells, threads, pars, seen]))
    return True
"""


@dataclass(frozen=True)
class Case:
    """A program that is ready for its first tick, and what happens around it."""

    name: str
    machine: Machine
    script: Sequence[TickInputs]


def on_cpython(case: Case) -> tuple[list[list[int]], list[Tick]]:
    """The input cells before each tick, and everything after it."""
    machine = case.machine
    inputs, trace = [], []
    for sensors, done in case.script:
        for sensor, value in sensors.items():
            machine.set_input(sensor, value)
        for actuator, is_done in done.items():
            machine.set_done(actuator, is_done)
        inputs.append(list(machine.cells[1 : machine.layout.inputs + 1]))
        machine.tick()
        trace.append([list(part) for part in (machine.out, machine.cells, machine.threads, machine.pars, machine.seen)])
    return inputs, trace


def on_micropython(cases: Sequence[tuple[Machine, list[list[int]]]]) -> list[Tick]:
    """Everything after each tick of all the cases, one after the other, run by MicroPython from the image's file."""
    files = onboard_files() | {"traces.py": PROGRAM}
    for number, (machine, inputs) in enumerate(cases):
        case = {"image": machine.image.to_bytes().hex(), "inputs": inputs, "watched": bool(machine.seen)}
        files[f"case{number}.json"] = json.dumps(case).encode()
    return [json.loads(line) for line in run(files, "traces.py").splitlines()]


def disagreements(cases: Sequence[Case]) -> list[str]:
    """Where the two differ first, for each case in which they do."""
    ours = [on_cpython(case) for case in cases]
    theirs = iter(on_micropython([(case.machine, inputs) for case, (inputs, _) in zip(cases, ours, strict=True)]))
    found = []
    for case, (_, trace) in zip(cases, ours, strict=True):
        pairs = [(expected, next(theirs, None)) for expected in trace]
        first = next((number for number, (left, right) in enumerate(pairs) if left != right), None)
        if first is not None:
            expected, got = pairs[first]
            found.append(f"{case.name}, tick {first}: CPython {expected}, MicroPython {got}")
    assert next(theirs, None) is None
    return found


def rested(count: int) -> list[TickInputs]:
    """Ticks in which nothing happens around the robot."""
    return [TickInputs({}, {}) for _ in range(count)]


def seeded(name: str) -> random.Random:
    """Chance that is the same each time."""
    return random.Random(name)
