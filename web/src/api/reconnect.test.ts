import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { api } from "./client";
import { rememberSecret, renewToken } from "./reconnect";
import { forgetToken, takeToken, token } from "./token";

const SECRET = "the folder's";

async function proofOf(who: string, asked: string, answered: string, secret = SECRET): Promise<string> {
  const write = new TextEncoder();
  const key = await crypto.subtle.importKey("raw", write.encode(secret), { name: "HMAC", hash: "SHA-256" }, false, [
    "sign",
  ]);
  const words = [who, window.location.host, asked, answered].join("\n");
  const made = await crypto.subtle.sign("HMAC", key, write.encode(words));
  return [...new Uint8Array(made)].map((one) => one.toString(16).padStart(2, "0")).join("");
}

/** Who listens: `secret` is what they know. Gives what they were told. */
function listen(secret: string): object[] {
  const told: object[] = [];
  vi.stubGlobal("fetch", async (address: string, { body }: { body: string }) => {
    const said = JSON.parse(body) as { asked: string; answered?: string; proof?: string };
    told.push(said);
    if (address === "api/again") {
      const proof = await proofOf("studio", said.asked, "ab12", secret);
      return new Response(JSON.stringify({ answered: "ab12", proof }));
    }
    const right = said.proof === (await proofOf("page", said.asked, "ab12", secret));
    return new Response(JSON.stringify({ token: "new" }), { status: right ? 200 : 403 });
  });
  return told;
}

beforeEach(() => {
  forgetToken();
  takeToken("old");
  rememberSecret(SECRET);
  vi.stubGlobal("isSecureContext", true);
});
afterEach(() => {
  vi.unstubAllGlobals();
  localStorage.clear();
});

it("takes the token of a studio that proves that it is of the same folder", async () => {
  listen(SECRET);
  expect(await renewToken()).toBe("new");
  expect(token()).toBe("new");
  expect(await renewToken()).toBe("same");
});

it("tells a stranger nothing but a number that was never used", async () => {
  const told = listen("another");
  expect(await renewToken()).toBe("stranger");
  expect(told.map((one) => Object.keys(one))).toEqual([["asked"]]);
  expect(token()).toBe("old");
});

it("tells a missing studio from a stranger", async () => {
  vi.stubGlobal("fetch", () => Promise.reject(new TypeError("Failed to fetch")));
  expect(await renewToken()).toBe("nobody");
});

it("sends a refused request again although somebody else took the new token meanwhile", async () => {
  listen(SECRET);
  const meet = fetch;
  const tokens: string[] = [];
  vi.stubGlobal("fetch", async (address: string, asked: RequestInit) => {
    if (address.startsWith("api/again")) return meet(address, asked);
    tokens.push(new Headers(asked.headers).get("X-KitRobot-Token") ?? "");
    if (tokens.at(-1) === "new") return new Response("[]");
    await renewToken();
    return new Response("{}", { status: 403 });
  });
  expect(await api.missions()).toEqual([]);
  expect(tokens).toEqual(["old", "new"]);
});
