from collections.abc import Sequence

def tick(
    code: Sequence[int],
    cells: list[int],
    threads: list[int],
    pars: list[int],
    out: list[int],
    seen: list[int],
) -> None: ...
