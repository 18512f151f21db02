/** What is said of the browser's storage when it is full, when there is room again, and when it is denied. */
import type { PyodideInterface } from "pyodide";
import { expect, test, vi } from "vitest";

import { Kept } from "./kept";
import type { FromWorker } from "./messages";

const full = new DOMException("no room", "QuotaExceededError");

const gone = new DOMException("the connection is closed", "InvalidStateError");
const damaged = new DOMException("no backing store", "UnknownError");

/** Storage that answers reading and writing with the next of these; `mounts`: whether there is any. */
function storage(answers: unknown[], mounts = true) {
  const told: FromWorker[] = [];
  const makeRoom = vi.fn(() => Promise.resolve(false));
  const syncfs = vi.fn((_: boolean, done: (cause: unknown) => void) => done(answers.shift() ?? null));
  const FS = {
    mkdirTree: vi.fn(),
    mount: () => {
      if (!mounts) throw new DOMException("not here", "SecurityError");
    },
    filesystems: { IDBFS: { quit: vi.fn() } },
    syncfs,
  };
  const kept = new Kept({ FS } as unknown as PyodideInterface, "/home", (one) => told.push(one), makeRoom);
  return { kept, told, makeRoom, writes: () => syncfs.mock.calls.filter(([reads]) => !reads).length };
}

const said = (...keeping: string[]) => keeping.map((one) => ({ kind: "keeping", keeping: one }));

test("full storage is told, and told again once there is room", async () => {
  const { kept, told } = storage([null, full, full, null]);
  await kept.read();
  await kept.write();
  await kept.write();
  expect(told).toEqual(said("full"));
  await kept.write();
  expect(told).toEqual(said("full", "kept"));
});

test("what is not needed is thrown away first, and nothing is said if that is enough", async () => {
  const { kept, told, makeRoom } = storage([null, full, null]);
  makeRoom.mockResolvedValueOnce(true);
  await kept.read();
  await kept.write();
  expect(makeRoom).toHaveBeenCalledOnce();
  expect(told).toEqual([]);
});

test("a connection that the browser closed is opened anew, and what cannot be written is told until it can", async () => {
  const { kept, told, writes } = storage([null, gone, null, gone, gone]);
  await kept.read();
  await kept.write();
  expect([told, writes()]).toEqual([[], 2]);
  await kept.write();
  expect(told).toEqual(said("denied"));
  await kept.write();
  expect(told).toEqual(said("denied", "kept"));
});

test("storage that is denied, whether at the start or when read, is told once and never written", async () => {
  const none = storage([], false);
  await none.kept.read();
  await none.kept.write();
  expect([none.told, none.writes()]).toEqual([said("denied"), 0]);
  const { kept, told, makeRoom, writes } = storage([gone, gone]);
  await kept.read();
  await kept.write();
  expect([told, writes()]).toEqual([said("denied"), 0]);
  expect(makeRoom).not.toHaveBeenCalled();
});

test("what was kept and cannot be read is never written over", async () => {
  const { kept, told, writes } = storage([damaged, damaged]);
  await kept.read();
  await kept.write();
  await kept.write();
  expect([told, writes()]).toEqual([said("unread"), 0]);
});
