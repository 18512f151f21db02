"""The studio's server: a thin door to the workspace for the page in the browser."""

from typing import TYPE_CHECKING, Any

from kitrobot.server.studio_server import serve

if TYPE_CHECKING:
    from kitrobot.server.app import create_app
    from kitrobot.server.class_server import ClassSettings, serve_class

__all__ = ["ClassSettings", "create_app", "serve", "serve_class"]


def __getattr__(name: str) -> Any:
    # What is imported for it takes a second, and a second `kitrobot` on a folder does not need it.
    if name == "create_app":
        from kitrobot.server.app import create_app

        return create_app
    if name in ("ClassSettings", "serve_class"):
        from kitrobot.server import class_server

        return getattr(class_server, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
