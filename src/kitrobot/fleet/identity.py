"""What all processes of a fleet must have in common."""

from __future__ import annotations

from hashlib import blake2b

from kitrobot.mission.writer import write_mission
from kitrobot.sim.simulation import Simulation
from kitrobot.world.xml_writer import write_world


def identity_of(simulation: Simulation) -> str:
    """24 letters that are equal where mission, world and programs are."""
    digest = blake2b(write_mission(simulation.mission) + write_world(simulation.world), digest_size=12)
    for name, image in sorted(simulation.images.items()):
        digest.update(name.text.encode() + b"\0" + image.to_bytes())
    return digest.hexdigest()
