"""Images and listings as files."""

from __future__ import annotations

from pathlib import Path

from kitrobot.files.disk import FileError, read_bytes, read_text
from kitrobot.image.listing import assemble
from kitrobot.image.model import Image, ImageError
from kitrobot.image.verification import verify
from kitrobot.text.sentences import Sentence


def read_image(path: Path) -> Image:
    """The image of a `.kri`. Does not verify what it says.

    Raises:
        FileError: the file cannot be read, is damaged, or is no image.
    """
    data = read_bytes(path)
    try:
        return Image.from_bytes(data)
    except ImageError as error:
        raise FileError(Sentence("`{path}`: {reason}", path, error.message), error.help, path=path) from None


def read_listing(path: Path) -> Image:
    """The image of a `.kra`. Does not verify what it says.

    Raises:
        FileError: the file cannot be read or is not text.
        ImageError: it is no listing; the message begins with FILE:LINE.
    """
    return assemble(read_text(path), str(path))


def why_unsafe(image: Image) -> ImageError | None:
    """Why no host would run an image; None when all would."""
    try:
        verify(image)
    except ImageError as error:
        return error
    return None
