/**
 * The socket that is open as long as the page is: it gives the page its name and tells what changes on disk.
 *
 * When the connection is lost it is sought again, since nothing that it carried is gone: the page has it all. A studio that
 * started anew meanwhile is known by its proof (reconnect.ts).
 */
import type { HelloMessage, HereMessage, NewsMessage } from "./generated";
import { type Met, renewToken } from "./reconnect";
import { type Silence, watchSilence } from "./silence";
import { token } from "./token";
import { inPage, transport } from "./transport";

/** What is on disk and who else has the mission open; the page keeps it without the name of the message. */
export type News = Omit<NewsMessage, "type">;

export interface Watcher {
  onHello: (tab: string) => void | Promise<void>;
  onNews: (news: News) => void;
  onLost: () => void;
  /** The connection is open, and nobody answers; or somebody does again. */
  onSilence: (silent: boolean) => void;
  /** After the hello of a studio that started anew. */
  onReturn: () => void;
  /** Another server answers at the studio's address. */
  onStranger: () => void;
}

const AGAIN_MS = 2000;

/** Opens the socket; the returned function closes it for good. */
export function openWatch({ onHello, onNews, onLost, onSilence, onReturn, onStranger }: Watcher): () => void {
  let socket: WebSocket | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let over = false;
  let warned = false;
  let known = "";
  let silence: Silence | null = null;
  const open = (met: Met = "same") => {
    if (over) return;
    let greeted = false;
    const given = token();
    const address = new URL("api/watch", window.location.href);
    address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
    address.search = `?token=${encodeURIComponent(given)}`;
    address.hash = "";
    const opened = transport().socket(address);
    socket = opened;
    // Python in the page is busy with a run, and says so itself.
    silence = inPage() ? null : watchSilence(() => opened.readyState === WebSocket.OPEN && opened.send("?"), onSilence);
    socket.addEventListener("message", (event: MessageEvent<string>) => {
      if (over) return;
      silence?.heard();
      const message = JSON.parse(event.data) as HelloMessage | HereMessage | NewsMessage;
      if (message.type === "here") return;
      if (message.type === "news") {
        onNews(message);
        return;
      }
      const anew = known !== "" && known !== given;
      [greeted, warned, known] = [true, false, given];
      void Promise.resolve(onHello(message.tab)).then(() => {
        if (anew) onReturn();
      });
    });
    socket.addEventListener("close", () => {
      silence?.end();
      if (over) return;
      onLost();
      if (met === "stranger" && !greeted && !warned) {
        warned = true;
        onStranger();
      }
      timer = setTimeout(seek, AGAIN_MS);
    });
  };
  const seek = () => {
    void renewToken().then((met) => {
      if (over) return;
      // Who is no studio of this folder does not take the old token; a page through a tunnel is let in by it.
      if (met === "nobody") timer = setTimeout(seek, AGAIN_MS);
      else open(met);
    });
  };
  open();
  return () => {
    over = true;
    clearTimeout(timer);
    silence?.end();
    socket?.close();
  };
}
