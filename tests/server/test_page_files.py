"""The page's files travel compressed, to who can read that."""

from __future__ import annotations

import gzip
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from kitrobot.server.app import create_app
from kitrobot.server.page_files import accepted_encodings

TOKEN = "t" * 20
PLAIN = b"export const answer = 42;\n" * 100


@pytest.fixture
def files(tmp_path: Path) -> TestClient:
    static = tmp_path / "static"
    assets = static / "assets"
    assets.mkdir(parents=True)
    (static / "index.html").write_text("<!doctype html>")
    (assets / "page-1.js").write_bytes(PLAIN)
    (assets / "page-1.js.gz").write_bytes(gzip.compress(PLAIN, mtime=0))
    (assets / "page-1.js.br").write_bytes(b"brotli")
    (assets / "only-2.css").write_text("a {}")
    (tmp_path / "secret.js.gz").write_bytes(b"secret")
    return TestClient(create_app(tmp_path, None, TOKEN, static=static), base_url="http://127.0.0.1:8000")


def get(files: TestClient, path: str, encodings: str, **headers: str) -> tuple[int, dict[str, str], bytes]:
    with files.stream("GET", path, headers={"accept-encoding": encodings, **headers}) as answer:
        return answer.status_code, dict(answer.headers), b"".join(answer.iter_raw())


@pytest.mark.parametrize(
    ("encodings", "encoding", "content"),
    [
        ("gzip, deflate, br, zstd", "br", b"brotli"),
        ("gzip;q=1.0, br;q=0", "gzip", gzip.compress(PLAIN, mtime=0)),
        ("identity", None, PLAIN),
        ("", None, PLAIN),
        ("br;q=much", None, PLAIN),
    ],
)
def test_a_file_travels_in_the_smallest_form_that_the_browser_takes(
    files: TestClient, encodings: str, encoding: str | None, content: bytes
) -> None:
    status, headers, body = get(files, "/assets/page-1.js", encodings)
    assert status == 200
    assert headers.get("content-encoding") == encoding
    assert headers["content-type"].startswith("text/javascript")
    assert headers["vary"] == "accept-encoding"
    assert "immutable" in headers["cache-control"]
    assert int(headers["content-length"]) == len(body)
    if encoding == "gzip":
        body = gzip.decompress(body)
        content = PLAIN
    assert body == content


def test_a_file_without_a_twin_travels_as_it_is(files: TestClient) -> None:
    status, headers, body = get(files, "/assets/only-2.css", "br, gzip")
    assert (status, body, headers.get("content-encoding")) == (200, b"a {}", None)


def test_a_file_that_the_browser_has_is_not_sent_again(files: TestClient) -> None:
    _, headers, _ = get(files, "/assets/page-1.js", "br")
    status, _, body = get(files, "/assets/page-1.js", "br", **{"if-none-match": headers["etag"]})
    assert (status, body) == (304, b"")


@pytest.mark.parametrize("path", ["/assets/none.js", "/../secret.js", "/%2e%2e/secret.js", "/assets"])
def test_what_is_not_there_and_what_lies_outside_is_not_found(files: TestClient, path: str) -> None:
    status, _, body = get(files, path, "gzip")
    assert status == 404
    assert b"secret" not in body.replace(b"/secret.js", b"")


def test_the_encodings_of_a_request_are_read() -> None:
    assert accepted_encodings(" GZIP , br;q=0.5, zstd;q=0, ;q=1, x;q=") == {"gzip", "br", "x"}
