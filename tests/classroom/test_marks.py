"""Marks of a class: kept in its file, and as CSV for gradebooks."""

from __future__ import annotations

import csv
import io

import pytest

from kitrobot.classroom.class_room import ClassRoom
from kitrobot.classroom.gradebook_list import _COLUMNS, GradebookListError, parse_gradebook_list, read_gradebook_list
from kitrobot.classroom.gradebook_tables import GRADEBOOKS, Gradebook, marks_as_csv
from kitrobot.classroom.marks import MOST_MARKS, Mark, put_mark
from kitrobot.classroom.record import ClassRecord, PupilRecord, read_record
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.translation.catalogue import catalogue
from kitrobot.translation.languages import TRANSLATED
from tests.classroom.conftest import join

SQUARE = Mark("example:square", "A square", 3, 5, "Well done")
LINE = Mark("line.exercise.xml", "Follow, the “line”", 0, 2)
MOODLE = "First name,Last name,ID number,Email address\r\nAda,Lovelace,7,ada@school.org\r\nBen,Ali,,ben@school.org\r\n"
CANVAS = (
    "\ufeffStudent,ID,SIS User ID,SIS Login ID,Section\r\n"
    "    Points Possible,,,,\r\n"
    '"Lovelace, Ada",4711,s1,ada,5b\r\n'
    '"Student, Test",1,,,5b\r\n'
)


def pupil(name: str, *marks: Mark) -> PupilRecord:
    return PupilRecord(name, name, "WORD", marks=list(marks))


def rows(gradebook: Gradebook, pupils: list[PupilRecord], listed: str = "") -> list[list[str]]:
    found = parse_gradebook_list(listed.encode()) if listed else []
    text = marks_as_csv(gradebook, pupils, found).text
    assert text.startswith("\ufeff"), "Excel takes UTF-8 for another encoding without it"
    return list(csv.reader(io.StringIO(text.removeprefix("\ufeff"), newline=""), strict=True))


def read(room: ClassRoom) -> ClassRecord:
    found = read_record(room.folder)
    assert found is not None
    return found


def test_moodle_gets_a_column_that_names_the_pupil_and_points_with_feedback():
    assert rows("moodle", [pupil("ada lovelace", SQUARE, LINE), pupil("Ben")], MOODLE) == [
        [
            *("Email address", "Full name", "A square (max 5)", "A square (Feedback)"),
            *("Follow, the “line” (max 2)", "Follow, the “line” (Feedback)"),
        ],
        ["ada@school.org", "Ada Lovelace", "3", "Well done", "0", ""],
        ["ben@school.org", "Ben Ali", "-", "", "-", ""],
    ]


def test_canvas_gets_its_columns_in_its_order_and_the_points_possible():
    assert rows("canvas", [pupil("Ada Lovelace", SQUARE), pupil("Eve")], CANVAS) == [
        ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "A square"],
        ["    Points Possible", "", "", "", "", "5"],
        ["Lovelace, Ada", "4711", "s1", "ada", "5b", "3"],
        ["Eve", "", "", "", "", ""],
    ]


def test_a_plain_sheet_has_names_points_and_comments():
    assert rows("sheet", [pupil("Ada", SQUARE)]) == [
        ["Name", "A square (max 5)", "A square (comment)"],
        ["Ada", "3", "Well done"],
    ]


def test_a_line_for_moodle_never_lacks_what_names_the_pupil():
    """Moodle gives the points of such a line to the pupil of the line before."""
    for listed in ("", MOODLE, MOODLE.replace("ben@school.org", "")):
        lines = rows("moodle", [pupil("Ada"), pupil("Ben Ali"), pupil("Eve", SQUARE)], listed)
        assert all(line[0] for line in lines)
        assert lines[-1][0] == "? Eve"


