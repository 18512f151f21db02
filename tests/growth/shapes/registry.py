"""What registers shapes: `SHAPES[name](n)` makes a file with `n` of something."""

from __future__ import annotations

from collections.abc import Callable

SHAPES: dict[str, Callable[[int], str | bytes]] = {}


def shape(name: str) -> Callable[[Callable[[int], str | bytes]], Callable[[int], str | bytes]]:
    """Registers what makes files of one shape."""

    def keep(make: Callable[[int], str | bytes]) -> Callable[[int], str | bytes]:
        assert name not in SHAPES
        SHAPES[name] = make
        return make

    return keep


def lines(kind: str, pieces: dict[str, tuple[str, str, str]]) -> None:
    """Shapes that are one text many times, between a beginning and an end; `#` becomes the number of the time."""
    for what, (before, one, after) in pieces.items():

        def make(n: int, before: str = before, one: str = one, after: str = after) -> str:
            return before + "".join(one.replace("#", str(at)) for at in range(n)) + after

        shape(f"{kind} {what}")(make)


def lines_inside(kind: str, before: str, after: str, pieces: dict[str, str]) -> None:
    lines(kind, {what: (before, one + "\n", after) for what, one in pieces.items()})
