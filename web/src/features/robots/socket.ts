/**
 * The socket to the server's robots. It is opened when somebody first wants a robot and stays as long as one is held or the panel
 * is open; when it closes, the server lets the robots go, and those that are held stop.
 */
import { socketAddress } from "../../api/address";
import { talk } from "../../api/line";
import { t } from "../../i18n/words";
import { boardsConnecting, boardsLost, takeMessage } from "./boards";
import { setStopAll } from "./state";
import type { BoardsMessage, BoardsRequest } from "./wire";

let socket: WebSocket | null = null;
let waiting: BoardsRequest[] = [];

/** Why the connection ended: refused before it began, or broken. */
function lost(): void {
  socket = null;
  waiting = [];
  boardsLost({ message: t("boards.server-lost"), help: t("boards.server-lost-help"), problems: [] });
}

/** Opens the socket, if it is not. */
export function connect(): void {
  if (socket !== null) return;
  const opened = talk().socket(socketAddress("api/boards"));
  socket = opened;
  boardsConnecting();
  setStopAll(() => send({ type: "stop", address: "" }));
  opened.addEventListener("open", () => {
    for (const request of waiting) opened.send(JSON.stringify(request));
    waiting = [];
  });
  opened.addEventListener("message", (event: MessageEvent<string>) => {
    if (socket !== opened) return;
    takeMessage(JSON.parse(event.data) as BoardsMessage);
  });
  opened.addEventListener("close", () => {
    if (socket === opened) lost();
  });
}

export function send(request: BoardsRequest): void {
  connect();
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(request));
  else waiting.push(request);
}
