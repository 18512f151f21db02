from collections.abc import Callable
from typing import Any

HEADER: str
HEADER_SIZE: int
NO_PARALLEL: int

def arrays(
    read: Callable[[int], bytes], fields: tuple[Any, ...]
) -> tuple[bytes, list[int], list[int], list[int], list[int]]: ...
