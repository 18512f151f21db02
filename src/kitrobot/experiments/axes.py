"""Axes: what a study puts into its mission, as text (`carry.v3.speed=30:60:5`) and as the points that come of it.

An axis is a list (`0,5,10`), a range with a step (`30:60:5`, both ends included), whole numbers (`2..6`), or a
design: `lhs(20, 30, 60)`, `sobol(64)`, `random(100)`, n points between two bounds, those of the address unless others
are given. Designs of one kind and number are drawn together, each axis being one dimension. Other axes are multiplied,
in the order in which they are given, or with `zip` taken side by side.
"""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

from kitrobot.experiments.addresses import Address, ExperimentError, find_address
from kitrobot.experiments.sampling import MOST_DIMENSIONS, latin_hypercube, random_points, sobol
from kitrobot.experiments.variant import Value
from kitrobot.text.sentences import Sentence

MOST_POINTS = 1_000_000
"""Points of a study at most."""

_DESIGN = re.compile(r"(lhs|sobol|random)\(\s*(\d+)\s*(?:,\s*([^,()]+),\s*([^,()]+))?\)")
_WHOLE = re.compile(r"(-?\d+)\.\.(-?\d+)")
_USUAL = Sentence("write a list 0,5,10, a range 30:60:5 or 2..6, or a design lhs(20), sobol(64), random(100)")


@dataclass(frozen=True)
class AxisGroup:
    """Addresses that vary together: a row of values for each of its points, in the order of `addresses`."""

    addresses: tuple[str, ...]
    rows: tuple[tuple[Value, ...], ...]


@dataclass(frozen=True)
class _Design:
    kind: str
    count: int
    bounds: tuple[str, str] | None


def read_axes(given: Sequence[tuple[str, str]], known: Mapping[str, Address], chance: str) -> list[AxisGroup]:
    """The axes of a study.

    Args:
        given: each address with the text of its values.
        known: the addresses of the mission.
        chance: what the points of designs are drawn from.

    Raises:
        ExperimentError: an address is not there or given twice, or a value cannot stand there.
    """
    groups: list[AxisGroup] = []
    designs: dict[tuple[str, int], list[tuple[Address, float, float]]] = {}
    places: dict[tuple[str, int], int] = {}
    seen: set[str] = set()
    for name, text in given:
        address = find_address(known, name.strip())
        if address.name in seen:
            raise ExperimentError(Sentence("`{address}` varies twice", address.name), _USUAL)
        seen.add(address.name)
        design = _design(text.strip())
        if design is None:
            groups.append(AxisGroup((address.name,), tuple((value,) for value in _values(address, text.strip()))))
            continue
        key = design.kind, design.count
        if key not in designs:
            places[key] = len(groups)
            groups.append(AxisGroup((), ()))
        designs.setdefault(key, []).append((address, *_bounds(address, design)))
    for key, axes in designs.items():
        groups[places[key]] = _drawn(*key, axes, chance)
    return groups


def read_axis(text: str) -> tuple[str, str]:
    """`ADDRESS=VALUES` in two.

    Raises:
        ExperimentError: there is no `=`.
    """
    name, found, values = text.partition("=")
    if not found or not name.strip() or not values.strip():
        raise ExperimentError(Sentence("expected ADDRESS=VALUES, found `{found}`", text), _USUAL)
    return name.strip(), values.strip()


def read_table(text: str, name: str, known: Mapping[str, Address]) -> AxisGroup:
    """The rows of a CSV file: its first line has addresses, each other line is a point.

    Raises:
        ExperimentError: a line has too few or too many cells, or one that cannot stand there; its line is told.
    """
    lines = list(csv.reader(io.StringIO(text.removeprefix("\ufeff"), newline="")))
    if len(lines) < 2 or not lines[0]:
        message = Sentence("`{file}`: expected a line of addresses and lines of values", name)
        raise ExperimentError(message, _USUAL)
    addresses = [find_address(known, cell.strip()) for cell in lines[0]]
    if len({address.name for address in addresses}) < len(addresses):
        raise ExperimentError(Sentence("`{file}`: an address stands there twice", name))
    rows = []
    for number, cells in enumerate(lines[1:], 2):
        if not cells:
            continue
        if len(cells) != len(addresses):
            message = Sentence("`{file}`, line {line}: expected {cells} cells", name, number, len(addresses))
            raise ExperimentError(message)
        try:
            rows.append(tuple(address.read(cell) for address, cell in zip(addresses, cells, strict=True)))
        except ExperimentError as error:
            message = Sentence("`{file}`, line {line}: {reason}", name, number, error.message)
            raise ExperimentError(message, error.help) from None
    return AxisGroup(tuple(address.name for address in addresses), tuple(rows))


