/** What is said of the browser's storage when it is full, when there is room again, and when it is denied. */
import type { PyodideInterface } from "pyodide";
import { expect, test, vi } from "vitest";

import { Kept } from "./kept";
import type { FromWorker } from "./messages";

const full = new DOMException("no room", "QuotaExceededError");

/** Storage that answers each writing with the next of these; `mounts`: whether there is any. */
function storage(answers: unknown[], mounts = true) {
  const told: FromWorker[] = [];
  const makeRoom = vi.fn(() => Promise.resolve(false));
  const FS = {
    mkdirTree: vi.fn(),
    mount: () => {
      if (!mounts) throw new DOMException("not here", "SecurityError");
    },
    filesystems: { IDBFS: {} },
    syncfs: (_: boolean, done: (cause: unknown) => void) => done(answers.shift() ?? null),
  };
  const kept = new Kept({ FS } as unknown as PyodideInterface, "/home", (one) => told.push(one), makeRoom);
  return { kept, told, makeRoom };
}

const said = (...keeping: string[]) => keeping.map((one) => ({ kind: "keeping", keeping: one }));

test("full storage is told, and told again once there is room", async () => {
  const { kept, told } = storage([full, full, null]);
  await kept.write();
  await kept.write();
  expect(told).toEqual(said("full"));
  await kept.write();
  expect(told).toEqual(said("full", "kept"));
});

test("what is not needed is thrown away first, and nothing is said if that is enough", async () => {
  const { kept, told, makeRoom } = storage([full, null]);
  makeRoom.mockResolvedValueOnce(true);
  await kept.write();
  expect(makeRoom).toHaveBeenCalledOnce();
  expect(told).toEqual([]);
});

test("storage that is denied is told once, whether it is denied at the start, when read or when written", async () => {
  const denied = new DOMException("a private window", "InvalidStateError");
  expect(storage([], false).told).toEqual(said("denied"));
  const { kept, told, makeRoom } = storage([denied, denied]);
  await kept.read();
  await kept.write();
  expect(told).toEqual(said("denied"));
  expect(makeRoom).not.toHaveBeenCalled();
});
