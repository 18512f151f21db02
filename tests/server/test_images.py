"""What the page asks for to hand out as a file, and pictures in the folder that are opened like missions."""

from __future__ import annotations

from base64 import b64decode, b64encode
from pathlib import Path
from typing import Any

import pytest

from kitrobot.image.listing import assemble
from kitrobot.image.model import Image
from tests.deploy.uf2_firmware import binary, uf2
from tests.files.test_embedded_mission import pdf
from tests.server.conftest import SHORT, TestClient


@pytest.fixture
def mission(page: TestClient) -> dict[str, Any]:
    opened: dict[str, Any] = page.get("/api/mission", params={"path": "blink.krt"}).json()["mission"]
    return opened


def ask(page: TestClient, mission: dict[str, Any], program: str = "blink") -> Any:
    return page.post("/api/image", json={"mission": mission, "path": "blink.krt", "program": program})


def test_an_image_and_its_listing_are_the_same_image(page: TestClient, mission: dict[str, Any]) -> None:
    made = ask(page, mission).json()
    data = b64decode(made["image"], validate=True)
    assert Image.from_bytes(data).to_bytes() == data
    assert assemble(made["listing"], "blink.kra").to_bytes() == data


def test_a_program_with_errors_has_no_image_and_says_why(page: TestClient, mission: dict[str, Any]) -> None:
    mission["programs"][0]["vertices"][1]["element"] = "Light.Fly"
    answer = ask(page, mission)
    assert answer.status_code == 422
    assert answer.json()["message"] == "`blink` has 1 error, so there is no image of it yet."
    assert [problem["vertices"] for problem in answer.json()["problems"]] == [["v1"]]


def test_a_program_whose_robot_is_away_says_so(page: TestClient, mission: dict[str, Any]) -> None:
    mission["programs"][0]["robot"] = "nobody"
    answer = ask(page, mission)
    assert answer.status_code == 422
    assert "nobody" in answer.json()["message"]


def test_a_program_that_is_not_there_says_so(page: TestClient, mission: dict[str, Any]) -> None:
    assert ask(page, mission, "other").status_code == 422


def ask_tree(page: TestClient, mission: dict[str, Any], program: str = "blink") -> Any:
    return page.post("/api/tree", json={"mission": mission, "path": "blink.krt", "program": program})


def test_a_program_becomes_a_tree_that_a_program_of_that_robot_is_read_from(
    page: TestClient, mission: dict[str, Any]
) -> None:
    made = ask_tree(page, mission).json()["text"]
    read = page.post("/api/fragment", json={"text": made, "robot": "mini-robot", "path": ""}).json()
    assert read["problems"] == []
    [program] = mission["programs"]
    known = [vertex["element"] for vertex in program["vertices"]]
    assert [vertex["element"] for vertex in read["program"]["vertices"]] == known


def test_what_is_no_tree_says_why(page: TestClient, mission: dict[str, Any]) -> None:
    program = page.post("/api/fragment", json={"text": "BREAK;", "robot": "mini-robot", "path": ""}).json()["program"]
    mission["programs"] = [{**program, "name": "blink", "robot": "mini-robot"}]
    answer = ask_tree(page, mission)
    assert answer.status_code == 422
    assert answer.json()["message"].startswith("`blink` is no behaviour tree: ")
    assert answer.json()["help"]


def save(page: TestClient, path: str, program: str, kit: str, firmware: bytes = b"") -> Any:
    opened = page.get("/api/mission", params={"path": path}).json()["mission"]
    wanted = {"mission": opened, "path": "", "program": program, "kit": kit, "firmware_name": "RPI_PICO.uf2"}
    return page.post("/api/board-file", json={**wanted, "firmware": b64encode(firmware).decode()})


def test_a_file_for_a_board_is_for_both_micro_bits_and_opens_as_its_mission(page: TestClient) -> None:
    made = save(page, "example:heart/heart.krt", "heart", "microbit").json()
    assert (made["boards"], made["ending"], made["reasons"]) == ("the micro:bit of 2016, the micro:bit V2", ".hex", [])
    data = b64decode(made["file"], validate=True)
    opened = page.post("/api/mission/read", params={"name": "heart.hex"}, content=data).json()
    assert (opened["path"], opened["name"]) == ("", "heart.krt")
    assert [program["name"] for program in opened["mission"]["programs"]] == ["heart"]


def test_a_file_for_a_pico_has_the_firmware_that_came_along_and_opens_as_its_mission(page: TestClient) -> None:
    kits = {kit["name"]: kit["file"] for kit in page.get("/api/kits", params={"path": ""}).json()}
    found = [kits[name] for name in ("pico", "xrp", "cutebot", "esp32", "alvik")]
    assert found == [".uf2", ".uf2", ".hex", "", ""]
    made = save(page, "example:square/square.krt", "square", "pico", uf2(binary())).json()
    assert (made["boards"], made["ending"]) == ("the board of `RPI_PICO.uf2` (RP2040)", ".uf2")
    assert made["steps"].startswith("Hold the button BOOTSEL while you plug the board in")
    data = b64decode(made["file"], validate=True)
    opened = page.post("/api/mission/read", params={"name": "square.uf2"}, content=data).json()
    assert [program["name"] for program in opened["mission"]["programs"]] == ["square"]
    refused = save(page, "example:square/square.krt", "square", "xrp", uf2(binary()))
    assert refused.json()["message"] == "The firmware `RPI_PICO.uf2` is for RP2040, and the kit `xrp` has RP2350."
    cut = save(page, "example:square/square.krt", "square", "pico", uf2(binary())[:-1])
    assert (cut.status_code, "it is cut off in its block" in cut.json()["message"]) == (422, True)
    others = page.post("/api/mission/read", params={"name": "RPI_PICO.uf2"}, content=uf2(binary()))
    assert others.json()["message"] == "`RPI_PICO.uf2` is a file for a board without a mission of KitRobot inside."


def test_what_is_no_file_for_a_board_says_why(page: TestClient) -> None:
    refused = save(page, "example:square/square.krt", "square", "pico")
    assert refused.status_code == 422
    assert refused.json()["message"] == "A `.hex` is for a micro:bit, and the kit `pico` is for another board."
    cut = page.post("/api/mission/read", params={"name": "heart.hex"}, content=b":020000040000FA\n:20")
    assert cut.status_code == 422
    assert cut.json()["message"].startswith("`heart.hex` is no hex file of a micro:bit that is whole: its line 2")


def test_a_picture_in_the_folder_opens_as_a_mission_without_a_file(page: TestClient, folder: Path) -> None:
    (folder / "blink.pdf").write_bytes(pdf(SHORT.encode()))
    found = page.get("/api/mission", params={"path": "blink.pdf"}).json()
    assert (found["path"], found["revision"], found["name"]) == ("", "", "blink.krt")
    assert [program["name"] for program in found["mission"]["programs"]] == ["blink"]


def test_nothing_is_ever_saved_over_a_picture(page: TestClient, folder: Path, mission: dict[str, Any]) -> None:
    before = pdf(SHORT.encode())
    (folder / "blink.pdf").write_bytes(before)
    answer = page.put("/api/mission", json={"path": "blink.pdf", "revision": "", "mission": mission})
    assert answer.status_code == 403
    assert (folder / "blink.pdf").read_bytes() == before


@pytest.mark.parametrize("name", ["../x.pdf", ".pdf", "/etc/x.png", "a/../../b.svg"])
def test_a_picture_outside_of_the_folder_is_out_of_reach(page: TestClient, name: str) -> None:
    assert page.get("/api/mission", params={"path": name}).status_code == 403
