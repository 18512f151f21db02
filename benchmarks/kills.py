"""Random kills of everything that makes a study, and whether a row is lost or there twice.

`python -m benchmarks.kills --kills 1000 --seed 1` makes studies of 5000 runs with the commands of a user, and kills
their processes at random: the supervisor, its workers and whatever else it began; with Dask the client, the scheduler,
workers and their nannies. Whatever is gone is begun again. A study that is complete must hold, line by line, the rows
that one process makes undisturbed; then comes the next one, until so many kills are done. Exit status 1: it does not.

Only processes that this one began are ended, by their number. The clock says when a kill comes, never what is right.
"""

from __future__ import annotations

import argparse
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path

import psutil  # type: ignore[import-untyped]

import kitrobot
from kitrobot.experiments.plan import Plan, StudyRequest, plan_study
from kitrobot.experiments.point_runner import Pace, PointRunner
from kitrobot.experiments.study_folder import ROWS, begin_study, row_lines
from kitrobot.experiments.study_run import study_status

ROUNDS = ("local", "dask")
WEIGHTS = {"worker": 4, "supervisor": 1, "Dask worker": 4, "nanny": 1, "client": 2, "scheduler": 1}
"""How often each kind is killed, against the others of its round."""
MOMENTS, MOMENT_S = 0.3, 0.5
"""The share of pauses that are moments, and how long such a one is in the mean."""
ROW_BYTES = 230
LOOK_S = 0.1
MOST_PATIENCE_S = 120
"""How long a command may take to say that its scheduler is gone, or to make a row, before that is a fault."""
_SCHEDULER = ("-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")
_WORKER = ("-m", "distributed.cli.dask_worker", "--nthreads", "1", "--no-dashboard")


_Victim = tuple[str, psutil.Process]


class CampaignError(Exception):
    """A study came out otherwise than undisturbed, or a command failed in a way that is no kill."""


