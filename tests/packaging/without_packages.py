"""The main commands in one process where packages that need not be installed cannot be imported; told as JSON.

Run as a script with a folder to work in: nothing of ours may be imported before.
"""

import contextlib
import io
import json
import sys
from pathlib import Path

ABSENT = ("numpy", "numba", "llvmlite", "orjson", "zenoh", "uvloop", "zstandard")
HEART = "examples/heart/heart.krt"
TRANSPORT = "examples/transport/transport.krt"


def main(root: Path, folder: Path) -> None:
    for name in ABSENT:
        sys.modules[name] = None  # type: ignore[assignment]
    from kitrobot.cli.app import main as kitrobot

    told = []

    def call(*words: str) -> None:
        out, said = io.TextIOWrapper(io.BytesIO(), encoding="utf-8"), io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
        status: object = None
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(said):
            try:
                kitrobot(list(words))
            except SystemExit as end:
                status = end.code
        texts = []
        for stream in (out, said):
            stream.flush()
            stream.seek(0)
            texts.append(stream.read())
        told.append([words[0], status, *texts])

    heart, transport = str(root / HEART), str(root / TRANSPORT)
    text, image = str(folder / "heart.lll"), str(folder / "heart.kri")
    trace = str(folder / "run.krtrace")
    call("run", transport, "--seed", "1", "--trace", trace)
    call("run", transport, "--seed", "1", "--json")
    call("run", heart, "--seconds", "5", "--fail-sweep", "1", "--jobs", "1", "--json")
    call("replay", trace)
    call("convert", trace, str(folder / "run.mcap"))
    call("verify", str(root / "examples/passing-loop/passing-loop.krt"), "--timing", "lockstep", "--max-states", "500")
    call("check", heart)
    call("convert", heart, text)
    call("convert", heart, image)
    call("convert", image, str(folder / "heart.kra"))
    call("format", text)
    call("diff", heart, heart)
    call("exec", text, "--robot", "microbit", "--ticks", "5", "--json")
    call("merge", heart, heart, heart, "--output", str(folder / "merged.krt"))
    call("grade", str(root / "examples/exercises/01-first-drive.krt"), "--json")
    call("maze", "--seed", "3")
    call("boards", "--to", "socket://127.0.0.1:1", "--json")
    call("deploy", heart, "--to", "socket://127.0.0.1:1")
    call("team", str(root / "examples/convoy/convoy.krt"), "--seconds", "1")
    call("run", heart, "--seconds", "1", "--ros", "0")
    sys.stdout.write(json.dumps(told))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
