"""What one robot of the model is: how it moves along its road, and what else it is.

A robot on a road is in a zone and at a class of gap to the robot ahead (`roads`). Its wheels stand, drive or brake.
It comes into the next zone, or nearer than a class of gap, only after a tick of its own in the one where it is. Where
that very tick lets it brake, or it was braking when it came, it leaves only a zone (or a class of gap) that is shorter
than its braking distance; where it brakes later, it may leave any.
"""

from __future__ import annotations

from typing import NamedTuple

RUNS, STALLED, FAILED = range(3)
"""`Inside.down`: the order of `columns.WELL`, `STALLED` and `FAILED`."""


class Inside(NamedTuple):
    """One robot but for its motion.

    Attributes:
        local: the state of its program (see `programs`).
        load: whether a box is on its bed.
        busy: of each of its actuators that take longer: 0, or 1 and the number of the procedure.
        down: RUNS, STALLED (it rolls on and does not tick) or FAILED.
        own: its copies of the shared variables, once it hears nobody; empty as long as it does.
        loose: the bits of its actuators that go on although the marked action's parallel is over (see `stops`).
    """

    local: int
    load: int
    busy: tuple[int, ...]
    down: int
    own: tuple[int, ...] = ()
    loose: int = 0


class Body(NamedTuple):
    """The motion of a robot on a road. Directions are 1 (forward), -1 (back) and 0 (stands).

    Attributes:
        want: the direction that its wheels were told.
        way: the direction in which it rolls.
        zone: where it is along its road.
        gap: the class of the gap to the robot ahead (see `motion.Track.around`).
        new_zone: whether it came into its zone after its last tick.
        new_gap: whether it came to its class of gap, by its own motion, after its last tick.
        held_zone: whether it brakes since it came into its zone, or since before.
        held_gap: the same of its class of gap.
        ticks: whether it has ticks: its program goes on, and nothing befell it.
    """

    want: int
    way: int
    zone: int
    gap: int
    new_zone: bool
    new_gap: bool
    held_zone: bool
    held_gap: bool
    ticks: bool

    def told(self, want: int) -> Body:
        """After its wheels were told a direction, in a tick of its own."""
        if want == self.want:
            return self
        if self.way == 0 or want == self.way:
            return self._replace(want=want, held_zone=False, held_gap=False)
        if self.want != self.way:
            return self._replace(want=want)
        return self._replace(want=want, held_zone=self.new_zone, held_gap=self.new_gap)

    def begun(self) -> Body:
        """After it began to roll as it was told."""
        return self._replace(way=self.want, held_zone=False, held_gap=False)

    def halted(self) -> Body:
        """After it came to stand; what its wheels were told stays."""
        return self._replace(way=0, new_zone=False, new_gap=False, held_zone=False, held_gap=False)

    def entered(self, zone: int) -> Body:
        """After it came into a zone by its own motion."""
        brakes = self.want != self.way
        return self._replace(zone=zone, new_zone=not brakes, held_zone=brakes)

    def closed_in(self, gap: int) -> Body:
        """After its own motion brought it to a narrower class of gap."""
        brakes = self.want != self.way
        return self._replace(gap=gap, new_gap=not brakes, held_gap=brakes)

    def at_gap(self, gap: int) -> Body:
        """After the gap ahead became of another class without its doing."""
        return self._replace(gap=gap, new_gap=False, held_gap=False)
