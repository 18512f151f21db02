"""Who may talk to the studio."""

from __future__ import annotations

import pytest
from starlette.websockets import WebSocketDisconnect

from kitrobot.server.security import LARGEST_BODY_BYTES
from tests.server.conftest import HOST, SOCKET, TOKEN, TestClient

OUTSIDE = [
    ("GET", "/"),
    ("GET", "/api/session"),
    ("GET", "/api/missions"),
    ("GET", "/api/mission?path=blink.krt"),
    ("GET", "/api/openapi.json"),
    ("PUT", "/api/mission"),
    ("POST", "/api/check"),
    ("GET", "/api/nothing"),
    ("GET", "/api"),
]


@pytest.mark.parametrize(("method", "path"), OUTSIDE)
@pytest.mark.parametrize("token", [None, "", "wrong", TOKEN[:-1], TOKEN + "x", "ключ"])
def test_nothing_of_the_users_is_given_without_the_token(stranger, method, path, token):
    headers = {} if token is None else {"X-KitRobot-Token": token.encode()}
    assert stranger.request(method, path, headers=headers).status_code == 403


def test_a_wrong_token_gets_a_page_for_people(stranger):
    answer = stranger.get("/?token=wrong")
    assert answer.status_code == 403
    assert answer.headers["content-type"] == "text/html; charset=utf-8"
    assert "has ended" in answer.text
    assert "Run <code>kitrobot</code> in the same folder" in answer.text


def test_a_page_at_the_name_goes_to_the_number_where_it_can_know_its_studio_again(stranger):
    answer = stranger.get(f"/?token={TOKEN}", headers={"Host": "localhost:8765"}, follow_redirects=False)
    assert (answer.status_code, answer.headers["location"]) == (307, f"{HOST}/?token={TOKEN}")
    # The far end of a tunnel has a port of its own.
    assert stranger.get(f"/?token={TOKEN}", headers={"Host": "localhost:9000"}).text.endswith("the page</title>")


def test_the_page_itself_is_told_in_json(stranger):
    answer = stranger.get("/api/session", headers={"X-KitRobot-Token": "wrong"})
    assert answer.json()["message"] == "The token of this request is missing or wrong."
    assert answer.json()["help"] == "Open the address that `kitrobot` printed."


@pytest.mark.parametrize("way", ["query", "header"])
def test_the_token_comes_in_the_address_or_a_header(stranger, way):
    headers = {"X-KitRobot-Token": TOKEN} if way == "header" else {}
    query = f"?token={TOKEN}" if way == "query" else ""
    assert stranger.get(f"/api/session{query}", headers=headers).status_code == 200


def cookie_of(stranger) -> str:
    """What the first page load sets, as `name=value`."""
    set_cookie = str(stranger.get(f"/?token={TOKEN}").headers["set-cookie"])
    stranger.cookies.clear()
    return set_cookie.partition(";")[0]


def test_the_first_page_load_sets_a_cookie_that_no_script_and_no_other_page_can_use(stranger):
    cookie = stranger.get(f"/?token={TOKEN}").headers["set-cookie"]
    assert cookie.startswith("kitrobot-8765=")
    assert cookie.endswith("; Path=/; HttpOnly; SameSite=Strict")
    assert stranger.get("/").status_code == 200


def test_the_cookie_is_not_the_token_and_opens_nothing_but_the_page(stranger):
    """A browser shows the cookies of a machine to every server on it, also to those of its other users."""
    cookie = cookie_of(stranger)
    assert TOKEN not in cookie
    assert stranger.get("/", headers={"Cookie": cookie}).status_code == 200
    value = cookie.partition("=")[2]
    for headers in ({"Cookie": cookie}, {"X-KitRobot-Token": value}, {"Cookie": f"kitrobot-8765={TOKEN}"}):
        assert stranger.get("/api/session", headers=headers).status_code == 403
    with (
        pytest.raises(WebSocketDisconnect),
        stranger.websocket_connect(f"{SOCKET}/api/run", headers={"Cookie": cookie}),
    ):
        pass


@pytest.mark.parametrize(
    "before",
    [
        'odd="unclosed; ',
        "a=b=c; ",
        "{json: [1,2]}; ",
        "session id=1; ",
        "; ; =; ",
        "kitrobot-8765=old; ",
        "\xe9=\xe9; ",
    ],
)
def test_cookies_of_other_servers_on_this_machine_do_not_hide_ours(stranger, before):
    ours = cookie_of(stranger)
    assert stranger.get("/", headers={"Cookie": (before + ours).encode("latin-1")}).status_code == 200


