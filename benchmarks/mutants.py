"""Who finds the mistake: all judges on mutants of the missions that come with KitRobot.

    python -m benchmarks.mutants --count 1000 ROWS.jsonl

Each mission is judged unchanged first. A mutant is *found* by a judge that says *broken* of something of which it did
not say so of the mission unchanged. The rows are kept in a file, a line of JSON each; a file that is there already is
gone on with, and `--count 0` prints its table alone.

Each mission gets as much processor time as the others, so small ones have more mutants judged.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from benchmarks.judge_comparison import (
    Comparison,
    ComparisonOptions,
    compare,
    judge_options_of,
    questions_of,
    run_length,
)
from benchmarks.mutation import Mutant, Operator, mutants
from kitrobot.judges.judgement import Judge, JudgeAnswer
from kitrobot.judges.mission_judges import judge_mission
from kitrobot.workspace.child_processes import cores
from kitrobot.workspace.mission_loader import OpenMission, open_mission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.task_pool import run_tasks

EXAMPLES = Path(__file__).parents[1] / "examples"
UNCHANGED = -1
"""The number of a mission as it is, among its mutants."""
_MOST_ROBOT_SECONDS = 150.0
_LONGEST_S, _SHORTEST_S = 30.0, 10.0

_ASKED = 3
"""Questions for a mutant besides the ready ones."""
_USUAL_S = 1.0
"""What a mutant is taken to cost while it is judged, in seconds of processor time."""

Row = dict[str, Any]
_Task = tuple[str, int]
_Answer = tuple[_Task, Row | None]


class MutatedMission:
    """A shipped mission, its mutants by number, and what is asked of them; `name` is its place in `examples`."""

    def __init__(self, name: str, seed: int) -> None:
        self.name = name
        self.opened = open_mission(EXAMPLES / name)
        self.questions = questions_of(self.opened, seed)
        self._coming = mutants(self.opened, seed)
        self._made: list[Mutant] = []
        self._rulings: dict[tuple[Judge, str], str] = {}
        robots = max(1, len(self.opened.mission.team.agents))
        limit = max(_SHORTEST_S, min(_LONGEST_S, _MOST_ROBOT_SECONDS / robots))
        outcome, seconds = run_length(self.opened.prepare(RunOptions(1, limit)).simulation)
        self.seconds = limit if outcome == "time" else min(limit, 1.5 * seconds + 5.0)

    def mutant(self, number: int) -> Mutant | None:
        """The mutant of that number, from 0 on; None where there are not so many."""
        while len(self._made) <= number:
            made = next(self._coming, None)
            if made is None:
                return None
            self._made.append(made)
        return self._made[number]

    def ruling(self, judge: Judge, question: str, options: ComparisonOptions) -> str:
        """What many runs or failures say of the mission as it is; asked for once."""
        known = self._rulings.get((judge, question))
        if known is None:
            prepared = self.opened.prepare(RunOptions(1, options.seconds))
            [said] = judge_mission(prepared, [question], judge_options_of(options, judge))
            known = self._rulings[judge, question] = said.ruling.value
        return known

    def asked(self, number: int) -> list[str]:
        """The questions for a mutant, others for each; all of them for the mission as it is."""
        if number == UNCHANGED:
            return self.questions
        at = number % len(self.questions)
        return (self.questions[at:] + self.questions[:at])[:_ASKED]


def judge_mutant(mission: MutatedMission, number: int, folder: Path, options: ComparisonOptions) -> Row | None:
    """Asks all judges of a mutant, or of the mission as it is; None where there are not so many mutants."""
    row: Row = {"mission": mission.name, "number": number, "program": "", "operator": "", "change": ""}
    opened: OpenMission = mission.opened
    if number != UNCHANGED:
        mutant = mission.mutant(number)
        if mutant is None:
            return None
        opened = mutant.opened
        row |= {"program": mutant.program, "operator": mutant.operator.value, "change": mutant.change}
    began = time.process_time()
    made: Comparison = compare(opened, mission.asked(number), folder, options)
    # The mission as it is was asked for other questions by those that make runs for each.
    unchanged = {
        judge.value: {
            question: mission.ruling(judge, question, options)
            for question, one in made.said.get(judge, {}).items()
            if number != UNCHANGED and one.ruling is JudgeAnswer.BROKEN
        }
        for judge in (Judge.RUNS, Judge.FAILURES)
    }
    return row | {
        "unchanged": unchanged,
        "seconds": mission.seconds,
        "outcome": made.outcome,
        "said": made.rulings(),
        "disagreements": [asdict(one) for one in made.disagreements],
        "limits": list(made.limits),
        "processor_s": round(time.process_time() - began, 2),
    }


def missions() -> list[str]:
    """The missions that come with KitRobot and have no errors, by their places in `examples`."""
    paths = sorted(EXAMPLES.rglob("*.krt"))
    return [path.relative_to(EXAMPLES).as_posix() for path in paths if open_mission(path).report.ok]


def found_by(row: Row, unchanged: Row) -> set[str]:
    """The judges that find what is wrong in a mutant, by questions that the unchanged one was asked too."""
    said = {judge: row.get("unchanged", {}).get(judge) or unchanged["said"].get(judge, {}) for judge in row["said"]}
    return {
        judge
        for judge, rulings in row["said"].items()
        if any(ruling == "broken" and said[judge].get(name, "broken") != "broken" for name, ruling in rulings.items())
    }


def table(rows: Iterable[Row]) -> str:
    """Who found what: a line for each operator, a column for each judge."""
    rows = list(rows)
    unchanged = {row["mission"]: row for row in rows if row["number"] == UNCHANGED}
    counts: dict[str, Counter[str]] = {one.value: Counter() for one in Operator}
    for row in rows:
        if row["number"] == UNCHANGED or row["mission"] not in unchanged:
            continue
        found = found_by(row, unchanged[row["mission"]])
        counts[row["operator"]].update(["mutants", *found, *(["anybody"] if found else [])])
    counts["all"] = sum(counts.values(), Counter())
    columns = ["mutants", "anybody", *(one.value for one in Judge)]
    lines = [["operator", *columns]] + [[name, *(str(of[one]) for one in columns)] for name, of in counts.items()]
    widths = [max(len(line[at]) for line in lines) for at in range(len(lines[0]))]
    return "\n".join(
        "  ".join(
            cell.rjust(width) if at else cell.ljust(width)
            for at, (cell, width) in enumerate(zip(line, widths, strict=True))
        )
        for line in lines
    )


def disagreements(rows: Iterable[Row], *, known: bool) -> Iterator[str]:
    """All disagreements that are faults, or all `known` ones, in lines to read."""
    for row in rows:
        for one in row["disagreements"]:
            if bool(one["known"]) != known:
                continue
            yield (
                f"{row['mission']} {row['number']} ({row['operator'] or 'unchanged'}: {row['change']})\n"
                f"  {one['rule']}: {one['question']}\n    {one['first']}\n    {one['second']}"
            )


def main(arguments: list[str] | None = None) -> int:
    """Judges so many mutants; status 1 where judges disagree."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.mutants", description="All judges on mutants.")
    parser.add_argument("rows", type=Path, help="the file of the rows; what is in it is not judged again")
    parser.add_argument("--count", type=int, default=1000, help="so many mutants (1000); 0 for the table alone")
    parser.add_argument("--seed", type=int, default=1, help="where chance begins (1)")
    parser.add_argument("--jobs", type=int, default=cores(), help="so many processes; one for each core")
    parser.add_argument("--minutes", type=float, default=60.0, help="leaves off after so long (60)")
    parser.add_argument("--each", type=float, default=8.0, help="seconds of processor time for one mutant, about (8)")
    given = parser.parse_args(arguments)
    rows = _read_rows(given.rows)
    ends = time.monotonic() + 60 * given.minutes
    order = JudgingOrder(missions() if given.count else [], rows)
    count = sum(row["number"] != UNCHANGED for row in rows)
    # Compiled, no run of a mutant would be quicker by as much as it takes to compile.
    os.environ.setdefault("KITROBOT_COMPILE", "no")
    with given.rows.open("a", encoding="utf-8") as file:
        begin = (given.seed, given.each)
        found = run_tasks(_work, order, given.jobs, _begin, begin, lambda: time.monotonic() > ends)
        for task, row in found if count < given.count else ():
            order.judged(task, row)
            if row is None:
                continue
            file.write(json.dumps(row, ensure_ascii=False) + "\n")
            file.flush()
            rows.append(row)
            count += row["number"] != UNCHANGED
            print(f"{count} mutants", end="\r", file=sys.stderr, flush=True)
            if count >= given.count:
                break
    told = list(disagreements(rows, known=False))
    known = len(list(disagreements(rows, known=True)))
    print(table(rows), *told, f"{len(told)} disagreements, and {known} that are known", sep="\n")
    return 1 if told else 0


