"""What a page does in its first minutes, in a process where only may be had what a browser has; tells it as JSON.

Run as a script, with a folder for the missions: nothing of it may be imported before the ban is there.
"""

import asyncio
import json
import sys
import threading
from pathlib import Path

BANNED = frozenset(
    {"numpy", "numba", "llvmlite", "orjson", "uvicorn", "uvloop", "websockets", "h11", "serial", "mpremote", "zenoh"}
    | {"rich", "typer", "python_minifier", "multiprocessing", "_multiprocessing", "concurrent.futures.process"}
)


class Ban:
    """Finds nothing of what is banned."""

    def find_spec(self, name, path=None, target=None):
        if name in BANNED or name.partition(".")[0] in BANNED:
            raise ModuleNotFoundError(f"{name} is not to be had in a browser", name=name)
        return None


def no_thread(self):
    raise RuntimeError("can't start new thread")


async def scenario(folder: Path) -> dict:
    from kitrobot.server.in_page import begin

    studio = begin(folder)
    told = {}

    async def ask(method, address, value=None, language="en"):
        body = b"" if value is None else json.dumps(value).encode()
        headers = {"Content-Type": "application/json", "Accept-Language": language}
        answer = await studio.fetch(method, f"/api/{address}", headers, body)
        return answer.status, json.loads(answer.body)

    async def heard(address, first, until):
        said, news = [], asyncio.Event()

        def hear(words):
            said.append(words)
            news.set()

        socket = studio.open(f"/api/{address}?language=en", hear)
        socket.say(json.dumps(first))
        at = 0
        while True:
            while at < len(said):
                words = said[at]
                at += 1
                if words is None or (isinstance(words, str) and until(json.loads(words))):
                    socket.close()
                    return [json.loads(one) for one in said[:at] if isinstance(one, str)], said[:at]
            news.clear()
            await news.wait()

    _, session = await ask("GET", "session")
    told["first"] = session["path"]
    _, opened = await ask("GET", f"mission?path={session['path']}")
    mission = opened["mission"]
    told["vertices"] = len(mission["programs"][0]["vertices"])
    status, report = await ask("POST", "check", {"mission": mission, "path": session["path"]})
    told["check"] = [status, len(report["programs"])]
    run = {"type": "start", "mission": mission, "path": session["path"], "seed": 1, "speed": 0}
    messages, every = await heard(
        "run", run, lambda one: one["type"] == "state" and one["status"] not in ("running", "paused")
    )
    told["run"] = messages[-1]["status"]
    told["frames"] = sum(isinstance(one, bytes) for one in every)
    status, _ = await ask("PUT", "mission", {"path": "mine.krt", "revision": "", "mission": mission})
    told["saved"] = [status, (folder / "mine.krt").is_file()]
    _, missions = await ask("GET", "missions")
    told["own"] = [one["path"] for one in missions if not one["example"]]
    messages, _ = await heard("boards", {"type": "look", "on": True}, lambda one: one["type"] == "refused")
    told["boards"] = messages[-1]["message"]
    messages, _ = await heard(
        "sweep",
        {"type": "start", "mission": mission, "path": "", "seed": 1, "seconds": 60, "moments": 2},
        lambda one: one["type"] != "progress",
    )
    told["sweep"] = messages[-1]["type"]
    _, small = await ask("GET", "mission/new")
    messages, _ = await heard(
        "verify",
        {"type": "start", "mission": small["mission"], "path": "", "seed": 1, "seconds": 5, "failures": 0},
        lambda one: one["type"] in ("end", "refused"),
    )
    told["verify"] = messages[-1]["type"]
    fleet = {**run, "type": "fleet", "holder": "", "boards": []}
    messages, _ = await heard("run", fleet, lambda one: one["type"] in ("error", "problems", "state"))
    told["fleet"] = messages[-1].get("message", messages[-1]["type"])
    status, refused = await ask("POST", "check", {"mission": 1}, "fr")
    told["french"] = refused["message"]
    told["nowhere"] = (await studio.fetch("GET", "/api/nowhere", {})).status
    told["imported"] = sorted(BANNED & set(sys.modules))
    return told


def main() -> None:
    # What a site does without is not looked for; the interpreter's own threads are of no matter.
    sys.meta_path.insert(0, Ban())
    threading.Thread.start = no_thread  # type: ignore[method-assign]
    print(json.dumps(asyncio.run(scenario(Path(sys.argv[1])))))


if __name__ == "__main__":
    main()