def count_points(groups: Sequence[AxisGroup], is_zip: bool) -> int:
    """How many points there are; 1 without axes.

    Raises:
        ExperimentError: there are too many, or axes that are taken side by side are not of one length.
    """
    sizes = [len(group.rows) for group in groups]
    if is_zip and len(set(sizes)) > 1:
        shown = ", ".join(map(str, sizes))
        message = Sentence("axes side by side have the same number of values; these have {numbers}", shown)
        raise ExperimentError(message, Sentence("leave --zip out to try every combination"))
    count = (sizes[0] if sizes else 1) if is_zip else math.prod(sizes)
    if not 0 < count <= MOST_POINTS:
        message = Sentence("expected from 1 to {most} points, found {count}", MOST_POINTS, count)
        raise ExperimentError(message, Sentence("choose fewer values, or a design such as lhs(100)"))
    return count


def point_at(groups: Sequence[AxisGroup], is_zip: bool, number: int) -> dict[str, Value]:
    """The values of a point, by address; the last axis changes from each point to the next."""
    point: dict[str, Value] = {}
    for group in reversed(groups):
        number, at = (number, number) if is_zip else divmod(number, len(group.rows))
        point = dict(zip(group.addresses, group.rows[at], strict=True)) | point
    return point


def all_points(groups: Sequence[AxisGroup], is_zip: bool) -> Iterator[dict[str, Value]]:
    """Every point, in order."""
    for rows in zip(*(g.rows for g in groups), strict=True) if is_zip else product(*(g.rows for g in groups)):
        yield {
            name: value
            for group, row in zip(groups, rows, strict=True)
            for name, value in zip(group.addresses, row, strict=True)
        }


def _values(address: Address, text: str) -> list[Value]:
    whole = _WHOLE.fullmatch(text)
    if whole is not None:
        first, last = int(whole[1]), int(whole[2])
        step = 1 if last >= first else -1
        _expect_few(abs(last - first) + 1)
        return [address.check(number) for number in range(first, last + step, step)]
    parts = text.split(":")
    if len(parts) in (2, 3) and address.takes_numbers:
        first_value, last_value = address.read(parts[0]), address.read(parts[1])
        try:
            step_value = float(parts[2]) if len(parts) == 3 else 1.0
        except ValueError:
            step_value = math.nan
        if (
            isinstance(first_value, str)
            or isinstance(last_value, str)
            or not (math.isfinite(step_value) and step_value)
        ):
            raise ExperimentError(Sentence("`{text}` is no range", text), _USUAL)
        span = (last_value - first_value) / step_value
        if span < 0:
            raise ExperimentError(Sentence("`{text}` is no range", text), _USUAL)
        _expect_few(span)
        return [address.check(_rounded(first_value + n * step_value)) for n in range(math.floor(span + 1e-9) + 1)]
    cells = next(csv.reader([text], skipinitialspace=True), [])
    return [address.read(cell) for cell in cells]


def _expect_few(count: float) -> None:
    if count > MOST_POINTS:
        message = Sentence("expected from 1 to {most} points, found {count}", MOST_POINTS, f"{count:.15g}")
        raise ExperimentError(message, Sentence("choose fewer values, or a design such as lhs(100)"))


def _rounded(value: float) -> float:
    """Without the dust of adding steps."""
    return float(f"{value:.12g}")


def _design(text: str) -> _Design | None:
    found = _DESIGN.fullmatch(text)
    if found is None:
        return None
    count = int(found[2])
    if not 1 <= count <= MOST_POINTS:
        message = Sentence("expected from 1 to {most} points, found {count}", MOST_POINTS, count)
        raise ExperimentError(message, _USUAL)
    return _Design(found[1], count, (found[3], found[4]) if found[3] else None)


def _bounds(address: Address, design: _Design) -> tuple[float, float]:
    """Between what a design draws; of words, places among them."""
    if not address.takes_numbers:
        raise ExperimentError(Sentence("`{address}` has words, so give a list of them", address.name), _USUAL)
    if design.bounds is None:
        return address.least, address.most
    least, most = (address.read(text) for text in design.bounds)
    if isinstance(least, str) or isinstance(most, str) or least > most:
        raise ExperimentError(Sentence("`{text}` is no range", ", ".join(design.bounds)), _USUAL)
    return float(least), float(most)


def _drawn(kind: str, count: int, axes: Sequence[tuple[Address, float, float]], chance: str) -> AxisGroup:
    if kind == "sobol" and len(axes) > MOST_DIMENSIONS:
        raise ExperimentError(Sentence("a Sobol design has at most {most} axes", MOST_DIMENSIONS), _USUAL)
    chance = f"{chance}/{kind}"
    if kind == "sobol":
        points = sobol(count, len(axes))
    else:
        points = (latin_hypercube if kind == "lhs" else random_points)(count, len(axes), chance)
    rows = tuple(tuple(_scaled(*axis, x) for axis, x in zip(axes, point, strict=True)) for point in points)
    return AxisGroup(tuple(address.name for address, _, _ in axes), rows)


def _scaled(address: Address, least: float, most: float, x: float) -> Value:
    if address.whole:
        return address.check(min(int(most), int(least) + math.floor(x * (int(most) - int(least) + 1))))
    return address.check(_rounded(least + x * (most - least)))
