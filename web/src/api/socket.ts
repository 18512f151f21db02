/**
 * The run's WebSocket: JSON both ways, binary pose frames in.
 *
 * A lost connection is said once and not mended in secret: the run it carried is gone, so the person decides.
 * Messages and frames that came since the last picture are handed on together, in their order: a page that is slower than
 * its run draws the newest state and falls no further behind.
 */
import { t } from "../i18n/words";
import { socketAddress } from "./address";
import type { Failure } from "./refusal";
import { transport } from "./transport";
import { decodeFrames, type PoseFrame, type RunMessage, type RunRequest } from "./wire";

export interface RunSocket {
  send: (request: RunRequest) => void;
  close: () => void;
}

interface Listener {
  onOpen: (socket: RunSocket) => void;
  onMessage: (message: RunMessage) => void;
  /** The last one is where the robots are, those before it the way there. */
  onFrames: (way: readonly PoseFrame[], last: PoseFrame) => void;
  onLost: (failure: Failure) => void;
}

/** Does what is put in before the next picture, in order; at once in a page that draws none. */
function collectForPicture() {
  let waiting: (() => void)[] = [];
  const flush = () => {
    for (const act of waiting.splice(0)) act();
  };
  const hide = () => {
    if (document.hidden) flush();
  };
  document.addEventListener("visibilitychange", hide);
  return {
    put: (act: () => void) => {
      waiting.push(act);
      if (document.hidden) flush();
      else if (waiting.length === 1) requestAnimationFrame(flush);
    },
    flush,
    end: () => {
      waiting = [];
      document.removeEventListener("visibilitychange", hide);
    },
  };
}

export function openRunSocket(listener: Listener): RunSocket {
  const socket = transport().socket(socketAddress("api/run"));
  socket.binaryType = "arraybuffer";
  let ours = false;
  const news = collectForPicture();
  const hand: RunSocket = {
    send: (request) => {
      if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(request));
    },
    close: () => {
      ours = true;
      news.end();
      socket.close();
    },
  };
  socket.addEventListener("open", () => listener.onOpen(hand));
  socket.addEventListener("message", (event: MessageEvent<string | ArrayBuffer>) => {
    if (ours) return;
    const { data } = event;
    news.put(() => {
      if (ours) return;
      if (typeof data === "string") {
        listener.onMessage(JSON.parse(data) as RunMessage);
        return;
      }
      const way = decodeFrames(data);
      const last = way.pop();
      if (last !== undefined) listener.onFrames(way, last);
    });
  });
  socket.addEventListener("close", () => {
    if (ours) return;
    news.flush();
    // What was handed on last may have ended the run.
    if (ours) return;
    ours = true;
    news.end();
    listener.onLost({
      message: t("error.run-lost"),
      help: t("error.run-lost-help"),
    });
  });
  return hand;
}
