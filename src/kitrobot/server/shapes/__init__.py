"""What travels between the server and the page: one model for each shape, and how our own values become it.

The models are the authority: `tools/api_types.py` writes the page's TypeScript types from them, under the same names
without `Shape`. Every field is always sent. Left to others: reading requests, and what the values mean.
"""

from kitrobot.server.shapes.catalogue import CatalogueShape, catalogue_shape
from kitrobot.server.shapes.files import (
    ConflictShape,
    MissionEntryShape,
    MissionFileShape,
    MissionTextShape,
    PictureShape,
    SavedShape,
    SaveShape,
    SessionShape,
    TextShape,
)
from kitrobot.server.shapes.mission import MissionShape, mission_from_shape, mission_shape
from kitrobot.server.shapes.problem import FailureShape, ProblemShape, problem_shapes
from kitrobot.server.shapes.report import CheckShape, ProgramReportShape, ReportShape, report_shape
from kitrobot.server.shapes.run import (
    REQUEST,
    REQUEST_MODELS,
    RUN_MESSAGE_MODELS,
    AgentReportShape,
    ErrorMessage,
    PauseRequest,
    ProblemsMessage,
    ResumeRequest,
    RunEventShape,
    RunMessage,
    RunRequest,
    SpeedRequest,
    StartedAgentShape,
    StartedMessage,
    StartRequest,
    StateMessage,
    StepRequest,
    StopRequest,
    TickMessage,
)
from kitrobot.server.shapes.world import WorldShape, world_shape

__all__ = [
    "REQUEST",
    "REQUEST_MODELS",
    "RUN_MESSAGE_MODELS",
    "AgentReportShape",
    "CatalogueShape",
    "CheckShape",
    "ConflictShape",
    "ErrorMessage",
    "FailureShape",
    "MissionEntryShape",
    "MissionFileShape",
    "MissionShape",
    "MissionTextShape",
    "PauseRequest",
    "PictureShape",
    "ProblemShape",
    "ProblemsMessage",
    "ProgramReportShape",
    "ReportShape",
    "ResumeRequest",
    "RunEventShape",
    "RunMessage",
    "RunRequest",
    "SaveShape",
    "SavedShape",
    "SessionShape",
    "SpeedRequest",
    "StartRequest",
    "StartedAgentShape",
    "StartedMessage",
    "StateMessage",
    "StepRequest",
    "StopRequest",
    "TextShape",
    "TickMessage",
    "WorldShape",
    "catalogue_shape",
    "mission_from_shape",
    "mission_shape",
    "problem_shapes",
    "report_shape",
    "world_shape",
]
