"""The simulator: a mission in its world, fixed step, seeded, the same run every time."""

from kitrobot.sim.agent_views import ALARM, ARM, FAILED, LAMP, MOVING, AgentView
from kitrobot.sim.devices import DisplayKind, ManualControl
from kitrobot.sim.event_text import Event
from kitrobot.sim.hosted import TickResult, begin_hosted_step, finish_hosted_step, fits, report_write
from kitrobot.sim.jit_policy import expect_run
from kitrobot.sim.limits import MAX_SECONDS, MAX_SEED, check_limits
from kitrobot.sim.pens import pens_of
from kitrobot.sim.recorder import DOING, Recorder, record_again, simulate, strokes_now
from kitrobot.sim.settings import Appearance, appearance_of, device_problems, length_of, moves_boxes, simulated_devices
from kitrobot.sim.setup import MAX_AGENTS, SimulationError, check_mission, free_start
from kitrobot.sim.simulation import Outcome, Simulation
from kitrobot.sim.source import SimulationSource

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
    "Appearance",
    "DisplayKind",
    "Event",
    "ManualControl",
    "Outcome",
    "Recorder",
    "Simulation",
    "SimulationError",
    "SimulationSource",
    "TickResult",
    "appearance_of",
    "begin_hosted_step",
    "check_limits",
    "check_mission",
    "device_problems",
    "expect_run",
    "finish_hosted_step",
    "fits",
    "free_start",
    "length_of",
    "moves_boxes",
    "pens_of",
    "record_again",
    "report_write",
    "simulate",
    "simulated_devices",
    "strokes_now",
]