class JudgingOrder:
    """What is judged next: first each mission as it is, then a mutant of the mission that took the least time so far.

    Args:
        names: the missions.
        rows: what is judged already.
    """

    def __init__(self, names: Iterable[str], rows: Iterable[Row]) -> None:
        self._spent = dict.fromkeys(names, 0.0)
        self._known: dict[str, set[int]] = {name: set() for name in self._spent}
        self._next = dict.fromkeys(self._spent, UNCHANGED)
        for row in rows:
            if row["mission"] in self._spent:
                self._known[row["mission"]].add(row["number"])
                self._spent[row["mission"]] += row["processor_s"]

    def __iter__(self) -> Iterator[_Task]:
        while self._next:
            name = min(self._next, key=lambda one: (self._next[one] > UNCHANGED, self._spent[one]))
            number = self._next[name]
            self._next[name] = number + 1
            if number not in self._known[name]:
                self._spent[name] += _USUAL_S
                yield name, number

    def judged(self, task: _Task, row: Row | None) -> None:
        """Takes in what came of a task; None: the mission has not so many mutants."""
        name, _ = task
        if row is None:
            self._next.pop(name, None)
        else:
            self._spent[name] += row["processor_s"] - _USUAL_S


def _read_rows(path: Path) -> list[Row]:
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()] if path.exists() else []


_here: list[Any] = []
"""Of a process of the pool: the seed, the seconds for a mutant, when to leave off, its folder, its missions."""


def _begin(seed: int, each: float, leave_off: Any) -> None:
    """In a process of the pool, once."""
    _here[:] = [seed, each, leave_off, tempfile.TemporaryDirectory(), {}]


def _work(task: _Task) -> _Answer:
    seed, each, leave_off, folder, known = _here
    name, number = task
    if name not in known:
        known[name] = MutatedMission(name, seed)
    mission = known[name]
    ends = time.process_time() + each
    options = ComparisonOptions(
        mission.seconds,
        states=2_000,
        moments=1,
        stop=lambda: leave_off.is_set() or time.process_time() > ends,
    )
    return task, judge_mutant(mission, number, Path(folder.name), options)


if __name__ == "__main__":
    sys.exit(main())
