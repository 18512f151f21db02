"""Files and functions can be read at once (CONTRIBUTING.md, How we write)."""

from __future__ import annotations

from pathlib import Path

import pytest

from tools import sizes
from tools.sizes import problems


def test_no_file_and_no_function_is_too_large_and_every_exception_is_one_that_is_needed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    needless = ("src/kitrobot/api/trial.py: no_such_function", "lines")
    monkeypatch.setitem(sizes.EXCEPTIONS, needless, "for this test")
    assert problems() == [f"{needless[0]}: is an exception without need; lines, at most 60"]


def test_each_limit_holds_at_it_and_not_one_over_it(tmp_path: Path) -> None:
    (tmp_path / "src").mkdir()
    body = "    pass\n"
    names = ", ".join(f"p{n}" for n in range(7))
    fits = f"class A:\n    def f(self, {names}, *more):\n        pass\n\n\ndef g():\n" + 59 * body
    too_large = f"def f({names}, *more, key):\n" + body + "\n\ndef g():\n" + 60 * body
    (tmp_path / "src" / "fits.py").write_text(fits + (400 - fits.count("\n")) * "#\n")
    (tmp_path / "src" / "too_large.py").write_text(too_large + (401 - too_large.count("\n")) * "#\n")
    assert [line.partition(";")[0] for line in problems(tmp_path)] == [
        "src/too_large.py: 401 lines of a file, at most 400",
        "src/too_large.py: f: 9 parameters, at most 8",
        "src/too_large.py: g: 61 lines, at most 60",
    ]