@pytest.mark.parametrize("gradebook", GRADEBOOKS)
@pytest.mark.parametrize("nasty", ["=1+1", "+4", "@SUM(A1)", "-2", "\t=1", "＝1", 'x,=cmd|"/c calc"', "a;=1", '"=1'])
def test_no_cell_begins_as_a_formula(gradebook, nasty):
    mark = Mark(nasty, nasty, 1, 2, nasty)
    listed = f'Name,Email address,ID,Section\r\n"{nasty.replace(chr(34), chr(34) * 2)}",=1,+2,@x\r\n'
    for line in rows(gradebook, [pupil(nasty, mark), pupil("Ada")], listed):
        for cell in line:
            for part in csv.reader([cell], delimiter=";"):
                assert not any(one.strip(" \t\"'")[:1] in tuple("=+@＝") and "'" not in one for one in part), cell


@pytest.mark.parametrize("gradebook", GRADEBOOKS)
def test_names_with_commas_quotes_and_line_breaks_stay_in_their_cell(gradebook):
    names = ["Lovelace, Ada", 'Ada "the" Countess', "آدا لولیس", "Zoë\u202e"]
    mark = Mark("x", "Two\r\nlines; and, more", 1, 2, "one\r\ntwo")
    found = rows(gradebook, [pupil(name, mark) for name in names])
    assert len({len(line) for line in found}) == 1
    assert all(any(name in line for line in found) for name in names)
    assert not any("\n" in cell for cell in found[0]), "Canvas counts commas of the first lines"


def test_two_exercises_of_one_title_are_two_columns():
    one, other = Mark("a", "Square", 1, 2), Mark("b", "Square", 2, 2)
    head, line = rows("sheet", [pupil("Ada", one, other)])
    assert head[1::2] == ["Square (max 2)", "Square [b] (max 2)"]
    assert line[1::2] == ["1", "2"]


def test_pupils_without_work_and_a_class_without_marks_have_their_lines():
    assert rows("sheet", [pupil("Ada")]) == [["Name"], ["Ada"]]
    assert rows("canvas", [])[1:] == [["    Points Possible", "", "", "", ""]]


def test_nobody_gets_the_marks_of_another_of_that_name():
    listed = parse_gradebook_list(
        b"Name,Email address\nAda King,1@x\nAda Byron,2@x\nBen Ali,3@x\nBen Ali,4@x\nEve X,5@x\n"
    )
    pupils = [pupil("Ada"), pupil("Ben Ali"), pupil("ada king"), pupil("Eve"), pupil("Eve X")]
    made = marks_as_csv("moodle", pupils, listed)
    # Of two first names one is claimed in full: the one that is left is no guess any more.
    assert made.unlisted == ("Ben Ali", "Eve")
    assert [line.split(",")[0] for line in made.text.splitlines()[1:]] == ["2@x", "? Ben Ali", "1@x", "? Eve", "5@x"]
    assert marks_as_csv("moodle", [pupil("Ada")], listed).unlisted == ("Ada",)


@pytest.mark.parametrize("parts_at", [",", ";", "\t"])
@pytest.mark.parametrize(
    "head",
    [
        "First name,Last name,E-mail",
        "Prénom,Nom,Adresse de courriel",
        "Prénom,Nom de famille,Adresse e-mail",
        "نام,خاندانی نام,ای میل",
        "Nombre,Apellido(s),Dirección de correo",
        "NOMBRE,APELLIDOS,Correo electrónico",
        "Nome,Sobrenome,Endereço de email",
        "Nome,Apelido,Endereço de e-mail",
    ],
)
def test_columns_of_a_list_are_found_by_their_names(head, parts_at):
    text = f"\ufeff{head}\r\nAda,King,a@x\r\n".replace(",", parts_at)
    (found,) = parse_gradebook_list(text.encode())
    assert found.values["email"] == "a@x"
    assert "ada" in found.first_name() or found.name.startswith("Ada")


