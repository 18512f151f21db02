"""The simulator: a mission in its world, fixed step, seeded, the same run every time."""

from kitrobot.sim.hurry import expect_run
from kitrobot.sim.limits import MAX_SECONDS, MAX_SEED, check_limits
from kitrobot.sim.recording import DOING, Recorder, record_again, simulate
from kitrobot.sim.sayings import Event
from kitrobot.sim.settings import device_problems, length_of, simulated_devices
from kitrobot.sim.simulation import ALARM, ARM, FAILED, LAMP, MOVING, AgentView, Outcome, Simulation
from kitrobot.sim.staging import MAX_AGENTS, SimulationError, free_start, look_over

__all__ = [
    "ALARM",
    "ARM",
    "DOING",
    "FAILED",
    "LAMP",
    "MAX_AGENTS",
    "MAX_SECONDS",
    "MAX_SEED",
    "MOVING",
    "AgentView",
    "Event",
    "Outcome",
    "Recorder",
    "Simulation",
    "SimulationError",
    "check_limits",
    "device_problems",
    "expect_run",
    "free_start",
    "length_of",
    "look_over",
    "record_again",
    "simulate",
    "simulated_devices",
]
