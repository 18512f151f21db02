"""Whatever a request holds, the studio does not fail: bodies are made at random from the shapes of the API."""

from __future__ import annotations

import json
import os
import random
from typing import Any

import pytest

from kitrobot.server.app import create_app
from kitrobot.server.routes.json_bodies import read_json
from kitrobot.wire.board import BOARD_REQUEST_MODELS
from kitrobot.wire.experiment import EXPERIMENT_REQUEST_MODELS
from kitrobot.wire.run_requests import REQUEST_MODELS
from kitrobot.wire.sweep import SWEEP_REQUEST_MODELS
from tests.effort import THOROUGH
from tests.server.conftest import HOST, SOCKET, TOKEN, TestClient

BUDGET = int(os.environ.get("KITROBOT_BUDGET", "240"))
STREAMS = [*range(4 if THOROUGH else 1)]
A_STREAM = BUDGET // 4
ODD = (
    *("", "\ud800", "a\x00b", "x" * 300, "../x", "blink.krt", "example:square/square.krt", "recording:1/x", "é", "²"),
    *("<code>", "{a}", "°", "9" * 5000, "-1", "mini-robot", "blink"),
)
DEEPEST = 5


class Maker:
    """Makes values of JSON schemas."""

    def __init__(self, rng: random.Random, shapes: dict[str, Any], mission: dict[str, Any]) -> None:
        self.rng = rng
        self.shapes = shapes
        self.mission = mission

    def value(self, schema: dict[str, Any], depth: int = 0) -> Any:
        rng = self.rng
        if "$ref" in schema:
            name = schema["$ref"].split("/")[-1]
            right = name == "MissionShape" and rng.random() < 0.7
            return self.mission if right else self.value(self.shapes[name], depth)
        if "const" in schema or "enum" in schema:
            return schema["const"] if "const" in schema else rng.choice(schema["enum"])
        if "anyOf" in schema:
            return self.value(rng.choice(schema["anyOf"]), depth)
        match schema.get("type"):
            case "string":
                return rng.choice(ODD)
            case "integer":
                return rng.choice((0, 1, -1, 2**31, 2**63, 5))
            case "number":
                return rng.choice((0, 1, -1, 1e308, 0.5))
            case "boolean":
                return rng.random() < 0.5
            case "array":
                count = rng.choice((0, 1, 2)) if depth < DEEPEST else 0
                return [self.value(schema.get("items", {}), depth + 1) for _ in range(count)]
            case "object":
                return self.object(schema, depth + 1)
        return None

    def object(self, schema: dict[str, Any], depth: int) -> dict[str, Any]:
        needed = schema.get("required", [])
        fields = schema.get("properties", {}).items()
        made = {name: self.value(of, depth) for name, of in fields if name in needed or self.rng.random() < 0.6}
        more = schema.get("additionalProperties")
        if isinstance(more, dict) and depth < DEEPEST:
            made |= {self.rng.choice(ODD): self.value(more, depth) for _ in range(self.rng.choice((0, 1, 2)))}
        return made


