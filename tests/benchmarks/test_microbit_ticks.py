"""How ticks of a micro:bit of 2016 are told from what its loop calls, and that docs/kits.md has those it should."""

from __future__ import annotations

from benchmarks.firmware_probe import ProbedCall
from benchmarks.m0_cycles import cycles
from benchmarks.microbit_ticks import Tick, chosen, row_of, ticks_of
from tools.kit_pages import ticks_2016
from tools.microbit_kits import small_kits

CALLS = [
    ProbedCall(False, 900, 100, 99),  # not due yet
    ProbedCall(False, 2_000, 100, 100),  # due: it begins
    ProbedCall(False, 4_000, 101, 40),  # of a part that is busy
    ProbedCall(True, 9_000, 100, 20),  # done
    ProbedCall(False, 9_100, 120, 107),  # there is time until the next one
    ProbedCall(True, 9_200, 107, 13),  # waits for requests so long
    ProbedCall(False, 22_000, 120, 120),
    ProbedCall(True, 45_000, 120, 20),
    ProbedCall(False, 45_100, 140, 143),  # which is late by 3 ms
    ProbedCall(False, 45_300, 143, 143),
    ProbedCall(True, 52_000, 143, 20),
    ProbedCall(False, 52_100, 163, 150),
]


def test_a_tick_begins_when_it_is_due_and_is_late_when_the_next_one_is_due_before_it_is_done() -> None:
    ticks = ticks_of(CALLS, 20)
    assert ticks == [Tick(2_000, 9_000, 0), Tick(22_000, 45_000, 3), Tick(45_300, 52_000, 0)]
    row = row_of([ticks, ticks], 20, (3000, 2900), 1386)
    assert (row.ticks, row.late, row.late_ms) == (6, 2, [3, 3, 3])
    assert row.takes_ms == [7.0, 23.0, 23.0]
    assert row.off_ms == [3.3, 3.3, 3.3]


def test_instructions_of_thumb_take_the_cycles_of_a_cortex_m0() -> None:
    assert [cycles(code, goes_on=True) for code in (0x3001, 0x6888, 0x4B02, 0xB510, 0xC807)] == [1, 2, 2, 3, 4]
    assert [cycles(code, goes_on=False) for code in (0xBD10, 0xD0F1, 0xE7F6, 0x4770, 0xF7FF)] == [6, 3, 3, 3, 4]
    assert cycles(0xD0F1, goes_on=True) == 1


def test_the_largest_program_and_those_that_drive_are_measured_on_each_kit_of_a_micro_bit() -> None:
    found = ticks_2016()
    assert {name: chosen(kit) for name, kit in small_kits().items()} == {name: [*rows] for name, rows in found.items()}
    assert all(row.ticks and row.free and row.flash for rows in found.values() for row in rows.values())
