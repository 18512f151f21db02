"""Write the teachers' pages, `docs/teachers/`, from the tutorials: one for each that comes with KitRobot, and a list.

python tools/teacher_pages.py            write them
python tools/teacher_pages.py --check    exit with 1 when one is not what the tutorials say
"""

from __future__ import annotations

import re
import sys
from pathlib import Path, PurePosixPath

from kitrobot.live.studio import Studio
from kitrobot.tutorial.model import Tutorial

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "docs" / "teachers"
_NAMES = re.compile(r"\{([^{}|]+)\}")
_EITHER = re.compile(r"\{([^{}|]*)\|[^{}|]*\}")


def pages() -> dict[str, str]:
    """The files by their names."""
    studio = Studio(ROOT, None)
    assert studio.folder.examples == (ROOT / "examples").resolve()
    found = {
        PurePosixPath(one.name).name.removesuffix(".tutorial.xml"): one.lesson
        for one in studio.tutorials.all()
        if one.name.startswith("example:") and one.lesson is not None
    }
    made = {f"{name}.md": _page(tutorial) for name, tutorial in found.items() if tutorial.teacher is not None}
    return {"README.md": _list(found), **made}


def _list(tutorials: dict[str, Tutorial]) -> str:
    lines = [
        "# For teachers",
        "",
        "A page for each tutorial: its aim, how long it takes, what goes wrong, and what to ask afterwards. The studio",
        "shows the same, in the reader's language, under the tutorial's card in *Help → Learn step by step*.",
        "",
        "| tutorial | minutes | aim |",
        "|---|---|---|",
    ]
    for name, tutorial in tutorials.items():
        if tutorial.teacher is not None:
            page = tutorial.teacher
            lines.append(f"| [{tutorial.label['']}]({name}.md) | {page.minutes} | {page.aim['']} |")
    return "\n".join([*lines, ""])


def _page(tutorial: Tutorial) -> str:
    page = tutorial.teacher
    assert page is not None
    lines = [f"# {tutorial.label['']}", "", tutorial.help[""], ""]
    lines += [f"**Aim.** {page.aim['']}", "", f"**Time.** {page.minutes} minutes.", "", "## Steps", ""]
    for number, step in enumerate(tutorial.steps, 1):
        words = _EITHER.sub(r"\1", _NAMES.sub(_plain, step.help[""]))
        lines.append(f"{number}. **{step.label['']}.** {words}")
    for title, texts in (("What goes wrong", page.troubles), ("Questions for afterwards", page.questions)):
        lines += ["", f"## {title}", "", *(f"- {text['']}" for text in texts)]
    return "\n".join([*lines, ""])


def _plain(braces: re.Match[str]) -> str:
    """What a text names in braces, in the words of LLL: `Wheel.Advance`."""
    return f"`{braces[1]}`"


def main(arguments: list[str]) -> int:
    """Writes the pages, or says which are not as they should be."""
    made = pages()
    if "--check" in arguments:
        there = {path.name: path.read_text(encoding="utf-8") for path in FOLDER.glob("*.md")}
        other = sorted(name for name in {*made, *there} if made.get(name) != there.get(name))
        for name in other:
            print(f"docs/teachers/{name} is not what the tutorials say: python tools/teacher_pages.py")
        return 1 if other else 0
    FOLDER.mkdir(exist_ok=True)
    for path in FOLDER.glob("*.md"):
        if path.name not in made:
            path.unlink()
    for name, text in made.items():
        (FOLDER / name).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
