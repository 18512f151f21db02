"""What a writer of the product writes, its reader reads: every pair of the two, each with a test of random values.

| pair | test |
|---|---|
| missions `.krt` | `test_all_that_a_mission_says_comes_back` here, `tests/mission`, `tests/graph` |
| worlds, in files and in missions | `tests/mission/test_own_world.py` |
| kits `.board.xml` | `test_a_kit_comes_back` here |
| constructors, variables of one's own | `test_constructors_come_back` here |
| LLL | `tests/forms/test_parts_come_back.py`, `tests/forms/test_round_trips.py` |
| images `.kri`, listings `.kra` | `tests/image` |
| programs on boards `.krp` | `tests/deploy/test_program_file.py` |
| recordings `.krtrace` | `tests/trace`, `tests/robots/test_recording.py` |
| snapshots | `tests/sim/test_snapshots.py` |
| journals | `test_a_journal_comes_back` here |
| the record of a class, folders of pupils | `test_a_class_opens_again_whatever_its_pupils_are_called` here |
| what is handed in and out | `test_what_is_handed_in_is_listed_and_read`, `test_what_is_handed_out_is_read` here |
| an exercise as a ZIP file | `test_the_files_of_an_exercise_come_back` here |
| labels of boards, firmware of boards | `test_small_maps_come_back`, `test_labels_come_back` here |
| names of programs on boards, what recordings embed | `test_what_is_stored_of_a_program_comes_back` here |
| previews of examples | `test_a_preview_comes_back` here |
| messages of a team | `tests/team/test_messages.py`, `tests/fleet/test_messages.py`, `tests/fleet/test_bundles.py` |

Exercises, tutorials and robots are read only. Names are in their one form (NFC) when they are read.
"""

from __future__ import annotations

import string
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.boards import labels as board_labels
from kitrobot.boards.json_store import read_entries, write_entries
from kitrobot.boards.sent_programs import load_names, load_recording_context, store_names, store_recording_context
from kitrobot.classroom.admission import Admission, NameTakenError
from kitrobot.classroom.assignments import is_plain, pack, unpack
from kitrobot.classroom.class_room import ClassRoom
from kitrobot.classroom.names import InvalidNameError, as_file_name, free_name, is_file_name, key_of
from kitrobot.classroom.teacher_actions import TeacherActions
from kitrobot.files.folder import MissionFolder, MissionNameError
from kitrobot.files.journal_file import Journal, read_journal, write_journal
from kitrobot.graph.model import empty_program
from kitrobot.mission.breakdown import Breakdown, BreakdownRule
from kitrobot.mission.model import Agent, Goal, Mission, Team
from kitrobot.mission.radio import Radio
from kitrobot.mission.reader import read_mission
from kitrobot.mission.trial import Breakpoint, Failure, FailureKind
from kitrobot.mission.writer import SaveError, save, write_mission
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.kit import Kit, KitEvidence, Source
from kitrobot.primitives.kit_xml import read_kit, write_kit
from kitrobot.primitives.own_xml import write_constructors
from kitrobot.robots.names import BoardNames
from kitrobot.robots.recording_context import RecordingContext
from kitrobot.text.forms import name_form
from kitrobot.trace.model import TracePart
from kitrobot.translation.languages import TEXT_LANGUAGES
from kitrobot.workspace.previews import Preview, preview_from, preview_text, read_previews
from tests.effort import examples

DEVICES = ["con", "Aux", "NUL", "prn", "com1", "LPT³", "conin$"]
PIECES = st.one_of(
    st.text(max_size=8),
    st.text(alphabet=". ~-_/\\:*?\"<>|'", max_size=4),
    st.sampled_from(
        [*DEVICES, ".krt", ".xml", "grades.html", "class.toml", "log.txt", "Handed out", "😀" * 40, "\u200d"]
    ),
)
ODD = st.lists(PIECES, min_size=1, max_size=4).map("".join)
"""Names as nobody has them, and as somebody types them all the same."""
XML = st.characters(codec="utf-8", exclude_categories=["Cc", "Cs"], exclude_characters="\ufffe\uffff")
TEXTS = st.text(XML, min_size=1, max_size=12)
NAMES = TEXTS.map(name_form)
WORDS = TEXTS.map(lambda text: " ".join(text.split())).filter(bool)
LANGUAGES = st.dictionaries(st.sampled_from(TEXT_LANGUAGES), WORDS, max_size=3)


