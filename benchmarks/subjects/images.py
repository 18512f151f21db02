"""An image on its way to a robot: writing its file, reading and verifying it, getting ready to run. No peer.

The image is that of a program of 10 000 vertices; a usual one is a hundredth of it. `board` reads it as a robot does,
with the checksum worked out bit by bit.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from benchmarks.measurement import Row, in_turns, milliseconds
from benchmarks.random_programs import ROBOT, catalogue, graph_of, tree_of_vertices
from kitrobot.compiler.compilation import compile_program
from kitrobot.image.machine import Machine
from kitrobot.image.model import Image
from kitrobot.image.verification import verify
from kitrobot_onboard.image import load

TITLE = "images"


@dataclass(frozen=True)
class Size:
    vertices: int
    rounds: int


FULL = Size(10_000, 7)
TINY = Size(40, 1)


def run(size: Size, *, peers: bool) -> list[Row]:
    robot = catalogue().robot(ROBOT)
    image = compile_program(graph_of(tree_of_vertices(size.vertices)), catalogue()).image
    assert image is not None
    data = image.to_bytes()
    assert Image.from_bytes(data) == image
    work: dict[str, Callable[[], object]] = {
        "write": image.to_bytes,
        "read": lambda: Image.from_bytes(data),
        "verify": lambda: verify(image),
        "ready": lambda: Machine(image, robot),
        "board": lambda: load(data),
    }
    words = {
        "write": "image → file",
        "read": "file → image",
        "verify": "verify",
        "ready": "verify, ready to run",
        "board": "file → arrays, on a board's code",
    }
    seconds = in_turns(work, size.rounds)
    size_of_it = f"{image.instructions} instructions"
    return [
        Row(f"{words[name]}, {size_of_it}", "ms", milliseconds(taken), lower_is_better=True)
        for name, taken in seconds.items()
    ]
