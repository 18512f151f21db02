"""The studio's server: a thin door to the workspace for the page in the browser."""

from kitrobot.server.app import create_app
from kitrobot.server.start import serve

__all__ = ["create_app", "serve"]