@dataclass
class Campaign:
    """So many kills.

    Attributes:
        kills: how many there are to be.
        seed: decides who is killed, and after which pause.
        runs: of each study.
        rows: between two kills, in the mean, where one does not come after some moments.
        rounds: what makes the studies in turn.
        studies: how many are complete.
        done: the kills by what was killed.
        said: what commands said at their end, how often.
    """

    kills: int
    seed: int = 1
    runs: int = 5000
    rows: int = 50
    rounds: tuple[str, ...] = ROUNDS
    studies: int = 0
    done: Counter[str] = field(default_factory=Counter)
    said: Counter[str] = field(default_factory=Counter)

    def run(self, folder: Path, tell: Callable[[str], None] = print) -> None:
        """Kills, study by study.

        Raises:
            CampaignError: a row is lost, twice or another one; the study stays where it is.
        """
        self._chance = random.Random(self.seed)
        plan = campaign_plan(self.runs)
        runner = PointRunner(plan, pace=Pace.PLAIN)
        undisturbed = sorted(runner.run(row) for row in range(plan.rows))
        while self.done.total() < self.kills:
            kind = self.rounds[self.studies % len(self.rounds)]
            study = folder / f"study-{self.studies}"
            begin_study(study, plan)
            (self._local if kind == "local" else self._dask)(study)
            found = sorted(row_lines(study))
            if found != undisturbed:
                lost, other = set(undisturbed) - set(found), sorted(set(found) - set(undisturbed))
                raise CampaignError(
                    f"{study}: {len(lost)} rows are lost, {len(found) - len(set(found))} twice, others: {other[:3]}"
                )
            self.studies += 1
            tell(f"study {self.studies} ({kind}): the rows of an undisturbed one; {self.done.total()} kills so far")

    @property
    def _is_enough(self) -> bool:
        return self.done.total() >= self.kills

    def _local(self, study: Path) -> None:
        while not _is_complete(study):
            with _command(study, "--jobs", "2") as command:
                while self._is_alive_after_pause(command, study):
                    self._kill(command, _victims(command, "supervisor", "worker"))
                self._note_end(command)

    def _dask(self, study: Path) -> None:
        while not _is_complete(study):
            with _program(*_SCHEDULER, says=r"Scheduler at:\s+(tcp://\S+)") as (scheduler, address):
                self._with_workers(study, scheduler, address)

    def _with_workers(self, study: Path, scheduler: subprocess.Popen[bytes], address: str) -> None:
        """Until the scheduler was killed, or the study is complete."""
        workers: list[subprocess.Popen[bytes]] = []
        try:
            while scheduler.poll() is None and not _is_complete(study):
                with _command(study, "--cluster", address) as command:
                    _fill_up(workers, address)
                    while scheduler.poll() is None and self._is_alive_after_pause(command, study):
                        victims = _victims(command, "client", "client")
                        victims += _victims(scheduler, "scheduler", "scheduler")
                        for worker in workers:
                            victims += _victims(worker, "nanny", "Dask worker")
                        self._kill(command, victims)
                        _fill_up(workers, address)
                    self._note_end(command)
        finally:
            for worker in workers:
                _end_family(worker)

    def _is_alive_after_pause(self, command: subprocess.Popen[bytes], study: Path) -> bool:
        """Whether there is somebody left to kill, and somebody to be killed yet; else waits for its end.

        A pause is some moments, so that kills come while processes begin and end too, or some rows long.
        """
        if self._is_enough:
            command.wait()
            return False
        if self._chance.random() < MOMENTS:
            return not _has_ended(command, self._chance.expovariate(1 / MOMENT_S))
        file = study / ROWS
        end = _size(file) + ROW_BYTES * self._chance.randrange(1, 2 * self.rows)
        longest = time.monotonic() + MOST_PATIENCE_S
        while not _has_ended(command, LOOK_S):
            if _size(file) >= end or time.monotonic() > longest:
                return True
        return False

    def _kill(self, command: subprocess.Popen[bytes], victims: list[_Victim]) -> None:
        """One of them, workers most often."""
        kinds = sorted({kind for kind, _ in victims})
        if not kinds:
            return
        (kind,) = self._chance.choices(kinds, [WEIGHTS[kind] for kind in kinds])
        victim = self._chance.choice([process for name, process in victims if name == kind])
        try:
            victim.kill()
            self.done[kind] += 1
        except psutil.NoSuchProcess:
            return
        if victim.pid == command.pid:
            command.wait()

    def _note_end(self, command: subprocess.Popen[bytes]) -> None:
        """A command ends by a kill, with all rows, or with a sentence that says how to go on; nothing else."""
        try:
            status = command.wait(MOST_PATIENCE_S)
        except subprocess.TimeoutExpired:
            raise CampaignError("the command waits for ever") from None
        if status > 0:
            assert command.stderr is not None, "it was asked for"
            said = _text_of(command.stderr)
            if "Traceback" in said or not re.search("scheduler|die before they begin", said):
                raise CampaignError(f"the command ended with the status {status}: {said}")
            self.said[said.strip().splitlines()[-2 if "help" in said else -1]] += 1


def campaign_plan(runs: int) -> Plan:
    """The study: two robots that drive for a moment at two speeds, and may fail; so many runs, an even number."""
    names = ("ann", "ben")
    starts = tuple(kitrobot.Start(name, pose=kitrobot.Pose(200, 200 + 200 * at, 0)) for at, name in enumerate(names))
    drive = kitrobot.read_program("Wheel.Advance(50); WAIT(8); Wheel.Stop();", "mini-robot", "drive")
    team = kitrobot.Team([kitrobot.Agent(name, "drive") for name in names])
    world = kitrobot.World("yard", 1000, 600, starts=starts)
    opened = kitrobot.open_mission(kitrobot.Mission(programs=[drive], team=team, own_world=world))
    (vertex,) = (one for one in opened.mission.programs[0].vertices if one.element == "Wheel.Advance")
    vary = [(f"drive.{vertex.id}.speed", "30,60")]
    measures = ["seconds,distance"]
    return plan_study(opened, StudyRequest(vary, seeds=f"1-{runs // 2}", fail_rate=0.9, measures=measures))


