"""The session with one robot: what becomes of its state, and what subscribers are told, once each."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from kitrobot.deploy.errors import LineError
from kitrobot.deploy.line.board import is_slow
from kitrobot.deploy.line.news import Fault, News, Text
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.robots.names import BoardNames, NoNameError
from kitrobot.robots.session import LOOK_S, InstalledProgram, NotConnectedError, RobotSession
from kitrobot.robots.state import Activity, Change, ChangeKind
from kitrobot.robots.view import WatchedRobot
from kitrobot.translation.reader_language import override_language, translate
from tests.robots.twin import Clock, Twin

NAMES = BoardNames("walk", "rover", 20, {"Eye": 1}, {"Count": 2}, ("Motor",), (0,), (("v1", 1, "Motor.Go();"),))
PROGRAM = InstalledProgram(NAMES)


class Visit:
    """A robot that was opened, and all changes since."""

    def __init__(self, doing: Activity = "running", tick: int = 0, known: InstalledProgram | None = PROGRAM) -> None:
        self.clock = Clock()
        self.session = RobotSession(self.clock)
        self.changes: list[Change] = []
        self.session.subscribe(self.changes.append)
        self.twin = Twin(doing, tick)
        self.session.open(self.twin, self.twin.hello, known)

    def hears(self, *news: News | Fault | Text) -> None:
        self.twin.waiting.extend(news)
        for _ in news:
            self.session.poll(0)

    def looks(self, doing: Activity, tick: int = 0) -> None:
        self.twin.stands(doing, tick)
        self.clock.now += LOOK_S
        self.session.poll(0)

    @property
    def happened(self) -> list[Any]:
        return [change.kind for change in self.changes if change.kind is not ChangeKind.QUIET]

    @property
    def texts(self) -> list[str]:
        return [event.text for change in self.changes for event in change.events]


def test_news_are_folded_into_one_state() -> None:
    visit = Visit()
    visit.hears(News(3, {1: 7, 2: 5}, {0: 0, 1: 4}), News(6, {2: 6}, {1: None}))
    state = visit.session.state
    assert (state.doing, state.tick, state.cells, state.threads) == ("running", 6, {1: 7, 2: 6}, {0: 0})
    assert visit.happened == [ChangeKind.GREETED, ChangeKind.NEWS, ChangeKind.NEWS]
    assert visit.changes[-1].state == state


def test_the_state_is_looked_at_only_when_it_is_due_and_an_end_is_an_event_once() -> None:
    visit = Visit()
    visit.twin.stands("ended", 40)
    visit.session.poll(0)
    assert visit.session.state.doing == "running"
    for _ in range(3):
        visit.looks("ended", 40)
    assert (visit.session.state.doing, visit.session.state.threads) == ("ended", {})
    assert visit.texts == ["its program has ended"]


def test_a_fault_is_told_once_however_it_is_found() -> None:
    fault = Fault(1, 0, 9, "a0 OSError")
    visit = Visit()
    visit.hears(fault, fault)
    visit.twin.fault = fault
    visit.looks("fault", 9)
    assert visit.texts == ["fault 1: a driver failed (Motor: OSError); at the vertex v1, line 1 of the code"]
    other = Visit("fault", 9)
    assert other.texts == []
    other.twin.fault = fault
    other.looks("fault", 9)
    assert other.session.state.fault == fault
    assert other.texts == visit.texts
    assert other.twin.asked == ["last fault", "last fault"]


def test_a_fault_is_forgotten_when_it_runs_again_and_not_before() -> None:
    visit = Visit()
    visit.hears(Fault(1, None, 9, ""))
    visit.session.stop()
    stopped = visit.session.state
    visit.session.start(held=True)
    again = visit.session.state
    assert (stopped.fault, again.fault, again.held) == (Fault(1, None, 9, ""), None, True)


def test_a_robot_that_began_anew_is_watched_again_and_nothing_told_before_holds() -> None:
    visit = Visit(tick=500)
    visit.session.watch(70)
    visit.session.force("Eye", 3)
    visit.hears(News(501, {2: 5}, {0: 0}))
    visit.looks("running", 3)
    state = visit.session.state
    assert (state.doing, state.tick, state.cells, state.threads, state.forced) == ("running", 0, {}, {}, {})
    assert visit.twin.asked.count(("watch", 70)) == 2
    visit.looks("running", 4)
    assert visit.texts == ["Eye held by hand: 3", "it began anew by itself"]


def test_what_is_done_by_hand_is_told_in_the_words_of_the_palette_with_the_unit() -> None:
    robot = load_catalogue().robots["mini-robot"]
    known = InstalledProgram(replace(NAMES, sensors={"Captor": 1}, variables={"Level": 2}, made_of=robot))
    visit = Visit(known=known)
    visit.session.force("Captor", 12)
    visit.session.set_variable("Level", 50)
    visit.session.force("Captor", None)
    assert visit.texts == [
        "Distance sensor held by hand: 12 cm",
        "Level set by hand: 50",
        "Distance sensor no longer held",
    ]
    [first, *_] = [event.text for change in visit.changes for event in change.events]
    with override_language("fr"):
        assert translate(first) == "Capteur de distance maintenu à la main : 12 cm"


def test_one_that_is_held_is_stopped_when_it_began_anew() -> None:
    visit = Visit("ready")
    visit.session.start(held=True)
    visit.hears(News(100, {}, {}))
    visit.looks("running", 3)
    assert (visit.session.state.doing, visit.session.state.held) == ("ready", False)
    assert visit.twin.asked[-1] == "stop"
    assert visit.happened[-1] is ChangeKind.REBOOTED
    assert visit.texts[-2:] == ["it began anew by itself", "it was stopped from here"]


def test_a_lost_link_is_closed_and_one_that_is_back_to_the_same_program_is_an_event() -> None:
    visit = Visit()
    visit.hears(News(1, {}, {0: 0}))
    visit.session.lose("the link is lost")
    assert (visit.session.state.lost, visit.session.state.threads) == ("the link is lost", {})
    assert visit.twin.asked == ["close"]
    with pytest.raises(NotConnectedError):
        visit.session.stop()
    twin = Twin("running", 60)
    visit.session.open(twin, twin.hello, InstalledProgram(NAMES))
    assert (visit.session.state.lost, visit.session.state.tick) == ("", 60)
    visit.session.lose("the link is lost")
    other = Twin("running", program="87654321")
    visit.session.open(other, other.hello, None)
    assert visit.texts == ["the link is lost", "the link is back", "the link is lost"]


def test_names_are_refused_where_there_are_none() -> None:
    visit = Visit()
    with pytest.raises(NoNameError):
        visit.session.force("Ear", 1)
    with pytest.raises(NoNameError):
        visit.session.set_variable("Sum", 1)
    with pytest.raises(NotConnectedError):
        Visit(known=None).session.set_variable("Count", 1)
    assert visit.twin.asked == []


def test_a_variable_that_was_set_and_a_sensor_that_is_forced_are_in_the_state_at_once() -> None:
    visit = Visit()
    visit.session.set_variable("Count", 9)
    visit.session.force("Eye", 4)
    assert (visit.session.state.cells, visit.session.state.forced) == ({2: 9}, {"Eye": 4})
    visit.session.force("Eye", None)
    assert visit.session.state.forced == {}
    assert visit.twin.asked == [("set", 2, 9), ("force", 1, 4), ("force", 1, None)]


def test_another_program_takes_the_place_of_the_one_before() -> None:
    visit = Visit()
    visit.hears(News(1, {2: 3}, {0: 0}))
    visit.session.replaced()
    assert visit.session.known is None
    assert (visit.session.state.doing, visit.session.state.threads) == ("ready", {})


def test_a_terminal_sees_names_or_numbers() -> None:
    lines: dict[bool, list[str]] = {}
    for known in (InstalledProgram(NAMES), None):
        twin = Twin("running")
        watched = WatchedRobot("socket://twin:1", twin, twin.hello, known)
        watched.begin(100)
        twin.stands("running", 2)
        twin.waiting.extend(
            [News(1, {0: 0, 1: 4, 2: 7}, {0: 0}), Text("hello\n"), News(2, {}, {}), News(2, {}, {0: None})]
        )
        lines[known is None] = []
        for _ in range(4):
            assert watched.listen(0) is None
            lines[known is None] += watched.describe(watched.news) if watched.news is not None else []
        assert watched.printed == ["hello"]
        assert watched.thread_places() == []
        assert twin.asked == [("watch", 100)]
    assert lines[False] == ["tick 1: Count = 7, Eye = 4, v1, line 1: Motor.Go();", "hello", "tick 2: nothing runs"]
    assert lines[True] == ["tick 1: cell 1 = 4, cell 2 = 7, instruction 0", "hello", "tick 2: nothing runs"]


def test_a_terminal_is_told_that_a_link_is_lost() -> None:
    twin = Twin("running")
    watched = WatchedRobot("socket://twin:1", twin, twin.hello, None)
    watched.begin(100)
    twin.broken = True
    assert isinstance(watched.listen(0), LineError)
    assert watched.session.state.lost == "the link is lost"
    watched.end()


def test_a_robot_whose_ticks_are_late_is_told_so_and_one_that_has_just_begun_is_not() -> None:
    assert not is_slow("running", 3, 3)
    assert is_slow("running", 4, 7)
    assert not is_slow("running", 4, 8)
    assert not is_slow("ready", 50, 50)
