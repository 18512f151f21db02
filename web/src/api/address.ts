/** Where a WebSocket of the studio is: `path` is that of its request. */
import { languageInUse } from "../i18n/words";
import { token } from "./token";

export function socketAddress(path: string): URL {
  const found = new URL(path, window.location.href);
  found.protocol = found.protocol === "https:" ? "wss:" : "ws:";
  found.search = `?language=${languageInUse()}&token=${encodeURIComponent(token())}`;
  found.hash = "";
  return found;
}