# ---- a class


@given(ODD)
def test_the_name_of_a_file_is_its_own_nearest_name(name: str) -> None:
    made = as_file_name(name)
    assert as_file_name(made) == made
    assert is_file_name(made)
    assert Path(made).name == made
    assert made == made.strip(" .~")
    stem = made.split(".")[0].rstrip().casefold()
    assert stem not in {one.casefold() for one in DEVICES}
    assert len(made.encode()) <= 160


@given(ODD, st.integers(1, 120))
def test_a_free_name_is_a_name_and_free(name: str, taken: int) -> None:
    wanted = as_file_name(name)
    there: list[str] = []
    for _ in range(min(taken, 12)):
        found = free_name(wanted, there)
        assert as_file_name(found) == found
        assert key_of(found) not in map(key_of, there)
        there.append(found)


@settings(max_examples=examples(30), deadline=None)
@given(st.lists(ODD, min_size=1, max_size=5), ODD)
def test_a_class_opens_again_whatever_its_pupils_are_called(
    tmp_path_factory: pytest.TempPathFactory, names: list[str], handed: str
) -> None:
    folder = tmp_path_factory.mktemp("class")
    room = ClassRoom(folder)
    for name in names:
        try:
            Admission(room).join(room.record.code, name, "", "x")
        except (InvalidNameError, NameTakenError):
            continue
    name, _ = TeacherActions(room).hand_out(handed, b"<kitrobot/>")
    room.close()
    again = ClassRoom(folder)
    again.close()
    assert again.record == room.record
    assert again.record.unread == []
    assert {path.name for path in folder.iterdir() if path.is_dir()} == {*again.pupils, "Handed out"}
    for pupil in again.pupils.values():
        assert again.read_handed(pupil) == b"<kitrobot/>", name


@settings(max_examples=examples(30), deadline=None)
@given(st.lists(st.tuples(ODD, st.binary(max_size=3)), max_size=4))
def test_what_is_handed_in_is_listed_and_read(
    tmp_path_factory: pytest.TempPathFactory, files: list[tuple[str, bytes]]
) -> None:
    room = ClassRoom(tmp_path_factory.mktemp("class"))
    pupil, _ = Admission(room).join(room.record.code, "Ada", "", "x")
    for name, data in files:
        handed = room.hand_in(pupil, name, data, "")
        assert room.read_submission(pupil, handed.name) == (data, handed.revision)
        assert room.hand_in(pupil, handed.name, data + b".", handed.revision).name == handed.name
    room.close()


@settings(max_examples=examples(30), deadline=None)
@given(ODD)
def test_what_is_handed_out_is_read(tmp_path_factory: pytest.TempPathFactory, name: str) -> None:
    room = ClassRoom(tmp_path_factory.mktemp("class"))
    pupil, _ = Admission(room).join(room.record.code, "Ada", "", "x")
    TeacherActions(room).hand_out(name, b"1")
    assert room.read_handed(pupil) == b"1"
    room.close()


@given(st.dictionaries(ODD.filter(is_plain), st.binary(max_size=20), max_size=4))
def test_the_files_of_an_exercise_come_back(files: dict[str, bytes]) -> None:
    files = {name: data for name, data in files.items() if name and "\0" not in name and name.isprintable()}
    assert unpack(pack(files)) == files


@settings(max_examples=examples(50), deadline=None)
@given(ODD)
def test_a_mission_that_can_be_saved_under_a_name_can_be_saved_again_and_is_listed(
    tmp_path_factory: pytest.TempPathFactory, stem: str
) -> None:
    folder = MissionFolder(tmp_path_factory.mktemp("missions"))
    name = f"{stem}.krt"
    try:
        path = folder.path_of(name)
    except MissionNameError:
        return
    try:
        save(path, Mission())
    except SaveError:
        return  # a folder in the name that is not there
    save(path, Mission(label={"": "again"}))
    data, _ = folder.read(name)
    assert read_mission(data, name)[0] == Mission(label={"": "again"})
    if not path.name.startswith("."):
        assert [one.path for one in folder.missions() if not one.example] == [path.relative_to(folder.root).as_posix()]


