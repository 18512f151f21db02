"""`kitrobot format`."""

from __future__ import annotations

import pytest

LAID_OUT = "# on\nLight.LightOn();  # bright\nWAIT(5);\n"
CROOKED = "# on\n Light.LightOn( ) # bright\n;WAIT ( 5 )"


def test_the_result_goes_to_standard_output_and_the_file_stays(kitrobot, here):
    (here / "a.lll").write_text(CROOKED)
    said = kitrobot("format", "a.lll")
    assert (said.status, said.out, said.err) == (0, LAID_OUT, "")
    assert (here / "a.lll").read_text() == CROOKED


def test_no_robot_is_needed_and_names_are_not_looked_at(kitrobot, here):
    (here / "a.lll").write_text("Nobody.Knows(1);")
    assert kitrobot("format", "a.lll").out == "Nobody.Knows(1);\n"


def test_the_result_laid_out_again_is_the_same(kitrobot, program, here):
    once = kitrobot("format", program).out
    (here / "b.lll").write_text(once)
    assert kitrobot("format", "b.lll").out == once


def test_write_puts_the_result_in_the_files_place(kitrobot, here):
    (here / "a.lll").write_text(CROOKED)
    said = kitrobot("format", "--write", "a.lll")
    assert (said.status, said.out) == (0, "")
    assert (here / "a.lll").read_text() == LAID_OUT


def test_write_leaves_a_file_that_is_right_alone(kitrobot, here):
    path = here / "a.lll"
    path.write_text(LAID_OUT)
    before = path.stat()
    assert kitrobot("format", "--write", "a.lll").status == 0
    assert (path.stat().st_mtime_ns, path.stat().st_ino) == (before.st_mtime_ns, before.st_ino)


def test_write_keeps_the_files_mode_and_follows_a_link(kitrobot, here):
    path, link = here / "a.lll", here / "link.lll"
    path.write_text(CROOKED)
    path.chmod(0o640)
    link.symlink_to(path)
    assert kitrobot("format", "--write", link).status == 0
    assert link.is_symlink()
    assert path.read_text() == LAID_OUT
    assert path.stat().st_mode & 0o777 == 0o640
    assert sorted(entry.name for entry in here.iterdir()) == ["a.lll", "link.lll"]


@pytest.mark.parametrize(("text", "status"), [(LAID_OUT, 0), (CROOKED, 1), ("", 0), ("\n", 1), (LAID_OUT + "\n", 1)])
def test_check_says_whether_a_file_would_change_and_writes_nothing(kitrobot, here, text, status):
    (here / "a.lll").write_text(text)
    said = kitrobot("format", "--check", "a.lll")
    assert (said.status, said.out) == (status, "")
    assert ("a.lll" in said.err) == bool(status)
    assert (here / "a.lll").read_text() == text


def test_other_line_ends_would_change_and_are_mended(kitrobot, here):
    (here / "a.lll").write_bytes(b"\xef\xbb\xbf" + LAID_OUT.replace("\n", "\r\n").encode())
    assert kitrobot("format", "--check", "a.lll").status == 1
    kitrobot("format", "--write", "a.lll")
    assert (here / "a.lll").read_bytes() == LAID_OUT.encode()


@pytest.mark.parametrize("options", [[], ["--write"], ["--check"]])
def test_a_mistake_exits_1_with_its_place_and_nothing_is_written(kitrobot, here, options):
    (here / "a.lll").write_text("Light.LightOn();\nWAIT(;\n")
    said = kitrobot("format", *options, "a.lll")
    assert (said.status, said.out) == (1, "")
    assert said.err.startswith("a.lll:2:6: error: ")
    assert (here / "a.lll").read_text() == "Light.LightOn();\nWAIT(;\n"


def test_every_one_of_ten_mistakes_is_told(kitrobot, here):
    (here / "a.lll").write_text("WAIT(;\n" * 10)
    err = kitrobot("format", "a.lll").err
    assert [number for number in range(1, 11) if f"a.lll:{number}:" in err] == list(range(1, 11))


def test_a_hint_is_no_mistake(kitrobot, here):
    (here / "a.lll").write_text("Light.LightOn() Light.LightOff()")
    said = kitrobot("format", "a.lll")
    assert (said.status, said.out) == (0, "Light.LightOn();\nLight.LightOff();\n")


def test_a_dash_reads_standard_input(kitrobot):
    said = kitrobot("format", "-", stdin=CROOKED.encode())
    assert (said.status, said.out) == (0, LAID_OUT)


def test_a_mistake_in_standard_input_is_told_with_its_place(kitrobot):
    said = kitrobot("format", "-", stdin=b"WAIT(;")
    assert (said.status, said.out) == (1, "")
    assert said.err.startswith("<stdin>:1:6: error: ")


def test_the_other_files_are_laid_out_after_one_with_a_mistake(kitrobot, here):
    (here / "a.lll").write_text("WAIT(;")
    (here / "b.lll").write_text(CROOKED)
    said = kitrobot("format", "--write", "a.lll", "none.lll", "b.lll")
    assert said.status == 1
    assert (here / "b.lll").read_text() == LAID_OUT


@pytest.mark.parametrize("options", [["--write", "--check", "a.lll"], ["--write", "-"], []])
def test_options_that_make_no_sense_are_refused(kitrobot, options):
    assert kitrobot("format", *options).status == 2


def test_characters_of_every_script_pass_whatever_the_locale(kitrobot, here):
    text = "# درائیو, é, 🤖\nموٹر.چلاؤ(5);\n"
    (here / "a.lll").write_text(text, encoding="utf-8")
    assert kitrobot("format", "a.lll").out == text


def test_bytes_that_are_no_text_are_told_with_their_place(kitrobot, here):
    (here / "a.lll").write_bytes(b"WAIT(1);\nab\xff;")
    said = kitrobot("format", "a.lll")
    assert (said.status, said.out) == (1, "")
    assert said.err.startswith("a.lll:2:3: error: ")


@pytest.mark.parametrize("name", ["none.lll", "."])
def test_a_file_that_is_not_there_is_a_sentence(kitrobot, name):
    said = kitrobot("format", name)
    assert said.status == 1
    assert f"`{name}`" in said.err


def test_the_nearest_name_is_offered(kitrobot, program):
    assert "did you mean `drive.lll`?" in kitrobot("format", "drvie.lll").err
