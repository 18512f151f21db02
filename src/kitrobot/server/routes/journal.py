"""Nothing is lost: the page's journal, and what it must know of its file and of other pages.

`WS /api/watch` is open as long as the page is: it makes the page a tab, sends it what changes on disk, and when it
closes, for whatever reason, what the page wrote is free for the next one. The other requests bring records in.
"""

from __future__ import annotations

import asyncio
import contextlib

from fastapi import WebSocket, WebSocketDisconnect

from kitrobot.files.folder import MissionNameError
from kitrobot.files.journal_file import Journal
from kitrobot.live.background import run_in_background
from kitrobot.live.studio import Studio
from kitrobot.mission.writer import write_mission
from kitrobot.server.routes.api_router import ThisStudio, api_router, studio_of
from kitrobot.translation.reader_language import translate
from kitrobot.versions.comparison import Difference, differences
from kitrobot.wire.journal import (
    ClaimShape,
    ConflictedShape,
    DifferenceAskShape,
    DifferenceShape,
    ForgetShape,
    HelloMessage,
    HereMessage,
    JournalAppendShape,
    JournalShape,
    JournalSizeShape,
    MergeAskShape,
    MergedShape,
    NewsMessage,
    OrphanedJournalShape,
)
from kitrobot.wire.mission import mission_from_shape, mission_shape
from kitrobot.wire.values import ClaimedValue
from kitrobot.workspace.file_merge import merge_checked

LOOK_S = 0.5
"""How often a tab's files are looked at."""

journal_routes = api_router()


@journal_routes.post("/journal/claim")
def claim(studio: ThisStudio, wanted: ClaimShape) -> ClaimedValue:
    """The journal for the mission that the page has opened, with what was left in it."""
    if wanted.path:
        studio.folder.path_of(wanted.path)
    return studio.journals.claim(wanted.tab, wanted.path, wanted.journal)


@journal_routes.put("/journal")
def replace(studio: ThisStudio, wanted: JournalShape) -> JournalSizeShape:
    """Puts a whole journal in the place of the page's."""
    if wanted.path:
        studio.folder.path_of(wanted.path)
    journal = Journal(wanted.path, wanted.name, tuple(wanted.records), wanted.unsaved)
    return JournalSizeShape(bytes=studio.journals.replace(wanted.tab, journal))


@journal_routes.post("/journal")
def append(studio: ThisStudio, wanted: JournalAppendShape) -> JournalSizeShape:
    """Writes records behind the others."""
    return JournalSizeShape(bytes=studio.journals.append(wanted.tab, wanted.first, wanted.records, wanted.unsaved))


@journal_routes.get("/journal/left")
def left(studio: ThisStudio) -> list[OrphanedJournalShape]:
    """Unsaved work that nobody has open, the newest first."""
    return [OrphanedJournalShape.model_validate(one) for one in studio.journals.orphaned()]


@journal_routes.post("/journal/forget")
def forget(studio: ThisStudio, wanted: ForgetShape) -> list[OrphanedJournalShape]:
    """Throws unsaved work away that nobody has open; gives what is left."""
    studio.journals.discard(wanted.journal)
    return left(studio)


@journal_routes.post("/mission/difference")
def difference(studio: ThisStudio, wanted: DifferenceAskShape) -> DifferenceShape:
    """What is different in a mission from its file, in words."""
    data, revision = studio.folder.read(wanted.path)
    theirs = studio.read(data, wanted.path, wanted.path).mission
    found = differences(theirs, mission_from_shape(wanted.mission))
    return DifferenceShape(revision=revision, changes=[_in_words(one) for one in found])


@journal_routes.post("/mission/merge")
def merge(studio: ThisStudio, wanted: MergeAskShape) -> MergedShape:
    """A mission with the edits of its file, both made of `base`; nothing is written."""
    data, revision = studio.folder.read(wanted.path)
    theirs = studio.read(data, wanted.path, wanted.path).mission
    base, ours = mission_from_shape(wanted.base), mission_from_shape(wanted.mission)
    merged = merge_checked(
        base,
        ours,
        theirs,
        lambda mission: studio.read(write_mission(mission), wanted.path, wanted.path),
        frozenset(wanted.taken),
    )
    return MergedShape(
        revision=revision,
        mission=mission_shape(merged.mission),
        theirs=mission_shape(theirs),
        conflicts=[
            ConflictedShape(
                name=one.name,
                what=_capital(translate(one.what)),
                sentence=_capital(translate(one.sentence)),
                ours=translate(one.ours),
                theirs=translate(one.theirs),
                taken=one.taken,
                open=one.open,
            )
            for one in merged.clashes
        ],
    )


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]


def _in_words(difference: Difference) -> str:
    """What is different, after the program that it is about: the words are a sentence, the name stays as it is."""
    words = translate(difference.words)
    return f"{difference.program}: {words}" if difference.program else words[:1].upper() + words[1:]


@journal_routes.websocket("/watch")
async def watch(socket: WebSocket) -> None:
    """Serves one page until it closes."""
    studio = studio_of(socket)
    await socket.accept()
    tab = studio.journals.join()
    closed = asyncio.ensure_future(_until_closed(socket))
    try:
        await socket.send_text(HelloMessage(tab=tab).model_dump_json())
        sent: object = None
        while not closed.done():
            message = await run_in_background(_news, studio, tab)
            if message != sent:
                sent = message
                await socket.send_text(message.model_dump_json())
            await asyncio.wait({closed}, timeout=LOOK_S)
    except (WebSocketDisconnect, RuntimeError):
        pass  # gone while we spoke
    finally:
        closed.cancel()
        with contextlib.suppress(asyncio.CancelledError, Exception):
            await closed
        studio.journals.leave(tab)


def _news(studio: Studio, tab: str) -> NewsMessage:
    news = studio.journals.status_of(tab)
    try:
        parts = studio.stamp(news.path)
    except MissionNameError:
        parts = ""  # a journal may be of a mission whose name leads nowhere any more
    runs = studio.runs_of(news.path)
    return NewsMessage(path=news.path, revision=news.revision, others=news.others, parts=parts, runs=runs)


async def _until_closed(socket: WebSocket) -> None:
    """Answers any message from the threads that answer requests, so the page can check that they do."""
    with contextlib.suppress(WebSocketDisconnect, RuntimeError):
        while (await socket.receive())["type"] != "websocket.disconnect":
            await run_in_background(lambda: None)
            await socket.send_text(HereMessage().model_dump_json())
