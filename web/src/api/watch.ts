/**
 * The socket that is open as long as the page is: it gives the page its name and tells what changes on disk.
 *
 * When the connection is lost it is sought again, since nothing that it carried is gone: the page has it all.
 */
import { token } from "./token";

export interface News {
  path: string;
  /** What is on disk, "" when nothing is. */
  revision: string;
  /** How many other pages have this mission open. */
  others: number;
  /** The state of the XML files that the mission depends on. */
  parts: string;
  /** The runs of this mission that are on, here or on another page. */
  runs: string[];
}

type Message = { type: "hello"; tab: string } | ({ type: "news" } & News);

export interface Watcher {
  onHello: (tab: string) => void;
  onNews: (news: News) => void;
  onLost: () => void;
}

const AGAIN_MS = 2000;

/** Opens the socket; the returned function closes it for good. */
export function openWatch({ onHello, onNews, onLost }: Watcher): () => void {
  let socket: WebSocket | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let over = false;
  const open = () => {
    const address = new URL("api/watch", window.location.href);
    address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
    address.search = `?token=${encodeURIComponent(token())}`;
    address.hash = "";
    socket = new WebSocket(address);
    socket.addEventListener("message", (event: MessageEvent<string>) => {
      if (over) return;
      const message = JSON.parse(event.data) as Message;
      if (message.type === "hello") onHello(message.tab);
      else onNews(message);
    });
    socket.addEventListener("close", () => {
      if (over) return;
      onLost();
      timer = setTimeout(open, AGAIN_MS);
    });
  };
  open();
  return () => {
    over = true;
    clearTimeout(timer);
    socket?.close();
  };
}