def test_a_wrong_token_sets_no_cookie(stranger):
    assert "set-cookie" not in stranger.get("/?token=wrong").headers


def test_the_cookie_of_a_studio_on_another_port_does_not_serve(app, stranger):
    client = TestClient(app, base_url="http://127.0.0.1:9000")
    assert client.get("/", headers={"Cookie": cookie_of(stranger)}).status_code == 403


def test_the_built_files_need_no_token_and_hold_nothing_of_the_users(stranger):
    assert stranger.get("/assets/page.js").text == "export {};"


@pytest.mark.parametrize(
    "host",
    ["evil.example", "evil.example:8765", "127.0.0.1.evil.example", "192.168.1.5:8765", "", "127.0.0.1:x", "[::1"],
)
def test_a_foreign_host_name_is_refused_even_with_the_token(page, host):
    answer = page.get("/api/session", headers={"Host": host})
    assert answer.status_code == 403
    assert "does not answer to the name" in answer.json()["message"]


@pytest.mark.parametrize("host", ["127.0.0.1:8765", "localhost:1", "[::1]:8765", "LOCALHOST", "127.0.0.1"])
def test_every_name_of_this_machine_is_answered(page, host):
    assert page.get("/api/session", headers={"Host": host}).status_code == 200


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:9999", "https://127.0.0.1:8765"])
def test_a_foreign_origin_is_refused_even_with_the_token(page, origin):
    assert page.get("/api/session", headers={"Origin": origin}).status_code == 403


def test_the_pages_own_origin_is_answered(page):
    assert page.get("/api/session", headers={"Origin": HOST}).status_code == 200


def test_an_announced_body_that_is_too_large_is_refused(page):
    answer = page.post("/api/mission/read", headers={"Content-Length": str(LARGEST_BODY_BYTES + 1)}, content=b"x")
    assert answer.status_code == 413
    assert "16 MB" in answer.json()["message"]


def test_a_body_that_is_too_large_without_saying_so_is_refused(page):
    pieces = (b"x" * 1024 * 1024 for _ in range(17))
    assert page.post("/api/mission/read", content=pieces).status_code == 413


@pytest.mark.parametrize("path", ["/", "/api/session", "/assets/page.js", "/nothing", "/api/mission?path=../x.krt"])
def test_every_answer_keeps_the_page_to_itself(page, path):
    headers = page.get(path).headers
    assert "default-src 'self'" in headers["content-security-policy"]
    assert "script-src 'self';" in headers["content-security-policy"]
    assert "frame-ancestors 'none'" in headers["content-security-policy"]
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "no-referrer"
    assert headers["cross-origin-resource-policy"] == "same-origin"


def test_answers_about_missions_are_not_kept_by_the_browser(page):
    assert page.get("/api/missions").headers["cache-control"] == "no-store"


@pytest.mark.parametrize("path", ["/../conftest.py", "/assets/../../missions/blink.krt", "/%2e%2e/missions/blink.krt"])
def test_built_files_lead_nowhere_else(page, path):
    assert page.get(path).status_code == 404


@pytest.mark.parametrize(
    ("token", "headers"),
    [
        ("", {}),
        ("?token=wrong", {}),
        (f"?token={TOKEN}", {"Origin": "http://evil.example"}),
        (f"?token={TOKEN}", {"Host": "evil.example"}),
    ],
)
def test_a_run_is_not_opened_for_strangers(stranger, token, headers):
    with pytest.raises(WebSocketDisconnect), stranger.websocket_connect(f"{SOCKET}/api/run{token}", headers=headers):
        pass


def test_a_page_that_was_not_built_says_so(folder, tmp_path):
    from kitrobot.server.app import create_app

    client = TestClient(create_app(folder, None, TOKEN, static=tmp_path / "none"), base_url=HOST)
    answer = client.get(f"/?token={TOKEN}")
    assert answer.status_code == 503
    assert "has not been built" in answer.text


def test_an_error_nobody_expected_is_one_sentence(app, page, monkeypatch, caplog):
    def broken() -> None:
        raise ZeroDivisionError("secret detail")

    monkeypatch.setattr(app.state.studio.folder, "missions", broken)
    answer = page.get("/api/missions")
    assert answer.status_code == 500
    assert answer.json()["message"] == "Something went wrong inside KitRobot."
    assert "secret" not in answer.text
    assert "Traceback" not in caplog.text


def test_a_run_is_opened_for_the_page(stranger):
    with stranger.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}", headers={"Origin": HOST}):
        pass
