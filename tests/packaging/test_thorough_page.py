"""Each test that `make test` leaves out says where its fact is held, and the page that lists them is current."""

from __future__ import annotations

import pytest

from tools import thorough_tests
from tools.thorough_tests import SkippedTest, find_skipped_tests

MARKED = """
import pytest
pytestmark = pytest.mark.thorough("test_a.py, on one mission")

@pytest.mark.thorough("test_b.py")
@pytest.mark.parametrize("x", [1, pytest.param(2, marks=pytest.mark.thorough("the first case"))])
def test_c(x): ...
"""


def test_the_page_is_current() -> None:
    assert thorough_tests.main(["--check"]) == 0


def test_marks_are_found_at_files_tests_and_cases() -> None:
    assert find_skipped_tests(MARKED, "tests/a/test_c.py") == [
        SkippedTest("tests/a/test_c.py", "all of it", "test_a.py, on one mission"),
        SkippedTest("tests/a/test_c.py", "test_c", "test_b.py"),
        SkippedTest("tests/a/test_c.py", "test_c", "the first case"),
    ]


@pytest.mark.parametrize("mark", ["pytest.mark.thorough", "pytest.mark.thorough()", "pytest.mark.thorough(' ')"])
def test_a_mark_that_says_nothing_is_told_with_its_place(mark: str) -> None:
    with pytest.raises(ValueError, match=r"test_c\.py, line 2: `thorough`"):
        find_skipped_tests(f"import pytest\n@{mark}\ndef test_c(): ...", "tests/a/test_c.py")


def test_a_test_of_the_page_that_is_not_there_is_told_with_its_place() -> None:
    mark = "@pytest.mark.thorough('web/src/features/none.test.tsx')\ndef test_c(): ..."
    with pytest.raises(ValueError, match=r"test_c\.py, line 1: there is no web/src/features/none\.test\.tsx"):
        find_skipped_tests(mark, "tests/a/test_c.py")
