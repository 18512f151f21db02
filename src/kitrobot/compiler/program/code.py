"""The growing three-address code of one program: instructions, labels, cells. Knows nothing of LLL.

While code grows, an operand in a region whose place is not known yet is written as a `Cell`: a region and a number.
When all is there the regions are laid out (state | temporaries, constants) and every operand becomes a byte.
"""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.image.debug import Origin
from kitrobot.image.instructions import BY_NUMBER


class Cell(NamedTuple):
    """A cell by region: "state" (its number), "counter", "temporary" or "constant" (an index)."""

    region: str
    number: int


class Label(NamedTuple):
    """A place in the code, by number."""

    number: int


Operand = Cell | Label | int
FAULT = Cell("state", 0)


class Code:
    """Instructions so far, and the pools of cells they use."""

    def __init__(self) -> None:
        self.rows: list[tuple[int, Cell | int, Operand, Cell | int]] = []
        self.origins: list[Origin] = []
        self.origin = Origin("", None, 0, 0)
        self.labels: list[int] = []
        self.constants: list[int] = []
        self._constant: dict[int, int] = {}
        self._runs: dict[tuple[int, ...], int] = {}
        self.counters = 0
        self.temporaries = 0
        self._temporaries_in_use = 0

    def emit(self, op: int, a: Cell | int = 0, b: Cell | int = 0, c: Cell | int = 0) -> None:
        """Appends an instruction."""
        self.rows.append((op, a, b, c))
        self.origins.append(self.origin)

    def jump(self, op: int, label: Label, a: Cell | int = 0) -> None:
        """Appends a jump to a label."""
        self.rows.append((op, a, label, 0))
        self.origins.append(self.origin)

    def label(self) -> Label:
        """A new label, not placed yet."""
        self.labels.append(-1)
        return Label(len(self.labels) - 1)

    def place(self, label: Label) -> None:
        """Puts a label before the next instruction."""
        self.labels[label.number] = len(self.rows)

    def here(self) -> Label:
        """A new label before the next instruction."""
        label = self.label()
        self.place(label)
        return label

    def constant(self, value: int) -> Cell:
        """The cell of a constant."""
        index = self._constant.get(value)
        if index is None:
            index = self._constant[value] = len(self.constants)
            self.constants.append(value)
        return Cell("constant", index)

    def constant_run(self, values: tuple[int, ...]) -> Cell:
        """The first of consecutive cells that hold these constants."""
        if len(values) == 1:
            return self.constant(values[0])
        first = self._runs.get(values)
        if first is None:
            first = self._runs[values] = len(self.constants)
            for offset, value in enumerate(values):
                self._constant.setdefault(value, first + offset)
            self.constants += values
        return Cell("constant", first)

    def temporary_run(self, count: int) -> Cell:
        """The first of consecutive temporaries, free until `free_temporaries`."""
        first = self._temporaries_in_use
        self._temporaries_in_use += count
        self.temporaries = max(self.temporaries, self._temporaries_in_use)
        return Cell("temporary", first)

    def free_temporaries(self) -> None:
        """Gives all temporaries back; an instruction keeps none for the next."""
        self._temporaries_in_use = 0

    def cells(self, state: int) -> int:
        """How many cells the program needs, with `state` cells before the counters."""
        return state + self.counters + self.temporaries + len(self.constants)

    def assemble(self, state: int) -> bytes:
        """The code as bytes, with the counters after `state` cells. All labels are placed and all operands fit."""
        first = {
            "state": 0,
            "counter": state,
            "temporary": state + self.counters,
            "constant": state + self.counters + self.temporaries,
        }

        code: list[int] = []
        for op, a, b, c in self.rows:
            # What is asked most comes first: this is done for every operand of a program.
            code.append(op)
            code.append(a if isinstance(a, int) else first[a[0]] + a[1])
            if isinstance(b, Label):
                target = self.labels[b.number]
                assert target >= 0
                assert BY_NUMBER[op].jumps
                code.append(target % 256)
                code.append(target // 256)
            else:
                code.append(b if isinstance(b, int) else first[b[0]] + b[1])
                code.append(c if isinstance(c, int) else first[c[0]] + c[1])
        return bytes(code)
