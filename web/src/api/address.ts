/** Where a WebSocket of the studio is: `path` is that of its request, `page` the address of this page. */
import { languageInUse } from "../i18n/words";
import { token } from "./token";

export function socketAddress(path: string, page = window.location.href, secret = token()): URL {
  const found = new URL(path, page);
  found.protocol = found.protocol === "https:" ? "wss:" : "ws:";
  found.search = `?language=${languageInUse()}&token=${encodeURIComponent(secret)}`;
  found.hash = "";
  return found;
}
