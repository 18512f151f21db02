"""Pages that watch a run, as sockets without a picture: `python -m benchmarks.audience ADDRESS TOKEN MISSION WATCHERS`.

One starts the mission at real time and so many watch it; all read whatever comes. It says "all watch" when everybody
was told the run, and after a line on its standard input how many frames each watcher got in between, as JSON.
"""

from __future__ import annotations

import asyncio
import json
import sys
import urllib.parse
import urllib.request
from dataclasses import dataclass, field

from websockets.asyncio.client import ClientConnection, connect


@dataclass
class Page:
    """One socket that reads everything. `run` is the name of the run, once it was told."""

    socket: ClientConnection
    frames: int = 0
    run: asyncio.Future[str] = field(default_factory=asyncio.Future)

    async def read(self) -> None:
        """Until the socket closes."""
        async for message in self.socket:
            if isinstance(message, bytes):
                self.frames += 1
            elif not self.run.done():
                said = json.loads(message)
                if said["type"] != "started":
                    raise SystemExit(f"instead of a run came {message}")
                self.run.set_result(said["run"])


async def main(address: str, token: str, path: str, watchers: int) -> None:
    """Starts, watches, counts."""
    query = urllib.parse.urlencode({"path": path, "token": token})
    with urllib.request.urlopen(f"{address.replace('ws:', 'http:', 1)}/api/mission?{query}") as answer:
        mission = json.load(answer)["mission"]
    pages: list[Page] = []
    tasks: list[asyncio.Task[None]] = []

    async def opened(request: dict[str, object]) -> Page:
        page = Page(await connect(f"{address}/api/run?token={token}", max_size=None))
        pages.append(page)
        tasks.append(asyncio.create_task(page.read()))
        await page.socket.send(json.dumps(request))
        return page

    owner = await opened({"type": "start", "mission": mission, "path": path, "seed": 1, "speed": 1})
    run = await owner.run
    for _ in range(watchers):
        await opened({"type": "watch", "run": run, "mission": mission})
    await asyncio.gather(*(page.run for page in pages))
    before = [page.frames for page in pages]
    print("all watch", flush=True)
    await asyncio.to_thread(sys.stdin.readline)
    print(json.dumps([page.frames - was for page, was in zip(pages, before, strict=True)]), flush=True)
    for task in tasks:
        task.cancel()
    await asyncio.gather(*(page.socket.close() for page in pages))


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1], sys.argv[2], sys.argv[3], int(sys.argv[4])))
