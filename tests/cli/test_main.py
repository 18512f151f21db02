"""The command line as a whole: which word does what, and how everything ends."""

from __future__ import annotations

import pytest

import kitrobot as package
from kitrobot.cli import format
from kitrobot.cli.studio import StudioOptions


@pytest.fixture
def opened():
    """A studio that only remembers how it was opened."""
    return []


def test_without_anything_the_studio_is_opened(kitrobot, opened):
    assert kitrobot(studio=opened.append).status == 0
    assert opened == [StudioOptions(None, "127.0.0.1", None, True)]


def test_a_folder_or_a_mission_opens_the_studio_on_it(kitrobot, opened, here):
    (here / "m.krt").write_text("<kitrobot/>")
    for name in (".", "m.krt", str(here)):
        assert kitrobot(name, studio=opened.append).status == 0
    assert [str(opening.target) for opening in opened] == [".", "m.krt", str(here)]


@pytest.mark.parametrize("first", [[], ["studio"]])
def test_the_options_of_the_studio_stand_before_or_after_the_file(kitrobot, opened, here, first):
    (here / "m.krt").write_text("<kitrobot/>")
    kitrobot(*first, "--no-browser", "--port", 0, "m.krt", "--host", "localhost", studio=opened.append)
    assert (opened[0].browser, opened[0].port, opened[0].host) == (False, 0, "localhost")


def test_a_mission_called_like_a_command_opens_by_its_path(kitrobot, opened, here):
    (here / "run").mkdir()
    assert kitrobot("./run", studio=opened.append).status == 0
    assert len(opened) == 1


@pytest.mark.parametrize(
    ("words", "offer"),
    [(["frmat"], "kitrobot format"), (["chek"], "kitrobot check"), (["chek", "a.krt", "--json"], "kitrobot check")],
)
def test_a_word_that_is_no_command_gets_the_nearest_one(kitrobot, opened, words, offer):
    said = kitrobot(*words, studio=opened.append)
    assert (said.status, opened) == (2, [])
    assert offer in " ".join(said.err.split())


def test_a_word_like_nothing_gets_the_list(kitrobot, opened):
    said = kitrobot("zzzzzzz", studio=opened.append)
    assert said.status == 2
    for command in ("run", "convert", "exec", "check", "format", "studio"):
        assert command in said.err


@pytest.mark.parametrize("name", ["none.krt", "no/such/folder"])
def test_a_file_that_is_not_there_is_said(kitrobot, opened, name):
    said = kitrobot(name, studio=opened.append)
    assert (said.status, opened) == (1, [])
    assert f"there is no file or folder `{name}`" in said.err


def test_a_file_that_is_no_mission_is_said(kitrobot, opened, program):
    said = kitrobot(program, studio=opened.append)
    assert (said.status, opened) == (1, [])
    assert "kitrobot convert" in said.err


@pytest.mark.parametrize("arguments", [["--help"], ["-h"], ["run", "--help"], ["studio", "--help"], ["exec", "-h"]])
def test_help_is_given(kitrobot, arguments):
    said = kitrobot(*arguments)
    assert said.status == 0
    assert "Usage: kitrobot" in said.out


def test_the_main_help_names_every_command(kitrobot):
    out = kitrobot("--help").out
    for command in ("run", "convert", "exec", "check", "format", "studio"):
        assert command in out


def test_the_version_is_said(kitrobot):
    assert kitrobot("--version").out == f"kitrobot {package.__version__}\n"


def test_ctrl_c_ends_with_one_line(kitrobot, program, monkeypatch):
    def interrupted(*arguments: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(format, "_format", interrupted)
    said = kitrobot("format", program)
    assert (said.status, said.out, said.err) == (130, "", "broken off\n")


@pytest.mark.parametrize("error", [ZeroDivisionError("x"), RecursionError(), MemoryError(), AssertionError("no")])
def test_a_mistake_of_ours_is_one_sentence_and_how_to_report_it(kitrobot, program, monkeypatch, error):
    def broken(*arguments: object) -> None:
        raise error

    monkeypatch.setattr(format, "_format", broken)
    said = kitrobot("format", program)
    assert (said.status, said.out) == (70, "")
    assert type(error).__name__ in said.err
    assert "KITROBOT_DEBUG=1" in said.err


def test_the_operating_systems_refusal_is_a_sentence(kitrobot, program, monkeypatch):
    def refused(*arguments: object) -> None:
        raise OSError(28, "No space left on device", "x.lll")

    monkeypatch.setattr(format, "_format", refused)
    said = kitrobot("format", program)
    assert (said.status, said.err) == (1, "error: No space left on device: `x.lll`\n")


def test_without_a_studio_the_command_line_says_so(kitrobot):
    said = kitrobot()
    assert said.status == 1
    assert "without a studio" in said.err


@pytest.mark.parametrize("name", ["a\x1b[31m.lll", "a\x07.lll", "a\u202e.lll", "a\r.lll"])
def test_a_files_name_does_not_steer_the_terminal(kitrobot, name):
    err = kitrobot("format", name).err
    assert "a\ufffd" in err
    assert not set(err) & set("\x1b\x07\u202e\r")
