"""The bench of a robot, on which a page tries its parts: current step and failures. It lives on the worker's thread."""

from __future__ import annotations

from kitrobot.boards.bench import Bench, PartKey
from kitrobot.boards.bench_loader import PartError, Send, load_parts
from kitrobot.boards.bench_run import BenchHand
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.robot import RobotObject
from kitrobot.robots.program import BoardProgram
from kitrobot.robots.session import RobotSession
from kitrobot.text.sentences import Label, Sentence
from kitrobot.wire.bench import BenchLeftOutShape, BenchStepShape, BoardBenchFailureShape, BoardBenchShape, ReadingShape
from kitrobot.wire.board import BoardStepsMessage


class StepError(KitRobotError):
    """There is no such step."""


class RobotBench:
    """A bench on the session of a robot."""

    def __init__(self, session: RobotSession, bench: Bench) -> None:
        self.hand = BenchHand(session, bench, frozenset())
        self._broken: dict[PartKey, KitRobotError] = {}

    def load(self, needed: PartKey | None, send: Send) -> BoardProgram:
        """Sends the program for as many parts as the robot takes, the needed one among them.

        Raises:
            KitRobotError: what `send` raises, or the needed part does not start.
        """
        session, bench = self.hand.session, self.hand.bench
        parts, program = load_parts(bench, needed, self._broken, send)
        self.hand = BenchHand(session, bench, parts)
        return program

    def needs(self, at: int | None) -> PartKey | None:
        """The part of a step that the program on the robot lacks; None when it has it.

        Raises:
            StepError: there is no such step.
        """
        if at is None:
            return None
        steps = self.hand.bench.steps
        if at >= len(steps):
            raise StepError(Sentence("there is no step {number} to try", at + 1), Sentence("open the parts once more"))
        key = steps[at].key
        return key if key not in self.hand.parts and key not in self._broken else None

    def do(self, at: int | None) -> None:
        """Does a step until the next one; None ends it. One whose part does not start is not done.

        Raises:
            KitRobotError: the robot does not answer, or refuses.
        """
        if at is None or self.hand.bench.steps[at].key not in self.hand.parts:
            self.hand.end()
        else:
            self._broken.pop(self.hand.bench.steps[at].key, None)
            self.hand.begin(self.hand.bench.steps[at])

    def check(self) -> None:
        """Checks whether the part of the step failed."""
        try:
            self.hand.check()
        except PartError as error:
            if error.part is not None:
                self._broken[error.part] = error

    def shape(self) -> BoardBenchShape:
        """The state of the bench for the page."""
        steps, step = self.hand.bench.steps, self.hand.step
        failed = [
            BoardBenchFailureShape(step=at, message=_by_label(error, one.part), help=error.help)
            for at, one in enumerate(steps)
            if (error := self._broken.get(one.key)) is not None
        ]
        at = next((at for at, one in enumerate(steps) if one is step), None)
        return BoardBenchShape(step=at, value=self.hand.value, slow=self.hand.is_slow, failed=failed)


def _by_label(error: KitRobotError, part: RobotObject) -> str:
    """The message of an error, with the part's label as the page shows it."""
    if isinstance(error, PartError) and isinstance(error.message, Sentence):
        return error.message.with_value("part", Label(part.name, part.label))
    return error.message


def steps_message(address: str, bench: Bench) -> BoardStepsMessage:
    """The steps of a bench, for a page."""
    return BoardStepsMessage(
        address=address,
        steps=[
            BenchStepShape(
                part=step.part.name,
                label=dict(step.part.label),
                call=step.call,
                reads=ReadingShape.model_validate(step.part),
                seen=dict(step.seen),
                trouble=dict(step.trouble),
            )
            for step in bench.steps
        ],
        left_out=[BenchLeftOutShape(part=part.name, label=dict(part.label), why=why) for part, why in bench.left_out],
    )