# ---- missions and parts

breakpoints = st.builds(
    Breakpoint,
    NAMES,
    NAMES,
    st.lists(NAMES, max_size=2).map(tuple),
    st.booleans(),
    st.one_of(st.just(""), NAMES),
    st.integers(1, 1_000_000),
    st.booleans(),
)
seconds = st.integers(0, 999_999_000).map(lambda ms: ms / 1000)
missions = st.builds(
    Mission,
    programs=st.lists(st.builds(empty_program, NAMES, NAMES), max_size=2, unique_by=lambda one: one.name),
    team=st.builds(
        Team,
        st.lists(st.builds(Agent, NAMES, NAMES, st.one_of(st.just(""), NAMES)), max_size=3, unique_by=lambda a: a.name),
        st.lists(st.builds(Goal, NAMES, st.one_of(st.just("all"), st.integers(0, 65535).map(str))), max_size=2),
    ),
    world_href=st.one_of(st.just(""), NAMES),
    label=LANGUAGES,
    help=LANGUAGES,
    breakpoints=st.lists(breakpoints, max_size=2),
    failures=st.lists(st.builds(Failure, NAMES, seconds, st.sampled_from(FailureKind)), max_size=2),
    radio=st.one_of(
        st.none(),
        st.builds(
            Radio,
            st.one_of(st.none(), st.integers(1000, 10**9).map(lambda mm: mm / 1000)),
            st.integers(0, 2000),
            st.integers(0, 100_000).map(lambda part: part / 1000),
        ),
    ),
    breakdown=st.one_of(
        st.just(Breakdown()),
        st.just(Breakdown(BreakdownRule.PASS)),
        st.builds(Breakdown, st.just(BreakdownRule.TOW), seconds),
    ),
)


@given(missions)
def test_all_that_a_mission_says_comes_back(made: Mission) -> None:
    data = write_mission(made)
    found, _ = read_mission(data, "m.krt")
    assert found == made
    assert write_mission(found) == data


@given(TEXTS)
def test_a_name_in_another_form_is_read_in_its_one_form(name: str) -> None:
    found, _ = read_mission(write_mission(Mission(team=Team([Agent(name, name)]))), "m.krt")
    assert found is not None
    assert found.team.agents == [Agent(name_form(name), name_form(name))]


kits = st.builds(
    Kit,
    st.text(alphabet="abZ0_-", min_size=1, max_size=8).map("k".__add__),
    st.just("machine"),
    pins=st.lists(st.sampled_from(["LED", "A0", *map(str, range(20))]), max_size=8, unique=True).map(tuple),
    micropython=st.sampled_from(["", "1.20", "1.9.4"]),
    tried=st.just(KitEvidence.HAND),
    tried_by=NAMES,
    sources=st.lists(st.builds(Source, st.just("https://example.org/a"), WORDS), max_size=2).map(tuple),
    supplies=st.lists(st.builds(lambda en, fr: {"": en, "fr": fr}, WORDS, WORDS), max_size=2).map(tuple),
    steps=st.lists(st.builds(lambda en: {"": en}, WORDS), max_size=2).map(tuple),
    label=LANGUAGES,
    help=LANGUAGES,
)


@given(kits)
def test_a_kit_comes_back(kit: Kit) -> None:
    text = write_kit(kit)
    found, _ = read_kit(text.encode(), "a.board.xml")
    assert found == kit
    assert write_kit(found) == text


@given(NAMES, LANGUAGES, LANGUAGES)
def test_constructors_come_back(name: str, label: dict[str, str], help: dict[str, str]) -> None:
    start = b"""<constructors version="1"><group name="g" colour="loop">
      <constructor name="Twice"><number name="count" min="1" max="9" default="2"/><flow name="body" loop="yes"/>
      <code>{count}*({body})</code></constructor></group></constructors>"""
    [group], _ = read_constructors(start, "c.xml")
    [constructor] = group.constructors
    made: Constructor = replace(constructor, name=name, label=label, help=help)
    data = write_constructors([made])
    groups, _ = read_constructors(data, "c.xml")
    found = [one for group in groups for one in group.constructors]
    assert write_constructors(found) == data
    assert [(one.name, one.label, one.help) for one in found] == [(name, label, help)]


