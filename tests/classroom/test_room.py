"""A class without HTTP: who comes in, what is kept, what outlives a kill."""

from __future__ import annotations

import pytest

from kitrobot.classroom import submissions
from kitrobot.classroom.admission import Admission, AdmissionRefusedError, NameTakenError
from kitrobot.classroom.class_room import MOST_NEWCOMERS, ClassError, ClassRoom
from kitrobot.classroom.pupil import GoalReport, Report, state_of
from kitrobot.classroom.record import read_record, unread_sentence
from kitrobot.classroom.teacher_actions import TeacherActions
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import FileError
from kitrobot.files.folder_quota import QuotaError
from tests.classroom.conftest import join


@pytest.mark.parametrize(
    ("name", "folder"),
    [
        ("Ada", "Ada"),
        ("  Ada   Lovelace ", "Ada Lovelace"),
        ("فاطمہ", "فاطمہ"),
        ("José", "José"),
        ("李小龙", "李小龙"),
        ("../../etc/passwd", "-..-etc-passwd"),
        ("C:\\Windows", "C--Windows"),
        ("CON", "CON-"),
        ("...a...", "a"),
        ("~a", "a"),
        ("\u202eada\u0000", "ada"),
        ("Handed out", "Handed out 2"),
        ("class.toml", "class.toml 2"),
        ("Con. Smith", "Con-. Smith"),
        ("Con.B", "Con-.B"),
        ("Aux. Bo", "Aux-. Bo"),
        ("Nul.1", "Nul-.1"),
        ("com1.Kim", "com1-.Kim"),
        ("conin$", "conin$-"),
        (". .Ada", "Ada"),
        ("~ .studios", "studios"),
        ("Ada~ .", "Ada"),
        ("grades.html", "grades.html 2"),
        ("Grades.CSV", "Grades.CSV 2"),
        ("log.txt", "log.txt 2"),
        ("tower.robot.xml", "tower.robot.xml 2"),
        ("a.krt", "a.krt 2"),
        ("😀" * 39 + "a", "😀" * 39 + "a"),
    ],
)
def test_a_name_in_any_script_gets_a_folder_that_leads_nowhere_else(room, admission, name, folder):
    pupil, _ = join(room, admission, name)
    assert pupil.folder == folder
    assert (room.folder / folder).is_dir()
    assert (room.folder / folder).resolve().parent == room.folder


@pytest.mark.parametrize(
    "name", ["", "   ", "...", "\u202e", "-/-", "x" * 41, "😀😀", "a" * 2000, "\u3164\uffa0", "\u2800"]
)
def test_a_name_that_nobody_can_have_is_a_sentence(room, admission, name):
    with pytest.raises(KitRobotError, match="this name"):
        join(room, admission, name)
    assert room.pupils == {}


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("Ada", "A\u200dda"),
        ("Ada", "Ada\ufe0f"),
        ("Ada", "\u3164Ada"),
        ("Ada", "Аda"),  # the first letter is Cyrillic
        ("Ada", "Αda"),  # and Greek
        ("ADA", "АДА".replace("Д", "D")),
        ("Ben", "Веn"),
        ("Sofia", "Ѕоfіа"),
        ("Jo", "Ｊｏ"),
        ("Jo", "𝐉𝐨"),
        ("Al", "AI"),
        ("Bo", "B0"),
        ("O'Brien", "O’Brien"),
        ("Anne-Marie", "Anne‐Marie"),
        ("José", "Jose\u0301"),
        ("علی", "علي"),
        ("کمال", "كمال"),
        ("محمد", "محـمد"),
        ("گروہ ۲", "گروه ٢"),
    ],
)
def test_names_that_look_the_same_are_one_name(room, admission, name, other):
    pupil, _ = join(room, admission, name)
    with pytest.raises(NameTakenError):
        join(room, admission, other)
    with pytest.raises(NameTakenError):
        TeacherActions(room).add(other)
    assert admission.join(room.record.code, other, pupil.record.word, "x")[0] is pupil


