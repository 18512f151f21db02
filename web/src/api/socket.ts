/**
 * The run's WebSocket: JSON both ways, binary pose frames in.
 *
 * A lost connection is said once and not mended in secret: the run it carried is gone, so the person decides.
 * Messages that came since the last picture are handed on together: a page that is slower than its run draws the newest
 * state and falls no further behind.
 */
import { t } from "../i18n/words";
import { socketAddress } from "./address";
import { talk } from "./line";
import { decodeFrames, type PoseFrame, type RunMessage, type RunRequest } from "./wire";

export interface Failure {
  message: string;
  help: string;
}

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

/** Hands on what is put in before the next picture, in order; at once in a page that draws none. */
function collectForPicture<T>(handOn: (one: T) => void) {
  let waiting: T[] = [];
  const flush = () => {
    for (const one of waiting.splice(0)) handOn(one);
  };
  const hide = () => {
    if (document.hidden) flush();
  };
  document.addEventListener("visibilitychange", hide);
  return {
    put: (one: T) => {
      waiting.push(one);
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
  const socket = talk().socket(socketAddress("api/run"));
  socket.binaryType = "arraybuffer";
  let ours = false;
  const messages = collectForPicture((message: RunMessage) => {
    if (!ours) listener.onMessage(message);
  });
  const hand: RunSocket = {
    send: (request) => {
      if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(request));
    },
    close: () => {
      ours = true;
      messages.end();
      socket.close();
    },
  };
  socket.addEventListener("open", () => listener.onOpen(hand));
  socket.addEventListener("message", (event: MessageEvent<string | ArrayBuffer>) => {
    if (ours) return;
    if (typeof event.data === "string") {
      messages.put(JSON.parse(event.data) as RunMessage);
    } else {
      const way = decodeFrames(event.data);
      const last = way.pop();
      if (last !== undefined) listener.onFrames(way, last);
    }
  });
  socket.addEventListener("close", () => {
    if (ours) return;
    messages.flush();
    // What was handed on last may have ended the run.
    if (ours) return;
    ours = true;
    messages.end();
    listener.onLost({
      message: t("error.run-lost"),
      help: t("error.run-lost-help"),
    });
  });
  return hand;
}
