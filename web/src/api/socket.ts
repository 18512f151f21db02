/**
 * The run's WebSocket: JSON both ways, binary pose frames in.
 *
 * A lost connection is said once and not mended in secret: the run it carried is gone, so the person decides.
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

export function openRunSocket(listener: Listener): RunSocket {
  const socket = talk().socket(socketAddress("api/run"));
  socket.binaryType = "arraybuffer";
  let ours = false;
  const hand: RunSocket = {
    send: (request) => {
      if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(request));
    },
    close: () => {
      ours = true;
      socket.close();
    },
  };
  socket.addEventListener("open", () => listener.onOpen(hand));
  socket.addEventListener("message", (event: MessageEvent<string | ArrayBuffer>) => {
    if (ours) return;
    if (typeof event.data === "string") {
      listener.onMessage(JSON.parse(event.data) as RunMessage);
    } else {
      const way = decodeFrames(event.data);
      const last = way.pop();
      if (last !== undefined) listener.onFrames(way, last);
    }
  });
  socket.addEventListener("close", () => {
    if (ours) return;
    ours = true;
    listener.onLost({
      message: t("error.run-lost"),
      help: t("error.run-lost-help"),
    });
  });
  return hand;
}