def test_of_two_of_before_whose_names_look_the_same_each_comes_back(tmp_path):
    rows = [
        f"[[pupil]]\nname = '{name}'\nfolder = '{name}'\nword = '{word}'"
        for name, word in (("Al", "BADOBA"), ("AI", "LIMOLI"))
    ]
    (tmp_path / "class.toml").write_text("\n".join(["name = 'c'", "code = 'BADOBA'", *rows]))
    room = ClassRoom(tmp_path)
    for name, word in (("Al", "BADOBA"), ("ai", "LIMOLI")):
        assert Admission(room).join("BADOBA", name, word, "x")[0].record.word == word
    room.close()


def test_names_that_look_different_are_two(room, admission):
    names = [
        "Ada",
        "Ida",
        "Ad",
        "Adа A",
        "Али",
        "Али А",
        "Iris",
        "Irís",
        "علی",
        "علیا",
        "Bob",
        "B-b",
        "Σ",
        "李",
        "李小",
    ]
    for name in names:
        join(room, admission, name)
    assert len(room.pupils) == len(names)


def test_a_key_leads_to_its_pupil_and_only_its_digest_is_kept(room, admission):
    pupil, key = join(room, admission)
    other, _ = join(room, admission, "Ben")
    assert room.pupil_of(key) is pupil is not other
    assert room.pupil_of(key + "x") is None
    assert room.pupil_of("") is None
    assert room.pupil_of("x" * 10_000) is None
    assert room.pupil_of("\ud800") is None
    assert key not in (room.folder / "class.toml").read_text()


def test_a_class_is_the_same_after_a_kill(tmp_path, clock):
    folder = tmp_path / "Class 5b"
    first = ClassRoom(folder, clock)
    pupil, key = join(first, Admission(first), 'Ada "\\ \x7f؟ K.')
    kept = first.hand_in(pupil, "square.krt", b"<kitrobot/>", "")
    TeacherActions(first).set_exercise("example:exercises/03-square.exercise.xml")
    TeacherActions(first).set_frozen(True)
    # As a kill leaves it: nothing is closed, the lock alone is gone.
    first.close()
    again = ClassRoom(folder, clock)
    found = again.pupil_of(key)
    assert found is not None
    assert (found.record.name, found.record.word) == (pupil.record.name, pupil.record.word)
    assert (found.work, found.revision) == (kept.name, kept.revision)
    assert again.record == first.record
    again.close()


def test_one_folder_is_one_class_at_a_time(room):
    with pytest.raises(ClassError, match="runs already"):
        ClassRoom(room.folder)


@pytest.mark.parametrize(
    "text",
    [
        "name = 3",
        "pupil = 3",
        "\x00",
        "[" * 100_000,
    ],
)
def test_a_class_file_that_makes_no_sense_is_a_sentence(tmp_path, text):
    (tmp_path / "class.toml").write_text(text)
    with pytest.raises(FileError, match=r"class\.toml") as raised:
        ClassRoom(tmp_path)
    assert "mend it" in raised.value.help
    assert (tmp_path / "class.toml").read_text() == text


@pytest.mark.parametrize(
    "wrong",
    [
        "[[pupil]]\nname = 'Ben'\nfolder = '../Ben'",
        "[[pupil]]\nname = 'Ben'\nfolder = '.studios'",
        "[[pupil]]\nname = 'Ben'\nfolder = 'Ada'",
        "[[pupil]]\nname = 'Ada'\nfolder = 'Ben'",
        "[[pupil]]\nname = 'Ben'\nfolder = 'Ben'\nhanded_file = '../../x'",
        "[[pupil]]\nname = 'Ben'\nfolder = 'Ben",
        "[[pupil]]\nname = 3\nfolder = 'Ben'\nhanded = 1\n# said by hand",
        "[[pupil]]",
    ],
)
def test_a_pupil_whose_lines_make_no_sense_is_left_out_and_the_others_are_there(tmp_path, wrong):
    def row(name: str) -> str:
        return f"[[pupil]]\nname = '{name}'\nfolder = '{name}'\nword = 'BADOBA'\n"

    head = "name = 'Class 5b'\ncode = 'BADOBA'\n"
    (tmp_path / "class.toml").write_text(head + row("Ada") + wrong + "\n" + row("Cem"))
    for _ in range(2):  # what is written then is read again
        room = ClassRoom(tmp_path)
        room.close()
        assert list(room.pupils) == ["Ada", "Cem"]
        assert wrong in (tmp_path / "class.toml").read_text()
        assert "is not in the class: from line" in (tmp_path / "log.txt").read_text()
        assert str(unread_sentence(room.record.unread[0])) in room.log.last()[0]


