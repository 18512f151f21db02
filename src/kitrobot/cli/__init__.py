"""The command line: a thin door to the workspace."""

from kitrobot.cli.app import main
from kitrobot.cli.classroom import ClassOptions
from kitrobot.cli.studio import StudioOptions

__all__ = ["ClassOptions", "StudioOptions", "main"]
