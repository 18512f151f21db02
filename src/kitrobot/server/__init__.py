"""The studio's server: a thin door to the workspace for the page in the browser."""

from typing import TYPE_CHECKING, Any

from kitrobot.server.start import serve

if TYPE_CHECKING:
    from kitrobot.server.app import create_app
    from kitrobot.server.class_start import ClassOpening, serve_class

__all__ = ["ClassOpening", "create_app", "serve", "serve_class"]


def __getattr__(name: str) -> Any:
    # What is imported for it takes a second, and a second `kitrobot` on a folder does not need it.
    if name == "create_app":
        from kitrobot.server.app import create_app

        return create_app
    if name in ("ClassOpening", "serve_class"):
        from kitrobot.server import class_start

        return getattr(class_start, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