def test_a_pupil_in_another_encoding_is_left_out_byte_for_byte(tmp_path):
    head = b"name = 'Class 5b'\n[[pupil]]\nname = 'Ada'\nfolder = 'Ada'\n"
    zoe = "[[pupil]]\nname = 'Zoë'\nfolder = 'Zoë'\n".encode("latin-1")
    (tmp_path / "class.toml").write_bytes(head + zoe)
    room = ClassRoom(tmp_path)
    room.close()
    assert list(room.pupils) == ["Ada"]
    assert zoe.strip() in (tmp_path / "class.toml").read_bytes()
    assert "not text in UTF-8" in (tmp_path / "log.txt").read_text()


@pytest.mark.parametrize("end", ["\r\n", "\r"])
def test_a_class_file_may_have_the_line_ends_of_any_system(tmp_path, end):
    lines = ["name = 'Class 5b'", "code = 'BADOBA'", "# by hand", "[[pupil]]", "name = 'Ada'", "folder = 'Ada'"]
    (tmp_path / "class.toml").write_bytes(end.join(lines).encode())
    found = read_record(tmp_path)
    assert found is not None
    assert [one.name for one in found.pupils] == ["Ada"]


def test_a_class_file_cut_off_before_its_first_line_is_a_new_class(tmp_path):
    (tmp_path / "class.toml").write_text("")
    assert read_record(tmp_path) is None


def test_wrong_codes_are_counted_until_nobody_may_guess(room, admission, clock):
    wrong = "AAAAAA"
    for _ in range(10):
        with pytest.raises(AdmissionRefusedError, match="not the code"):
            admission.join(wrong, "Eve", "", "10.0.0.9")
    with pytest.raises(AdmissionRefusedError, match="too many"):
        admission.join(room.record.code, "Eve", "", "10.0.0.9")
    # Others are let in, and after a while who guessed is, too.
    join(room, admission)
    clock.now += 60
    admission.join(room.record.code, "Eve", "", "10.0.0.9")


def test_a_class_behind_one_address_is_not_held_up_by_those_who_mistype(room, admission):
    join(room, admission, "Pupil 0")
    for _ in range(100):
        with pytest.raises(AdmissionRefusedError, match="not the code"):
            admission.join("AAAAAA", "Eve", "", "10.0.0.5")
    for at in range(1, 40):
        join(room, admission, f"Pupil {at}")
    # Guessing has an end there too.
    for _ in range(20):
        with pytest.raises(AdmissionRefusedError):
            admission.join("AAAAAA", "Eve", "", "10.0.0.5")
    with pytest.raises(AdmissionRefusedError, match="too many"):
        admission.join("AAAAAA", "Eve", "", "10.0.0.5")


def test_guesses_from_elsewhere_do_not_hold_up_a_class_that_comes_in(room, admission):
    join(room, admission, "Ada")
    for at in range(200):
        with pytest.raises(AdmissionRefusedError):
            admission.join("AAAAAA", "Eve", "", f"10.0.1.{at}")
    join(room, admission, "Ben")


