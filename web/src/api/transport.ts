/**
 * What the page talks to its studio through: the network; in a static site it is the worker that Python runs in (`site`).
 *
 * Addresses are the same for both.
 */
export interface Transport {
  fetch: (address: string, asked: RequestInit) => Promise<Response>;
  socket: (address: URL) => WebSocket;
}

let current: Transport = {
  fetch: (address, asked) => fetch(address, asked),
  socket: (address) => new WebSocket(address),
};

export function transport(): Transport {
  return current;
}

/** Everything is said through that transport from now on. */
export function setTransport(other: Transport): void {
  current = other;
}

/** Whether the page is one of a static site: Python runs in it, and it reaches no network. */
export const inPage = (): boolean => document.documentElement.dataset["place"] === "page";