def _victims(process: subprocess.Popen[bytes], name: str, children: str) -> list[_Victim]:
    """A process by what it is, and those that it began."""
    try:
        parent = psutil.Process(process.pid)
        return [(name, parent), *((children, child) for child in parent.children(recursive=True))]
    except psutil.NoSuchProcess:
        return []


def _fill_up(workers: list[subprocess.Popen[bytes]], address: str) -> None:
    """Two workers, each with its nanny."""
    workers[:] = [one for one in workers if one.poll() is None]
    workers += [_begin(*_WORKER, address) for _ in range(2 - len(workers))]


def _has_ended(process: subprocess.Popen[bytes], within_s: float) -> bool:
    try:
        process.wait(within_s)
    except subprocess.TimeoutExpired:
        return False
    return True


def _size(file: Path) -> int:
    return file.stat().st_size if file.exists() else 0


def _is_complete(study: Path) -> bool:
    found = study_status(study)
    return found.done == found.total


def _begin(*arguments: str, **options: int) -> subprocess.Popen[bytes]:
    nothing = subprocess.DEVNULL
    pipes = {"stdin": nothing, "stdout": nothing, "stderr": nothing, **options}
    return subprocess.Popen([sys.executable, *arguments], **pipes)  # type: ignore[call-overload, no-any-return]


@contextmanager
def _command(study: Path, *options: str) -> Iterator[subprocess.Popen[bytes]]:
    """`kitrobot sweep STUDY --resume`, with what it says."""
    arguments = ("-m", "kitrobot", "sweep", str(study), "--resume", *options)
    with tempfile.TemporaryFile() as said:
        process = _begin(*arguments, stderr=said.fileno())
        process.stderr = said
        try:
            yield process
        finally:
            _end_family(process)


@contextmanager
def _program(*arguments: str, says: str) -> Iterator[tuple[subprocess.Popen[bytes], str]]:
    """A program of Dask's once it has said that, and what it said there."""
    with tempfile.TemporaryFile() as said:
        process = _begin(*arguments, stderr=said.fileno())
        try:
            while not (found := re.search(says, _text_of(said))):
                if process.poll() is not None:
                    raise CampaignError(f"a program of Dask's has ended: {_text_of(said)}")
                time.sleep(0.05)
            yield process, found[1]
        finally:
            _end_family(process)


def _text_of(file: object) -> str:
    file.seek(0)  # type: ignore[attr-defined]
    text: bytes = file.read()  # type: ignore[attr-defined]
    return text.decode(errors="replace")


def _end_family(process: subprocess.Popen[bytes]) -> None:
    """Ends a process that this one began, and those that it began."""
    try:
        family = psutil.Process(process.pid).children(recursive=True)
    except psutil.NoSuchProcess:
        family = []
    if process.poll() is None:
        process.kill()
    for one in family:
        try:
            one.kill()
        except psutil.NoSuchProcess:
            continue
    process.wait()


def main() -> int:
    """Status 1 where a study is not as an undisturbed one."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.kills", description="Kill what makes studies.")
    parser.add_argument("--kills", type=int, default=1000, help="how many (1000)")
    parser.add_argument("--seed", type=int, default=1, help="who is killed and when (1)")
    parser.add_argument("--runs", type=int, default=5000, help="of each study (5000)")
    parser.add_argument("--rows", type=int, default=50, help="between two kills, in the mean (50)")
    parser.add_argument("--only", choices=ROUNDS, help="only processes of this machine, or only Dask")
    given = parser.parse_args()
    rounds = (given.only,) if given.only else ROUNDS if find_spec("distributed") else ROUNDS[:1]
    campaign = Campaign(given.kills, given.seed, given.runs, given.rows, rounds)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    begun = time.perf_counter()
    folder = Path(tempfile.mkdtemp())
    try:
        campaign.run(folder, lambda line: print(line, flush=True))
    except CampaignError as error:
        print(error, file=sys.stderr)
        return 1
    finally:
        print(f"{campaign.studies} studies of {campaign.runs} runs in {time.perf_counter() - begun:.0f} s")
        print("kills:", ", ".join(f"{count} of a {name}" for name, count in sorted(campaign.done.items())))
        for sentence, count in campaign.said.items():
            print(f"said {count} times: {sentence}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