def test_wrong_words_of_one_pupil_hold_up_neither_others_nor_newcomers(room, admission, clock):
    ada, _ = join(room, admission, "Ada")
    ben, _ = join(room, admission, "Ben")
    for _ in range(10):
        with pytest.raises(AdmissionRefusedError, match="not the word"):
            admission.join(room.record.code, "Ada", "AAAAAA", "10.0.0.5")
    with pytest.raises(AdmissionRefusedError, match="too many wrong words"):
        admission.join(room.record.code, "Ada", ada.record.word, "10.0.0.5")
    admission.join(room.record.code, "Ada", ada.record.word, "10.0.0.6")
    admission.join(room.record.code, "Ben", ben.record.word, "10.0.0.5")
    join(room, admission, "Cyd")
    clock.now += 60
    admission.join(room.record.code, "Ada", ada.record.word, "10.0.0.5")


def test_new_pupils_from_one_address_are_counted_until_the_teacher_makes_room(room, admission, clock):
    for at in range(MOST_NEWCOMERS):
        join(room, admission, f"Pupil {at}")
    with pytest.raises(AdmissionRefusedError, match="very many new pupils"):
        join(room, admission, "One more")
    admission.join(room.record.code, "Elsewhere", "", "10.0.0.6")
    clock.now += 60
    join(room, admission, "After a minute")
    TeacherActions(room).set_places(200)
    join(room, admission, "At once")


def test_those_who_came_in_and_did_nothing_are_removed_together(room, admission):
    ada, _ = join(room, admission, "Ada")
    room.hand_in(ada, "a", b"1", "")
    here, _ = join(room, admission, "Here")
    room.open_page(here)
    TeacherActions(room).add("Later")
    for at in range(30):
        join(room, admission, f"Invented {at}")
    assert TeacherActions(room).remove_idle() == 30
    assert {one.record.name for one in room.pupils.values()} == {"Ada", "Here", "Later"}
    assert not (room.folder / "Invented 0").exists()
    again, _ = join(room, admission, "Invented 0")
    assert again.folder == "Invented 0"


def test_a_raised_hand_and_what_the_teacher_wrote_are_there_after_a_restart(room, admission, clock):
    ada, _ = join(room, admission, "Ada")
    room.set_hand(ada, up=True)
    TeacherActions(room).send_note(ada, 'Look at "this"')
    TeacherActions(room).send_note(ada, "and that")
    room.close()
    again = ClassRoom(room.folder, clock)
    found = again.pupils["Ada"]
    status = again.status_of(found)
    assert (status.hand, status.note, status.note_text) == (True, 2, "and that")
    again.set_hand(found, up=False)
    TeacherActions(again).send_note(found, "more")
    again.close()
    last = ClassRoom(room.folder, clock)
    status = last.status_of(last.pupils["Ada"])
    assert (status.hand, status.note, status.note_text) == (False, 3, "more")
    last.close()


def test_guesses_from_many_addresses_are_counted_together(room, admission):
    for at in range(120):
        with pytest.raises(AdmissionRefusedError):
            admission.join("AAAAAA", "Eve", "", f"10.0.1.{at}")
    with pytest.raises(AdmissionRefusedError, match="too many"):
        admission.join(room.record.code, "Eve", "", "10.0.2.1")


def test_a_code_is_typed_in_any_case_with_spaces(room, admission):
    code = room.record.code
    assert admission.join(f" {code[:3].lower()} - {code[3:]}", "Ada", "", "x")[0].record.name == "Ada"


def test_a_revoked_code_lets_nobody_in_and_who_is_in_stays(room, admission):
    code = room.record.code
    pupil, key = join(room, admission)
    TeacherActions(room).set_code(False)
    for given in (code, ""):
        with pytest.raises(AdmissionRefusedError, match="nobody can join"):
            admission.join(given, "Ben", "", "x")
    assert room.pupil_of(key) is pupil
    TeacherActions(room).set_code(True)
    assert room.record.code not in ("", code)


def test_a_pupil_comes_back_with_the_word_and_with_no_other(room, admission):
    pupil, key = join(room, admission)
    with pytest.raises(NameTakenError):
        admission.join(room.record.code, "ADA", "", "x")
    with pytest.raises(AdmissionRefusedError, match="not the word"):
        admission.join(room.record.code, "Ada", "WRONGS", "x")
    again, other = admission.join(room.record.code, "ada", pupil.record.word.lower(), "x")
    assert again is pupil
    assert other != key
    assert room.pupil_of(key) is room.pupil_of(other) is pupil


