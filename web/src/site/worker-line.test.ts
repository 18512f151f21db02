/** Requests and sockets through the worker look as those of a network do. */
import { expect, test } from "vitest";

import type { ToWorker } from "./messages";
import { WorkerLine } from "./worker-line";

function made(): { line: WorkerLine; posted: ToWorker[] } {
  const posted: ToWorker[] = [];
  return { line: new WorkerLine((message) => posted.push(message), "/school/kit/"), posted };
}

const bytes = (text: string) => new TextEncoder().encode(text).buffer;

test("a request is a message, and its answer a response", async () => {
  const { line, posted } = made();
  const asked = line.fetch("api/session", { method: "PUT", headers: { "X-A": "b" }, body: "{}" });
  expect(posted).toEqual([
    { kind: "fetch", id: 1, method: "PUT", address: "/api/session", headers: { "X-A": "b" }, body: "{}" },
  ]);
  expect(line.hear({ kind: "answer", id: 1, status: 404, headers: [["X-C", "d"]], body: bytes('{"a":1}') })).toBe(true);
  const response = await asked;
  expect([response.status, response.headers.get("X-C"), await response.json()]).toEqual([404, "d", { a: 1 }]);
});

test("a request without an answer fails as one without a network does, and one that nobody waits for is called off", async () => {
  const { line } = made();
  const failed = line.fetch("api/a", {});
  line.hear({ kind: "failed", id: 1, reason: "broken" });
  await expect(failed).rejects.toBeInstanceOf(TypeError);
  const off = new AbortController();
  const called = line.fetch("api/b", { signal: off.signal });
  off.abort();
  await expect(called).rejects.toMatchObject({ name: "AbortError" });
  line.hear({ kind: "answer", id: 2, status: 200, headers: [], body: bytes("late") });
});

test("a socket opens, hears, says, and is closed by either end once", () => {
  const { line, posted } = made();
  const socket = line.socket(new URL("ws://host/school/kit/api/run?language=en"));
  const seen: string[] = [];
  for (const kind of ["open", "close"]) socket.addEventListener(kind, () => seen.push(kind));
  socket.addEventListener("message", ({ data }: MessageEvent<string>) => seen.push(data));
  socket.send("too early");
  line.hear({ kind: "opened", id: 1 });
  socket.send("go");
  line.hear({ kind: "heard", id: 1, words: "on" });
  expect(posted).toEqual([
    { kind: "open", id: 1, address: "/api/run?language=en" },
    { kind: "say", id: 1, words: "go" },
  ]);
  line.hear({ kind: "closed", id: 1 });
  line.hear({ kind: "closed", id: 1 });
  socket.close();
  expect(seen).toEqual(["open", "on", "close"]);
  expect(socket.readyState).toBe(WebSocket.CLOSED);
  expect(posted).toHaveLength(2);
});

test("bytes that are said are a copy of their own, which the worker gets", () => {
  const posted: [ToWorker, Transferable[]][] = [];
  const line = new WorkerLine((message, given = []) => posted.push([message, given]), "/");
  const socket = line.socket(new URL("ws://host/api/boards/port"));
  line.hear({ kind: "opened", id: 1 });
  const whole = new Uint8Array([1, 2, 3, 4]);
  socket.send(whole.subarray(1, 3));
  const [said, given] = posted[1] ?? [];
  expect(said).toEqual({ kind: "say", id: 1, words: new Uint8Array([2, 3]).buffer });
  expect(given).toEqual(said?.kind === "say" ? [said.words] : []);
  expect(whole.length).toBe(4);
  expect(socket.bufferedAmount).toBe(0);
});

test("what is no answer is for somebody else", () => {
  const { line } = made();
  expect(line.hear({ kind: "ready" })).toBe(false);
  line.hear({ kind: "heard", id: 77, words: "nobody" });
});
