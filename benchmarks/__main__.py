"""`python -m benchmarks`: measures and prints a table, or JSON."""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
import time
from dataclasses import asdict

from benchmarks.measurement import Rate, Row
from benchmarks.subjects import names, subject


def main(arguments: list[str] | None = None) -> int:
    """Runs the subjects that were asked for; status 2 when there is none of that name."""
    known = names()
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description="Measure, each subject beside its peer.")
    parser.add_argument("subject", nargs="*", help=f"some of {', '.join(known)}; all when none is named")
    parser.add_argument("--no-peers", action="store_true", help="measure only ours")
    parser.add_argument("--tiny", action="store_true", help="tiny sizes, to see that it runs: the numbers mean nothing")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    given = parser.parse_args(arguments)
    unknown = [name for name in given.subject if name not in known]
    if unknown:
        parser.error(f"there is no subject {unknown[0]!r}; there is {', '.join(known)}")

    begun = time.perf_counter()
    measured: dict[str, list[Row]] = {}
    for name in given.subject or known:
        print(f"measuring {name} …", file=sys.stderr, flush=True)
        one = subject(name)
        measured[name] = one.run(one.TINY if given.tiny else one.FULL, peers=not given.no_peers)
    if given.json:
        rows = [
            {"subject": name, **asdict(row), "ratio": row.ratio} for name, found in measured.items() for row in found
        ]
        print(json.dumps({"machine": machine(), "rows": rows}, indent=1, ensure_ascii=False))
    else:
        print(f"\n{machine()}; {time.perf_counter() - begun:.0f} s\n")
        print(table(measured))
        print(
            "\nMedian [slowest … fastest round], in processor time; `studio` on the clock."
            " Ratio: how many times as fast as the peer we are."
        )
    return 0


def table(measured: dict[str, list[Row]]) -> str:
    """The rows as aligned columns."""
    lines = [("subject", "what", "unit", "ours", "", "peer", "theirs", "", "ratio")]
    for name, rows in measured.items():
        for row in rows:
            theirs = _shown(row.theirs) if row.theirs else ("", "")
            ratio = "" if row.ratio is None else f"{row.ratio:.2f}×" if row.ratio < 10 else f"{row.ratio:.0f}×"
            lines.append((name, row.what, row.unit, *_shown(row.ours), row.peer, *theirs, ratio))
    widths = [max(len(line[column]) for line in lines) for column in range(len(lines[0]))]
    right = {3, 6, 8}
    return "\n".join(
        "  ".join(
            cell.rjust(width) if column in right else cell.ljust(width)
            for column, (cell, width) in enumerate(zip(line, widths, strict=True))
        ).rstrip()
        for line in lines
    )


def machine() -> str:
    """What it ran on, in one line."""
    load = f", load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else ""
    return (
        f"{time.strftime('%Y-%m-%d')}, {platform.python_implementation()} {platform.python_version()}, "
        f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores{load}"
    )


def _shown(rate: Rate) -> tuple[str, str]:
    return _number(rate.median), f"[{_number(rate.slowest)} … {_number(rate.fastest)}]"


def _number(value: float) -> str:
    """Three digits and a unit: 205 k, 50.1 M."""
    for factor, letter in ((1e6, " M"), (1e3, " k")):
        if value >= factor:
            return f"{value / factor:#.3g}".rstrip(".") + letter
    return f"{value:#.3g}".rstrip(".")


if __name__ == "__main__":
    sys.exit(main())