def test_a_pupil_comes_back_with_the_teachers_yes_and_the_answer_is_given_once(room, admission, clock):
    pupil, _ = join(room, admission)
    asked = admission.request(room.record.code, "Ada", "x")
    assert admission.pending() == {asked: "Ada"}
    assert admission.take_answer(asked) == (None, None, "")
    admission.answer(asked, True)
    admission.answer(asked, False)
    yes, who, key = admission.take_answer(asked)
    assert yes
    assert who is pupil
    assert room.pupil_of(key) is pupil
    with pytest.raises(AdmissionRefusedError):
        admission.take_answer(asked)
    no = admission.request(room.record.code, "Ada", "x")
    admission.answer(no, False)
    assert admission.take_answer(no) == (False, pupil, "")
    late = admission.request(room.record.code, "Ada", "x")
    clock.now += 3600
    assert late not in admission.pending()
    with pytest.raises(ClassError, match="no `Eve`"):
        admission.request(room.record.code, "Eve", "x")


def test_a_removed_pupil_is_out_and_the_work_stays(room, admission):
    pupil, key = join(room, admission)
    room.hand_in(pupil, "a", b"1", "")
    TeacherActions(room).remove(pupil)
    assert room.pupil_of(key) is None
    assert (room.folder / "Ada" / "a.krt").read_bytes() == b"1"
    again, _ = join(room, admission)
    assert again.folder == "Ada 2"


def test_a_class_takes_so_many_pupils_and_not_one_more_until_its_teacher_makes_room(room, admission):
    TeacherActions(room).set_places(3)
    for at in range(3):
        join(room, admission, f"Pupil {at}")
    with pytest.raises(ClassError, match="3 pupils already"):
        join(room, admission, "One more")
    TeacherActions(room).set_places(4)
    join(room, admission, "One more")
    assert read_record(room.folder) == room.record


def test_work_goes_on_where_it_was_and_never_over_another(room, admission):
    pupil, _ = join(room, admission)
    first = room.hand_in(pupil, "Square.krt", b"1", "")
    second = room.hand_in(pupil, first.name, b"2", first.revision)
    assert first.name == second.name == "Square.krt"
    anew = room.hand_in(pupil, "square", b"the exercise begun again", "")
    assert anew.name == "square 2.krt"
    assert room.read_submission(pupil, "Square.krt")[0] == b"2"
    # The same bytes once more are the same file: an answer that was lost makes no second one.
    assert room.hand_in(pupil, "square.krt", b"2", "").name == "Square.krt"
    assert {one.name for one in room.list_submissions(pupil)} == {"Square.krt", "square 2.krt"}


@pytest.mark.parametrize(
    "name", ["../../x", "/etc/passwd", "..", "", "a/b/../../c", "a\\..\\b", "x\0y", ".", "CON", "~x"]
)
def test_work_stays_in_the_folder_of_its_pupil(room, admission, name):
    pupil, _ = join(room, admission)
    kept = room.hand_in(pupil, name, b"1", "")
    assert [path.name for path in (room.folder / "Ada").iterdir()] == [kept.name]
    assert kept.name.endswith(".krt")


@pytest.mark.parametrize("name", ["../Ben/secret.krt", "../class.toml", "/etc/passwd", "a\0", "", "nothing.krt", "."])
def test_only_a_pupils_own_files_are_read(room, admission, name):
    pupil, _ = join(room, admission)
    ben, _ = join(room, admission, "Ben")
    room.hand_in(ben, "secret", b"1", "")
    with pytest.raises(FileError):
        room.read_submission(pupil, name)


