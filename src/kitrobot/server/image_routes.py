"""The request for a program's image, for a download."""

from __future__ import annotations

from base64 import b64encode

from kitrobot.diagnostics import ProblemsError
from kitrobot.image import disassemble
from kitrobot.server.routing import ThisStudio, api_router
from kitrobot.server.shapes import mission_from_shape
from kitrobot.server.shapes.image import ImageAskShape, ImageShape

image_routes = api_router()


@image_routes.post("/image")
def image(studio: ThisStudio, wanted: ImageAskShape) -> ImageShape:
    """Compiles one program of a mission: its image and the listing of it."""
    opened = studio.open(mission_from_shape(wanted.mission), wanted.path)
    program = opened.program(wanted.program)
    compiled = opened.compiled.get(program.name)
    if compiled is None:
        raise ProblemsError(
            f"the robot `{program.target}` of `{program.name}` is not at hand, so there is no image of it",
            "put the robot's file beside the mission",
            opened.diagnostics,
        )
    if compiled.image is None:
        errors = tuple(item for item in compiled.diagnostics if item.is_error)
        raise ProblemsError(
            f"`{program.name}` has {_counted(len(errors))}, so there is no image of it yet",
            "mend what the list of problems shows",
            errors,
        )
    data = compiled.image.to_bytes()
    return ImageShape(image=b64encode(data).decode(), listing=disassemble(compiled.image))


def _counted(errors: int) -> str:
    return f"{errors} error{'s' if errors != 1 else ''}"
