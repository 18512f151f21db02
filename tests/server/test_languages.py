"""What the server says, it says in the language that the request asks for."""

from __future__ import annotations

import json

import pytest

from kitrobot.translation.languages import TRANSLATED
from tests.server.conftest import SOCKET, TOKEN

FRENCH = {"Accept-Language": "fr-CA,en;q=0.5"}
URDU = {"Accept-Language": "ur"}


def opened(page):
    return page.get("/api/mission", params={"path": "blink.krt"}).json()["mission"]


def checked(page, mission, headers):
    answer = page.post("/api/check", json={"mission": mission, "path": "blink.krt"}, headers=headers)
    return answer.json()["problems"]


def test_a_problem_and_its_help_follow_the_header(page):
    mission = opened(page)
    mission["programs"][0]["vertices"][2]["settings"]["duration"] = "many"
    english, french, urdu = (checked(page, mission, headers)[0] for headers in ({}, FRENCH, URDU))
    assert english["message"] == "expected a whole number from 0 to 65535 as the duration of `v2`, found `many`"
    assert french["message"] == "durée de `v2` : on attend un nombre entier de 0 à 65535, trouvé : `many`"
    assert urdu["message"] == "`v2` میں وقت: 0 سے 65535 تک کا پورا عدد چاہیے، ملا `many`"
    assert {problem["code"] for problem in (english, french, urdu)} == {"not-a-number"}


def test_a_failure_is_a_sentence_of_the_language(page, folder):
    answer = page.get("/api/mission", params={"path": "none.krt"}, headers=FRENCH)
    assert answer.status_code == 404
    assert answer.json()["message"] == f"Il n'y a pas de fichier `{folder / 'none.krt'}`."
    answer = page.put(
        "/api/mission", json={"path": "blink.krt", "revision": "x", "mission": opened(page)}, headers=URDU
    )
    assert answer.status_code == 409
    assert answer.json()["message"] == "اس دوران `blink.krt` کی فائل کسی اور نے بدل دی۔"


def test_what_one_reader_is_told_does_not_stay_for_the_next(page, folder):
    (folder / "bad.robot.xml").write_text('<robot name="bad" version="1" tick="x"/>')
    for headers, begin in ((FRENCH, "on attend"), ({}, "expected"), (URDU, "`tick`"), (FRENCH, "on attend")):
        file = page.get("/api/mission", params={"path": "blink.krt"}, headers=headers).json()
        assert file["catalogue"]["problems"][0]["message"].startswith(begin)


def test_differences_are_told_in_the_language_and_keep_the_programs_name(page):
    mission = opened(page)
    mission["programs"][0]["vertices"][2]["settings"]["duration"] = "9"
    wanted = {"path": "blink.krt", "mission": mission}
    answer = page.post("/api/mission/difference", json=wanted, headers=FRENCH).json()
    assert answer["changes"] == ["blink: durée de « Attendre » (v2) : 2 → 9"]


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "Done after 0.2 s: every program has ended."),
        ("fr", "Fini en 0,2 s : tous les programmes sont finis."),
        ("ur", "0.2 سیکنڈ میں مکمل: سب پروگرام ختم ہو گئے ہیں۔"),
        ("xx", "Done after 0.2 s: every program has ended."),
    ],
)
def test_a_run_ends_in_the_language_of_its_socket(page, language, sentence):
    mission = opened(page)
    with page.websocket_connect(f"{SOCKET}/api/run?language={language}&token={TOKEN}") as socket:
        socket.send_json({"type": "start", "mission": mission, "path": "blink.krt", "seed": 1, "speed": 0})
        while True:
            text = socket.receive().get("text")
            message = json.loads(text) if text else {}
            if message.get("type") == "state" and message["status"] != "running":
                break
    assert (message["status"], message["sentence"]) == ("done", sentence)


@pytest.mark.parametrize(("language", "label"), [("es", "Ruedas"), ("pt", "Rodas"), ("ur", "پہیے"), ("en", None)])
def test_parts_come_with_the_words_of_the_reader_and_the_english_ones_alone(page, language, label):
    asked = {"params": {"path": "blink.krt"}, "headers": {"Accept-Language": language}}
    catalogue = page.get("/api/catalogue", **asked).json()["catalogue"]
    wheel = next(part for robot in catalogue["robots"] for part in robot["objects"] if part["name"] == "Wheel")
    assert wheel["label"].get(language) == label
    said = json.dumps(catalogue)
    assert not any(f'"{other}":' in said for other in TRANSLATED if other != language)
    assert '"": "' in said


def test_who_has_no_token_is_told_so_in_the_language_of_the_browser(stranger):
    answer = stranger.get("/", headers={**URDU, "accept": "text/html"})
    assert answer.status_code == 403
    assert '<html lang="ur" dir="rtl">' in answer.text
    assert "جس اسٹوڈیو کا یہ پتا ہے وہ بند ہو چکا ہے۔" in answer.text


@pytest.mark.parametrize("wish", ["", ",,,;;;", "fr" * 10_000, "\u00e9", "ur;q=x"])
def test_any_wish_for_a_language_is_answered(page, wish):
    answer = page.get("/api/session", headers={"Accept-Language": wish.encode("latin-1")})
    assert answer.status_code == 200
