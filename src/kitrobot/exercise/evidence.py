"""The evidence that goals are decided from, as plain values.

A `RunEvidence` describes a run of the simulator, a `ProgramEvidence` the submitted programs, and a `CheckEvidence` the
result of checking one property. Lengths are in mm, times in simulated seconds.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from kitrobot.text.sentences import Label, Sentence


class PathPoint(NamedTuple):
    """Where an agent was, and when."""

    x: float
    y: float
    seconds: float


@dataclass(frozen=True)
class Contact:
    """An agent began to touch something; `text` says what."""

    agent: str
    seconds: float
    text: str


@dataclass(frozen=True)
class RunEvidence:
    """A run that is over. `paths` has each agent's path, points at least 1 mm apart and the last one; it is empty where
    no goal asks for it.
    """

    seed: int
    outcome: Literal["done", "failed", "stuck", "time"]
    sentence: str
    seconds: float
    contacts: tuple[Contact, ...] = ()
    paths: Mapping[str, tuple[PathPoint, ...]] | None = None
    lines: Mapping[str, tuple[tuple[PathPoint, ...], ...]] | None = None
    """What each agent's pens drew, as `paths`: a line each."""
    properties: Mapping[str, CheckEvidence] = field(default_factory=dict)
    """What this run says of properties that were watched in it, by `CheckGoal.property`."""


@dataclass(frozen=True)
class ProgramEvidence:
    """For each program, how many vertices of each element hang on its Start (Start and Stop are not counted), and how
    many the own blocks stand for that it uses, each block once. `own` is how many of its vertices are own blocks, which
    count under no name. `labels` is what elements are called on the
    page, where the program's robots and the catalogue know them.
    """

    elements: Mapping[str, Mapping[str, int]]
    own: Mapping[str, int]
    labels: Mapping[str, Sentence] = field(default_factory=dict)

    def label_of(self, part: str) -> Sentence:
        """The label of an element on the page; its name where it has none."""
        return self.labels.get(part) or Label(part, {})


@dataclass(frozen=True)
class CheckEvidence:
    """The result of checking one property under one assumption, or of watching it in one run; `sentence` is the
    property in words.

    `answer` is `holds`, `broken`, `not finished`, `vacuous`, `nothing found` by an approximate search, or `none` where
    it could not be checked, and `sentence` says why. So many `states` were looked at. Of a broken one `seed` and
    `seconds` are the run of the simulator that shows it, where there is one that needs no failures, and `steps` what
    happens in the shortest run of the model. A run says `holds`, `broken` or `vacuous`.
    """

    answer: Literal["holds", "broken", "not finished", "nothing found", "vacuous", "none"]
    sentence: str
    seed: int | None = None
    seconds: float | None = None
    steps: tuple[str, ...] = ()
    states: int = 0