# ---- files of the user's state folder


@given(st.text(max_size=8), st.text(max_size=8), st.lists(st.text(max_size=12), max_size=4), st.booleans())
def test_a_journal_comes_back(
    tmp_path_factory: pytest.TempPathFactory, path: str, name: str, records: list[str], unsaved: bool
) -> None:
    file = tmp_path_factory.mktemp("journal") / "0123456789abcdef.journal"
    made = Journal(path, name, tuple(records), unsaved and records != [])
    write_journal(file, made)
    assert read_journal(file) == made


@pytest.fixture
def state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path))
    return tmp_path


def in_state(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path_factory.mktemp("state")))


@settings(max_examples=examples(20), deadline=None)
@given(st.dictionaries(st.text(max_size=8), st.one_of(st.text(max_size=8), st.integers()), max_size=4))
def test_small_maps_come_back(tmp_path_factory: pytest.TempPathFactory, found: dict[str, Any]) -> None:
    with pytest.MonkeyPatch.context() as patch:
        in_state(tmp_path_factory, patch)
        write_entries("some", found, 1000)
        assert read_entries("some") == found


def test_a_map_that_is_too_large_to_be_read_loses_its_oldest_entries_and_no_more(state: Path) -> None:
    write_entries("some", {f"usb {number:04}": "آ" * 200 for number in range(1000)}, 1000)
    found = read_entries("some")
    assert 350 < len(found) < 1000
    assert [*found][-1] == "usb 0999"


@settings(max_examples=examples(20), deadline=None)
@given(st.lists(ODD, max_size=3))
def test_labels_come_back(tmp_path_factory: pytest.TempPathFactory, labels: list[str]) -> None:
    with pytest.MonkeyPatch.context() as patch:
        in_state(tmp_path_factory, patch)
        expected: dict[str, str] = {}
        for number, label in enumerate(labels):
            address = f"socket://board-{number}"
            try:
                kept = board_labels.store_label(address, label)
            except board_labels.LabelError:
                continue
            expected = {
                key: one for key, one in expected.items() if board_labels.label_key(one) != board_labels.label_key(kept)
            }
            if kept:
                expected[address] = kept
        assert board_labels.labels_of([f"socket://board-{number}" for number in range(3)]) == expected


@settings(max_examples=examples(20), deadline=None)
@given(NAMES, NAMES, st.dictionaries(NAMES, st.integers(0, 99), max_size=3), st.lists(NAMES, max_size=3).map(tuple))
def test_what_is_stored_of_a_program_comes_back(
    tmp_path_factory: pytest.TempPathFactory, program: str, robot: str, cells: dict[str, int], names: tuple[str, ...]
) -> None:
    with pytest.MonkeyPatch.context() as patch:
        in_state(tmp_path_factory, patch)
        places = (("v1", 1, program), (None, 2, robot))
        made = BoardNames(program, robot, 100, cells, cells, names, (1, 2), places)
        carried = RecordingContext(
            program, robot, (TracePart(program, robot),), names, (3,), {4: (program, robot, (5, 6))}
        )
        store_names(made, ["0123abcd"])
        store_recording_context(carried, ["0123abcd"])
        assert load_names("0123abcd") == made
        assert load_recording_context("0123abcd") == carried


@given(st.lists(st.text(alphabet="a\n\r\x85\u2028\u2029é", max_size=6), max_size=3))
def test_a_preview_comes_back(tmp_path_factory: pytest.TempPathFactory, names: list[str]) -> None:
    made = Preview([[name, "p", "r", 1] for name in names], 2.5, 3, [[1, 2, 3, 4, 5]], [], [], [], [], [])
    assert preview_from(preview_text(made)) == made
    file = tmp_path_factory.mktemp("previews") / "previews.jsonl"
    file.write_text("".join(f"{key} {preview_text(made)}\n" for key in string.ascii_lowercase[:2]), encoding="utf-8")
    assert [preview_from(line) for line in read_previews(file).values()] == [made, made]
