"""What a run is made of; it can be sent to another process, which makes the same run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.compiler.team.points import TeamPlan
from kitrobot.mission.model import DEFAULT_SEED, Mission
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.sim.simulation import Simulation
from kitrobot.world.model import World


@dataclass(frozen=True)
class RunSpec:
    """The arguments of a `Simulation`, under the same names."""

    mission: Mission
    world: World
    images: Mapping[ImageName, CompiledProgram]
    catalogue: Catalogue
    seed: int = DEFAULT_SEED
    seconds: float | None = None
    fail_rate: float = 0.0
    team: TeamPlan | None = None

    def simulation(self, seed: int | None = None) -> Simulation:
        """The run before its first step, with another seed if one is given.

        Raises:
            SimulationError: the mission cannot be run.
        """
        return Simulation(
            self.mission,
            self.world,
            self.images,
            self.catalogue,
            self.seed if seed is None else seed,
            self.seconds,
            self.fail_rate,
            self.team,
        )
