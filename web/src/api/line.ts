/**
 * What the page talks to its studio through: the network; in a static site it is the worker that Python runs in (`site`).
 *
 * Addresses are the same for both.
 */
export interface Line {
  fetch: (address: string, asked: RequestInit) => Promise<Response>;
  socket: (address: URL) => WebSocket;
}

let line: Line = {
  fetch: (address, asked) => fetch(address, asked),
  socket: (address) => new WebSocket(address),
};

export function talk(): Line {
  return line;
}

/** Everything is said through that line from now on. */
export function talkThrough(other: Line): void {
  line = other;
}

/** Whether the page is one of a static site: Python runs in it, and it reaches no network. */
export const inPage = (): boolean => document.documentElement.dataset["place"] === "page";
