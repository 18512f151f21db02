"""Long work in a process that has no threads, as in a page: each kind is begun and broken off; tells it as JSON.

Run as a script, with a folder for the missions; the mission comes on standard input.
"""

import asyncio
import json
import sys
from pathlib import Path

from tests.server.in_page_scenario import Heard, remove_what_pages_lack
from tests.server.sleeping_loop import SleepingLoop, sleep

HOURS = 10**7
FIRST = 500
"""The tick at which the run is paused."""


async def scenario(folder: Path, text: str) -> dict:
    from kitrobot.live import watched_run
    from kitrobot.live.background import set_sleep_function
    from kitrobot.server.in_page_server import begin

    watched_run.LONGEST_STEP_S = HOURS
    studio = begin(folder)
    told: dict = {}

    async def ask(method, address, body=b""):
        answer = await studio.fetch(method, f"/api/{address}", {"Content-Type": "application/json"}, body)
        return answer.status, json.loads(answer.body)

    _, read = await ask("POST", "mission/read", text.encode())
    mission = read["mission"]

    def is_state(*statuses):
        return lambda one: isinstance(one, dict) and one["type"] == "state" and one["status"] in statuses

    async def paused_run():
        run = Heard(studio, "/api/run?language=en")
        start = {"type": "start", "mission": mission, "path": "", "seed": 1, "speed": 0}
        run.socket.say(json.dumps(start))
        started = await run.until(lambda one: isinstance(one, dict) and one["type"] == "started")
        await run.until(lambda one: isinstance(one, dict) and one["type"] == "tick" and one["tick"] >= FIRST)
        run.socket.say(json.dumps({"type": "pause"}))
        await run.until(is_state("paused"))
        return run, started["run"]

    jobs = {
        "to the next part": {"type": "step", "by": "vertex", "agent": "robot-1"},
        "to the part before": {"type": "step", "by": "vertex", "agent": "robot-1", "back": True},
        "to a moment": {"type": "seek", "tick": 1},
    }
    for where, how in (("calls that cannot sleep", None), ("calls that sleep", sleep)):
        set_sleep_function(how)
        told[where] = {}
        for name, job in jobs.items():
            run, _ = await paused_run()
            run.socket.say(json.dumps(job))
            await ask("GET", "session")
            run.socket.say(json.dumps({"type": "stop"}))
            told[where][name] = (await run.until(is_state("stopped")))["status"]
            run.socket.close()
            run, _ = await paused_run()
            run.socket.say(json.dumps(job))
            await ask("GET", "session")
            run.socket.close()
    works = {
        "sweep": {"moments": 100, "seconds": 36_000.0},
        "verify": {"seconds": 3600.0, "failures": 2},
        "drawing-check": {},
    }
    for name, more in works.items():
        start = {"type": "start", "mission": mission, "path": "", "seed": 1, **more}
        for closing in (True, False):
            work = Heard(studio, f"/api/{name}?language=en")
            work.socket.say(json.dumps(start))
            await ask("GET", "session")
            if closing:
                work.socket.close()
                while True:
                    again = Heard(studio, f"/api/{name}?language=en")
                    again.socket.say(json.dumps({**start, "mission": {**mission, "agents": []}}))
                    said = await again.until(lambda one: one["type"] == "refused")
                    again.socket.close()
                    if "already" not in said["message"]:
                        break
            elif name != "drawing-check":
                work.socket.say(json.dumps({"type": "stop"}))
                said = await work.until(lambda one: one["type"] in ("refused", "end"))
                told[name] = said.get("message", said["type"])
                work.socket.close()
    run, name = await paused_run()
    saving = asyncio.create_task(studio.fetch("GET", f"/api/run/trace?run={name}", {}))
    await ask("GET", "session")
    saving.cancel()
    try:
        await saving
    except asyncio.CancelledError:
        told["recorded"] = "broken off"
    run.socket.close()
    await ask("GET", "session")
    return told


def main() -> None:
    text = sys.stdin.read()
    remove_what_pages_lack()
    with asyncio.Runner(loop_factory=SleepingLoop) as runner:
        print(json.dumps(runner.run(scenario(Path(sys.argv[1]), text))))


if __name__ == "__main__":
    main()