def test_a_folder_takes_so_many_files_and_bytes(room, admission, monkeypatch):
    monkeypatch.setattr(submissions, "MOST_FILES", 2)
    monkeypatch.setattr(submissions, "MOST_BYTES", 100)
    monkeypatch.setattr(submissions, "LARGEST_BYTES", 80)
    pupil, _ = join(room, admission)
    a = room.hand_in(pupil, "a", b"x" * 80, "")
    with pytest.raises(QuotaError, match="larger"):
        room.hand_in(pupil, "b", b"x" * 81, "")
    with pytest.raises(QuotaError, match="MB already"):
        room.hand_in(pupil, "b", b"x" * 21, "")
    room.hand_in(pupil, "b", b"x" * 20, "")
    room.hand_in(pupil, "a", b"y" * 80, a.revision)
    with pytest.raises(QuotaError, match="2 files already"):
        room.hand_in(pupil, "c", b"", "")


def test_the_state_of_a_pupil(room, admission, clock):
    pupil, _ = join(room, admission)
    exercise = "x"

    def state():
        return state_of(pupil, exercise, 2, clock.now)

    assert state() == ("away", None)
    room.open_page(pupil)
    assert state() == ("editing", None)
    clock.now += 239
    assert state() == ("editing", None)
    clock.now += 1
    assert state() == ("stuck", 240)
    room.take_report(pupil, Report(edits=1))
    assert state() == ("editing", None)
    room.take_report(pupil, Report(running=True, edits=1, runs=1))
    assert state() == ("running", None)
    goals = (GoalReport(True), GoalReport(True))
    room.take_report(pupil, Report(edits=1, runs=1, exercise="x", goals=goals))
    clock.now += 1000
    assert state() == ("done", None)
    room.take_report(pupil, Report(edits=1, runs=1, exercise="another", goals=goals))
    assert state() == ("stuck", 1000)
    room.set_hand(pupil, up=True)
    clock.now += 30
    assert state() == ("asks", 30)
    room.set_hand(pupil, up=False)
    room.close_page(pupil)
    clock.now += 60
    assert state() == ("away", 60)


def test_what_pupils_are_told_is_told_when_it_changes(room, admission):
    pupil, _ = join(room, admission)
    actions = TeacherActions(room)
    heard: list[int] = []
    end = room.subscribe(lambda: heard.append(1))
    name, count = actions.hand_out("My mission.krt", b"<kitrobot/>")
    assert (name, count) == ("My mission", 1)
    assert room.status_of(pupil).handed == 1
    assert room.read_handed(pupil) == b"<kitrobot/>"
    actions.send_note(pupil, "look\nat the loop " + "x" * 1000)
    assert room.status_of(pupil).note == 1
    assert len(room.status_of(pupil).note_text) == 500
    actions.view_pupil(pupil)
    actions.set_frozen(True)
    status = room.status_of(pupil)
    assert status.looked
    assert status.frozen
    assert len(heard) == 4
    end()
    actions.set_frozen(False)
    assert len(heard) == 4


def test_a_mission_is_handed_out_to_some(room, admission):
    ada, _ = join(room, admission)
    ben, _ = join(room, admission, "Ben")
    assert TeacherActions(room).hand_out("x", b"1", ["Ben"]) == ("x", 1)
    assert (room.status_of(ada).handed, room.status_of(ben).handed) == (0, 1)
    with pytest.raises(FileError):
        room.read_handed(ada)


def test_the_log_says_who_came_and_what_was_refused(room, admission):
    pupil, _ = join(room, admission)
    room.open_page(pupil)
    room.hand_in(pupil, "a", b"1", "")
    room.hand_in(pupil, "a", b"1", "")
    with pytest.raises(AdmissionRefusedError):
        admission.join("AAAAAA", "Eve", "", "10.0.0.9")
    lines = [line[21:] for line in (room.folder / "log.txt").read_text().splitlines()]
    assert lines == [
        "Ada joined",
        "Ada is here",
        "Ada handed in a.krt",
        "that is not the code of this class (from 10.0.0.9)",
    ]
    assert room.log.last()[0].endswith("(from 10.0.0.9)")
