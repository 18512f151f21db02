"""Files of every kind in many shapes, each of a size that is asked for: `SHAPES[name](n)` has `n` of something.

A name is the ending of the file, a space, and what there are `n` of. The files are right, mistaken or senseless on
purpose: whoever reads them takes work in proportion to their size, whatever they hold.
"""

from tests.growth.shapes import lll, missions, parts, pictures, programs, worlds
from tests.growth.shapes.missions import mission
from tests.growth.shapes.registry import SHAPES


def content(made: str | bytes) -> bytes:
    """What is made, as the bytes of a file."""
    return made if isinstance(made, bytes) else made.encode()


__all__ = ["SHAPES", "content", "lll", "mission", "missions", "parts", "pictures", "programs", "worlds"]