@pytest.mark.parametrize(
    ("head", "nobody"),
    [
        ("Student,ID,SIS User ID,SIS Login ID,Section", "    Points Possible"),
        ("Estudiante,ID,ID de usuario de SIS,ID de inicio de sesión de SIS,Sección", "    Puntos posibles"),
        ("Aluno,ID,ID de usuário do SIS,ID de login do SIS,Seção", "    Pontos possíveis"),
        ("Étudiant,ID,ID utilisateur SIS,ID de connexion SIS,Section", "    Points possibles"),
    ],
)
def test_the_columns_of_canvas_are_found_and_the_line_of_points_is_of_nobody(head, nobody):
    text = f'{head}\r\n{nobody},,,,\r\n"King, Ada",4711,s1,ada,5b\r\n'
    (found,) = parse_gradebook_list(text.encode())
    assert found.name == "King, Ada"
    assert {key: found.values[key] for key in ("id", "sis_user", "sis_login", "section")} == {
        "id": "4711",
        "sis_user": "s1",
        "sis_login": "ada",
        "section": "5b",
    }


@pytest.mark.parametrize(
    "head", ["Nombre,Número de ID,Nombre de usuario", "Nome,Número de identificação,Nome de utilizador"]
)
def test_numbers_and_users_of_moodle_are_found_and_a_whole_name_may_stand_under_the_first(head):
    (found,) = parse_gradebook_list(f"{head}\nAda King,7,ada\n".encode())
    assert (found.values["number"], found.values["username"]) == ("7", "ada")
    assert "ada king" in found.names()


def test_every_language_has_a_word_for_every_column():
    """One column of a list is one thing: no word of a language stands for two."""
    for language in TRANSLATED:
        known: dict[str, str] = {}
        for key, words in _COLUMNS.items():
            for word in words:
                text = catalogue(language).word("column", word)
                assert text, (language, word)
                for one in text.split("|"):
                    assert known.setdefault(one.strip().casefold(), key) == key, (language, one)


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\x00\xff\xfe",
        b"a,b\n1,2\n",
        b"\xff\xfeN\x00a\x00m\x00e\x00",
        b'Name\n"' + b"x" * 200_000,
        b"," * 5_000_000,
    ],
)
def test_a_list_that_is_none_is_a_sentence(data):
    with pytest.raises(GradebookListError) as refused:
        parse_gradebook_list(data)
    assert "gradebook.csv" in str(refused.value)
    assert refused.value.help


def test_a_list_that_is_a_folder_is_a_sentence(tmp_path):
    (tmp_path / "gradebook.csv").mkdir()
    with pytest.raises(KitRobotError):
        read_gradebook_list(tmp_path)


def test_marks_are_there_after_a_restart(room, admission):
    join(room, admission)
    nasty = Mark("x", 'a "]]\n[[pupil]]', None, 0, "\\ [[pupil]] \x7f ؟")
    room.pupils["Ada"].record.marks = [SQUARE, nasty]
    room.notify(kept=True)
    (kept,) = read(room).pupils
    assert kept.marks[0] == SQUARE
    assert (kept.marks[1].label, kept.marks[1].points) == (nasty.label, None)
    assert not read(room).unread


@pytest.mark.parametrize(
    "wrong",
    [
        "mark = 3",
        "mark = [3]",
        "mark = [{}]",
        'mark = [{exercise = "x", points = -1}]',
        'mark = [{exercise = "x", of = "many"}]',
    ],
)
def test_a_pupil_with_a_mark_that_makes_no_sense_is_left_out_and_the_lines_stay(room, wrong):
    file = room.folder / "class.toml"
    file.write_text(f'{file.read_text()}\n[[pupil]]\nname = "Ada"\nfolder = "Ada"\n{wrong}\n')
    found = read(room)
    assert (found.pupils, [one.name for one in found.unread]) == ([], ["Ada"])


def test_a_pupil_has_so_many_marks_and_the_oldest_goes():
    made: list[Mark] = []
    for number in range(MOST_MARKS + 1):
        made = put_mark(made, Mark(str(number), ""))
    assert [len(made), made[0].exercise] == [MOST_MARKS, "1"]
    assert put_mark(made, Mark("1", "", 5))[0].points == 5