@pytest.fixture(scope="module")
def spec(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """The API as OpenAPI tells it, made once: it is dear, and the same for every studio."""
    made: dict[str, Any] = create_app(tmp_path_factory.mktemp("missions"), None, TOKEN).openapi()
    return made


@pytest.mark.parametrize("stream", STREAMS)
def test_no_request_makes_the_studio_fail(spec, page, stream: int) -> None:
    mission = page.get("/api/mission", params={"path": "blink.krt"}).json()["mission"]
    rng = random.Random(stream)
    maker = Maker(rng, spec["components"]["schemas"], mission)
    requests = [(path, method, of) for path, methods in spec["paths"].items() for method, of in methods.items()]
    for _ in range(A_STREAM):
        path, method, of = rng.choice(requests)
        query = {}
        for one in of.get("parameters", []):
            if one["in"] == "query":
                query[one["name"]] = rng.choice(ODD).encode(errors="surrogatepass")
            else:
                path = path.replace(f"{{{one['name']}}}", "blink")
        content = of.get("requestBody", {"content": {}})["content"]
        if "application/json" in content:
            body = json.dumps(maker.value(content["application/json"]["schema"])).encode()
            sent = {"content": body, "headers": {"Content-Type": "application/json"}}
        else:
            sent = {"content": rng.randbytes(50)} if content else {}
        answer = page.request(method.upper(), path, params=query, **sent)
        assert answer.status_code < 500, (method, path, query, sent, answer.text)


def test_text_that_is_no_unicode_is_refused_in_a_sentence(page) -> None:
    headers = {"Content-Type": "application/json"}
    answer = page.post("/api/part/file", content=b'{"constructors": [], "odd": "\xff"}', headers=headers)
    assert answer.status_code == 422
    assert "was not understood" in answer.json()["message"]


@pytest.mark.parametrize(
    ("body", "value"),
    [
        (rb'["\ud800"]', ["\ufffd"]),
        (rb'["a\udc00b\ud83d\ude00"]', ["a\ufffdb\U0001f600"]),
        (rb'["\\ud800 \ud800"]', ["\\ud800 \ufffd"]),
        (rb'{"\ud800": "\u0041"}', {"\ufffd": "A"}),
    ],
)
def test_half_a_character_is_read_as_no_character(body: bytes, value: object) -> None:
    assert read_json(body) == value


@pytest.mark.parametrize(
    "body", [b"", b"{", b'["\xff"]', rb'["\ud800", NaN]', rb'["\ud800"', b'["\\ud800",' + b"[" * 100_000]
)
def test_what_is_no_json_is_not_read(body: bytes) -> None:
    with pytest.raises(json.JSONDecodeError):
        read_json(body)


def test_a_part_that_only_adds_a_branch_has_no_code_to_read(page, catalogue_part) -> None:
    answer = page.post("/api/part/read", json=catalogue_part)
    assert answer.status_code == 422
    assert "adds a branch" in answer.json()["message"]


@pytest.fixture
def catalogue_part(page) -> dict[str, Any]:
    """What asks for the reading of a part that is shipped and only adds a branch."""
    file = page.get("/api/mission", params={"path": "blink.krt"}).json()
    parts = [one for group in file["catalogue"]["groups"] for one in group["constructors"] if one["adds"] is not None]
    return {"mission": file["mission"], "path": "blink.krt", "robot": "mini-robot", "constructor": parts[0]}


ODD_FRAMES = (
    *("", "null", "[]", "{}", "{", '"start"', "1e999", "[" * 100_000, '{"type":"start"}', '{"type":["start"]}'),
    *('{"type":"\\ud800"}', '{"type":"start","mission":null}', '{"type":"nothing"}', "\0", "é" * 5000),
)
SOCKETS = {
    "/api/run": REQUEST_MODELS,
    "/api/boards": BOARD_REQUEST_MODELS,
    "/api/sweep": SWEEP_REQUEST_MODELS,
    "/api/experiment": EXPERIMENT_REQUEST_MODELS,
}


@pytest.mark.parametrize("stream", STREAMS)
@pytest.mark.parametrize("path", SOCKETS)
def test_no_frame_makes_a_socket_fail(app, spec, page, path: str, stream: int) -> None:
    """Frames at random, and what they are mixed with, are refused or done; the socket goes on until it is closed."""
    shapes_of = spec["components"]["schemas"]
    mission = page.get("/api/mission", params={"path": "blink.krt"}).json()["mission"]
    rng = random.Random(stream)
    maker = Maker(rng, shapes_of, mission)
    models = [model.__name__ for model in SOCKETS[path]]
    here = TestClient(app, base_url=HOST, client=("127.0.0.1", 50000))
    with here, here.websocket_connect(f"{SOCKET}{path}?token={TOKEN}") as socket:
        for _ in range(A_STREAM // 2):
            kind = rng.random()
            if kind < 0.7:
                socket.send_text(json.dumps(maker.value(shapes_of[rng.choice(models)])))
            elif kind < 0.9:
                socket.send_text(rng.choice(ODD_FRAMES))
            else:
                socket.send_bytes(rng.randbytes(rng.choice((0, 1, 40, 5000))))
        socket.send_text('{"type": "the end"}')
        said = ""
        while "the end" not in said:
            said = socket.receive().get("text") or ""
            assert "went wrong inside" not in said
    assert page.get("/api/session").status_code == 200


METHODS = ("GET", "HEAD", "POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "FOO")
QUERIES = ("", "?", "?path=%00", "?path=%FF%FE", "?path=..%2F..%2Fx", "?path=" + "a" * 5000, "?path[]=1&path=2", "?%zz")
HEADERS: tuple[dict[str, str], ...] = (
    {},
    *({"range": value} for value in ("bytes=0-1", f"bytes={'9' * 30}-", "bytes=-5,0-0,1-1", "lines=1")),
    *({"content-encoding": "gzip", "content-type": kind} for kind in ("text/xml", "application/json; charset=x")),
    {"accept-encoding": "br;q=nan, gzip;q=-1", "accept-language": "\xff,*;q=x", "if-none-match": "x"},
)
ADDRESSES = (
    *("/%2e%2e/%2e%2e/x", "/assets/%2e%2e/index.html", "/assets/..%5cindex.html", "//", "/%", "/%00", "/index.html/"),
    *("/" + "a/" * 3000, "/assets/" + "x" * 300, "/api/%2Fmission"),
)


def test_no_method_query_or_header_makes_the_studio_fail(app, page) -> None:
    for path in (route.path for route in app.routes):
        for method in METHODS if THOROUGH else random.Random(path).sample(METHODS, 3):
            tried = [(query, HEADERS[0]) for query in QUERIES] + [("", header) for header in HEADERS[1:]]
            for query, header in tried if THOROUGH else random.Random(f"{path} {method}").sample(tried, 1):
                headers = {name: value.encode("latin-1") for name, value in header.items()}
                answer = page.request(method, path.replace("{", "").replace("}", "") + query, headers=headers)
                assert answer.status_code < 500, (method, path, query, header)
    for address in ADDRESSES:
        answer = page.get(address)
        assert answer.status_code in (200, 404), address
        assert "root:" not in answer.text
