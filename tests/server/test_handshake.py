"""A page and a studio that started anew know each other; nobody else gets the token."""

from __future__ import annotations

import pytest

from kitrobot.server.app import create_app
from kitrobot.server.handshake import MOST_ASKED
from kitrobot.server.handshake_proof import compute_proof
from tests.server.conftest import HOST, TOKEN, TestClient

SECRET = "the secret of the folder"
ASKED = "ab" * 32
ADDRESS = "127.0.0.1:8765"


@pytest.fixture
def studio(folder, tmp_path):
    return TestClient(create_app(folder, None, TOKEN, static=tmp_path, secret=SECRET), base_url=HOST)


def answered(studio, **more):
    return studio.post("/api/again", json={"asked": ASKED}, **more)


def token(studio, number, secret=SECRET, address=ADDRESS, **more):
    proof = compute_proof(secret, "page", address, ASKED, number)
    return studio.post("/api/again/token", json={"asked": ASKED, "answered": number, "proof": proof}, **more)


def test_a_page_that_knows_the_secret_gets_the_token_and_can_be_loaded_again(studio):
    said = answered(studio).json()
    assert said["proof"] == compute_proof(SECRET, "studio", ADDRESS, ASKED, said["answered"])
    assert studio.get("/").status_code == 403
    assert token(studio, said["answered"]).json() == {"token": TOKEN}
    assert studio.get("/").status_code == 503  # it was not built here, and is not refused


def test_a_page_that_does_not_know_the_secret_gets_nothing(studio):
    assert token(studio, answered(studio).json()["answered"], secret="another").status_code == 403


def test_a_number_serves_once(studio):
    number = answered(studio).json()["answered"]
    assert token(studio, number).status_code == 200
    assert token(studio, number).status_code == 403


def test_a_proof_from_another_address_serves_nobody(studio):
    """Who took the place of a studio cannot fetch proofs from the one that runs elsewhere."""
    assert token(studio, answered(studio).json()["answered"], address="127.0.0.1:9999").status_code == 403
    moved = answered(studio, headers={"Host": "127.0.0.1:9999"}).json()
    assert moved["proof"] == compute_proof(SECRET, "studio", ADDRESS, ASKED, moved["answered"])


def test_numbers_that_wait_are_bounded(studio):
    first = answered(studio).json()["answered"]
    for _ in range(MOST_ASKED):
        answered(studio)
    assert token(studio, first).status_code == 403


@pytest.mark.parametrize("headers", [{"Origin": "http://evil.example"}, {"Origin": "null"}, {"Host": "evil.example"}])
def test_another_page_may_not_even_ask(studio, headers):
    assert answered(studio, headers=headers).status_code == 403


def test_the_secret_is_told_with_the_token_only(studio):
    assert studio.get("/api/session").status_code == 403
    assert studio.get("/api/session", headers={"X-KitRobot-Token": TOKEN}).json()["secret"] == SECRET
