/** Work that takes long, over a socket of its own: begun by a request, broken off by another, over with its last message. */
import { socketAddress } from "./address";
import { transport } from "./transport";

export interface Work {
  /** Asks the server to break it off; false where it has not even begun. */
  breakOff: () => boolean;
  /** Wants to hear no more of it; the server ends it. */
  hangUp: () => void;
}

/** Begins work; `onMessage` says whether the message was its last. `onLost`: the connection broke before that one. */
export function beginWork<Message>(
  path: string,
  request: object,
  { onMessage, onLost }: { onMessage: (message: Message) => boolean; onLost: () => void },
): Work {
  const socket = transport().socket(socketAddress(path));
  let over = false;
  const hangUp = () => {
    over = true;
    socket.close();
  };
  socket.addEventListener("open", () => socket.send(JSON.stringify({ type: "start", ...request })));
  socket.addEventListener("message", (event: MessageEvent<string>) => {
    if (!over && onMessage(JSON.parse(event.data) as Message)) hangUp();
  });
  socket.addEventListener("close", () => {
    if (over) return;
    over = true;
    onLost();
  });
  return {
    hangUp,
    breakOff: () => {
      if (socket.readyState !== WebSocket.OPEN) return false;
      socket.send(JSON.stringify({ type: "stop" }));
      return true;
    },
  };
}
