"""What a page does in its first minutes, in a process where only may be had what a browser has; tells it as JSON.

Run as a script, with a folder for the missions: nothing of it may be imported before the ban is there.
"""

import asyncio
import json
import struct
import sys
import threading
from pathlib import Path

from kitrobot_onboard import link
from tests.server.sleeping_loop import SleepingLoop, sleep

ROOT = Path(__file__).parents[2]
BANNED = frozenset(
    {"numpy", "numba", "llvmlite", "orjson", "uvicorn", "uvloop", "websockets", "h11", "serial", "mpremote", "zenoh"}
    | {"rich", "typer", "python_minifier", "multiprocessing", "_multiprocessing", "concurrent.futures.process"}
    # What is not sent (`packaging.site_sources`, `packaging.site_packages`).
    | {"idna", "platformdirs", "argparse", "configparser", "tracemalloc", "http.server", "http.cookiejar"}
    | {"logging.handlers", "logging.config", "anyio._backends._trio", "starlette.testclient"}
)


def environment(home: Path) -> dict[str, str]:
    """That of a process that stands for a page, as `web/src/site/worker.ts` makes it."""
    folders = {"KITROBOT_CONFIG": str(home / "config"), "KITROBOT_STATE": str(home / "state")}
    return {"HOME": str(home), **folders, "PATH": "", "PYTHONPATH": f"{ROOT}:{ROOT / 'src'}"}


class Ban:
    """Finds nothing of what is banned."""

    def find_spec(self, name, path=None, target=None):
        if name in BANNED or name.partition(".")[0] in BANNED:
            raise ModuleNotFoundError(f"{name} is not to be had in a browser", name=name)
        return None


def no_thread(self):
    raise RuntimeError("can't start new thread")


def remove_what_pages_lack() -> None:
    """From now on this process starts no thread and imports no package that a page does not have."""
    sys.meta_path.insert(0, Ban())
    threading.Thread.start = no_thread  # type: ignore[method-assign]


async def scenario(folder: Path) -> dict:
    from kitrobot.live.background import set_sleep_function
    from kitrobot.server.in_page_server import begin

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
    study = {"mission": mission, "path": "mine.krt", "axes": [], "seeds": "1-2", "measures": ["seconds"], "seconds": 5}
    messages, _ = await heard("experiment", {"type": "start", **study}, lambda one: one["type"] != "progress")
    _, runs = await ask("GET", f"experiment/runs?path=mine.krt&study={messages[-1]['study']['study']}&first=0&count=9")
    told["experiment"] = [messages[-1]["type"], len(runs)]
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
    set_sleep_function(sleep)
    told |= await with_a_board(studio, mission, session["path"], ask)
    told["imported"] = sorted(BANNED & set(sys.modules))
    return told


class Heard:
    """What a socket of the studio says."""

    def __init__(self, studio, address):
        self.all, self._news = [], asyncio.Event()
        self.socket = studio.open(address, self._hear)

    def _hear(self, words):
        self.all.append(json.loads(words) if isinstance(words, str) and words[:1] == "{" else words)
        self._news.set()

    async def until(self, wanted):
        """The next message that is wanted; those before it are forgotten."""
        while True:
            while self.all:
                if wanted(one := self.all.pop(0)):
                    return one
            self._news.clear()
            await self._news.wait()


class Board:
    """A robot behind a port of the page that has a program of somebody else."""

    def __init__(self, studio, key):
        mark = "0" * 32
        self.address, self.asked, self.running = f"page:{mark}", [], False
        self._bytes = b""
        self._socket = studio.open(f"/api/boards/port?key={key}&mark={mark}&vendor=3368", self._hear)

    def _hear(self, words):
        if words == "open":
            self._socket.say("opened")
        elif isinstance(words, bytes):
            *whole, self._bytes = (self._bytes + words).split(b"~")
            for frame in filter(None, map(link.unwrap, whole)):
                self._answer(*frame)

    def _answer(self, kind, number, payload):
        self.asked.append(kind)
        self.running = kind == "s" or (kind != "x" and self.running)
        if kind == "h":
            state = struct.pack("<BBBIIHH", link.PROTOCOL, 2 if self.running else 1, 0, 999, 5, 0, 1)
            self._socket.say(link.wrap("H", number, state + b"00000000 11111111"))
        else:
            self._socket.say(link.wrap("K", number, b""))

    def pull(self):
        self._socket.say("gone")


async def with_a_board(studio, mission, path, ask):
    """What is told of a board that the page has opened, and what else is answered meanwhile."""
    told: dict = {}
    boards = Heard(studio, "/api/boards?language=en")
    welcome = await boards.until(lambda one: one["type"] == "welcome")
    board = Board(studio, welcome["key"])
    what = {"mission": mission, "path": path, "program": mission["programs"][0]["name"], "address": board.address}

    async def is_now(**wanted):
        return await boards.until(lambda one: one["type"] == "board" and wanted.items() <= one.items())

    def say(kind, **more):
        boards.socket.say(json.dumps({"type": kind, "address": board.address, **more}))

    say("look", on=True)
    ports = await boards.until(lambda one: one["type"] == "ports" and one["ports"])
    told["ports"] = [one["name"] for one in ports["ports"]]
    say("connect", **what)
    await is_now(phase="open", state="ready")
    say("start", held=True)
    await is_now(state="running", held=True)
    pinged = board.asked.count("p") + 2
    answers = []
    while board.asked.count("p") < pinged:
        answers.append((await ask("POST", "check", {"mission": mission, "path": path}))[0])
    told["checked meanwhile"] = sorted(set(answers))
    say("stop")
    await is_now(state="ready", held=False)
    told["stopped"] = "x" in board.asked
    boards.socket.say(json.dumps({"type": "connect", **what, "address": "socket://127.0.0.1:1"}))
    told["network"] = (await boards.until(lambda one: one["type"] == "refused"))["message"]
    say("start", held=True)
    await is_now(state="running", held=True)
    board.pull()
    told["pulled"] = (await is_now(phase="lost"))["message"]
    say("forget")
    await boards.until(lambda one: one["type"] == "gone")
    boards.socket.close()
    return told


def main() -> None:
    remove_what_pages_lack()
    with asyncio.Runner(loop_factory=SleepingLoop) as runner:
        print(json.dumps(runner.run(scenario(Path(sys.argv[1])))))


if __name__ == "__main__":
    main()
