"""The page is rebuilt when its sources changed, and only then does a build ask for Node."""

from __future__ import annotations

from pathlib import Path

import pytest

from tools import page


@pytest.fixture
def sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A small `web/`, whose build is a copy of its index.html."""
    root = tmp_path / "web"
    (root / "src").mkdir(parents=True)
    (root / "index.html").write_text("<title>A page</title>\n")
    (root / "src" / "main.tsx").write_text("draw();\n")
    (root / "package-lock.json").write_text("{}\n")
    built = tmp_path / "package" / "static"
    monkeypatch.setattr(page, "WEB", root)
    monkeypatch.setattr(page, "PAGE", built)
    monkeypatch.setattr(page, "PAGE_STAMP", built / ".built-from")
    monkeypatch.setattr(page, "MODULES_STAMP", root / "node_modules" / ".installed-from")

    def npm(*arguments: str) -> None:
        if arguments[0] == "ci":
            (root / "node_modules").mkdir(exist_ok=True)
        else:
            folder = Path(arguments[arguments.index("--outDir") + 1])
            folder.mkdir()
            (folder / "index.html").write_bytes((root / "index.html").read_bytes())

    monkeypatch.setattr(page, "npm", npm)
    return root


def test_the_first_build_makes_the_page_and_the_second_does_nothing(sources: Path) -> None:
    assert not page.is_current()
    assert page.build()
    assert (page.PAGE / "index.html").read_text() == "<title>A page</title>\n"
    assert page.is_current()
    assert not page.build()


@pytest.mark.parametrize("change", ["edit", "add", "remove", "rename"])
def test_a_changed_source_makes_the_page_stale(sources: Path, change: str) -> None:
    page.build()
    main = sources / "src" / "main.tsx"
    if change == "edit":
        main.write_text("draw()\n")
    elif change == "add":
        (sources / ".npmrc").write_text("")
    elif change == "remove":
        main.unlink()
    else:
        main.rename(main.with_suffix(".ts"))
    assert not page.is_current()
    assert page.build()
    assert page.is_current()


@pytest.mark.parametrize("made", ["node_modules/react/index.js", "dist/index.html", "app.tsbuildinfo", ".DS_Store"])
def test_what_the_tools_make_leaves_the_page_current(sources: Path, made: str) -> None:
    page.build()
    path = sources / made
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("made by a tool")
    assert page.is_current()


def test_windows_line_ends_leave_the_page_current(sources: Path) -> None:
    page.build()
    (sources / "src" / "main.tsx").write_bytes(b"draw();\r\n")
    assert page.is_current()


def test_a_page_without_its_index_is_stale(sources: Path) -> None:
    page.build()
    (page.PAGE / "index.html").unlink()
    assert not page.is_current()


def test_a_failed_build_keeps_the_old_page(sources: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page.build()
    (sources / "index.html").write_text("<title>Broken</title>\n")

    def fail(*arguments: str) -> None:
        raise page.WebToolError("`node` ended with status 1")

    monkeypatch.setattr(page, "npm", fail)
    with pytest.raises(page.WebToolError, match="status 1"):
        page.build()
    assert (page.PAGE / "index.html").read_text() == "<title>A page</title>\n"
    assert not page.is_current()
    assert [path.name for path in page.PAGE.parent.iterdir()] == ["static"]


def test_modules_are_installed_once_for_each_lock(sources: Path) -> None:
    assert page.install_modules()
    assert not page.install_modules()
    (sources / "package-lock.json").write_text('{"name": "other"}\n')
    assert page.install_modules()


def test_an_unknown_command_is_refused_with_the_usage(capsys: pytest.CaptureFixture[str]) -> None:
    assert page.main(["bild"]) == 2
    assert "usage: page.py build | install" in capsys.readouterr().err
