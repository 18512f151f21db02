/**
 * How this page knows a studio of its folder that started anew, and gets the token of that one.
 *
 * Whoever listens at the address after a lost connection may be anybody, so nobody is told anything before they have proved
 * that they know the folder's secret; server/handshake.py has the other half. The secret stays in this page's memory.
 */
import { takeToken, token } from "./token";
import { transport } from "./transport";

let secret = "";

/** What the studio said when the page began. */
export function rememberSecret(said: string): void {
  secret = said;
}

/** "same": the studio that we left; "new": one of the same folder that started since; "stranger": anybody else. */
export type Met = "same" | "new" | "stranger" | "nobody";

const hex = (bytes: ArrayBuffer | Uint8Array) =>
  [...new Uint8Array(bytes)].map((one) => one.toString(16).padStart(2, "0")).join("");

async function proof(who: "studio" | "page", asked: string, answered: string): Promise<string> {
  const write = new TextEncoder();
  const hash = { name: "HMAC", hash: "SHA-256" };
  const key = await crypto.subtle.importKey("raw", write.encode(secret), hash, false, ["sign"]);
  const words = [who, window.location.host, asked, answered].join("\n");
  return hex(await crypto.subtle.sign("HMAC", key, write.encode(words)));
}

async function post<T>(address: string, json: object): Promise<T | null> {
  const headers = { "Content-Type": "application/json" };
  const response = await transport().fetch(address, { method: "POST", headers, body: JSON.stringify(json) });
  return response.ok ? ((await response.json()) as T) : null;
}

/** Finds out which studio, if any, listens at the address. */
export async function renewToken(): Promise<Met> {
  // Only pages of this very machine can prove anything; the others still see whether anybody is there.
  if (secret === "" || !window.isSecureContext) {
    return fetch("api/again", { method: "POST" }).then(
      () => "stranger",
      () => "nobody",
    );
  }
  const asked = hex(crypto.getRandomValues(new Uint8Array(32)));
  try {
    const said = await post<{ answered: string; proof: string }>("api/again", { asked });
    if (said === null || said.proof !== (await proof("studio", asked, said.answered))) return "stranger";
    const { answered } = said;
    const given = await post<{ token: string }>("api/again/token", {
      asked,
      answered,
      proof: await proof("page", asked, answered),
    });
    if (given === null) return "stranger";
    const met = given.token === token() ? "same" : "new";
    takeToken(given.token);
    return met;
  } catch (cause) {
    return cause instanceof TypeError ? "nobody" : "stranger";
  }
}
